// What a mesh is taken for: hulls whose axes, unit and waterline are known, laid every way.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "hydro/Errors.h"
#include "hydro/geometry/guess/AxisEvidence.h"
#include "hydro/geometry/guess/HullGuess.h"
#include "hydro/geometry/shapes/Shapes.h"
#include "tests/support/Hulls.h"

namespace cutwater {
namespace {

const std::array<std::string, 6> kAxes{"x", "-x", "y", "-y", "z", "-z"};

Vec3 unit(const std::string& name) {
  return (name.front() == '-' ? -1.0 : 1.0) * Vec3::Unit(name.back() - 'x');
}

// The mesh, x forward and z up, with these axes up and forward instead.
SurfaceMesh laid(SurfaceMesh mesh, const std::string& up, const std::string& forward) {
  Mat3 turn;
  turn << unit(forward), unit(up).cross(unit(forward)), unit(up);
  for (Vec3& p : mesh.vertices) p = turn * p;
  return mesh;
}

SurfaceMesh scaled(SurfaceMesh mesh, double by) {
  for (Vec3& p : mesh.vertices) p *= by;
  return mesh;
}

template <typename Check>
void inAllAxes(const SurfaceMesh& mesh, const Check& check) {
  for (const std::string& up : kAxes)
    for (const std::string& forward : kAxes) {
      if (up.back() == forward.back()) continue;
      SCOPED_TRACE("up " + up + ", forward " + forward);
      check(guessAxes(laid(mesh, up, forward), {}), up, forward);
    }
}

// Open, with a skin of no thickness.
SurfaceMesh bowl() {
  SurfaceMesh open = bothHalves(wetFrigate(40, 8));
  return open;
}

// A box with the first sixth of its length narrowed to a wedge.
SurfaceMesh launch() {
  SurfaceMesh mesh = closedBox({12.0, 3.0, 1.0, 0.8}, 12, 2, 2);
  for (Vec3& p : mesh.vertices)
    if (p.x() > 5.9) p.y() *= 0.05;
  for (Vec3& p : mesh.vertices)
    if (p.z() < -0.9) p.y() *= 0.2;
  return mesh;
}

TEST(HullGuess, AShipWithABowIsFoundInAllTwentyFourPositions) {
  for (const SurfaceMesh& mesh : {closedFrigate(40, 8), bowl(), launch()})
    inAllAxes(mesh, [](const AxesGuess& guess, const std::string& up, const std::string& forward) {
      EXPECT_EQ(guess.up.value, up) << guess.up.reason;
      EXPECT_EQ(guess.forward.value, forward) << guess.forward.reason;
      EXPECT_TRUE(guess.ship);
    });
}

// Fore and aft alike: which end is the bow is habit, and is said to be.
TEST(HullGuess, ADoubleEnderIsUprightAndItsBowIsAGuess) {
  const auto check = [](const AxesGuess& guess, const std::string& up, const std::string& forward) {
    EXPECT_EQ(guess.up.value, up) << guess.up.reason;
    EXPECT_EQ(guess.forward.value.back(), forward.back());
    EXPECT_LT(guess.forward.confidence, 0.8);
  };
  inAllAxes(closedWigley(wigley(3), 0.1, 40, 10), check);
  inAllAxes(closedHalfEllipsoid({60.0, 7.0, 5.0}, 5.0, 40, 10), check);
}

TEST(HullGuess, TwinHullsHaveTheirDeckUp) {
  const SurfaceMesh port = test::moved(test::chinedHull(12, 4, 4, true), {0.0, 10.0, 0.0});
  const SurfaceMesh deck = test::moved(closedBox({50.0, 20.0, 0.5, 0.5}, 10, 4, 1), {-2, 0, 1.6});
  inAllAxes(joined(joined(port, mirroredInY(port)), deck),
            [](const AxesGuess& guess, const std::string& up, const std::string& forward) {
              EXPECT_EQ(guess.up.value, up) << guess.up.reason;
              EXPECT_EQ(guess.forward.value.back(), forward.back());
            });
}

// A box says which axis is up, not which way it points; a cube nothing.
TEST(HullGuess, ABargeLiesFlat) {
  inAllAxes(closedBox({60.0, 16.0, 4.0, 4.0}, 10, 4, 4),
            [](const AxesGuess& guess, const std::string& up, const std::string& forward) {
              EXPECT_EQ(guess.up.value.back(), up.back());
              EXPECT_EQ(guess.forward.value.back(), forward.back());
              EXPECT_LT(guess.up.confidence, 0.95);
            });
}

SurfaceMesh column(double radius, double below, double above, const Vec3& at = Vec3::Zero()) {
  constexpr int n = 24;
  SurfaceMesh mesh;
  for (const double z : {-below, above})
    for (int i = 0; i < n; ++i) {
      const double angle = 2.0 * kPi * i / n;
      mesh.vertices.push_back(at + Vec3(radius * std::cos(angle), radius * std::sin(angle), z));
    }
  mesh.vertices.push_back(at - below * Vec3::UnitZ());
  mesh.vertices.push_back(at + above * Vec3::UnitZ());
  for (int i = 0; i < n; ++i) {
    const int next = (i + 1) % n;
    mesh.faces.push_back({{i, next, n + next, n + i}});
    mesh.faces.push_back({{next, i, 2 * n, -1}});
    mesh.faces.push_back({{n + i, n + next, 2 * n + 1, -1}});
  }
  return mesh;
}

TEST(HullGuess, ASparAndASemiSubmersibleStandAndHaveNoBow) {
  SurfaceMesh platform;
  for (const double x : {-25.0, 25.0})
    for (const double y : {-25.0, 25.0})
      platform = joined(platform, column(6.0, 20.0, 12.0, {x, y, 0.0}));
  for (const SurfaceMesh& mesh : {column(6.0, 20.0, 5.0), platform})
    inAllAxes(mesh, [](const AxesGuess& guess, const std::string& up, const std::string&) {
      EXPECT_EQ(guess.up.value, up) << guess.up.reason;
      EXPECT_FALSE(guess.ship);
      EXPECT_EQ(guess.forward.confidence, 0.5);
    });
}

TEST(HullGuess, SaysWhatTheUserSays) {
  const SurfaceMesh mesh = closedFrigate(20, 6);
  const AxesGuess guess = guessAxes(mesh, {{}, "y", "-x"});
  EXPECT_EQ(guess.up.value, "y");
  EXPECT_EQ(guess.forward.value, "-x");
  EXPECT_EQ(guess.up.confidence, 1.0);
  EXPECT_THROW(guessAxes(mesh, {{}, "x", "-x"}), HydroError);
}

// A sphere says nothing: the habits of the format decide.
TEST(HullGuess, AFormatsHabitDecidesWhereTheShapeSaysNothing) {
  const SurfaceMesh sphere = closedSphere(2.0, 12, 8);
  EXPECT_EQ(guessAxes(sphere, {{"y", "z", "glTF"}, {}, {}}).up.value, "y");
  EXPECT_EQ(guessAxes(sphere, {}).up.value, "z");
}

TEST(HullGuess, UnitsThatMakeAShip) {
  EXPECT_EQ(guessUnit(12.0, false).value, "m");
  EXPECT_EQ(guessUnit(1.5, false).value, "m");      // a model in a tank
  EXPECT_EQ(guessUnit(1115.0, true).value, "cm");   // a boat of 11 m
  EXPECT_EQ(guessUnit(1115.0, false).value, "cm");  // 1.1 m in mm is no boat
  EXPECT_EQ(guessUnit(12000.0, false).value, "mm");
  EXPECT_EQ(guessUnit(12000.0, true).value, "cm");
  EXPECT_EQ(guessUnit(125000.0, false).value, "mm");
  EXPECT_EQ(guessUnit(0.011, false).value, "");
  EXPECT_EQ(guessUnit(1e9, false).value, "");
}

TEST(HullGuess, CalmWaterIsTheFilesZeroWhereThatLiesInTheHull) {
  const SurfaceMesh ship = closedFrigate(40, 8);
  for (const double by : {1.0, 100.0, 1000.0}) {
    const WaterlineGuess drawn = guessWaterline(scaled(ship, by), "z");
    EXPECT_EQ(drawn.height.value, 0.0);
    EXPECT_TRUE(drawn.inFile);
    // Its sides end at 5.5 m over most of the length, within the rise of the forecastle.
    EXPECT_NEAR(drawn.deck, 5.5 * by, 0.2 * by);
  }
  const WaterlineGuess wetOnly = guessWaterline(bothHalves(wetFrigate(40, 8)), "z");
  EXPECT_EQ(wetOnly.height.value, 0.0);
  EXPECT_TRUE(wetOnly.inFile);
}

TEST(HullGuess, AKeelAtZeroHasNoWaterline) {
  const SurfaceMesh ship = test::moved(closedFrigate(40, 8), {0.0, 0.0, 4.97});
  for (const std::string up : {"z", "-y", "x"}) {
    const WaterlineGuess made = guessWaterline(laid(ship, up, up == "x" ? "y" : "x"), up);
    EXPECT_FALSE(made.inFile);
    EXPECT_NEAR(made.height.value, 0.45 * made.deck, 1e-9 * made.deck);
    EXPECT_EQ(made.height.word(), "a guess");
  }
}

// Seen from below a box of 60 × 16 m is full to its bottom: cells of an 80th make no error there.
TEST(HullGuessClosedForm, VolumeFromBelowOfABox) {
  const SurfaceMesh box = closedBox({60.0, 16.0, 4.0, 4.0}, 10, 4, 4);
  EXPECT_NEAR(volumeFromBelow(box, "z", 0.0), 3840.0, 1e-9 * 3840.0);
  EXPECT_NEAR(volumeFromBelow(laid(box, "-y", "z"), "-y", 1.0), 4800.0, 1e-9 * 4800.0);
}

TEST(AxisEvidence, AMirrorImageIsSeenAcrossTheRightAxes) {
  const AxisEvidence ship(closedFrigate(40, 8));
  EXPECT_GT(ship.mirror(1), 0.99);
  EXPECT_LT(ship.mirror(0), 0.6);
  EXPECT_LT(ship.mirror(2), 0.6);
  const AxisEvidence spar(column(6.0, 20.0, 5.0));
  EXPECT_TRUE(spar.turnsAbout(2));
  EXPECT_FALSE(spar.turnsAbout(0));
}

}  // namespace
}  // namespace cutwater
