#include <gtest/gtest.h>

#include <cmath>

#include "hydro/bem/solution/XDerivative.h"
#include "tests/bem/Bodies.h"

// ∫∂φ/∂x dS of panels by Stokes' theorem, for potentials known by a formula: no flow is solved.
namespace cutwater::test {
namespace {

struct Known {
  double (*value)(const Vec3& x);
  Vec3 (*gradient)(const Vec3& x);
};

constexpr Known kLinear{[](const Vec3& x) { return 3.0 * x.x() - 2.0 * x.z(); },
                        [](const Vec3&) -> Vec3 {
                          return {3.0, 0.0, -2.0};
                        }};
constexpr Known kAcross{[](const Vec3& x) { return x.y(); },
                        [](const Vec3&) -> Vec3 {
                          return {0.0, 1.0, 0.0};
                        }};
constexpr Known kSquare{[](const Vec3& x) { return x.x() * x.x() + 0.3 * x.x() * x.z(); },
                        [](const Vec3& x) -> Vec3 {
                          return {2.0 * x.x() + 0.3 * x.z(), 0.0, 0.3 * x.x()};
                        }};

/// n_x v dS + Tφ of every panel.
Eigen::VectorXd integrals(const SurfaceMesh& wet, const PanelMesh& mesh, Parity parity,
                          const Known& phi) {
  const auto count = static_cast<Eigen::Index>(mesh.panels.size());
  Eigen::VectorXd value(count), projected(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Panel& panel = mesh.panels[static_cast<std::size_t>(i)];
    value[i] = phi.value(panel.centroid);
    projected[i] = panel.normal.x() * panel.normal.dot(phi.gradient(panel.centroid)) * panel.area;
  }
  return projected + XDerivative(wet, mesh).stokes(parity) * value;
}

// Two neighbours in its plane give a panel the gradient of a linear φ exactly, whatever their
// shape; a neighbour round the corner of the box does not count. Round-off of a dozen terms of size
// 10.
TEST(XDerivativeClosedForm, LinearPotentialIsExactOnABoxOfAnyPanels) {
  const SurfaceMesh quads = wetBox({8.0, 4.0, 3.0, 0.0}, 6, 3, 4);
  for (const SurfaceMesh& wet : {quads, triangulated(quads)}) {
    const PanelMesh mesh = makePanels(wet, true);
    for (const auto& [parity, phi] : {std::pair{Parity::Even, kLinear}, {Parity::Odd, kAcross}}) {
      const Eigen::VectorXd got = integrals(wet, mesh, parity, phi);
      for (Eigen::Index i = 0; i < got.size(); ++i) {
        const Panel& panel = mesh.panels[static_cast<std::size_t>(i)];
        EXPECT_NEAR(got[i], phi.gradient(panel.centroid).x() * panel.area, 1e-12) << i;
      }
    }
  }
}

/// The lower half of the rings of a hemisphere of radius 1: 45° of flare at its loose edge.
SurfaceMesh bowl(int around, int rings) {
  const SurfaceMesh whole = wetHemisphere(1.0, around, 2 * rings);
  SurfaceMesh lower = whole;
  lower.faces.clear();
  for (const Face& face : whole.faces) {
    double z = 0.0;
    for (int i = 0; i < face.size(); ++i) z += whole.corner(face, i).z() / face.size();
    if (z < -std::sqrt(0.5)) lower.faces.push_back(face);
  }
  return lower;
}

/// |∫φ_x n_1 dS − exact| of the bowl's port half.
double bowlError(int around, int rings) {
  const SurfaceMesh wet = bowl(around, rings);
  const PanelMesh mesh = makePanels(wet, true);
  const ModeNormals normals(mesh, Vec3::Zero());
  const double got = normals.n.col(Surge).dot(integrals(wet, mesh, Parity::Even, kSquare));
  // ∫(2x + 0.3z) x dS, the second part 0: π∫sin³θ dθ from 0 to 45°.
  const double c = std::sqrt(0.5);
  return std::abs(got - kPi * (2.0 / 3.0 - c + c * c * c / 3.0));
}

// Own values at the loose edge would make it first order. 1.8 allows for the terms of higher order.
TEST(XDerivativeConvergence, OfSecondOrderOnAFlaredHull) {
  const double order = std::log2(bowlError(12, 6) / bowlError(24, 12));
  EXPECT_GT(order, 1.8);
  EXPECT_LT(bowlError(24, 12), 0.01 * kPi * 0.0775);
}

}  // namespace
}  // namespace cutwater::test
