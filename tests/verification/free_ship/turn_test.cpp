#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "hydro/excitation/ExcitationTable.h"
#include "hydro/forces/FreeResponse.h"
#include "hydro/forces/SeaTables.h"
#include "hydro/waves/Encounter.h"
#include "hydro/waves/Spectrum.h"
#include "tests/support/Results.h"
#include "tests/verification/free_ship/FreeFrigate.h"

// In turns, transients and while it gathers way a free ship feels the sea of the place where it is.
namespace cutwater::test {
namespace {

constexpr double kSpeed = 8.0, kRamp = 60.0, kStraight = 90.0;  // [m/s], [s], [s] before a turn

/// Follows any turn: stiffer than Munk's moment (A₂₂ − A₁₁)U², without a limit.
CourseKeeper helmsman(double heading) {
  return {.heading = std::remainder(heading, 2.0 * kPi), .maxMoment = 1e9};
}

ShipSettings steered(double speed = kSpeed) {
  ShipSettings settings = freeShip(speed);
  settings.model.keepSpeed = SpeedKeeper{.speed = speed, .maxThrust = 5e6};
  settings.model.keepCourse = helmsman(0.0);
  return settings;
}

/// Where the waves are taken less where the hull is.
struct Away {
  double metres = 0.0, degrees = 0.0;
  void see(const Ship& ship) {
    const Vec3 at = ship.position();
    const MeanCourse& course = ship.course();
    metres = std::max(metres, std::hypot(at.x() - course.x(), at.y() - course.y()));
    const double turned = std::remainder(ship.attitude().z() - course.heading(), 2.0 * kPi);
    degrees = std::max(degrees, std::abs(turned) / kDegree);
  }
};

/// A manoeuvre of a ship that has gone straight on: what is done at each tick, and for how long.
struct Manoeuvre {
  std::string name;
  double speed, until;                    // [m/s] at first, [s]
  std::function<void(Ship&, double)> at;  // the time since it begins [s]
};

std::string shortly(double number) {
  char text[24];
  std::snprintf(text, sizeof text, "%g", number);
  return text;
}

std::vector<Manoeuvre> manoeuvres() {
  std::vector<Manoeuvre> all;
  for (const double rate : {0.25, 1.0, 3.0}) {
    all.push_back(
        {"turning at " + shortly(rate) + " deg/s", kSpeed, std::min(400.0, 360.0 / rate),
         [rate](Ship& ship, double time) { ship.keepCourse(helmsman(rate * kDegree * time)); }});
  }
  for (const double acceleration : {0.1, -0.1}) {
    all.push_back({"gathering way at " + shortly(acceleration) + " m/s2",
                   acceleration > 0.0 ? 0.0 : kSpeed, 80.0, [acceleration](Ship& ship, double) {
                     ship.stopKeepingSpeed();
                     const double mass =
                         ship.coefficients().ship.mass +
                         ship.hydrodynamics().freeResponse().addedMassAtRest()(Surge, Surge);
                     const double heading = ship.attitude().z(), force = mass * acceleration;
                     ship.body().applyCentralForce(
                         btVector3(force * std::cos(heading), force * std::sin(heading), 0));
                   }});
  }
  // A rudder's moment and force as far aft as it stands, over at once, over to the other side after
  // 20 s: some 2 degrees a second.
  all.push_back({"rudder steps", kSpeed, 120.0, [](Ship& ship, double time) {
                   ship.stopKeepingCourse();
                   const double side = std::fmod(time, 40.0) < 20.0 ? 4e5 : -4e5;
                   const double heading = ship.attitude().z();
                   ship.body().applyCentralForce(
                       side * btVector3(-std::sin(heading), std::cos(heading), 0));
                   ship.body().applyTorque(btVector3(0, 0, -60.0 * side));
                 }});
  return all;
}

// Acceptance: 0.1 m and 0.1 degrees, ticks of 0.02 s, in waves of a = 0.01 m. The hull's own motion
// in such waves is 0.01 m; what a tick makes is half of 3 degrees/s times 0.02 s, and at 8 m/s
// the turn's acceleration over it, 0.1 mm.
TEST(FreeShipTurnIdentity, WavesAreTakenWhereTheHullIs) {
  const SeaState sea({{0.6, 0.01, 0.0, 0.7}}, kGravity, kRamp);
  for (const Manoeuvre& manoeuvre : manoeuvres()) {
    ShipSettings settings = steered(manoeuvre.speed);
    OneShip run(coarseFrigate(), sea, settings);
    Away away;
    while (run.time() < kStraight + manoeuvre.until) {
      if (run.time() >= kStraight) manoeuvre.at(run.ship, run.time() - kStraight);
      run.tick();
      away.see(run.ship);
    }
    recordResult(kTopic, manoeuvre.name + ", waves of 0.01 m: waves taken off the hull [m]", "0",
                 away.metres, "0.1");
    recordResult(kTopic, manoeuvre.name + ", waves of 0.01 m: heading of that, off [deg]", "0",
                 away.degrees, "0.1");
    EXPECT_LE(away.metres, 0.1) << manoeuvre.name;
    EXPECT_LE(away.degrees, 0.1) << manoeuvre.name;
  }
}

/// Linear theory of a sea at a slow place, heading and way.
class LinearTheory {
 public:
  explicit LinearTheory(const SeaState& sea)
      : sea_(sea),
        tables_(
            SeaTables(coarseFrigate(), std::make_shared<const SeaState>(sea)).following().front()) {
  }

  struct At {
    double x, y, heading, ahead, leeway, time;
  };
  struct Answer {
    Vec6 motion = Vec6::Zero();
    Vec3 weighted = Vec3::Zero();  // x, y, heading in axes of the slow one, by FreeResponse::share
    double leastMet = 1e9;         // [rad/s]
  };
  Answer at(const At& way) const {
    const FreeResponse& response = coarseFrigate()->freeResponse();
    Answer answer;
    for (std::size_t i = 0; i < sea_.components().size(); ++i) {
      const WaveComponent& wave = sea_.components()[i];
      const double beta = wave.heading + way.heading, k = sea_.waveNumber(i);
      const double met =
          Encounter(wave.omega, way.ahead, way.leeway, beta, kGravity).signedFrequency();
      answer.leastMet = std::min(answer.leastMet, std::abs(met));
      const double phase = wave.omega * way.time + wave.phase -
                           k * (way.x * std::cos(wave.heading) - way.y * std::sin(wave.heading));
      const SteadyWay steady{way.ahead, way.leeway};
      const CVec6 found = response.at(met, steady, force(i, way), {}).motion * wave.amplitude;
      const Vec6 now = (found * std::polar(1.0, phase)).real();
      answer.motion += now;
      answer.weighted += response.share(met) * Vec3(now[Surge], now[Sway], now[Yaw]);
    }
    return answer;
  }

 private:
  CVec6 force(std::size_t i, const At& way) const {
    const WaveComponent& wave = sea_.components()[i];
    const HullLiftFactors& lift = coarseFrigate()->freeResponse().lift();
    const auto water = lift.orbital(wave.omega, sea_.waveNumber(i), wave.heading + way.heading);
    CVec6 sum = tables_->froudeKrylov(i, way.heading) +
                tables_->diffraction(i, way.heading, way.ahead, way.leeway);
    sum[Sway] += std::abs(way.ahead) * lift.side * water.side;
    sum[Yaw] += std::abs(way.ahead) * lift.turn * water.turn;
    return sum;
  }
  SeaState sea_;
  std::shared_ptr<const ExcitationTable> tables_;
};

struct Turn {
  double correlation = 0.0;  // of heave
  double beyond = 0.0;       // [m] that the waves are taken off the hull, beyond linear theory's
  double apart = 0.0;        // [m] of the two ways off, as vectors
  bool finite = true;
};

/// A turn at a steady rate, from a straight course on; heave is compared where ω_e ≥ 0.3.
Turn turn(const SeaState& sea, double rate) {
  const LinearTheory theory(sea);
  OneShip run(coarseFrigate(), sea, steered());
  double both = 0.0, found = 0.0, linear = 0.0;
  Turn result;
  const double until = kStraight + 60.0 + std::min(fullSize() ? 1440.0 : 360.0, 360.0 / rate);
  for (int i = 0; run.time() < until; ++i) {
    if (run.time() > kStraight)
      run.ship.keepCourse(helmsman(rate * kDegree * (run.time() - kStraight)));
    run.tick();
    if (run.time() < kStraight || i % 10 != 0) continue;
    const MeanCourse& course = run.ship.course();
    const auto answer = theory.at(
        {course.x(), course.y(), course.heading(), course.speed(), course.leeway(), run.time()});
    if (answer.leastMet < 0.3 && sea.components().size() == 1) continue;
    const double heave = run.ship.position().z() - coarseFrigate()->ship().cog.z();
    both += heave * answer.motion[Heave];
    found += heave * heave;
    linear += answer.motion[Heave] * answer.motion[Heave];
    const double c = std::cos(course.heading()), s = std::sin(course.heading());
    const Vec3 off = run.ship.position() - Vec3(course.x(), course.y(), 0.0);
    const Eigen::Vector2d way(c * off.x() + s * off.y(), c * off.y() - s * off.x());
    const Eigen::Vector2d predicted = answer.weighted.head<2>();
    result.beyond = std::max(result.beyond, way.norm() - predicted.norm());
    result.apart = std::max(result.apart, (way - predicted).norm());
    result.finite = result.finite && std::isfinite(heave);
  }
  result.correlation = both / std::sqrt(found * linear);
  return result;
}

void record(const std::string& where, const Turn& found, double least) {
  char bound[32] = "stated";
  if (least > 0.0) std::snprintf(bound, sizeof bound, ">= %g", least);
  recordResult(kTopic, where + ": correlation of heave", "1", found.correlation, bound);
  recordResult(kTopic, where + ": waves taken off the hull beyond linear theory's [m]", "0",
               found.beyond, "0.1");
  recordResult(kTopic, where + ": the two ways off, apart [m]", "0", found.apart, "stated");
}

// Acceptance: heave correlates with linear theory at the slow place by 0.999 where ω ≤ 0.6, and the
// waves are taken no more than 0.1 m further off than linear theory has the hull move. A wave of
// 0.8 rad/s is shorter than the ship, which hardly heaves in it: stated.
TEST(FreeShipTurnIdentity, HeaveIsThatOfTheWaveUnderTheShip) {
  for (const double omega : {0.4, 0.5, 0.6, 0.8}) {
    for (const double rate : {0.25, 1.0, 3.0}) {
      if (!fullSize() && omega != 0.6) continue;
      const Turn found = turn(SeaState({{omega, 1.0, 0.3, 0.0}}, kGravity, kRamp), rate);
      char where[80];
      std::snprintf(where, sizeof where, "turning at %g deg/s, a = 1 m, omega %g", rate, omega);
      record(where, found, omega < 0.7 ? 0.999 : 0.0);
      EXPECT_GE(found.correlation, omega < 0.7 ? 0.999 : 0.0) << where;
      EXPECT_LE(found.beyond, 0.1) << where;
    }
  }
}

// The same in an irregular sea up to 0.8 rad/s, by 0.995.
TEST(FreeShipTurnIdentity, HeaveIsThatOfTheSeaUnderTheShip) {
  const SeaState sea =
      makeSeaState({.hs = 3.0, .tp = 9.0}, {.components = 150, .omegaMax = 0.8, .ramp = kRamp});
  for (const double rate : {0.25, 1.0, 3.0}) {
    if (!fullSize() && rate != 3.0) continue;
    const Turn found = turn(sea, rate);
    char where[80];
    std::snprintf(where, sizeof where, "turning at %g deg/s, Hs 3 m up to 0.8 rad/s", rate);
    record(where, found, 0.995);
    EXPECT_GE(found.correlation, 0.995) << where;
    EXPECT_LE(found.beyond, 0.1) << where;
    EXPECT_TRUE(found.finite) << where;
  }
}

// Acceptance: a full turn at 8 m/s in Hs 3 m, through ω_e = 0 of every component, stays finite: no
// fault bit, upright to 30 degrees, never faster than half as much again.
TEST(FreeShipTurnIdentity, AFullTurnInARoughSeaStaysFinite) {
  const SeaState sea =
      makeSeaState({.hs = 3.0, .tp = 9.0}, {.heading = 0.5, .components = 150, .ramp = kRamp});
  OneShip run(coarseFrigate(), sea, steered());
  double tilt = 0.0, fastest = 0.0;
  while (run.time() < kStraight + 420.0) {
    if (run.time() > kStraight)
      run.ship.keepCourse(helmsman(std::min(360.0, run.time() - kStraight) * kDegree));
    run.tick();
    const Vec3 attitude = run.ship.attitude();
    tilt = std::max(tilt, std::hypot(attitude.x(), attitude.y()) / kDegree);
    fastest = std::max(fastest, run.ship.velocity().head<2>().norm());
  }
  recordResult(kTopic, "full turn at 8 m/s, Hs 3 m: largest tilt [deg]", "finite", tilt, "30");
  recordResult(kTopic, "full turn at 8 m/s, Hs 3 m: largest speed [m/s]", "finite", fastest, "12");
  EXPECT_LE(tilt, 30.0);
  EXPECT_LE(fastest, 1.5 * kSpeed);
  EXPECT_EQ(run.seaway.faults(), kStepOk);
  EXPECT_NEAR(run.ship.attitude().z(), 0.0, 3.0 * kDegree);
}

}  // namespace
}  // namespace cutwater::test
