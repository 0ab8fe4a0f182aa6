#include <gtest/gtest.h>

#include "tests/bem/Bodies.h"
#include "tests/support/Results.h"

// What holds for every hull: A and B symmetric, B passive, Haskind's relation, waves carry the work
// of B.
namespace cutwater::test {
namespace {

/// Largest |Z_jk − Z_kj| / √(Z_jj Z_kk) over the pairs.
double asymmetry(const Mat6& m) {
  double most = 0.0;
  for (int j = 0; j < 6; ++j)
    for (int k = 0; k < j; ++k) {
      const double scale = std::sqrt(std::abs(m(j, j) * m(k, k)));
      if (scale > 0.0) most = std::max(most, std::abs(m(j, k) - m(k, j)) / scale);
    }
  return most;
}

struct Case {
  explicit Case(const SurfaceMesh& wet, const Vec3& cog)
      : matrices(panels(wet, true, true), {.threads = 2}),
        normals(matrices.mesh(), cog),
        cog(cog) {}
  InfluenceMatrices matrices;
  ModeNormals normals;
  Vec3 cog;
};

struct Asymmetry {
  double A = 0.0, B = 0.0, leastB = 1.0;
};

/// Over wave lengths of 4 to ¼ ship lengths.
Asymmetry asymmetry(const Case& ship, double length) {
  Asymmetry worst;
  for (const double perLength : {0.25, 0.5, 1.0, 2.0, 4.0}) {
    const double K = 2.0 * kPi * perLength / length;
    const CMat6 Z = impulse(ship.matrices, ship.normals, K);
    const Mat6 B = damping(Z, std::sqrt(K * kGravity));
    worst.A = std::max(worst.A, asymmetry(addedMass(Z)));
    worst.B = std::max(worst.B, asymmetry(B));
    const Vec6 relative =
        B.diagonal().cwiseQuotient(std::sqrt(K * kGravity) * addedMass(Z).diagonal().cwiseAbs());
    worst.leastB = std::min(worst.leastB, relative.minCoeff());
  }
  return worst;
}

// Collocation makes A_jk and A_kj differ by the discretisation error; twice the panels, less of it.
TEST(ReciprocityIdentity, AddedMassAndDampingAreSymmetricAndDampingIsNotNegative) {
  const Vec3 cog(-2.0, 0.0, 1.3);
  const Case coarse(wetFrigate(22, 5), cog), fine(wetFrigate(32, 7), cog);
  const Asymmetry before = asymmetry(coarse, 124.5), after = asymmetry(fine, 124.5);
  EXPECT_LT(after.A, 0.03);  // of √(A_jj A_kk), at 225 panels a side
  EXPECT_LT(after.B, 0.03);
  EXPECT_LT(after.A, before.A);
  EXPECT_LT(after.B, before.B);
  EXPECT_GE(after.leastB, 0.0);
  EXPECT_GE(before.leastB, 0.0);
  const auto report = [](const Asymmetry& a, const std::string& n) {
    recordResult("solver", "frigate " + n + " a side, worst |A_jk − A_kj|/√(A_jj A_kk), %", "0",
                 100.0 * a.A, "falls with N");
    recordResult("solver", "frigate " + n + " a side, worst |B_jk − B_kj|/√(B_jj B_kk), %", "0",
                 100.0 * a.B, "falls with N");
    recordResult("solver", "frigate " + n + " a side, least B_jj/(ω A_jj)", "≥ 0", a.leastB, "≥ 0");
  };
  report(before, "111");
  report(after, "225");
  if (!fullSize()) return;
  const FrigateDivision medium = frigateDivision(433), large = frigateDivision(1040);
  const Asymmetry third = asymmetry(Case(wetFrigate(medium.along, medium.girth), cog), 124.5);
  const Asymmetry fourth = asymmetry(Case(wetFrigate(large.along, large.girth), cog), 124.5);
  EXPECT_LT(third.A, after.A);
  EXPECT_LT(third.B, after.B);
  EXPECT_LT(fourth.A, third.A);
  EXPECT_LT(fourth.B, third.B);
  EXPECT_GE(std::min(third.leastB, fourth.leastB), 0.0);
  report(third, "433");
  report(fourth, "1040");
}

// 225 panels a side in waves down to 8 m, less than two panel lengths: coarse, but the damping must
// fade as it does on finer meshes, positive and without ringing (with one point of the wave term it
// rings).
TEST(ReciprocityIdentity, DampingOfShortWavesFadesWithoutRinging) {
  const Case ship(wetFrigate(32, 7), Vec3(-2.0, 0.0, 1.3));
  double before = 1e30;
  for (double omega = 1.2; omega < 2.85; omega += 0.2) {
    const CMat6 Z = impulse(ship.matrices, ship.normals, omega * omega / kGravity);
    EXPECT_GT(damping(Z, omega).diagonal().minCoeff(), 0.0) << omega;
    EXPECT_LT(-Z(Heave, Heave).imag(), before) << omega;
    before = -Z(Heave, Heave).imag();
  }
}

/// F_D by the diffraction potential and by Haskind's relation, F_D,j = iωρ ∫ φ̂_j v dS, ρ = 1; and
/// the whole excitation with F_I.
struct Excitation {
  CVec6 direct, haskind, froudeKrylov;
};

Excitation excitation(const Case& ship, const AiryWave& wave) {
  const auto system = systemAt(ship.matrices, wave.waveNumber());
  const PanelMesh& mesh = ship.matrices.mesh();
  const IncidentVelocity v = incidentNormalVelocity(mesh, wave, ship.cog);
  Excitation x{solvedDiffraction(system, ship.normals, v, wave.omega, 1.0), CVec6::Zero(),
               froudeKrylovForce(mesh, wave, ship.cog, 1.0)};
  const auto phi = radiationPotentials(system, ship.normals);
  for (const Parity parity : ship.normals.parities()) {
    const Eigen::VectorXcd flux =
        (ship.normals.symmetric ? 2.0 : 1.0) *
        (ship.normals.area.array() * (parity == Parity::Even ? v.even : v.odd).array()).matrix();
    x.haskind(ship.normals.modes(parity)) =
        Complex(0.0, wave.omega) * phi[static_cast<std::size_t>(parity)].transpose() * flux;
  }
  return x;
}

/// Worst difference over frequencies and headings, as a part of each mode's largest excitation.
double haskindError(const Case& ship, const std::vector<double>& wavesPerLength, double length) {
  Vec6 worst = Vec6::Zero(), largest = Vec6::Zero();
  for (const double perLength : wavesPerLength)
    for (const double heading : {kPi, 3.0 * kPi / 4.0, kPi / 2.0}) {
      const double omega = std::sqrt(2.0 * kPi * perLength / length * kGravity);
      const Excitation x = excitation(ship, {omega, heading, kGravity});
      worst = worst.cwiseMax((x.direct - x.haskind).cwiseAbs());
      largest = largest.cwiseMax((x.direct + x.froudeKrylov).cwiseAbs());
    }
  double most = 0.0;  // without the moments that a sphere does not feel
  for (int j = 0; j < 6; ++j)
    if (largest[j] > 0.05 * largest.maxCoeff()) most = std::max(most, worst[j] / largest[j]);
  return most;
}

TEST(ReciprocityIdentity, HaskindsRelationHoldsToDiscretisationError) {
  const std::vector<double> waves{0.15, 0.3, 0.6};  // per diameter: Ka = 0.47, 0.94, 1.88
  const auto hemisphere = [](int around, int down) {
    return Case(wetHemisphere(1.0, around, down), Vec3::Zero());
  };
  const double coarse = haskindError(hemisphere(10, 6), waves, 2.0);
  const double fine = haskindError(hemisphere(16, 10), waves, 2.0);
  EXPECT_LT(fine, 0.01 * 432 / 160);  // 1 % is asked of 432 panels
  EXPECT_LT(fine, 0.6 * coarse);      // 60 → 160 panels at second order: 0.375
  recordResult("solver", "Haskind, hemisphere 160 a side, % of largest force", "0", 100.0 * fine,
               "≤ 2.7");
  if (!fullSize()) return;
  const double third = haskindError(hemisphere(27, 16), waves, 2.0);
  const double fourth = haskindError(hemisphere(40, 26), waves, 2.0);
  EXPECT_LT(third, 0.01);
  EXPECT_LT(fourth, third);
  recordResult("solver", "Haskind, hemisphere 432 a side, % of largest force", "0", 100.0 * third,
               "≤ 1");
  recordResult("solver", "Haskind, hemisphere 1040 a side, % of largest force", "0", 100.0 * fourth,
               "falls");
}

TEST(ReciprocityIdentity, HaskindsRelationHoldsForTheFrigate) {
  const Vec3 cog(-2.0, 0.0, 1.3);
  const std::vector<double> waves{0.5, 1.0, 2.0};
  const double coarse = haskindError(Case(wetFrigate(22, 5), cog), waves, 124.5);
  const double fine = haskindError(Case(wetFrigate(32, 7), cog), waves, 124.5);
  EXPECT_LT(fine, 0.01 * 433 / 225);
  EXPECT_LT(fine, coarse);
  recordResult("solver", "Haskind, frigate 225 a side, % of largest force", "0", 100.0 * fine,
               "≤ 1.9");
  if (!fullSize()) return;
  const FrigateDivision medium = frigateDivision(433), large = frigateDivision(1040);
  const double third =
      haskindError(Case(wetFrigate(medium.along, medium.girth), cog), waves, 124.5);
  const double fourth = haskindError(Case(wetFrigate(large.along, large.girth), cog), waves, 124.5);
  EXPECT_LT(third, 0.01);
  EXPECT_LT(fourth, third);
  recordResult("solver", "Haskind, frigate 433 a side, % of largest force", "0", 100.0 * third,
               "≤ 1");
  recordResult("solver", "Haskind, frigate 1040 a side, % of largest force", "0", 100.0 * fourth,
               "falls");
}

// Work of B = energy carried away: B_jj = k/(8πρg c_g) ∫|X_j(β)|² dβ, c_g = g/2ω, X_j the force of
// waves of unit amplitude from every side [Newman 1962]. ρ = 1. Both sides carry the error of B:
// 1 % of 432 panels scaled to 160.
TEST(ReciprocityIdentity, RadiatedWavesCarryTheWorkOfDamping) {
  const Case ship(wetHalfEllipsoid({2.0, 0.8, 0.6}, 16, 10), Vec3(0.1, 0.0, 0.05));
  const double omega = 2.0, k = omega * omega / kGravity;
  const Mat6 B = damping(impulse(ship.matrices, ship.normals, k), omega);
  constexpr int kHeadings = 24;  // trapezoidal rule, exact for the few harmonics of a small body
  Vec6 sum = Vec6::Zero();
  for (int h = 0; h < kHeadings; ++h) {
    const Excitation x = excitation(ship, {omega, 2.0 * kPi * h / kHeadings, kGravity});
    sum += (x.direct + x.froudeKrylov).cwiseAbs2() * 2.0 * kPi / kHeadings;
  }
  const double groupVelocity = 0.5 * kGravity / omega;
  for (int j = 0; j < 6; ++j) {
    const double radiated = k / (8.0 * kPi * kGravity * groupVelocity) * sum[j];
    EXPECT_NEAR(radiated / B(j, j), 1.0, 0.027) << kModeNames[j];
  }
}

}  // namespace
}  // namespace cutwater::test
