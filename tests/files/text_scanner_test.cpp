#include <gtest/gtest.h>

#include <cmath>

#include "hydro/files/TextScanner.h"
#include "tests/support/Refusal.h"

namespace cutwater {
namespace {

double scannedNumber(const std::string& word) {
  TextScanner text(word, "a.gdf");
  return text.next("a number");
}

TEST(TextScanner, WordsStandBetweenBlanksCommasAndLineEnds) {
  TextScanner text("one,two\tthree\r\n\n  , four", "a.off");
  for (const char* word : {"one", "two", "three", "four", "", ""}) EXPECT_EQ(text.nextWord(), word);
  EXPECT_FALSE(text.nextLine());
}

TEST(TextScanner, AWordOfThisLineIsNotTakenFromTheNext) {
  TextScanner text("a b\nc\n", "a.ply");
  EXPECT_EQ(text.wordInLine(), "");  // no line is read yet
  ASSERT_TRUE(text.nextLine());
  EXPECT_EQ(text.wordInLine(), "a");
  EXPECT_EQ(text.wordInLine(), "b");
  EXPECT_EQ(text.wordInLine(), "");
  ASSERT_TRUE(text.nextLine());
  EXPECT_EQ(text.wordInLine(), "c");
}

// Decimal fractions are read to the nearest double, so no tolerance is needed.
TEST(TextScanner, NumbersMayBeFortransOrHaveASign) {
  EXPECT_EQ(scannedNumber("1.5D+02"), 150.0);
  EXPECT_EQ(scannedNumber("-2d-1"), -0.2);
  EXPECT_EQ(scannedNumber("+.25E1"), 2.5);
  EXPECT_EQ(scannedNumber("7."), 7.0);
  EXPECT_TRUE(std::isnan(scannedNumber("nan")));
}

TEST(TextScanner, WhatIsTooLargeForADoubleIsInfiniteAndWhatIsTooSmallIsZero) {
  EXPECT_TRUE(std::isinf(scannedNumber("1e999")));
  EXPECT_TRUE(std::isinf(scannedNumber("-1D+999")));
  for (const char* word : {"1e-400", "1E-400", "-4.0D-999"}) EXPECT_EQ(scannedNumber(word), 0.0);
}

TEST(TextScanner, WhatIsNoNumberIsRefused) {
  for (const char* word : {"x", "1x", "0x10", "--1", "+-1", "+", "1e", "1,5e", "1.2.3"}) {
    TextScanner text(word, "a.gdf");
    test::expectRefusal(Fault::FileMalformed, {"a.gdf: line 1: '", "is not a number (ULEN)"}, [&] {
      while (true) text.next("ULEN");
    });
  }
}

TEST(TextScanner, AMessageIsShortAndPrintable) {
  const std::string word = "\x01\x80" + std::string(500, 'x');
  TextScanner text(word, "a.gdf");
  test::expectRefusal(Fault::FileMalformed, {"'??" + std::string(38, 'x') + "' is not"},
                      [&] { text.next("GRAV"); });
}

TEST(TextScanner, AMessageNamesFileLineAndFault) {
  TextScanner text("1 2\n\n3 4\n", "hull.off");
  for (int i = 0; i < 3; ++i) text.next("a number");
  test::expectRefusal(Fault::MeshNotFinite, {"hull.off: line 3: it is odd"},
                      [&] { text.fail("it is odd", Fault::MeshNotFinite); });
  text.next("a number");
  test::expectRefusal(Fault::FileMalformed, {"line 3: the file ends before the fifth"},
                      [&] { text.next("the fifth"); });
}

TEST(TextScanner, ARecordBeginsOnANewLine) {
  TextScanner text("1 2 commentary 3\n4 more\n5", "a.gdf");
  EXPECT_EQ(text.nextRecord("the first"), 1.0);
  EXPECT_EQ(text.nextRecord("the second"), 4.0);
  text.endRecord();
  EXPECT_EQ(text.next("the third"), 5.0);
  test::expectRefusal(Fault::FileMalformed, {"the file ends before the fourth"},
                      [&] { text.nextRecord("the fourth"); });
}

TEST(TextScanner, CommentsAreSkippedOnlyWhereTheFormatHasThem) {
  TextScanner off("# OFF\n1 # 2\n3#4\n5", "a.off", '#');
  for (const double value : {1.0, 3.0, 5.0}) EXPECT_EQ(off.next("a number"), value);
  TextScanner gdf("1 # 2", "a.gdf");
  gdf.next("a number");
  EXPECT_EQ(gdf.nextWord(), "#");
}

TEST(TextScanner, ACountIsWholeAndFitsIntoTheFile) {
  for (const char* word : {"0", "12", "1.2e1", "12.0"}) {
    TextScanner text(word, "a.ply");
    EXPECT_EQ(text.nextCount("faces", 12), static_cast<int>(scannedNumber(word)));
  }
  for (const char* word : {"-1", "1.5", "13", "nan", "inf", "1e300"}) {
    TextScanner text(word, "a.ply");
    test::expectRefusal(Fault::FileMalformed, {"faces is ", "not a count"},
                        [&] { text.nextCount("faces", 12); });
  }
}

TEST(TextScanner, TheRestIsAllThatFollowsTheLine) {
  TextScanner text(std::string_view("end_header\n\0\n\x7f", 14), "a.ply");
  EXPECT_EQ(text.nextWord(), "end_header");
  EXPECT_EQ(text.rest(), std::string_view("\0\n\x7f", 3));
}

}  // namespace
}  // namespace cutwater
