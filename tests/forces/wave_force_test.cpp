#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "hydro/excitation/ExcitationTable.h"
#include "tests/excitation/TableBox.h"
#include "tests/forces/WaveLoads.h"

namespace cutwater {
namespace {

using test::WaveLoads, test::tableBox, test::tableSea;

// Two components a tick: 40 of them follow within 20 ticks, then nothing changes any more.
TEST(WaveForceIdentity, AShipThatTurnedIsRenewedToTheLastBit) {
  const auto tables = WaveLoads::seaTablesOf(tableBox(), tableSea());
  WaveLoads turned(tables, {0.2, 3.0}, true), fresh(tables, {1.2, 5.0}, true);
  TickInput now;
  now.meanHeading = 1.2;
  now.speed = 5.0;
  Vec6 force;
  for (int n = 0; n < 21; ++n) force = turned.evaluate(now);
  EXPECT_EQ(force, fresh.evaluate(now));
  now.meanHeading = 0.2;
  now.speed = 3.0;
  EXPECT_EQ(turned.evaluateAnew(now), WaveLoads(tables, {0.2, 3.0}, true).evaluate(now));
}

/// The most that the two amplitudes of one tick can change when the course turns by `turn`, mode by
/// mode.
Vec6 twoAmplitudesTurned(const ExcitationTable& table, double turn, double speed) {
  Vec6 most = Vec6::Zero();
  for (double psi = 0.0; psi < 1.0; psi += 0.01)
    for (std::size_t i = 0; i + 1 < table.sea().components().size(); i += 2) {
      Vec6 both = Vec6::Zero();
      for (const std::size_t n : {i, i + 1}) {
        const auto before = table.at(n, psi, speed), after = table.at(n, psi + turn, speed);
        both += table.sea().components()[n].amplitude *
                (after.froudeKrylov + after.diffraction - before.froudeKrylov - before.diffraction)
                    .cwiseAbs();
      }
      most = most.cwiseMax(both);
    }
  return most;
}

// 1°/s, 60 ticks a second, 40 components, so that each is renewed every 20 ticks by 0.33°, two of
// them a tick. Against a force all of whose amplitudes are those of the moment, no tick brings more
// than that: 1 to 4 % of the mode's largest force here, where the shortest waves turn by
// 6 rad · 0.0058 at its ends. 15 %: the drift of the others by 1/60°, and courses between those
// tried.
TEST(WaveForce, TurnsWithoutLargerJumpsThanTwoAmplitudesMake) {
  const auto tables = WaveLoads::seaTablesOf(tableBox(), tableSea());
  WaveLoads turning(tables, {0.0, 5.0}, true), smooth(tables, {0.0, 5.0}, true);
  Vec6 before = Vec6::Zero(), largest = before, jump = before;
  TickInput now;
  now.speed = 5.0;
  for (int n = 0; n < 3000; ++n) {
    now.time = n / 60.0;
    now.meanHeading = n / 60.0 * kPi / 180.0;
    const Vec6 force = turning.evaluate(now), lag = force - smooth.evaluateAnew(now);
    if (n > 0) jump = jump.cwiseMax((lag - before).cwiseAbs());
    largest = largest.cwiseMax(force.cwiseAbs());
    before = lag;
  }
  const Vec6 allowed = twoAmplitudesTurned(*tables->following(), kPi / 540.0, 5.0);
  EXPECT_LT(jump.cwiseQuotient(allowed).maxCoeff(), 1.15);
  EXPECT_LT(jump.cwiseQuotient(largest).maxCoeff(), 0.05);
}

TEST(WaveForce, RestoredStateGivesTheSameBitsAndDamagedOnesDoNotFit) {
  const auto tables = WaveLoads::seaTablesOf(tableBox(), tableSea());
  const auto drive = [](WaveLoads& loads, int from, int to) {
    Vec6 sum = Vec6::Zero();
    TickInput now;
    for (int n = from; n < to; ++n) {
      now.time = 0.02 * n;
      now.meanHeading = 0.003 * n;
      now.speed = 4.0 + 0.01 * n;
      sum += loads.evaluate(now);
    }
    return sum;
  };
  WaveLoads one(tables, {0.0, 4.0}, true), other(tables, {1.0, 9.0}, true);
  drive(one, 0, 333);
  std::vector<double> state(one.froudeKrylov.stateSize());
  for (const auto part : {&WaveLoads::froudeKrylov, &WaveLoads::diffraction}) {
    (one.*part).save(state);
    ASSERT_TRUE((other.*part).fits(state));
    (other.*part).restore(state);
  }
  const Vec6 a = drive(one, 333, 400), b = drive(other, 333, 400);
  EXPECT_EQ(std::memcmp(a.data(), b.data(), sizeof a), 0);
  for (const double place : {-1.0, 40.0, 1e300, std::nan("")}) {
    state[0] = place;
    EXPECT_FALSE(other.diffraction.fits(state)) << place;
  }
  EXPECT_FALSE(other.diffraction.fits(std::span(state).first(5)));
}

TEST(WaveForce, OneTickOfACourseThatIsNotFiniteLeavesNoTrace) {
  const auto tables = WaveLoads::seaTablesOf(tableBox(), tableSea());
  WaveLoads loads(tables, {0.2, 3.0}, true), other(tables, {0.2, 3.0}, true);
  TickInput now;
  now.meanHeading = std::nan("");
  now.speed = 3.0;
  loads.evaluate(now);
  now.meanHeading = 0.2;
  EXPECT_EQ(loads.evaluate(now), other.evaluate(now));
}

TEST(WaveForce, CalmWaterGivesNoLoad) {
  WaveLoads calm(tableBox(), SeaState(), {0.0, 0.0}, true);
  EXPECT_EQ(calm.evaluate({}), Vec6::Zero().eval());
}

// A fixed course has the exact forces, of which the tables keep one copy for all ships on it.
TEST(WaveForceIdentity, OnAFixedCourseShipsShareTheExactForcesOfTheirCourse) {
  const auto tables = WaveLoads::seaTablesOf(tableBox(), tableSea());
  WaveLoads one(tables, {0.3, 2.0}, false), two(tables, {0.3, 2.0}, false);
  EXPECT_EQ(tables->exact(0.3, 2.0), tables->exact(0.3, 2.0));
  TickInput now;
  now.time = 7.0;
  EXPECT_EQ(one.evaluate(now), two.evaluate(now));
  now.meanHeading = 1.0;
  now.speed = 4.0;
  WaveLoads there(tables, {1.0, 4.0}, false);
  EXPECT_EQ(one.evaluateAnew(now), there.evaluate(now));
}

}  // namespace
}  // namespace cutwater
