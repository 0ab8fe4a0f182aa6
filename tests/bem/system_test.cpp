#include <gtest/gtest.h>

#include "hydro/geometry/MeshCut.h"
#include "tests/bem/Bodies.h"
#include "tests/support/Matrices.h"

// The algebra: halves against the whole, adjoint vectors against direct solutions, moments about G.
namespace cutwater::test {
namespace {

// Sums of a few hundred terms through one system; solutions from either side are two solves in
// single precision, (6e-8)² times condition numbers of 1e1 to 1e2 here.
constexpr double kRoundOff = 1e-10;
// Of two systems: backward errors of 1e-11 at most where 1e-10 is promised, times condition numbers
// of 1e2 to 1e3.
constexpr double kResidual = 1e-8;

/// Also at one angle oblique to the hull, all that a frequency gives.
struct Answer {
  CMat6 Z;
  CVec6 diffraction, byAdjoint, froudeKrylov;
};

Answer answer(const SurfaceMesh& wet, bool symmetric, const Vec3& cog) {
  const InfluenceMatrices matrices(panels(wet, symmetric, false));
  const ModeNormals normals(matrices.mesh(), cog);
  const AiryWave wave{1.1, 2.2, kGravity};
  const auto system = systemAt(matrices, wave.waveNumber());
  const PanelMesh& mesh = matrices.mesh();
  return {
      impulseMatrix(radiationPotentials(system, normals), normals, 1025.0),
      solvedDiffraction(system, normals, incidentNormalVelocity(mesh, wave, cog), wave.omega,
                        1025.0),
      wave.omega * diffractionForce(adjointVectors(system, normals, 1025.0).omega, mesh, wave, cog),
      froudeKrylovForce(mesh, wave, cog, 1025.0)};
}

TEST(SystemIdentity, HalfHullAndWholeHullGiveTheSame) {
  const SurfaceMesh port = wetHalfEllipsoid({10.0, 3.0, 2.0}, 10, 5);
  const Vec3 cog(0.5, 0.0, -0.4);
  const Answer half = answer(port, true, cog), whole = answer(bothHalves(port), false, cog);
  const double scale = half.Z.norm();
  EXPECT_LT((half.Z - whole.Z).norm(), kResidual * scale);
  EXPECT_LT((half.diffraction - whole.diffraction).norm(), kResidual * half.diffraction.norm());
  EXPECT_LT((half.froudeKrylov - whole.froudeKrylov).norm(), kResidual * half.froudeKrylov.norm());
}

TEST(SystemIdentity, HalfHullAndWholeHullGiveTheSameWithTheSameLid) {
  const SurfaceMesh port = wetHalfEllipsoid({10.0, 3.0, 2.0}, 10, 5);
  PanelMesh half = panels(port, true, true), whole = panels(bothHalves(port), false, false);
  whole.lid = half.lid;
  for (Panel panel : half.lid) {
    std::reverse(panel.corner.begin(), panel.corner.begin() + panel.corners);
    for (Vec3& corner : panel.corner) corner.y() *= -1.0;
    if (panel.corners == 3) panel.corner[3] = panel.corner[2];
    panel.centroid.y() *= -1.0;
    whole.lid.push_back(panel);
  }
  const InfluenceMatrices halves(half), all(whole);
  const ModeNormals halfNormals(half, Vec3::Zero()), allNormals(whole, Vec3::Zero());
  const CMat6 Z = impulse(halves, halfNormals, 0.4);
  EXPECT_LT((Z - impulse(all, allNormals, 0.4)).norm(), kResidual * Z.norm());
}

TEST(SystemIdentity, AdjointVectorsGiveTheDirectDiffractionForce) {
  const SurfaceMesh port = wetFrigate(12, 4);
  const Vec3 cog(-2.0, 0.0, 1.3);
  for (const bool lid : {false, true})
    for (const bool symmetric : {true, false}) {
      const SurfaceMesh wet = symmetric ? port : bothHalves(port);
      const InfluenceMatrices matrices(panels(wet, symmetric, lid));
      const PanelMesh& mesh = matrices.mesh();
      const ModeNormals normals(mesh, cog);
      const double omega = 0.9;
      const auto system = systemAt(matrices, omega * omega / kGravity);
      const auto b = adjointVectors(system, normals, 1025.0).omega;
      for (const double heading : {0.0, 0.7, kPi / 2, 2.5, kPi}) {
        const AiryWave wave{omega, heading, kGravity};
        const CVec6 direct = solvedDiffraction(
            system, normals, incidentNormalVelocity(mesh, wave, cog), omega, 1025.0);
        const CVec6 fast = omega * diffractionForce(b, mesh, wave, cog);
        EXPECT_LT((fast - direct).norm(), kRoundOff * direct.norm());
      }
    }
}

// The same adjoint vectors hold the radiation: b_jᵀ v_k = iρ ∫ φ̂_k n_j dS = −i Z_jk.
TEST(SystemIdentity, AdjointVectorsGiveTheRadiationForce) {
  const InfluenceMatrices matrices(panels(wetFrigate(12, 4), true, true));
  const ModeNormals normals(matrices.mesh(), Vec3(-2.0, 0.0, 1.3));
  const double omega = 0.9;
  const auto system = systemAt(matrices, omega * omega / kGravity);
  const CMat6 Z = impulseMatrix(radiationPotentials(system, normals), normals, 1.0);
  const auto b = adjointVectors(system, normals, 1.0).omega;
  for (int j = 0; j < 6; ++j)
    for (int k = j % 2; k < 6; k += 2)
      EXPECT_LT(std::abs(2.0 * (b.row(j) * normals.velocity.col(k)).value() +
                         Complex(0.0, 1.0) * Z(j, k)),
                kRoundOff * Z.norm());
}

// Moving G by d changes moments by −d × force, and rotations move the old point: Z′ = P Z Pᵀ.
TEST(SystemIdentity, MomentsAreTakenAboutTheCentreOfGravity) {
  const InfluenceMatrices matrices(panels(wetFrigate(12, 4), true, true));
  const Vec3 d(3.0, 0.0, 2.0);
  const auto system = systemAt(matrices, 0.1);
  const auto about = [&](const Vec3& cog) {
    const ModeNormals normals(matrices.mesh(), cog);
    return impulseMatrix(radiationPotentials(system, normals), normals, 1.0);
  };
  Mat6 P = Mat6::Identity();
  P.bottomLeftCorner<3, 3>() << 0.0, d.z(), -d.y(), -d.z(), 0.0, d.x(), d.y(), -d.x(), 0.0;
  const CMat6 expected = P * about(Vec3::Zero()) * P.transpose();
  EXPECT_LT((about(d) - expected).norm(), kRoundOff * expected.norm());
}

// The estimate is a lower bound that is rarely off by more than a factor of 3; the factors are in
// single precision.
TEST(SystemClosedForm, ConditionNumberOfAKnownMatrix) {
  Eigen::MatrixXcd m = Eigen::MatrixXcd::Zero(4, 4);
  m.diagonal() << 1.0, 10.0, 100.0, 1000.0;
  m(0, 3) = Complex(0.0, 500.0);
  const Eigen::MatrixXcd inverse = solved(m, Eigen::MatrixXcd::Identity(4, 4));
  const double exact = 1000.0 * inverse.cwiseAbs().rowwise().sum().maxCoeff();
  const double estimate = Factorization<Complex>(m).condition();
  EXPECT_LE(estimate, exact * (1.0 + 1e-6));
  EXPECT_GE(estimate, exact / 3.0);
}

TEST(System, RefusesASingularMatrix) {
  EXPECT_ANY_THROW(Factorization<double>(Eigen::MatrixXd::Zero(3, 3)));
}

// A sphere heeled or trimmed about its own centre is the same sphere on other panels, cut by calm
// water wherever they lie: 160 and 360 panels agree to the 2 % that the coarser of them is off. It
// is also the solver on a hull without symmetry, with triangles and slivers among its panels.
TEST(SystemConvergence, HeeledAndTrimmedSphereIsTheSameSphere) {
  const SurfaceMesh upright = closedSphere(1.0, 12, 6);
  const auto solved = [](const SurfaceMesh& closed, bool lid) {
    const SurfaceMesh wet = cutBelow(closed);
    const InfluenceMatrices matrices(panels(wet, false, lid), {.threads = 2});
    return impulse(matrices, ModeNormals(matrices.mesh(), Vec3::Zero()), 1.2);
  };
  const CMat6 before = solved(upright, true);
  for (const Vec3& axis : {Vec3(Vec3::UnitX()), Vec3(Vec3::UnitY())}) {
    SurfaceMesh turned = upright;
    for (Vec3& x : turned.vertices) x = Eigen::AngleAxisd(0.3, axis) * x;
    const CMat6 after = solved(turned, true);
    for (const int j : {Surge, Sway, Heave})
      EXPECT_LT(std::abs(after(j, j) - before(j, j)), 0.02 * std::abs(before(j, j)));
    // Moments about the centre of a sphere vanish, whichever way it is turned.
    for (const int j : {Roll, Pitch, Yaw}) EXPECT_LT(std::abs(after(j, j)), 2e-3);
  }
}

}  // namespace
}  // namespace cutwater::test
