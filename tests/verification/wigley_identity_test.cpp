#include <gtest/gtest.h>

#include "hydro/bem/solution/XDerivative.h"
#include "hydro/geometry/panels/SolverPanels.h"
#include "hydro/geometry/shapes/Shapes.h"
#include "tests/support/Results.h"

// ∫φ_x n_2 dS = ∫φ_y n_1 dS: the vertical part of n × ∇φ integrates to ∮φ dz, 0 on calm water. True
// of any φ; here of the yaw potential, so that the left side is ∂A_26.
namespace cutwater::test {
namespace {

/// ∫∂φ/∂y dS of the port panels for a potential odd in y: the T of the whole hull turned by 90°, so
/// that its x-axis is our y-axis.
Eigen::VectorXcd yIntegrals(const SurfaceMesh& port, const ModeNormals& normals,
                            const Eigen::VectorXd& v, const Eigen::VectorXcd& phi) {
  SurfaceMesh turned = bothHalves(port);
  for (Vec3& x : turned.vertices) x = Vec3(x.y(), -x.x(), x.z());
  const XDerivative derivative(turned, solverPanels(turned, false));
  Eigen::VectorXcd both(2 * phi.size());
  both << phi, -phi;
  const Eigen::VectorXcd tangential = derivative.stokes(Parity::Even).cast<Complex>() * both;
  return normals.area.cwiseProduct(normals.n.col(Sway)).cwiseProduct(v).cast<Complex>() +
         tangential.head(phi.size());
}

struct Sides {
  double x, y;  // ∂A_26 as ∫φ_x n_2 and as ∫φ_y n_1, over A_22
};

/// Hull III 100 m long at ω = 1 rad/s.
Sides sidesOf(int along, int girth) {
  WigleyShape shape = wigley(3);
  const double scale = 100.0 / shape.length;
  shape = {scale * shape.length, scale * shape.breadth, scale * shape.draft, shape.alpha};
  const SurfaceMesh wet = wetWigley(shape, along, girth);
  const InfluenceMatrices matrices(solverPanels(wet, true), {.threads = 2});
  const SymmetricSystem<Complex> system(matrices.atWaveNumber(1.0 / 9.81), 2);
  const ModeNormals normals(matrices.mesh(), Vec3::Zero());
  const XDerivative derivative(wet, matrices.mesh());
  const auto phi = radiationPotentials(system, normals);
  const CMat6 impulse = impulseMatrix(phi, normals, 1.0),
              impulseX = impulseMatrixX(system, phi, normals, derivative, 1.0);
  const std::size_t odd = static_cast<std::size_t>(Parity::Odd);
  const Eigen::VectorXd v = normals.n.col(Yaw);
  const Eigen::VectorXcd phiY =
      yIntegrals(wet, normals, v, phi[odd].col(2));  // odd modes: sway, roll, yaw
  const Complex y = -2.0 * normals.n.col(Surge).cast<Complex>().dot(phiY);
  const double swayed = impulse(Sway, Sway).real();
  return {impulseX(Sway, Yaw).real() / swayed, y.real() / swayed};
}

// With T the two sides differ on a panel by Σφ_edge dz, by algebra alone, and between neighbours
// that cancels: what remains is that flat panels of a twisted hull do not quite meet, less with
// more panels of one shape (along = 3.5 girth). The test is of T: neighbours, centreline,
// waterline. 5 % at 432 is the acceptance line; 0.7 % is reached.
TEST(WigleyIdentity, BothSidesOfTheCurlOfTheYawPotential) {
  double before = 1.0;
  for (const auto& [along, girth] : {std::pair{28, 8}, {39, 11}, {60, 17}}) {
    const int panels = along * girth;
    if (panels > 500 && !fullSize()) continue;
    const Sides got = sidesOf(along, girth);
    const double off = std::abs(got.y / got.x - 1.0);
    const std::string size = std::to_string(panels) + " panels a side";
    recordResult("forward speed", "Wigley III, int phi_x n_2 dS of yaw / A22, " + size,
                 "int phi_y n_1 dS / A22: " + std::to_string(got.y), got.x, "within 5 % at 429");
    EXPECT_LT(off, 0.05) << size;
    EXPECT_LT(off, before) << size;
    before = off;
  }
}

}  // namespace
}  // namespace cutwater::test
