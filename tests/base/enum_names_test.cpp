#include <gtest/gtest.h>

#include "hydro/base/EnumNames.h"

namespace cutwater {
namespace {

enum class Colour { Red, Green };
constexpr std::array kColourNames{"red", "green"};

TEST(EnumNames, ANameAndItsEnumeratorAreFoundFromEachOther) {
  EXPECT_STREQ(nameOf(kColourNames, Colour::Green), "green");
  EXPECT_EQ(fromName<Colour>(kColourNames, "red"), Colour::Red);
  EXPECT_EQ(fromName<Colour>(kColourNames, "green"), Colour::Green);
}

TEST(EnumNames, AnUnknownNameIsNoEnumerator) {
  EXPECT_FALSE(fromName<Colour>(kColourNames, "blue"));
  EXPECT_FALSE(fromName<Colour>(kColourNames, "Red"));  // case counts
  EXPECT_FALSE(fromName<Colour>(kColourNames, ""));
}

}  // namespace
}  // namespace cutwater
