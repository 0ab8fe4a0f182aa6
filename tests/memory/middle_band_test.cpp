#include <gtest/gtest.h>

#include "hydro/memory/MiddleBand.h"

namespace cutwater {
namespace {

std::vector<double> bandOf(const Coefficients& c) {
  std::vector<double> band;
  for (const Mat6& value :
       overMiddleBand(c, [&](std::size_t i) { return Mat6(Mat6::Constant(c.omega[i])); }))
    band.push_back(value(0, 0));
  return band;
}

// 0.3 to 0.6 of the last frequency, of the last that the panels resolve if that is known.
TEST(MiddleBand, GoesFromThreeToSixTenthsOfTheLastFrequencyInUse) {
  Coefficients c;
  for (int i = 1; i <= 20; ++i) c.omega.push_back(i);
  EXPECT_EQ(bandOf(c), (std::vector<double>{6, 7, 8, 9, 10, 11, 12}));
  c.resolvedOmega = 10.5;
  EXPECT_EQ(bandOf(c), (std::vector<double>{3, 4, 5, 6}));
}

TEST(MiddleBand, MayBeEmpty) {
  Coefficients c;
  c.omega = {1.0, 4.0};
  EXPECT_TRUE(bandOf(c).empty());
}

}  // namespace
}  // namespace cutwater
