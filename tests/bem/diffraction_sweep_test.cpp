#include <gtest/gtest.h>

#include "hydro/bem/BuildCoefficients.h"
#include "hydro/excitation/WaveExcitation.h"
#include "tests/bem/Frigate.h"
#include "tests/support/Results.h"

// Diffraction at forward speed: four ways to obtain it, and the sign of the encounter frequency.
namespace cutwater::test {
namespace {

ShipParticulars frigate(int along, int girth) { return frigateAfloat({along, girth}); }

/// Up to 2.4 rad/s, which these panels resolve.
SolveSettings settings(Influence influence, double step, int count) {
  SolveSettings s;
  s.forwardSpeed = ForwardSpeedForm::Report;
  for (int i = 1; i <= count; ++i) s.omega.push_back(step * i);
  s.influence = influence;
  s.speeds = {0.0, 8.0, 16.0};
  s.headings = {kPi / 6.0, 5.0 * kPi / 6.0};
  s.waveOmega = {0.25, 0.55, 0.8, 0.9};
  s.threads = 2;
  return s;
}

/// Largest |F_D| of each mode over a table.
Vec6 peaks(const DiffractionTable& table) {
  Vec6 peak = Vec6::Zero();
  for (const CVec6& force : table.values) peak = peak.cwiseMax(force.cwiseAbs());
  return peak;
}

double worst(const DiffractionTable& a, const DiffractionTable& b) {
  const Vec6 peak = peaks(a);
  double most = 0.0;
  for (std::size_t i = 0; i < a.values.size(); ++i)
    most = std::max(most, (a.values[i] - b.values[i]).cwiseAbs().cwiseQuotient(peak).maxCoeff());
  return most;
}

/// What the database gives back for the table's conditions, from its adjoint vectors.
DiffractionTable read(const CoefficientTables& c, DiffractionTable table) {
  const WaveExcitation excitation(c);
  std::size_t place = 0;
  for (const double speed : table.speeds)
    for (const double heading : table.headings)
      for (const double omega : table.waveOmega)
        table.values[place++] = excitation.at(omega, heading, speed).diffraction;
  return table;
}

// Adjoint vectors interpolated between frequencies 0.1 rad/s apart: 0.5 % is the acceptance line.
// At U = 16 m/s and 30° the ship is overtaking the shorter waves, so ω′ < 0 is among them.
TEST(DiffractionSweepVerification, AdjointVectorsGiveEveryConditionOffTheGrid) {
  const ShipParticulars ship = frigate(26, 5);
  const SolverOutput direct = buildCoefficients(ship, settings(Influence::Direct, 0.1, 24));
  const SolverOutput adjoint = buildCoefficients(ship, settings(Influence::Adjoint, 0.1, 24));
  const double error = worst(direct.diffractionTable, read(adjoint, direct.diffractionTable));
  EXPECT_LT(error, 0.005);
  recordResult("diffraction",
               "frigate 131 a side, F_D from adjoint vectors off the grid, % of mode's maximum",
               "direct solution", 100.0 * error, "<= 0.5");
}

// A database that holds the table instead gives it back to the last bit.
TEST(DiffractionSweep, TableIsWhatTheExcitationReads) {
  const SolverOutput c = buildCoefficients(frigate(12, 4), settings(Influence::Direct, 0.5, 6));
  EXPECT_TRUE(c.adjoint.empty());
  const DiffractionTable& table = c.diffractionTable;
  const DiffractionTable again = read(c, table);
  for (std::size_t i = 0; i < table.values.size(); ++i)
    EXPECT_LT((again.values[i] - table.values[i]).norm(), 1e-12 * table.values[i].norm());
}

// Linear interpolation: second order in the step of the grid, h²/8 of a curvature that a ship's
// length sets. Between panels a distance r apart the phase turns by 2ωhr/g, 2 rad for half a ship
// at 1.5 rad/s and h = 0.1; they share a few per cent of the force, hence 3 %. With lid nothing
// resonates inside and the inverses serve as well.
TEST(DiffractionSweepConvergence, InterpolatedMatricesAreOfSecondOrderInTheGrid) {
  const ShipParticulars ship = frigate(20, 5);
  const SolverOutput direct = buildCoefficients(ship, settings(Influence::Direct, 0.2, 12));
  const auto error = [&](Influence influence, double step, int count) {
    return worst(direct.diffractionTable,
                 buildCoefficients(ship, settings(influence, step, count)).diffractionTable);
  };
  const double coarse = error(Influence::Matrix, 0.2, 12), fine = error(Influence::Matrix, 0.1, 24);
  EXPECT_LT(fine, 0.03);
  EXPECT_GT(std::log2(coarse / fine), 1.5);  // the worst condition lies anywhere between nodes
  EXPECT_LT(error(Influence::Inverse, 0.1, 24), 0.03);
}

// The report's finding (6.2, Figures 21-24): near an irregular frequency D⁻¹ has a pole between two
// grid frequencies, which no interpolation of D⁻¹ follows; D itself passes through.
TEST(DiffractionSweepVerification, InterpolatedInverseFailsNearIrregularFrequencies) {
  const ShipParticulars ship = frigate(20, 5);
  SolveSettings s = settings(Influence::Direct, 0.1, 24);
  s.lid = false;
  s.speeds = {10.288};  // 20 knots
  s.headings = {5.0 * kPi / 6.0};
  s.waveOmega.clear();
  for (int i = 0; i <= 20; ++i) s.waveOmega.push_back(0.8 + 0.015 * i);
  const DiffractionTable direct = buildCoefficients(ship, s).diffractionTable;
  s.influence = Influence::Matrix;
  const double matrix = worst(direct, buildCoefficients(ship, s).diffractionTable);
  s.influence = Influence::Inverse;
  const double inverse = worst(direct, buildCoefficients(ship, s).diffractionTable);
  EXPECT_GT(inverse, 3.0 * matrix);
  recordResult("diffraction", "frigate, no lid, 20 knots, 150 deg: interpolated D, % of maximum",
               "direct solution", 100.0 * matrix, "-");
  recordResult("diffraction", "the same, interpolated inverse of D", "direct solution",
               100.0 * inverse, "(fails)");
}

// What a mask leaves out of the grid is not interpolated from either: the table is that of the grid
// without it, bit for bit.
TEST(DiffractionSweepIdentity, MaskedFrequencyIsNoNode) {
  const ShipParticulars ship = frigate(12, 4);
  for (const Influence influence : {Influence::Matrix, Influence::Inverse}) {
    SolveSettings masked = settings(influence, 0.4, 5), without = masked;
    masked.conditionLimitEven = {{1.1, 1e12}, {1.19, 1.0}, {1.21, 1.0}, {1.3, 1e12}};
    without.omega.erase(without.omega.begin() + 2);  // 1.2 rad/s
    const SolverOutput all = buildCoefficients(ship, settings(influence, 0.4, 5));
    const SolverOutput left = buildCoefficients(ship, without);
    const SolverOutput found = buildCoefficients(ship, masked);
    EXPECT_EQ(worst(left.diffractionTable, found.diffractionTable), 0.0);
    EXPECT_GT(worst(all.diffractionTable, found.diffractionTable), 1e-3);
  }
}

// On either side of ω′ = 0 the force tends to that at ω′ = 0, U F^U of the rigid surface.
TEST(DiffractionSweepIdentity, ForceIsContinuousThroughZeroEncounterFrequency) {
  const ShipParticulars ship = frigate(12, 4);
  SolveSettings s = settings(Influence::Direct, 0.2, 10);
  const double omega = 0.8, heading = kPi / 6.0;
  const double still = kStandardGravity / (omega * std::cos(heading));  // ω′ = 0 at this U
  s.speeds = {still * 0.999, still, still * 1.001};
  s.headings = {heading};
  s.waveOmega = {omega};
  const DiffractionTable table = buildCoefficients(ship, s).diffractionTable;
  const CVec6 &before = table.values[0], &at = table.values[1], &after = table.values[2];
  const Vec6 peak = before.cwiseAbs().cwiseMax(at.cwiseAbs());
  // 0.1 % of U is |ω′| = 8e-4 rad/s; F changes as ω′.
  EXPECT_LT((before - at).cwiseAbs().cwiseQuotient(peak).maxCoeff(), 0.01);
  EXPECT_LT((after - at).cwiseAbs().cwiseQuotient(peak).maxCoeff(), 0.01);
}

}  // namespace
}  // namespace cutwater::test
