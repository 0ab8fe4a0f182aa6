#include <gtest/gtest.h>

#include "hydro/files/ColladaCheck.h"
#include "tests/files/MeshFiles.h"
#include "tests/support/Meshes.h"
#include "tests/support/Refusal.h"

namespace cutwater {
namespace {

void expectColladaRefusal(const std::string& text, const std::vector<std::string>& words) {
  test::expectRefusal(Fault::FileMalformed, words, [&] { checkCollada(text, "hull.dae"); });
}

void expectColladaPasses(const std::string& text) {
  EXPECT_NO_THROW(checkCollada(text, "hull.dae")) << text;
}

/// An array of six numbers and an accessor to it.
std::string arrayAndAccessor(const std::string& accessor) {
  return "<float_array id=\"a\" count=\"6\">1 2 3 4 5 6</float_array><accessor " + accessor + "/>" +
         "<accessor " + accessor + "></accessor>";
}

TEST(ColladaCheck, AWholeFilePasses) {
  expectColladaPasses(test::colladaText(test::cubes(test::cells({0, 0, -2}, {3, 2, 1}))));
}

TEST(ColladaCheck, TextThatEndsAnywhereIsReadToItsEnd) {
  const std::string whole = test::colladaText(test::cubes({{0, 0, -1}}));
  for (std::size_t size = 0; size < whole.size(); size += 3) try {
      checkCollada(whole.substr(0, size), "hull.dae");
    } catch (const HydroError& error) {
      // Only where it ends within a list, or before the closing tag of one.
      EXPECT_NE(std::string(error.what()).find("holds something else"), std::string::npos)
          << error.what();
    }
  expectColladaPasses("");
  expectColladaPasses("no tag at all");
  expectColladaPasses("<p");
}

TEST(ColladaCheck, IndexListsHoldNumbersAndEndWithTheirOwnTag) {
  for (const char* tag : {"p", "vcount", "v", "h"}) {
    const std::string open = std::string("<") + tag + ">", close = std::string("</") + tag + ">";
    expectColladaPasses(open + "0 1\n-2\t3\r\n" + close);
    expectColladaPasses(open + close);
    const std::vector<std::string> said{open, "holds something else than numbers"};
    expectColladaRefusal(open + "0 1 x" + close, said);
    expectColladaRefusal(open + "0 1.5" + close, said);
    expectColladaRefusal(open + "0 <b/>1" + close, said);
    expectColladaRefusal(open + "0 1 2", said);
  }
  expectColladaPasses("<param>x</param><polygon>y</polygon>");  // names that only begin so
}

TEST(ColladaCheck, AMessageNamesFileTagAndByte) {
  expectColladaRefusal("<a>\n<b/>  <p>x</p>", {"hull.dae: <p> at byte 10 "});
  expectColladaRefusal(
      "<float_array id=\"" + std::string(99, 'i') + "\" count=\"1\"></float_array>",
      {"hull.dae: <float_array> at byte 0 says count = 1", "and holds 0"});
}

TEST(ColladaCheck, AnArrayHoldsAsManyNumbersAsItSays) {
  expectColladaPasses("<float_array count=\"3\">1.5 -2e3\n+NaN</float_array>");
  expectColladaPasses("<float_array count=\"0\"/>");
  expectColladaPasses("<float_array count=\"0\">  </float_array>");
  expectColladaPasses("<float_array mycount='7' count = '2'>1 2</float_array>");
  for (const char* text :
       {"<float_array count=\"4\">1 2 3</float_array>",
        "<float_array count=\"2\">1 2 3</float_array>", "<float_array count=\"3\"/>",
        "<float_array>1</float_array>", "<float_array mycount=\"1\">1</float_array>"})
    expectColladaRefusal(text, {"<float_array> at byte 0", "says count", "and holds"});
  expectColladaRefusal("<float_array count=\"1\">1;</float_array>",
                       {"something else than numbers"});
}

TEST(ColladaCheck, TwoArraysMayNotHaveOneId) {
  const std::string one = "<float_array id=\"a\" count=\"1\">1</float_array>";
  expectColladaPasses(one + "<float_array id=\"b\" count=\"1\">1</float_array>");
  expectColladaRefusal(one + one, {"at byte 45 has an id that is not its own"});
}

TEST(ColladaCheck, AnAccessorStaysWithinItsArray) {
  for (const char* within :
       {"source=\"#a\" count=\"2\" stride=\"3\"", "source='#a' count='6'",
        "stride = \"2\" offset = \"2\" count = \"2\" source = \"#a\"", "source=\"#a\"",
        "source=\"#names\" count=\"999\"", "count=\"999\""})  // no array of numbers
    expectColladaPasses(arrayAndAccessor(within));
  for (const char* beyond : {"source=\"#a\" count=\"3\" stride=\"3\"", "source=\"#a\" count=\"7\"",
                             "source=\"#a\" count=\"2\" stride=\"3\" offset=\"1\"",
                             "source=\"#a\" count=\"2\" stride=\"0\"",
                             "source=\"#a\" count=\"999999999\" stride=\"999999999\""})
    expectColladaRefusal(arrayAndAccessor(beyond),
                         {"<accessor> at byte", "reaches beyond its array"});
}

// The accessor may stand before the array that it names.
TEST(ColladaCheckIdentity, TheOrderOfArrayAndAccessorDoesNotMatter) {
  const std::string array = "<float_array id=\"a\" count=\"3\">1 2 3</float_array>";
  for (const char* accessor : {"<accessor source=\"#a\" count=\"4\"></accessor>",
                               "<accessor source=\"#a\" count=\"1\" stride=\"4\"></accessor>"}) {
    expectColladaRefusal(array + accessor, {"reaches beyond its array"});
    expectColladaRefusal(accessor + array, {"reaches beyond its array"});
  }
}

TEST(ColladaCheck, CountsAreWholeNumbersOfNineDigitsAtMost) {
  for (const char* tag : {"polylist", "triangles", "polygons"}) {
    const std::string open = std::string("<") + tag;
    expectColladaPasses(open + " count=\"999999999\">");
    expectColladaPasses(open + ">");
    for (const char* count : {"many", "-1", "1.5", "1e3", "1000000000", " 3"})
      expectColladaRefusal(
          open + " count=\"" + count + "\">",
          {open.substr(1), "count = \"" + std::string(count) + "\" is not a count"});
  }
}

TEST(ColladaCheck, AnAccessorWithoutContentIsCheckedToo) {
  const std::string array = "<float_array id=\"a\" count=\"3\">0 0 0</float_array>";
  expectColladaPasses(array + "<accessor source=\"#a\" count=\"1\" stride=\"3\"/>");
  expectColladaRefusal(array + "<accessor source=\"#a\" count=\"2\" stride=\"3\"/>",
                       {"reaches beyond its array"});
}

}  // namespace
}  // namespace cutwater
