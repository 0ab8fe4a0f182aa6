#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "hydro/forces/SeaTables.h"
#include "hydro/forces/WettedHull.h"
#include "tests/support/Results.h"
#include "tests/verification/nonlinear/NonlinearShip.h"

// Parametric roll in head seas: crests along the hull change its stability, and roll grows where
// they come twice a roll period and damping does not suffice.
namespace cutwater::test {
namespace {

constexpr double kGravity = 9.80665;  // [m/s²] of the frigate's database
constexpr int kPhases = 48;

std::shared_ptr<const Hydrodynamics> frigateWithDamping(double rollDamping) {
  Coefficients c = readHydrodynamics(CUTWATER_SOLVED "/frigate.h5")->coefficients();
  c.ship.supplementary = {};
  c.ship.supplementary.damping[Roll] = rollDamping;
  return std::make_shared<const Hydrodynamics>(std::move(c));
}

// As long as the ship, 2.5 m from trough to crest.
SeaState headSea(double length) {
  const double omega = std::sqrt(2.0 * kPi * kGravity / length);
  return SeaState({{.omega = omega, .amplitude = 1.25, .heading = kPi}}, kGravity, 0.0,
                  WaveProfile::Wheeler);
}

// Roll's stiffness [N·m/rad] as the wave passes the ship that is held but for roll.
struct Stiffness {
  std::array<double, kPhases> values{};
  double mean = 0.0, swing = 0.0;  // its mean, and its amplitude once a wave

  double at(double phase) const {  // linear between the phases
    const double place = std::fmod(phase / (2.0 * kPi), 1.0) * kPhases;
    const auto i = static_cast<std::size_t>(place);
    const double part = place - static_cast<double>(i);
    return (1.0 - part) * values.at(i % kPhases) + part * values.at((i + 1) % kPhases);
  }
};

Stiffness stiffnessOf(const std::shared_ptr<const Hydrodynamics>& ship, const SeaState& sea) {
  constexpr double kHeel = 0.01;  // [rad]
  const auto tables = std::make_shared<SeaTables>(ship, std::make_shared<const SeaState>(sea));
  WettedHull wetted(tables->pressureHull(2000), tables, false);
  Stiffness found;
  Complex first = 0.0;
  for (int i = 0; i < kPhases; ++i) {
    const double phase = 2.0 * kPi * i / kPhases;
    double moment = 0.0;
    for (const double heel : {kHeel, -kHeel}) {
      const Mat3 attitude = Eigen::AngleAxisd(heel, Vec3::UnitX()).toRotationMatrix();
      const WettedHull::Place place{Vec3(0.0, 0.0, ship->ship().cog.z()), attitude};
      wetted.look(phase / sea.components()[0].omega, place);
      moment += wetted.load()[Roll] * (heel > 0.0 ? 1.0 : -1.0);
    }
    const double stiffness = -moment / (2.0 * kHeel);
    found.values.at(static_cast<std::size_t>(i)) = stiffness;
    found.mean += stiffness / kPhases;
    first += 2.0 / kPhases * stiffness * std::polar(1.0, -phase);
  }
  found.swing = std::abs(first);
  return found;
}

struct RollMotion {
  double inertia, damping, meets;  // I, b, ω_e
};

// Greatest exponent [1/s] of I φ̈ + b φ̇ + K(ω_e t) φ = 0, by Floquet's theory: the growth of the
// two solutions over one wave, in 2000 steps of the classic Runge-Kutta method.
double floquetExponent(const RollMotion& roll, const Stiffness& stiffness) {
  constexpr int kSteps = 2000;
  const double period = 2.0 * kPi / roll.meets, h = period / kSteps;
  const auto rate = [&](double t, const Eigen::Matrix2d& y) {
    Eigen::Matrix2d dy;
    dy.row(0) = y.row(1);
    dy.row(1) = -(roll.damping * y.row(1) + stiffness.at(roll.meets * t) * y.row(0)) / roll.inertia;
    return dy;
  };
  Eigen::Matrix2d y = Eigen::Matrix2d::Identity();
  for (int i = 0; i < kSteps; ++i) {
    const double t = i * h;
    const Eigen::Matrix2d a = rate(t, y), b = rate(t + 0.5 * h, y + 0.5 * h * a),
                          c = rate(t + 0.5 * h, y + 0.5 * h * b), d = rate(t + h, y + h * c);
    y += h / 6.0 * (a + 2.0 * b + 2.0 * c + d);
  }
  const double trace = y.trace(), rest = trace * trace - 4.0 * y.determinant();
  const double largest =
      rest > 0.0 ? 0.5 * (std::abs(trace) + std::sqrt(rest)) : std::sqrt(y.determinant());
  return std::log(largest) / period;
}

// How fast roll grows in Bullet [1/s], from 100 s on, when one solution is left.
double growthInBullet(double damping, double start, double speed, const SeaState& sea,
                      double meets) {
  ShipSettings settings = pressureOnly();
  settings.model.immersion = Immersion::Constant;
  settings.model.without = {"radiation", "diffraction"};
  settings.model.restrained = {true, true, true, false, true, true};
  settings.start.speed = speed;
  settings.start.offset[Roll] = start;
  OneShip run(frigateWithDamping(damping), sea, settings);
  const double step = 2.0 * kPi / meets / 240.0;
  const auto amplitudeFrom = [&](double from) {  // over two waves
    double most = 0.0;
    while (run.seaway.time() < from - 0.5 * step) run.tick(step);
    for (int i = 0; i < 480; ++i) {
      run.tick(step);
      most = std::max(most, std::abs(run.ship.motion()[Roll]));
    }
    return most;
  };
  const double pair = 4.0 * kPi / meets;  // two waves, about one roll
  const double begin = 8.0 * pair, end = 20.0 * pair;
  const double first = amplitudeFrom(begin), last = amplitudeFrom(end);
  EXPECT_EQ(run.seaway.faults(), kStepOk);
  return std::log(last / first) / (end - begin);
}

// Mathieu: with ω_e = 2ω₀ roll grows by ω₀(ΔK/4K − ζ), K the mean of its stiffness, ΔK its
// amplitude once a wave, ζ the damping of the critical: the threshold is ζ = ΔK/4K. The frigate of
// this test has ΔK/K = 0.26 in waves of 1/50. What Mathieu leaves out, ΔK² and higher harmonics,
// Floquet's theory has: beside it Bullet is asked for 2 % of the growth without damping, as roll up
// to 2° changes the stiffness by its square.
TEST(ParametricRollVerification, GrowsBelowTheThresholdOfDampingAndDecaysAbove) {
  const auto bare = frigateWithDamping(0.0);
  const SeaState sea = headSea(bare->length());
  const Stiffness stiffness = stiffnessOf(bare, sea);
  const double inertia =
      bare->ship().massMatrix()(Roll, Roll) + bare->coefficients().addedMass.atInfinity(Roll, Roll);
  const double natural = std::sqrt(stiffness.mean / inertia), meets = 2.0 * natural;
  const double omega = sea.components()[0].omega;
  const double speed = (meets - omega) / (omega * omega / kGravity);
  const double change = stiffness.swing / stiffness.mean;
  const double threshold = 0.5 * change * inertia * natural;
  recordResult(kTopic,
               "frigate in head seas of its length, H/lambda 1/50: change of stability, dGM/GM",
               "stated", change, "none");
  const double unit = 0.25 * natural * change;
  for (const double share : {0.7, 0.9, 1.1, 1.3}) {
    const double damping = share * threshold;
    const double theory = floquetExponent({inertia, damping, meets}, stiffness);
    // Heel [rad] that keeps small as it grows, and large beside 1e-5 of the mesh as it decays.
    const double start = share < 1.0 ? 0.002 : 0.03;
    const double found = growthInBullet(damping, start, speed, sea, meets);
    char what[120];
    std::snprintf(what, sizeof what,
                  "parametric roll, damping %g of Mathieu's threshold: growth [1/s]", share);
    char reference[80];
    std::snprintf(reference, sizeof reference, "Floquet %.5f, Mathieu %.5f", theory,
                  unit * (1.0 - share));
    recordResult(kTopic, what, reference, found, "+- 7e-4");
    EXPECT_NEAR(found, theory, 0.02 * unit) << share;
    EXPECT_EQ(found > 0.0, share < 1.0) << share;
  }
}

}  // namespace
}  // namespace cutwater::test
