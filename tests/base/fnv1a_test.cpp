#include "hydro/base/Fnv1a.h"

#include <gtest/gtest.h>

namespace cutwater {
namespace {

std::string hashOf(const std::string& text) {
  Fnv1a hash;
  hash.add(text.data(), text.size());
  return hash.digits();
}

// Test vectors of the authors of the function: Fowler, Noll and Vo, "fnv64.c", test_fnv.c.
TEST(Fnv1a, HasThePublishedValues) {
  EXPECT_EQ(hashOf(""), "cbf29ce484222325");
  EXPECT_EQ(hashOf("a"), "af63dc4c8601ec8c");
  EXPECT_EQ(hashOf("foobar"), "85944171f73967e8");
}

TEST(Fnv1a, PiecesGiveTheHashOfTheWhole) {
  Fnv1a hash;
  hash.add("foo", 3);
  hash.add("bar", 3);
  EXPECT_EQ(hash.digits(), hashOf("foobar"));
  EXPECT_EQ(hash.value(), 0x85944171f73967e8u);
}

}  // namespace
}  // namespace cutwater
