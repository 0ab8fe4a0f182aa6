#include <gtest/gtest.h>

#include "hydro/bem/reference/DiffractionSweep.h"
#include "hydro/database/ForwardSpeed.h"
#include "tests/bem/Bodies.h"

// The table of solved conditions, against systems solved one by one. What interpolation between
// frequencies costs is in diffraction_sweep_test.cpp.
namespace cutwater::test {
namespace {

/// A half ellipsoid of 32 panels a side with its lid, and what belongs to it.
struct SmallSweep {
  ShipParticulars ship;
  InfluenceMatrices matrices;
  ModeNormals normals;
  XDerivative stokes;
  SolveSettings settings;

  explicit SmallSweep(Influence influence)
      : ship(particulars()),
        matrices(panels(ship.wetSurface, true, true)),
        normals(matrices.mesh(), ship.cog),
        stokes(ship.wetSurface, matrices.mesh()) {
    settings.forwardSpeed = ForwardSpeedForm::Report;
    settings.influence = influence;
    settings.speeds = {0.0, 3.0};
    settings.headings = {0.4, 2.5};
    settings.waveOmega = {0.7, 1.3};
  }
  static ShipParticulars particulars() {
    ShipParticulars ship;
    ship.wetSurface = wetHalfEllipsoid({10.0, 3.0, 2.0}, 8, 4);
    ship.symmetric = true;
    ship.cog = Vec3(0.3, 0.0, -0.2);
    return ship;
  }
  DiffractionTable solve(const std::vector<double>& grid, int threads = 1) const {
    return solveDiffractionTable({matrices, normals, stokes, ship}, settings, grid, threads);
  }
  /// One condition by itself, from its own system.
  CVec6 condition(double speed, double heading, double omega) const {
    const AiryWave wave{omega, heading, ship.gravity};
    const Encounter met(wave, speed);
    const double omegaE = met.frequency();
    const auto system = systemAt(matrices, omegaE * omegaE / ship.gravity);
    const IncidentVelocity v =
        atEncounter(incidentNormalVelocity(matrices.mesh(), wave, ship.cog), met);
    const bool tuck = settings.forwardSpeed == ForwardSpeedForm::Tuck;
    const DiffractionParts parts =
        diffraction(system, normals, {v}, ship.density, tuck ? nullptr : &stokes).front();
    return met.diffractionForce(parts.omega, tuck ? tuckSpeedForce(parts.omega) : parts.speed);
  }
};

double worstOf(const DiffractionTable& a, const DiffractionTable& b) {
  double error = 0.0, size = 0.0;
  for (std::size_t i = 0; i < a.values.size(); ++i) {
    error = std::max(error, (a.values[i] - b.values[i]).norm());
    size = std::max(size, a.values[i].norm());
  }
  return error / size;
}

// Two ways through systems of condition 1e2, backward errors of 1e-10 (Factorization.h).
constexpr double kOneSystem = 1e-8;

// Each force stands where speed, heading and frequency say, in both forms, with the ship overtaking
// none, some or all of the waves.
TEST(DiffractionTableIdentity, EveryConditionIsItsOwnSolution) {
  for (const ForwardSpeedForm form : {ForwardSpeedForm::Report, ForwardSpeedForm::Tuck}) {
    SmallSweep sweep(Influence::Direct);
    sweep.settings.forwardSpeed = form;
    sweep.settings.speeds = {0.0, 3.0, 20.0};  // 20 m/s in following seas of 0.7 rad/s: ω′ < 0
    const DiffractionTable table = sweep.solve({});
    ASSERT_EQ(table.values.size(), 12u);
    EXPECT_LT(Encounter(0.7, 20.0, 0.4, sweep.ship.gravity).signedFrequency(), 0.0);
    for (std::size_t s = 0; s < 3; ++s)
      for (std::size_t h = 0; h < 2; ++h)
        for (std::size_t w = 0; w < 2; ++w) {
          const CVec6 alone =
              sweep.condition(table.speeds[s], table.headings[h], table.waveOmega[w]);
          EXPECT_LT((table.at(s, h, w) - alone).norm(), kOneSystem * alone.norm()) << s << h << w;
        }
  }
}

// At the frequencies of the grid nothing is interpolated: all three ways are one. At rest ω_e is
// ω_I.
TEST(DiffractionTableIdentity, GridFrequenciesAreMetExactly) {
  const auto atRest = [](Influence influence) {
    SmallSweep sweep(influence);
    sweep.settings.speeds = {0.0};
    return sweep.solve({0.7, 1.3, 2.0});
  };
  const DiffractionTable direct = atRest(Influence::Direct);
  EXPECT_LT(worstOf(direct, atRest(Influence::Matrix)), kOneSystem);
  EXPECT_LT(worstOf(direct, atRest(Influence::Inverse)), kOneSystem);
}

// Between them something is: halved steps leave a quarter, of matrices and of inverses alike.
TEST(DiffractionTableConvergence, OfSecondOrderInTheStepOfTheGrid) {
  for (const Influence influence : {Influence::Matrix, Influence::Inverse}) {
    const auto error = [influence](double step) {
      SmallSweep direct(Influence::Direct), sweep(influence);
      for (SmallSweep* one : {&direct, &sweep}) {
        one->settings.speeds = {0.0};
        one->settings.waveOmega = {1.0};
      }
      return worstOf(direct.solve({}), sweep.solve({1.0 - 0.5 * step, 1.0 + 0.5 * step}));
    };
    const double coarse = error(0.2), fine = error(0.1);
    EXPECT_NEAR(std::log2(coarse / fine), 2.0, 0.2);
    EXPECT_LT(fine, 0.01);
  }
}

// Beyond the last frequency of the grid there is nothing to interpolate between: each is solved by
// itself, with the bits that Direct has. Within it, not.
TEST(DiffractionTableIdentity, BeyondTheGridEveryConditionIsSolved) {
  const DiffractionTable direct = SmallSweep(Influence::Direct).solve({});
  for (const Influence influence : {Influence::Matrix, Influence::Inverse}) {
    const SmallSweep sweep(influence);
    EXPECT_EQ(worstOf(direct, sweep.solve({0.1})), 0.0);
    EXPECT_GT(worstOf(direct, sweep.solve({0.1, 5.0})), 1e-3);
  }
}

TEST(DiffractionTableIdentity, SameBitsWhateverTheNumberOfThreads) {
  for (const Influence influence : {Influence::Direct, Influence::Matrix, Influence::Inverse}) {
    const SmallSweep sweep(influence);
    const std::vector<double> grid{0.5, 1.0, 1.5, 2.0};
    const DiffractionTable one = sweep.solve(grid, 1), three = sweep.solve(grid, 3);
    EXPECT_EQ(worstOf(one, three), 0.0);
  }
}

}  // namespace
}  // namespace cutwater::test
