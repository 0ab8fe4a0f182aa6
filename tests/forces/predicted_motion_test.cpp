#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "hydro/forces/PredictedMotion.h"
#include "tests/forces/Predicted.h"

namespace cutwater {
namespace {

using test::Predicted, test::tableSea;
using Way = PredictedMotion::Way;

constexpr double kTick = 1.0 / 60.0;
constexpr std::size_t kBeforeWays = 14;  // numbers of a saved state

/// All sums at one time and place, component by component: each wave's forces from the table, its
/// answer solved for directly.
PredictedMotion::Sums directly(const Predicted& ship, const Way& way, double t, double x,
                               double y) {
  const FreeResponse& response = ship.motion->response();
  const ExcitationTable& table = *ship.tables->following().front();
  const double U = way.through.ahead, V = way.through.leeway;
  PredictedMotion::Sums sums;
  for (std::size_t i = 0; i < ship.sea().components().size(); ++i) {
    const WaveComponent& wave = ship.sea().components()[i];
    const double k = wave.omega * wave.omega / test::kBoxGravity;
    const double along = std::cos(wave.heading), across = std::sin(wave.heading);
    const Complex phasor =
        std::polar(wave.amplitude, wave.omega * t - k * (x * along - y * across) + wave.phase);
    const double beta = wave.heading + way.heading;
    const double met = wave.omega - k * (U * std::cos(beta) - V * std::sin(beta));
    const CVec6 incident = table.froudeKrylov(i, way.heading);
    CVec6 scattered = table.diffraction(i, way.heading, U, V);
    scattered[Yaw] -= V * scattered[Surge] / Complex(0.0, met);
    const auto water = response.lift().orbital(wave.omega, k, beta);
    CVec6 force = incident + scattered;
    force[Sway] += std::abs(U) * response.lift().side * water.side;
    force[Yaw] += std::abs(U) * response.lift().turn * water.turn;
    const auto answer = response.at(met, way.through, force, {});
    const double w = response.share(met);
    const Complex of[] = {answer.motion[Surge], answer.motion[Sway], answer.motion[Yaw]};
    for (int j = 0; j < 3; ++j) {
      sums.displacement[j] += w * (phasor * of[j]).real();
      sums.velocity[j] += w * (phasor * Complex(0.0, met) * of[j]).real();
    }
    sums.momentumAhead += w * (phasor * answer.momentum[Surge]).real();
    sums.momentumAcross += w * (phasor * answer.momentum[Sway]).real();
    sums.froudeKrylov += (phasor * incident).real();
    sums.diffraction += (phasor * scattered).real();
  }
  return sums;
}

/// Largest difference of two sums, each over its own size.
double apart(const PredictedMotion::Sums& a, const PredictedMotion::Sums& b) {
  const auto of = [](const auto& u, const auto& v) { return (u - v).norm() / v.norm(); };
  return std::max({of(a.displacement, b.displacement), of(a.velocity, b.velocity),
                   std::abs(a.momentumAhead / b.momentumAhead - 1.0),
                   std::abs(a.momentumAcross / b.momentumAcross - 1.0),
                   of(a.froudeKrylov, b.froudeKrylov), of(a.diffraction, b.diffraction)});
}

// Round-off of 40 components that partly cancel.
TEST(PredictedMotionIdentity, SumsAreThoseOfEachWaveSolvedForDirectly) {
  Predicted ship(tableSea());
  for (const Way& way : {Way{0.3, {0.0, 0.0}}, Way{-2.0, {5.0, 0.0}}, Way{1.1, {-3.0, 0.8}}}) {
    ship.renewAll(way);
    EXPECT_LT(apart(ship.sumAt(7.3, 40.0, -25.0), directly(ship, way, 7.3, 40.0, -25.0)), 1e-9);
  }
}

TEST(PredictedMotionIdentity, DisplacementAloneIsThatOfTheSumsAndTheRampScalesAll) {
  Predicted ship(tableSea());
  ship.renewAll({0.3, {2.0, 0.1}});
  const PredictedMotion::Sums full = ship.sumAt(7.3, 40.0, -25.0);
  EXPECT_EQ(ship.motion->displacement(ship.phasors), full.displacement);
  const PredictedMotion::Sums& half = ship.sumAt(7.3, 40.0, -25.0, 0.5);
  EXPECT_EQ(half.displacement, (0.5 * full.displacement).eval());
  EXPECT_EQ(half.diffraction, (0.5 * full.diffraction).eval());
}

/// How far the oldest amplitude is behind the way: what it was made for, from the saved state.
struct Age {
  double heading = 0.0, ahead = 0.0, leeway = 0.0;

  void see(const PredictedMotion& motion, const Way& now) {
    std::vector<double> state(motion.stateSize());
    motion.save(state);
    for (std::size_t i = kBeforeWays; i + 2 < state.size(); i += 3) {
      heading = std::max(heading, std::abs(state[i] - now.heading));
      ahead = std::max(ahead, std::abs(state[i + 1] - now.through.ahead));
      leeway = std::max(leeway, std::abs(state[i + 2] - now.through.leeway));
    }
  }
};

// The header's promise: none is older than a turn of one degree. As it is made for half the way to
// come it is half a degree off at most, once the turn lasts as long as a round of renewals, of one
// degree. A tick's turn and what is not worth renewing (1e-3 rad) beside it.
TEST(PredictedMotionIdentity, InATurnNoAmplitudeIsMoreThanADegreeOff) {
  for (const int count : {40, 200}) {
    for (const double rate : {0.25, 1.0, 3.0, -2.0}) {  // [°/s]
      Predicted ship(tableSea(count));
      const double turn = rate * kPi / 180.0;
      Way way{0.2, {8.0, 0.3}};
      ship.renewAll(way);
      Age first, later;
      for (int n = 0; n < 600; ++n) {
        way.heading += kTick * turn;
        ship.motion->follow(way, turn, kTick);
        (n < 300 ? first : later).see(*ship.motion, way);
      }
      const double degree = kPi / 180.0, beside = std::abs(kTick * turn) + 1e-3;
      EXPECT_LT(first.heading, degree + beside) << count << ' ' << rate;
      EXPECT_LT(later.heading, 0.5 * degree + beside) << count << ' ' << rate;
    }
  }
}

// Two are renewed a tick, so that none is older than half a second for each 60 components at 60
// ticks a second: of speed ahead and of leeway what is gained in that time, and what is not worth
// renewing (0.02 m/s).
TEST(PredictedMotionIdentity, GainingSpeedNoAmplitudeIsOlderThanARound) {
  for (const int count : {40, 200}) {
    for (const double gain : {0.02, 0.1, -0.3}) {  // [m/s²]
      for (const bool sideways : {false, true}) {
        Predicted ship(tableSea(count));
        Way way{0.2, {4.0, 0.0}};
        ship.renewAll(way);
        Age age;
        for (int n = 0; n < 600; ++n) {
          (sideways ? way.through.leeway : way.through.ahead) += kTick * gain;
          ship.motion->follow(way, 0.0, kTick);
          age.see(*ship.motion, way);
        }
        const double round = 0.5 * count / 60.0 + kTick;
        EXPECT_LT(std::max(age.ahead, age.leeway), std::abs(gain) * round + 0.02 + 1e-9)
            << count << ' ' << gain << sideways;
      }
    }
  }
}

// In a steady turn the sums are those of amplitudes of the moment, but for half a degree and less
// of each: waves of 6 rad/(rad of turn) at the hull's ends change by 6 · 0.0087 of themselves at
// most, and as many are ahead as behind.
TEST(PredictedMotion, InATurnItsSumsFollowThoseOfTheMoment) {
  Predicted turning(tableSea()), moment(tableSea());
  const double turn = kPi / 180.0;
  Way way{0.2, {5.0, 0.0}};
  turning.renewAll(way);
  double worst = 0.0, largest = 0.0;
  for (int n = 0; n < 1200; ++n) {
    way.heading += kTick * turn;
    turning.motion->follow(way, turn, kTick);
    moment.renewAll(way);
    const double x = 5.0 * n * kTick;
    const Vec6 found = turning.sumAt(n * kTick, x, 0.0).diffraction;
    const Vec6 exact = moment.sumAt(n * kTick, x, 0.0).diffraction;
    worst = std::max(worst, (found - exact).norm());
    largest = std::max(largest, exact.norm());
  }
  EXPECT_LT(worst, 6.0 * 0.0087 * largest);
}

// A ship that goes straight again has the amplitudes of its way to the last bit but for what is not
// worth renewing.
TEST(PredictedMotionIdentity, AfterATurnAllAreRenewed) {
  Predicted ship(tableSea());
  Way way{0.0, {5.0, 0.0}};
  ship.renewAll(way);
  way.heading = 1.0;
  for (int n = 0; n < 40; ++n) ship.motion->follow(way, 0.0, kTick);
  Age age;
  age.see(*ship.motion, way);
  EXPECT_EQ(age.heading, 0.0);
}

// Driven alike after a restore both have the same bits, whatever the other did before.
TEST(PredictedMotion, RestoredStateGivesTheSameBitsAndDamagedOnesDoNotFit) {
  Predicted one(tableSea()), other(tableSea());
  const auto drive = [](Predicted& ship, int from, int to) {
    Vec6 sum = Vec6::Zero();
    for (int n = from; n < to; ++n) {
      const double turn = 0.03 * std::sin(0.01 * n);
      ship.motion->follow({0.003 * n, {4.0 + 0.01 * n, 0.1}}, turn, kTick);
      const auto& sums = ship.sumAt(kTick * n, 0.1 * n, 0.0);
      sum += sums.diffraction;
      sum.head<3>() += sums.displacement;
    }
    return sum;
  };
  one.renewAll({0.0, {4.0, 0.1}});
  other.renewAll({1.0, {9.0, 0.0}});
  drive(one, 0, 333);
  drive(other, 7, 50);
  std::vector<double> state(one.motion->stateSize());
  one.motion->save(state);
  ASSERT_TRUE(other.motion->fits(state));
  other.motion->restore(state);
  const Vec6 a = drive(one, 333, 400), b = drive(other, 333, 400);
  EXPECT_EQ(std::memcmp(a.data(), b.data(), sizeof a), 0);
  for (const double place : {-1.0, 40.0, 1e300, std::nan("")}) {
    state[0] = place;
    EXPECT_FALSE(other.motion->fits(state)) << place;
  }
  state[0] = 0.0;
  EXPECT_FALSE(other.motion->fits(std::span(state).first(5)));
}

// A state from before the first tick belongs to no way; the next renewAll makes all of it.
TEST(PredictedMotion, AStateFromBeforeTheFirstTickIsTaken) {
  Predicted fresh(tableSea()), used(tableSea()), other(tableSea());
  std::vector<double> state(fresh.motion->stateSize());
  fresh.motion->save(state);
  used.renewAll({1.0, {9.0, 0.0}});
  ASSERT_TRUE(used.motion->fits(state));
  used.motion->restore(state);
  used.renewAll({0.3, {2.0, 0.0}});
  other.renewAll({0.3, {2.0, 0.0}});
  EXPECT_EQ(used.sumAt(1.0, 2.0, 3.0).diffraction, other.sumAt(1.0, 2.0, 3.0).diffraction);
}

// One tick of a way that is not finite leaves no trace.
TEST(PredictedMotion, LooksAwayFromWhatIsNotFinite) {
  Predicted ship(tableSea()), other(tableSea());
  const Way way{0.2, {3.0, 0.0}};
  ship.renewAll(way);
  other.renewAll(way);
  const double nan = std::nan("");
  ship.motion->follow({nan, {3.0, 0.0}}, 0.0, kTick);
  ship.motion->follow({0.2, {HUGE_VAL, 0.0}}, 0.0, kTick);
  ship.motion->follow({0.2, {3.0, nan}}, 0.0, kTick);
  ship.motion->follow(way, nan, kTick);
  ship.renewAll({nan, {}});
  for (int n = 0; n < 30; ++n) ship.motion->follow(way, 0.0, kTick);
  EXPECT_EQ(ship.sumAt(1.0, 2.0, 3.0).diffraction, other.sumAt(1.0, 2.0, 3.0).diffraction);
  EXPECT_EQ(ship.motion->now().displacement, other.sumAt(1.0, 2.0, 3.0).displacement);
}

// Without the water there is no answer to subtract; loads of waves stay.
TEST(PredictedMotion, PartsThatAreOffDoNotCount) {
  Predicted ship(tableSea()), whole(tableSea());
  const Way way{0.2, {3.0, 0.0}};
  ship.renewAll(way);
  whole.renewAll(way);
  ActiveParts parts;
  parts.water = false;
  ship.motion->setParts(parts);
  EXPECT_EQ(ship.sumAt(1.0, 2.0, 3.0).displacement, Vec3::Zero().eval());
  EXPECT_EQ(ship.motion->now().diffraction, whole.sumAt(1.0, 2.0, 3.0).diffraction);
  parts = {};
  parts.diffraction = false;
  ship.motion->setParts(parts);
  EXPECT_GT((ship.sumAt(1.0, 2.0, 3.0).displacement - whole.motion->now().displacement).norm(),
            1e-3 * whole.motion->now().displacement.norm());
  ship.motion->setParts({});
  EXPECT_EQ(ship.sumAt(1.0, 2.0, 3.0).displacement, whole.motion->now().displacement);
}

TEST(PredictedMotion, InCalmWaterThereIsNone) {
  Predicted calm(SeaState{});
  calm.renewAll({0.2, {3.0, 0.0}});
  calm.motion->follow({0.3, {3.0, 0.0}}, 0.1, kTick);
  const PredictedMotion::Sums& sums = calm.sumAt(1.0, 2.0, 3.0);
  EXPECT_EQ(sums.displacement, Vec3::Zero().eval());
  EXPECT_EQ(sums.diffraction, Vec6::Zero().eval());
  std::vector<double> state(calm.motion->stateSize());
  calm.motion->save(state);
  EXPECT_TRUE(calm.motion->fits(state));
}

/// Displacement that counts after some minutes of a ship that moves `share` as predicted in sway,
/// over the predicted one.
double counted(double share) {
  Predicted ship(
      SeaState({{.omega = 2.0, .amplitude = 0.1, .heading = kPi / 2}}, test::kBoxGravity));
  ship.renewAll({0.0, {}});
  Predicted free(ship.sea());
  free.renewAll({0.0, {}});
  const auto unheld = [&](double t) { return free.sumAt(t, 0.0, 0.0).velocity[1]; };
  double whole = 0.0;
  for (int n = 0; n < 60 * 180; ++n) {
    const auto& sums = ship.sumAt(n * kTick, 0.0, 0.0);
    if (n == 0) whole = std::hypot(sums.displacement[1], sums.velocity[1] / 2.0);
    const double actual = share * unheld(n * kTick);
    ship.motion->compare({0.0, actual, 0.0}, kTick, n == 0);
  }
  const auto& sums = ship.sumAt(0.0, 0.0, 0.0);
  return std::hypot(sums.displacement[1], sums.velocity[1] / 2.0) / whole;
}

// As far as the ship moves like that the prediction counts, and whole, to the bit, from 0.85 on.
TEST(PredictedMotionClosedForm, CountsAsFarAsTheShipMovesLikeThat) {
  EXPECT_EQ(counted(1.0), 1.0);
  EXPECT_EQ(counted(0.9), 1.0);
  EXPECT_NEAR(counted(0.775), 0.85, 0.02);  // the tick's lag, and 1e-4 g that tells nothing
  EXPECT_NEAR(counted(0.5), 0.5, 0.02);
  EXPECT_NEAR(counted(0.0), 0.0, 0.02);
  EXPECT_EQ(counted(-1.0), 0.0);
}

}  // namespace
}  // namespace cutwater
