#include <gtest/gtest.h>

#include <cmath>

#include "hydro/Errors.h"
#include "hydro/database/IrregularFrequencies.h"
#include "tests/database/SampleShip.h"

namespace cutwater {
namespace {

TEST(IrregularFrequencies, EnvelopesAreLinearBetweenAndConstantOutside) {
  const std::vector<std::pair<double, double>> envelope{{1.0, 10.0}, {2.0, 30.0}};
  EXPECT_EQ(conditionLimitAt(envelope, 0.5), 10.0);
  EXPECT_EQ(conditionLimitAt(envelope, 1.5), 20.0);
  EXPECT_EQ(conditionLimitAt(envelope, 9.0), 30.0);
  EXPECT_EQ(conditionLimitAt({}, 1.0), HUGE_VAL);
}

// Even and odd systems each have their own envelope; without any the mask of the file stays.
TEST(IrregularFrequencies, AreThoseAboveEitherEnvelope) {
  Coefficients c = test::sampleShip();
  c.conditionEven.assign(c.omega.size(), 10.0);
  c.conditionOdd.assign(c.omega.size(), 10.0);
  c.conditionEven.front() = c.conditionOdd.back() = 50.0;
  c.conditionLimitEven = c.conditionLimitOdd = {{1.0, 20.0}};
  std::vector<int> expected(c.omega.size(), 0);
  expected.front() = expected.back() = 1;
  EXPECT_EQ(irregularFrequencies(c), expected);
  c.conditionLimitOdd.clear();
  expected.back() = 0;
  EXPECT_EQ(irregularFrequencies(c), expected);
  c.conditionLimitEven.clear();
  EXPECT_EQ(irregularFrequencies(c), c.masked);
}

TEST(IrregularFrequencies, RefuseBadEnvelopes) {
  Coefficients c = test::sampleShip();
  c.conditionLimitEven = {{1.0, 5.0}, {1.0, 6.0}};
  EXPECT_THROW(irregularFrequencies(c), HydroError);
  c.conditionLimitEven = {{1.0, -5.0}};
  EXPECT_THROW(irregularFrequencies(c), HydroError);
}

}  // namespace
}  // namespace cutwater
