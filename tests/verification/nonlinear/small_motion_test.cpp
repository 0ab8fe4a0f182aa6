#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "hydro/geometry/shapes/Shapes.h"
#include "hydro/geometry/wetted/PressureMesh.h"
#include "hydro/geometry/wetted/SymmetricTriangles.h"
#include "tests/support/Results.h"
#include "tests/verification/nonlinear/NonlinearShip.h"

// In small waves the nonlinear ship does what the linear one does, but for the square of their
// amplitude. Panels and wetted mesh are the same flat triangles, so that F_I, C and the pressure
// are of one surface. Nothing is thrown back, and added mass and damping are the same.
namespace cutwater::test {
namespace {

constexpr double kGravity = 9.81, kTick = 0.05, kRamp = 60.0, kFrom = 240.0;  // [s]
constexpr double kOmega = 0.7;                                                // waves of 126 m
constexpr double kFixedLeast = 0.025, kFreeLeast = 0.01;  // lowest amplitude [m]; others 2, 4 times
constexpr std::size_t kHeights = 3;
constexpr int kMany = 1000000;  // triangles: never thinned

// A Wigley hull of 100 m, wall-sided above water; its triangles divided further for the pressure.
std::shared_ptr<const Hydrodynamics> wigleyShip(double edge) {
  const WigleyShape shape{100.0, 14.0, 6.0, 0.0};
  Coefficients c = bareCoefficients({.closed = symmetricTriangles(closedWigley(shape, 5.0, 40, 8)),
                                     .cog = Vec3(0.0, 0.0, -1.0),
                                     .gyradii = Vec3(5.0, 25.0, 25.0),
                                     .gravity = kGravity});
  const double inertia = c.ship.massMatrix()(Roll, Roll), stiffness = c.ship.restoring(Roll, Roll);
  c.ship.supplementary.damping[Roll] = 0.2 * std::sqrt(stiffness * inertia);
  c.ship.hull = refined(c.ship.hull, edge, kMany).mesh;
  return std::make_shared<const Hydrodynamics>(std::move(c));
}

struct Passage {
  Mean mean;
  double speed, heading;  // [m/s], β [deg]
};

double metAt(const Passage& passage) {
  const double k = kOmega * kOmega / kGravity;
  return std::abs(kOmega - k * passage.speed * std::cos(passage.heading * kPi / 180.0));
}

/// Over one period of encounter: rows are times, columns modes.
using Motions = Eigen::Matrix<double, Eigen::Dynamic, 6>;

Motions motionsOf(const std::shared_ptr<const Hydrodynamics>& ship, const Passage& passage,
                  double amplitude, HullPressure mode) {
  ShipSettings settings;
  settings.model.mean = passage.mean;
  settings.model.mode = mode;
  settings.model.hullTriangles = kMany;
  settings.model.hullLift = settings.model.resistance = false;
  if (passage.mean == Mean::Fixed)
    settings.model.restrained = {true, true, false, false, false, true};
  if (passage.mean == Mean::Free) {
    settings.model.keepCourse = CourseKeeper{};
    if (passage.speed > 0.0) settings.model.keepSpeed = SpeedKeeper{.speed = passage.speed};
  }
  settings.start.speed = passage.speed;
  const WaveComponent wave{
      .omega = kOmega, .amplitude = amplitude, .heading = passage.heading * kPi / 180.0};
  OneShip run(ship, SeaState({wave}, kGravity, kRamp), settings);
  while (run.seaway.time() < kFrom) run.tick(kTick);
  Motions motions(std::lround(2.0 * kPi / metAt(passage) / kTick), 6);
  for (Eigen::Index i = 0; i < motions.rows(); ++i) {
    run.tick(kTick);
    const Vec3 way(passage.speed * run.seaway.time(), 0.0, ship->ship().cog.z());
    motions.row(i) << (run.ship.position() - way).transpose(), run.ship.attitude().transpose();
  }
  EXPECT_EQ(run.seaway.faults(), kStepOk);
  return motions;
}

Vec6 largest(const Motions& motions) { return motions.cwiseAbs().colwise().maxCoeff(); }

/// d = c₁a + c₂a² + c₃a³ of three amplitudes, each once, twice and four times.
struct Difference {
  Vec6 linear;         // motion of the linear ship in the lowest waves
  Vec6 first, second;  // |c₁a| and |c₂a²| there
  Vec6 ratio;          // of d(4a) − 2d(2a) to d(2a) − 2d(a): 4 of what is quadratic
};

Difference differenceOf(const std::shared_ptr<const Hydrodynamics>& ship, const Passage& passage) {
  const Motions still = motionsOf(ship, passage, 0.0, HullPressure::Nonlinear);
  std::array<Motions, kHeights> d;
  Difference result;
  for (std::size_t i = 0; i < kHeights; ++i) {
    const double least = passage.mean == Mean::Free ? kFreeLeast : kFixedLeast;
    const double amplitude = least * static_cast<double>(1 << i);
    const Motions linear = motionsOf(ship, passage, amplitude, HullPressure::Linear);
    d.at(i) = motionsOf(ship, passage, amplitude, HullPressure::Nonlinear) - linear - still;
    if (i == 0) result.linear = largest(linear);
  }
  const Motions once = d[1] - 2.0 * d[0], twice = d[2] - 2.0 * d[1];  // 2c₂ + 6c₃, 8c₂ + 48c₃
  const Motions third = (twice - 4.0 * once) / 24.0, second = 0.5 * (once - 6.0 * third);
  result.first = largest(d[0] - second - third);
  result.second = largest(second);
  result.ratio = largest(twice).cwiseQuotient(largest(once));
  return result;
}

// Surge, sway and yaw are held: heave, roll and pitch, where the waves move them at all.
bool moves(const Difference& d, int mode) {
  return mode >= Heave && mode <= Pitch && d.linear[mode] > 1e-9;
}

std::string nameOf(const Passage& passage, int mode) {
  char name[80];
  std::snprintf(name, sizeof name, "%g m/s, %g deg, %s", passage.speed, passage.heading,
                kModeNames[mode]);
  return name;
}

// Acceptance: the difference falls with the square of the amplitude. With 2.5, 5 and 10 cm, what is
// not linear of it is four times as large in waves twice as high; to 0.3, as the cube of the
// amplitude has 5 % of it. What is linear of it is the pressure that is taken linear over a
// triangle, and no more.
TEST(SmallMotionConvergence, NonlinearLessLinearFallsWithTheSquareOfTheWaves) {
  const auto ship = wigleyShip(2.0);
  const double missed = linearPressureError(2.0, kOmega * kOmega / kGravity);  // 8e-4
  for (const double speed : {0.0, 8.0}) {
    for (const double heading : {180.0, 120.0, 60.0, 90.0}) {
      const bool inShort = (speed == 0.0) == (heading == 180.0) && heading != 90.0;
      if (!fullSize() && (!inShort || heading == 120.0)) continue;
      const Passage passage{Mean::Fixed, speed, heading};
      const Difference d = differenceOf(ship, passage);
      for (int mode = 0; mode < 6; ++mode) {
        if (!moves(d, mode)) continue;
        const std::string name = nameOf(passage, mode);
        recordResult(kTopic, "nonlinear less linear, " + name + ": growth in waves twice as high",
                     "4", d.ratio[mode], "4 +- 0.3");
        recordResult(kTopic,
                     "nonlinear less linear, " + name + ": part linear in the wave, of motion", "0",
                     d.first[mode] / d.linear[mode], "(kh)^2/12 = 8.3e-4");
        EXPECT_NEAR(d.ratio[mode], 4.0, 0.3) << name;
        EXPECT_LT(d.first[mode], missed * d.linear[mode]) << name;
      }
    }
  }
}

// A free ship, kept on its course, in all six modes. It drifts by the square of the waves, and what
// they do to a ship elsewhere is of the cube: from 1 cm on the difference falls with the square at
// least, and what is linear of it is the pressure again.
TEST(SmallMotionConvergence, SoItDoesForAFreeShip) {
  const auto ship = wigleyShip(2.0);
  const double missed = linearPressureError(2.0, kOmega * kOmega / kGravity);  // 8e-4
  for (const double speed : {0.0, 8.0}) {
    for (const double heading : {180.0, 120.0, 60.0, 90.0}) {
      if (!fullSize() && !(speed > 0.0 && heading == 120.0)) continue;
      const Passage passage{Mean::Free, speed, heading};
      const Difference d = differenceOf(ship, passage);
      for (int mode = 0; mode < 6; ++mode) {
        if (!(d.linear[mode] > 1e-9)) continue;
        const std::string name = "free, " + nameOf(passage, mode);
        recordResult(kTopic, "nonlinear less linear, " + name + ": growth in waves twice as high",
                     ">= 4", d.ratio[mode], "4 - 0.5");
        recordResult(kTopic,
                     "nonlinear less linear, " + name + ": part linear in the wave, of motion", "0",
                     d.first[mode] / d.linear[mode], "(kh)^2/12 = 8.3e-4");
        EXPECT_GT(d.ratio[mode], 3.5) << name;
        EXPECT_LT(d.first[mode], missed * d.linear[mode]) << name;
      }
    }
  }
}

// Half the edges leave a quarter of what is linear, but for the water's single precision: 2e-6 of
// the pressure, and forces of waves are some ten times smaller than their parts.
TEST(SmallMotionConvergence, TheRestIsThePressureTakenLinear) {
  const Passage passage{Mean::Fixed, 8.0, 120.0};
  const Difference coarse = differenceOf(wigleyShip(2.0), passage);
  const Difference fine = differenceOf(wigleyShip(1.0), passage);
  for (const Mode mode : {Heave, Roll, Pitch}) {
    const std::string name = nameOf(passage, mode);
    const double before = coarse.first[mode] / coarse.linear[mode];
    const double after = fine.first[mode] / fine.linear[mode];
    recordResult(kTopic,
                 "nonlinear less linear, " + name + ", edges of 1 m: part linear in the wave",
                 "a quarter of " + std::to_string(before), after, "+ 2e-5");
    EXPECT_LT(after, 0.25 * before + 2e-5) << name;
  }
}

}  // namespace
}  // namespace cutwater::test
