#include <gtest/gtest.h>

#include "hydro/Errors.h"
#include "hydro/database/ChangeOfLoading.h"
#include "hydro/geometry/shapes/Shapes.h"
#include "hydro/ship/Afloat.h"
#include "hydro/solve/Solve.h"

namespace cutwater {
namespace {

constexpr double kRho = 1000.0, kG = 9.81;

// A box of 64 panels a side; whole: solved without symmetry.
ShipParticulars box(const Vec3& cog, bool whole) {
  PanelledHull hull{{}, wetBox({20.0, 6.0, 2.0, 1.0}, 8, 3, 2), true};
  if (whole) hull = {{}, wholeWet(hull), false};
  return afloat(hull, {.cog = cog, .gyradii = Vec3(2.0, 5.0, 5.0)}, {kRho, kG}).ship;
}

Coefficients solvedAbout(const Vec3& cog, bool whole) {
  SolveSettings settings;
  settings.forwardSpeed = ForwardSpeedForm::Report;
  settings.omega = {0.6, 1.4};
  settings.headings = {0.7, kPi};
  settings.threads = 2;
  return solve(box(cog, whole), settings);
}

double distance(const Mat6& a, const Mat6& b) {
  return (a - b).cwiseAbs().maxCoeff() / std::max(1e-300, b.cwiseAbs().maxCoeff());
}

double distance(const Coefficients::AdjointVectors& a, const Coefficients::AdjointVectors& b) {
  if (a.cols() != b.cols()) return HUGE_VAL;
  return a.cols() == 0 ? 0.0 : (a - b).cwiseAbs().maxCoeff() / b.cwiseAbs().maxCoeff();
}

// Two linear systems solved with other right-hand sides: round-off of the solver,
// 1e-13 × condition.
constexpr double kSolver = 1e-10;

void expectSame(const Coefficients& a, const Coefficients& b) {
  EXPECT_LT(distance(a.ship.restoring, b.ship.restoring), 1e-12);
  const auto expectNear = [](const auto& one, const auto& other) {
    ASSERT_EQ(one.size(), other.size());
    for (std::size_t i = 0; i < one.size(); ++i) EXPECT_LT(distance(one[i], other[i]), kSolver);
    EXPECT_LT(distance(one.atZero, other.atZero), kSolver);
    EXPECT_LT(distance(one.atInfinity, other.atInfinity), kSolver);
  };
  for (const auto quantity : {&Coefficients::addedMass, &Coefficients::damping,
                              &Coefficients::addedMassX, &Coefficients::dampingX})
    expectNear(a.*quantity, b.*quantity);
  for (const auto vectors : {&Coefficients::adjoint, &Coefficients::adjointX})
    expectNear(a.*vectors, b.*vectors);
  for (std::size_t h = 0; h < a.headings.size(); ++h) {
    for (std::size_t i = 0; i < a.omega.size(); ++i) {
      EXPECT_LT((a.diffraction[h][i] - b.diffraction[h][i]).norm(),
                kSolver * b.diffraction[h][i].norm());
      EXPECT_LT((a.froudeKrylov[h][i] - b.froudeKrylov[h][i]).norm(),
                1e-6 * b.froudeKrylov[h][i].norm());  // what its quadrature promises
    }
  }
}

TEST(LoadingIdentity, AnotherCentreOfGravityIsAnotherSolution) {
  // From a centre half a metre ahead of that of buoyancy, at z = 1, to one over it at 0.2.
  const Coefficients before = solvedAbout({0.5, 0.0, 1.0}, false);
  const Coefficients after =
      withLoading(before, before.ship.mass, {0.0, 0.0, 0.2}, Vec3(1.5, 6.0, 6.0));
  expectSame(after, solvedAbout({0.0, 0.0, 0.2}, false));
  EXPECT_EQ(after.ship.cog, Vec3(0.0, 0.0, 0.2));
  EXPECT_EQ(after.ship.gyradii, Vec3(1.5, 6.0, 6.0));
}

TEST(LoadingIdentity, AWholeHullMayAlsoMoveItSideways) {
  const Coefficients before = solvedAbout({0.0, 0.3, 1.0}, true);
  const Coefficients after =
      withLoading(before, before.ship.mass, {0.0, -0.1, 0.2}, before.ship.gyradii);
  expectSame(after, solvedAbout({0.0, -0.1, 0.2}, true));
}

TEST(LoadingIdentity, TablesOfDiffractionForcesMoveWithTheForcesThemselves) {
  Coefficients before = solvedAbout({0.5, 0.0, 1.0}, false);
  before.diffractionTable = {{0.0}, before.headings, before.omega, {}};
  for (std::size_t h = 0; h < 2; ++h) {
    for (std::size_t i = 0; i < 2; ++i)
      before.diffractionTable.values.push_back(before.diffraction[h][i]);
  }
  const Coefficients after =
      withLoading(before, before.ship.mass, {0.1, 0.0, 0.2}, before.ship.gyradii);
  for (std::size_t h = 0; h < 2; ++h) {
    for (std::size_t i = 0; i < 2; ++i)
      EXPECT_EQ(after.diffractionTable.at(0, h, i), after.diffraction[h][i]);
  }
}

TEST(Loading, WhatWasFoundOfTheLoadingBeforeIsForgotten) {
  Coefficients ship;
  ship.ship = box({0.0, 0.0, 1.0}, false);
  ship.stability.checkedTo = 10.0;
  const ShipParticulars& is = ship.ship;
  EXPECT_EQ(withLoading(ship, is.mass, is.cog, 1.1 * is.gyradii).stability.checkedTo, 0.0);
}

TEST(Loading, RefusesWhatFloatsOnAnotherWaterline) {
  Coefficients ship;
  ship.ship = box({0.0, 0.0, 1.0}, false);
  const Vec3 cog = ship.ship.cog, gyradii = ship.ship.gyradii;
  const double mass = ship.ship.mass;
  const auto refused = [&](double m, const Vec3& g, const Vec3& r, Fault fault, const char* word) {
    try {
      withLoading(ship, m, g, r);
      ADD_FAILURE() << word << " was accepted";
    } catch (const HydroError& error) {
      EXPECT_EQ(error.fault(), fault);
      EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
    }
  };
  refused(1.002 * mass, cog, gyradii, Fault::ValueOutOfRange, "+0.20 %");
  refused(-1.0, cog, gyradii, Fault::ValueOutOfRange, "mass = -1");
  refused(mass, {0.5, 0.0, 1.0}, gyradii, Fault::ValueOutOfRange, "trim");
  refused(mass, {0.0, 0.5, 1.0}, gyradii, Fault::ValueOutOfRange, "heel");
  // Within 0.1 % of the beam of 6 m.
  refused(mass, {0.0, 0.005, 1.0}, gyradii, Fault::BadArgument, "half a hull");
  refused(mass, cog, {0.0, 5.0, 5.0}, Fault::ValueOutOfRange, "roll = 0");
  EXPECT_NO_THROW(withLoading(ship, 1.0005 * mass, {0.01, 0.0, -1.0}, gyradii));
}

}  // namespace
}  // namespace cutwater
