#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "hydro/waves/Spectrum.h"
#include "tests/support/Results.h"
#include "tests/verification/free_ship/FreeFrigate.h"

// First-order waves push no ship: what is left of their mean force is no more than the second-order
// error of a theory of first order may be.
namespace cutwater::test {
namespace {

// Mean force ahead and across in earth axes and mean yaw moment of a ship without engine in one
// wave of 1 m.
struct Mean3 {
  Vec3 value = Vec3::Zero();
  double unit = 1.0;  // ½ρga²L [N]
};

// Fit of mean, trend, two harmonics and the first one's growth: the ship drifts a little, and by
// 1e-3 of a radian of phase what is not fitted would be taken for a mean.
Mean3 meanForce(double omega, double heading) {
  OneShip run(coarseFrigate(), SeaState({{omega, 1.0, 0.0, heading}}, kGravity, 120.0), freeShip());
  constexpr double kFrom = 200.0, kUntil = 520.0;  // [s]: 320 s, after the ramp and what it starts
  const int samples = static_cast<int>(std::lround((kUntil - kFrom) / kTick));
  Eigen::MatrixXd rows(samples, 8), values(samples, 3);
  while (run.time() < kFrom - 0.5 * kTick) run.tick();
  for (int i = 0; i < samples; ++i) {
    run.tick();
    const double t = run.ship.lastTick().time, phase = omega * t;
    const double middle = (t - 0.5 * (kFrom + kUntil)) / (0.5 * (kUntil - kFrom));
    rows.row(i) << 1.0, middle, std::cos(phase), std::sin(phase), std::cos(2.0 * phase),
        std::sin(2.0 * phase), middle * std::cos(phase), middle * std::sin(phase);
    const Vec6 waves = run.ship.load("froude_krylov") + run.ship.load("diffraction");
    const Vec6 water = run.ship.load("radiation") + run.ship.load("added_mass");
    const double course = run.ship.course().heading(), c = std::cos(course), s = std::sin(course);
    values.row(i) << c * waves[Surge] - s * waves[Sway], s * waves[Surge] + c * waves[Sway],
        waves[Yaw] + water[Yaw];
  }
  const ShipParticulars& ship = coarseFrigate()->ship();
  return {leastSquares(rows, values).row(0).transpose(),
          0.5 * ship.density * kGravity * coarseFrigate()->length()};
}

// The acceptance: 0.1 % of ½ρga²L, of that times the length for yaw, and 0.15 % for sway
// where ω ≥ 1. An error of the predicted motion's phase of one degree is 0.1 to 0.2 %.
TEST(FreeShipGhostIdentity, RegularWavesDoNotPushAShipWithoutEngine) {
  const std::vector<double> omegas =
      fullSize() ? std::vector<double>{0.4, 0.6, 0.8, 1.0, 1.2} : std::vector<double>{0.6, 1.0};
  std::array<double, 4> worst{};  // surge, sway below 1 rad/s, sway from there, yaw
  for (int degrees = 0; degrees < 360; degrees += fullSize() ? 30 : 120) {
    for (const double omega : omegas) {
      const double heading = (fullSize() ? degrees : degrees + 30) * kDegree;
      const Mean3 mean = meanForce(omega, heading);
      const Vec3 share = mean.value.cwiseAbs() / mean.unit * 100.0;
      const double yaw = share.z() / coarseFrigate()->length();
      const std::string where =
          std::to_string(omega) + " rad/s, heading " + std::to_string(heading / kDegree);
      const bool shortWave = omega > 0.99;
      EXPECT_LE(share.x(), 0.1) << where;
      EXPECT_LE(share.y(), shortWave ? 0.15 : 0.1) << where;
      EXPECT_LE(yaw, 0.1) << where;
      double& sway = worst[shortWave ? 2 : 1];
      worst[0] = std::max(worst[0], share.x());
      sway = std::max(sway, share.y());
      worst[3] = std::max(worst[3], yaw);
    }
  }
  const std::string of = "mean force of a regular wave, no engine, worst of 12 headings, ";
  recordResult(kTopic, of + "surge [% of ½ρga²L]", "0", worst[0], "0.1");
  recordResult(kTopic, of + "sway, ω < 1 [% of ½ρga²L]", "0", worst[1], "0.1");
  recordResult(kTopic, of + "sway, ω >= 1 [% of ½ρga²L]", "0", worst[2], "0.15");
  recordResult(kTopic, of + "yaw [% of ½ρga²L²]", "0", worst[3], "0.1");
}

SeaState roughSea(double heading, std::uint64_t seed) {
  return makeSeaState({.hs = 3.0, .tp = 9.0}, {.heading = heading, .seed = seed, .ramp = 120.0});
}

// Acceptance: below 0.1 m/s in the last five of thirty minutes, and never 100 m away. Only a mean
// force of second order could do more: 0.1 m/s after half an hour is 2e-4 of ½ρg(Hs²/8)L.
TEST(FreeShipGhostIdentity, AnIrregularSeaDoesNotPushAShipWithoutEngine) {
  for (const double degrees : {60.0, 0.0, 90.0, 120.0, 150.0}) {
    for (const std::uint64_t seed : {1, 2}) {
      if (!fullSize() && (degrees != 60.0 || seed != 1)) continue;
      OneShip run(coarseFrigate(), roughSea(degrees * kDegree, seed), freeShip());
      double furthest = 0.0;
      Vec3 place = Vec3::Zero();  // five minutes before the end
      while (run.time() < 1800.0) {
        run.tick();
        if (run.time() < 1500.0) place = run.ship.position();
        furthest = std::max(furthest, run.ship.position().head<2>().norm());
      }
      const double speed = (run.ship.position() - place).head<2>().norm() / 300.0;
      const std::string what = "dead ship, Hs 3 m, Tp 9 s from " + std::to_string(int(degrees)) +
                               " deg, seed " + std::to_string(seed) + ": ";
      recordResult(kTopic, what + "furthest in half an hour [m]", "0", furthest, "100");
      recordResult(kTopic, what + "speed of its last five minutes [m/s]", "0", speed, "0.1");
      EXPECT_LE(furthest, 100.0) << what;
      EXPECT_LE(speed, 0.1) << what;
      EXPECT_EQ(run.seaway.faults(), kStepOk) << what;
    }
  }
}

// Acceptance: 60 m and 0.1 m/s off after ten minutes. 60 m is 1.3 % of the way made; the keeper
// holds the heading, nothing the place or the speed.
TEST(FreeShipGhostIdentity, AnIrregularSeaDoesNotPushAShipUnderWay) {
  constexpr double kSpeed = 8.0;  // [m/s]
  ShipSettings settings = freeShip(kSpeed);
  settings.model.keepCourse = CourseKeeper{};
  OneShip run(coarseFrigate(), roughSea(30.0 * kDegree, 1), settings);
  while (run.time() < 600.0) run.tick();
  const double off =
      std::hypot(run.ship.position().x() - kSpeed * run.time(), run.ship.position().y());
  const double slower = std::abs(run.ship.course().speed() - kSpeed);
  recordResult(kTopic, "8 m/s, Hs 3 m from 30 deg: off its place after 10 minutes [m]", "0", off,
               "60");
  recordResult(kTopic, "8 m/s, Hs 3 m from 30 deg: speed off after 10 minutes [m/s]", "0", slower,
               "0.1");
  EXPECT_LE(off, 60.0);
  EXPECT_LE(slower, 0.1);
}

}  // namespace
}  // namespace cutwater::test
