#include <gtest/gtest.h>

#include "hydro/Errors.h"
#include "hydro/bem/BuildCoefficients.h"
#include "hydro/geometry/panels/WetSurface.h"
#include "tests/bem/Bodies.h"

namespace cutwater::test {
namespace {

ShipParticulars smallShip() {
  ShipParticulars ship;
  ship.wetSurface = wetHalfEllipsoid({10.0, 3.0, 2.0}, 8, 4);
  ship.symmetric = true;
  ship.cog = Vec3(0.3, 0.0, -0.2);
  return ship;
}

SolveSettings fewFrequencies(int threads) {
  SolveSettings settings;
  settings.forwardSpeed = ForwardSpeedForm::Report;
  settings.omega = {0.4, 0.9, 1.5, 2.2, 3.0};
  settings.headings = {kPi, 2.0};
  settings.threads = threads;
  return settings;
}

TEST(BuildCoefficientsIdentity, SameBitsWhateverTheNumberOfThreads) {
  const SolverOutput one = buildCoefficients(smallShip(), fewFrequencies(1));
  const SolverOutput three = buildCoefficients(smallShip(), fewFrequencies(3));
  for (std::size_t i = 0; i < one.omega.size(); ++i) {
    EXPECT_EQ(one.addedMass[i], three.addedMass[i]);
    EXPECT_EQ(one.damping[i], three.damping[i]);
    EXPECT_EQ(one.dampingX[i], three.dampingX[i]);
    EXPECT_EQ(one.diffraction[1][i], three.diffraction[1][i]);
    EXPECT_EQ(one.adjoint[i], three.adjoint[i]);
    EXPECT_EQ(one.conditionOdd[i], three.conditionOdd[i]);
  }
  EXPECT_EQ(one.addedMass.atInfinity, three.addedMass.atInfinity);
}

// Stopped after two frequencies, gone on with by another number of threads.
TEST(BuildCoefficientsIdentity, SameBitsWhenInterruptedAndResumed) {
  const std::string journal = ::testing::TempDir() + "resumed.sweep";
  std::remove(journal.c_str());
  const SolverOutput whole = buildCoefficients(smallShip(), fewFrequencies(1));
  struct Stop {};
  const auto stopAtTwo = [](int done, int) {
    if (done == 2) throw Stop{};
  };
  EXPECT_THROW(buildCoefficients(smallShip(), fewFrequencies(1), stopAtTwo, journal), Stop);
  int first = -1;
  const auto noteFirst = [&first](int done, int) { first = first < 0 ? done : first; };
  const SolverOutput resumed =
      buildCoefficients(smallShip(), fewFrequencies(2), noteFirst, journal);
  EXPECT_EQ(first, 2);
  for (std::size_t i = 0; i < whole.omega.size(); ++i) {
    EXPECT_EQ(whole.addedMass[i], resumed.addedMass[i]);
    EXPECT_EQ(whole.dampingX[i], resumed.dampingX[i]);
    EXPECT_EQ(whole.froudeKrylov[1][i], resumed.froudeKrylov[1][i]);
    EXPECT_EQ(whole.diffraction[0][i], resumed.diffraction[0][i]);
    EXPECT_EQ(whole.adjoint[i], resumed.adjoint[i]);
    EXPECT_EQ(whole.adjointX[i], resumed.adjointX[i]);
    EXPECT_EQ(whole.conditionOdd[i], resumed.conditionOdd[i]);
  }
  std::remove(journal.c_str());
}

TEST(BuildCoefficientsIdentity, AdjointVectorsReproduceTheDiffractionTable) {
  const SolverOutput c = buildCoefficients(smallShip(), fewFrequencies(2));
  const PanelMesh mesh = c.wet().panels();
  for (std::size_t h = 0; h < c.headings.size(); ++h)
    for (std::size_t i = 0; i < c.omega.size(); ++i) {
      const AiryWave wave{c.omega[i], c.headings[h], c.ship.gravity};
      const CVec6 fast = c.omega[i] * diffractionForce(c.adjoint[i], mesh, wave, c.ship.cog);
      EXPECT_LT((fast - c.diffraction[h][i]).norm(), 1e-10 * fast.norm());  // round-off
    }
}

// A heavier port side couples the parities; the hull is then solved whole. With G moved by d from
// the centre plane all is as there, transferred: A_33 unchanged, A_34 = −A_33·… from the shift of
// moments.
TEST(BuildCoefficientsIdentity, OffCentreGravityIsSolvedByTheWholeHull) {
  ShipParticulars ship = smallShip();
  SolveSettings settings = fewFrequencies(2);
  settings.lid = false;  // the lid of the whole hull need not be twice that of the half
  const SolverOutput centred = buildCoefficients(ship, settings);
  const double off = 0.25;
  ship.cog.y() = off;
  const SolverOutput shifted = buildCoefficients(ship, settings);
  EXPECT_FALSE(shifted.ship.symmetric);
  EXPECT_EQ(shifted.ship.wetSurface.faces.size(), 2 * ship.wetSurface.faces.size());
  EXPECT_TRUE(shifted.conditionOdd.empty());
  for (std::size_t i = 0; i < shifted.omega.size(); ++i) {
    const Mat6 &A = centred.addedMass[i], &moved = shifted.addedMass[i];
    const double scale = 1e-9 * A.norm();  // round-off
    EXPECT_NEAR(moved(Heave, Heave), A(Heave, Heave), scale);
    EXPECT_NEAR(moved(Roll, Heave), -off * A(Heave, Heave), scale);  // (y − off) n_3
    EXPECT_NEAR(moved(Yaw, Surge), off * A(Surge, Surge), scale);    // −(y − off) n_1
  }
}

TEST(BuildCoefficients, ReportsProgressToTheEnd) {
  int calls = 0, last = 0;
  buildCoefficients(smallShip(), fewFrequencies(2), [&](int done, int total) {
    ++calls;
    last = done;
    EXPECT_EQ(total, 5);
  });
  EXPECT_EQ(calls, 6);
  EXPECT_EQ(last, 5);
}

TEST(BuildCoefficients, StopsWhenProgressThrows) {
  EXPECT_THROW(buildCoefficients(smallShip(), fewFrequencies(2),
                                 [](int, int) { throw std::runtime_error("enough"); }),
               std::runtime_error);
}

TEST(BuildCoefficients, RefusesWhatItCannotSolve) {
  const auto fault = [](const ShipParticulars& ship, std::vector<double> omega,
                        std::vector<double> headings) {
    SolveSettings settings;
    settings.omega = std::move(omega);
    settings.headings = std::move(headings);
    try {
      buildCoefficients(ship, settings);
    } catch (const HydroError& error) {
      return error.fault();
    }
    return Fault::FileNotReadable;  // stands for "accepted"
  };
  EXPECT_EQ(fault(smallShip(), {}, {}), Fault::BadArgument);
  EXPECT_EQ(fault(smallShip(), {0.0}, {}), Fault::ValueOutOfRange);
  EXPECT_EQ(fault(smallShip(), {1.0, 1.0}, {}), Fault::FrequenciesNotIncreasing);
  EXPECT_EQ(fault(smallShip(), {1.0, NAN}, {}), Fault::ValueOutOfRange);
  EXPECT_EQ(fault(smallShip(), {1.0}, {NAN}), Fault::ValueOutOfRange);
  EXPECT_EQ(fault(ShipParticulars{}, {1.0}, {}), Fault::MeshEmpty);
  ShipParticulars heavy = smallShip();
  heavy.density = 0.0;
  EXPECT_EQ(fault(heavy, {1.0}, {}), Fault::ValueOutOfRange);
}

}  // namespace
}  // namespace cutwater::test
