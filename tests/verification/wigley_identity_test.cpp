#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "hydro/bem/XDerivative.h"
#include "hydro/geometry/Shapes.h"
#include "hydro/geometry/SolverPanels.h"
#include "tests/support/Results.h"

// ∫φ_x n_2 dS = ∫φ_y n_1 dS: the vertical part of n × ∇φ integrates to ∮φ dz, 0 on calm water. True
// of any φ; here of the yaw potential, so that the left side is ∂A_26.
namespace cutwater::test {
namespace {

/// The T of XDerivative.h for ∂/∂y and potentials odd in y, written again from its formula: (Tφ)_i
/// = Σ_edges φ_edge (e × n_i)_y, φ_edge the mean over the panels that share the edge, 0 on y = 0.
Eigen::MatrixXd stokesInY(const SurfaceMesh& wet, const PanelMesh& mesh) {
  std::map<std::pair<int, int>, std::vector<int>> sharing;
  const auto edge = [&](const Face& face, int i) {
    return std::pair<int, int>(std::minmax(face[i], face[(i + 1) % face.size()]));
  };
  for (std::size_t f = 0; f < wet.faces.size(); ++f)
    for (int i = 0; i < wet.faces[f].size(); ++i)
      sharing[edge(wet.faces[f], i)].push_back(static_cast<int>(f));
  const auto count = static_cast<Eigen::Index>(mesh.panels.size());
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(count, count);
  for (Eigen::Index row = 0; row < count; ++row) {
    const Face& face = wet.faces[static_cast<std::size_t>(row)];
    const Panel& panel = mesh.panels[static_cast<std::size_t>(row)];
    for (int i = 0; i < panel.corners; ++i) {
      const int next = (i + 1) % panel.corners;
      const double across = std::max(wet.corner(face, i).y(), wet.corner(face, next).y());
      const std::vector<int>& faces = sharing.at(edge(face, i));
      if (faces.size() == 1 && across < 1e-9) continue;
      const Vec3 along =
          panel.corner[static_cast<std::size_t>(next)] - panel.corner[static_cast<std::size_t>(i)];
      for (const int other : faces)
        matrix(row, other) += along.cross(panel.normal).y() / static_cast<double>(faces.size());
    }
  }
  return matrix;
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
      normals.area.cwiseProduct(normals.n.col(Sway)).cwiseProduct(v).cast<Complex>() +
      stokesInY(wet, matrices.mesh()) * phi[odd].col(2);  // odd modes: sway, roll, yaw
  const Complex y = -2.0 * normals.n.col(Surge).cast<Complex>().dot(phiY);
  const double swayed = impulse(Sway, Sway).real();
  return {impulseX(Sway, Yaw).real() / swayed, y.real() / swayed};
}

// With T the two sides differ on a panel by Σφ_edge dz, by algebra alone, and between neighbours
// that cancels: what remains is that flat panels of a twisted hull do not quite meet, less with
// more panels of one shape (along = 3.5 girth). The test is of T: neighbours, centreline,
// waterline. 5 % at 432 is the acceptance line; 0.6 % is reached.
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
