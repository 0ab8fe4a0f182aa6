#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "tests/excitation/TableBox.h"
#include "tests/forces/WaveLoads.h"

namespace cutwater {
namespace {

using test::WaveLoads, test::tableBox, test::tableSea;

TickInput onCourse(double heading, double speed) {
  TickInput now;
  now.time = 7.0;
  now.meanHeading = heading;
  now.speed = speed;
  return now;
}

// A fixed course has the exact forces, of which the tables keep one copy for all ships on it.
TEST(WaveForceIdentity, OnAFixedCourseShipsShareTheExactForcesOfTheirCourse) {
  const auto tables = WaveLoads::seaTablesOf(tableBox(), tableSea());
  WaveLoads one(tables, {0.3, 2.0}), two(tables, {0.3, 2.0});
  EXPECT_EQ(tables->exact(0.3, 2.0), tables->exact(0.3, 2.0));
  EXPECT_EQ(one.evaluate(onCourse(0.3, 2.0)), two.evaluate(onCourse(0.3, 2.0)));
}

// Only a course that begins anew has other amplitudes: of a ship that is put somewhere.
TEST(WaveForceIdentity, ACourseThatBeginsAnewHasItsOwnAmplitudes) {
  const auto tables = WaveLoads::seaTablesOf(tableBox(), tableSea());
  WaveLoads one(tables, {0.3, 2.0}), there(tables, {1.0, 4.0});
  const Vec6 before = one.evaluate(onCourse(0.3, 2.0));
  EXPECT_EQ(one.evaluate(onCourse(1.0, 4.0)), before);
  EXPECT_EQ(one.evaluateAnew(onCourse(1.0, 4.0)), there.evaluate(onCourse(1.0, 4.0)));
}

TEST(WaveForce, RestoredStateGivesTheSameBitsAndDamagedOnesDoNotFit) {
  const auto tables = WaveLoads::seaTablesOf(tableBox(), tableSea());
  WaveLoads one(tables, {0.3, 4.0}), other(tables, {1.0, 9.0});
  std::vector<double> state(one.froudeKrylov.stateSize());
  for (const auto part : {&WaveLoads::froudeKrylov, &WaveLoads::diffraction}) {
    (one.*part).save(state);
    ASSERT_TRUE((other.*part).fits(state));
    (other.*part).restore(state);
  }
  const Vec6 a = one.evaluate(onCourse(0.3, 4.0)), b = other.evaluate(onCourse(0.3, 4.0));
  EXPECT_EQ(std::memcmp(a.data(), b.data(), sizeof a), 0);
  for (const double damaged : {HUGE_VAL, std::nan("")}) {
    state[0] = damaged;
    EXPECT_FALSE(other.diffraction.fits(state)) << damaged;
  }
  EXPECT_FALSE(other.diffraction.fits(std::span(state).first(1)));
}

TEST(WaveForce, OneTickOfACourseThatIsNotFiniteLeavesNoTrace) {
  const auto tables = WaveLoads::seaTablesOf(tableBox(), tableSea());
  WaveLoads loads(tables, {0.2, 3.0}), other(tables, {0.2, 3.0});
  loads.evaluateAnew(onCourse(std::nan(""), 3.0));
  EXPECT_EQ(loads.evaluate(onCourse(0.2, 3.0)), other.evaluate(onCourse(0.2, 3.0)));
}

TEST(WaveForce, CalmWaterGivesNoLoad) {
  WaveLoads calm(tableBox(), SeaState(), {0.0, 0.0});
  EXPECT_EQ(calm.evaluate({}), Vec6::Zero().eval());
}

}  // namespace
}  // namespace cutwater
