#include <gtest/gtest.h>

#include "hydro/database/FreeMotion.h"

namespace cutwater::test {
namespace {

// No place and no heading of a free ship is held by anything; heave, roll and pitch are as given.
TEST(FreeRestoring, HoldsNoPlaceAndNoHeading) {
  Mat6 given;
  for (int n = 0; n < 36; ++n) given(n) = 1.0 + n;
  const Mat6 free = freeRestoring(given);
  for (const int mode : {Surge, Sway, Yaw}) EXPECT_TRUE(free.col(mode).isZero(0.0)) << mode;
  for (const int mode : {Heave, Roll, Pitch}) EXPECT_EQ(free.col(mode), given.col(mode)) << mode;
}

}  // namespace
}  // namespace cutwater::test
