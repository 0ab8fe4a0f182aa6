#include <gtest/gtest.h>

#include "hydro/Errors.h"
#include "hydro/database/ForwardSpeed.h"
#include "hydro/database/SolverOutput.h"
#include "tests/database/SampleShip.h"

namespace cutwater {
namespace {

// Neither kind of tables can be copied into the other, not through their common part either.
static_assert(!std::is_assignable_v<CoefficientTables&, const SolverOutput&>);
static_assert(!std::is_assignable_v<CoefficientTables&, SolverOutput>);
static_assert(!std::is_copy_constructible_v<CoefficientTables>);
static_assert(!std::is_constructible_v<SolverOutput, Coefficients>);
static_assert(std::is_copy_constructible_v<SolverOutput>);

TEST(SolverOutput, CanBeReadInTheFrequencyDomain) {
  SolverOutput output;
  output.omega = {0.5, 1.0};
  output.addedMass.values = {Mat6::Identity(), 2.0 * Mat6::Identity()};
  output.damping.values = output.addedMass.values;
  EXPECT_EQ(atSpeed(output, 1.0, 0.0, ForwardSpeedForm::Tuck).addedMass, output.addedMass[1]);
}

TEST(OverFrequency, IsZeroOrEmptyUntilSet) {
  const Coefficients c;
  EXPECT_TRUE(c.addedMass.empty());
  EXPECT_TRUE(c.addedMass.atZero.isZero(0.0));
  EXPECT_TRUE(c.damping.atInfinity.isZero(0.0));
  EXPECT_EQ(c.adjoint.atInfinity.cols(), 0);
}

TEST(OverFrequency, ForEachReachesValuesAndBothLimits) {
  Coefficients c = test::sampleShip();
  const Coefficients before = c;
  c.addedMass.forEach([](Mat6& m) { m *= 2.0; });
  for (std::size_t i = 0; i < c.omega.size(); ++i)
    EXPECT_EQ(c.addedMass[i], Mat6(2.0 * before.addedMass[i]));
  EXPECT_EQ(c.addedMass.atZero, Mat6(2.0 * before.addedMass.atZero));
  EXPECT_EQ(c.addedMass.atInfinity, Mat6(2.0 * before.addedMass.atInfinity));
}

TEST(RequireFinished, RefusesUnfinishedCoefficientsWithTheReason) {
  Coefficients c;
  EXPECT_NO_THROW(requireFinished(c, "test"));
  c.status = CoefficientStatus::Unfinished;
  c.unfinishedBecause = "steps of 0.2 rad/s";
  try {
    requireFinished(c, "the sum");
    FAIL();
  } catch (const HydroError& error) {
    EXPECT_EQ(error.fault(), Fault::DatabaseIncomplete);
    EXPECT_STREQ(error.what(), "the sum: the database is unfinished: steps of 0.2 rad/s");
  }
}

}  // namespace
}  // namespace cutwater
