#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "hydro/bem/solution/PanelGradients.h"
#include "tests/bem/Bodies.h"

// Gradients along the panels of functions known by a formula.
namespace cutwater::test {
namespace {

/// The gradient of values that f has at the centroids; of an odd f a mirror image has the other
/// sign.
Vec3 gradientOfValues(const PanelGradients& gradients, const PanelMesh& mesh, int panel, auto f,
                      double sideOfImage = 1.0) {
  const PanelGradients::Gradient& g = gradients.of(panel);
  const auto valueOf = [&](int i) { return f(mesh.panels[static_cast<std::size_t>(i)].centroid); };
  Vec3 sum = Vec3::Zero();
  for (std::size_t k = 0; k < g.neighbours.size(); ++k) {
    const auto& [other, isImage, away] = g.neighbours[k];
    sum += g.columns.col(static_cast<Eigen::Index>(k)) *
           ((isImage ? sideOfImage : 1.0) * valueOf(other) - valueOf(panel));
  }
  return sum;
}

/// A flat sheet of nx × ny panels, z = −1, its lines at uneven distances, y from 0 on.
SurfaceMesh unevenSheet(int nx, int ny) {
  SurfaceMesh mesh;
  for (int j = 0; j <= ny; ++j)
    for (int i = 0; i <= nx; ++i)
      mesh.vertices.emplace_back(i + 0.3 * std::sin(2.0 * i), j + 0.1 * j * j, -1.0);
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i) {
      const int a = j * (nx + 1) + i, b = a + nx + 1;
      mesh.faces.push_back({{a, b, b + 1, a + 1}});  // normal down, out of the hull
    }
  return mesh;
}

constexpr auto kPlane = [](const Vec3& x) { return 3.0 * x.x() - 2.0 * x.y() + 5.0; };

// Two neighbours that are not in one line give a linear function's slope exactly: on quadrilaterals
// and triangles, inside and on the edges. Round-off of a few terms.
TEST(PanelGradientsClosedForm, LinearFunctionIsExactOnAFlatSheet) {
  const SurfaceMesh quads = unevenSheet(5, 4);
  for (const SurfaceMesh& wet : {quads, triangulated(quads)}) {
    const PanelMesh mesh = makePanels(wet, false);
    const PanelGradients gradients(wet, mesh);
    for (int i = 0; i < static_cast<int>(mesh.panels.size()); ++i)
      EXPECT_LT((gradientOfValues(gradients, mesh, i, kPlane) - Vec3(3.0, -2.0, 0.0)).norm(), 1e-12)
          << i;
  }
}

// In a strip of one row the neighbours lie in one line: the slope along it, and none made up across
// it.
TEST(PanelGradientsClosedForm, OneRowGivesTheSlopeAlongItself) {
  const SurfaceMesh wet = unevenSheet(6, 1);
  const PanelMesh mesh = makePanels(wet, false);
  const PanelGradients gradients(wet, mesh);
  for (int i = 0; i < 6; ++i)
    EXPECT_LT((gradientOfValues(gradients, mesh, i, kPlane) - Vec3(3.0, 0.0, 0.0)).norm(), 1e-12);
}

TEST(PanelGradients, PanelWithoutNeighboursHasNoSlope) {
  const SurfaceMesh wet = unevenSheet(1, 1);
  const PanelMesh mesh = makePanels(wet, false);
  const PanelGradients gradients(wet, mesh);
  EXPECT_TRUE(gradients.of(0).neighbours.empty());
  EXPECT_EQ(gradients.of(0).columns.cols(), 0);
  EXPECT_EQ(gradients.sharing(0, 2), std::vector<int>{0});
}

// Every value alike: no slope, because columns multiply differences; and no slope leaves the
// panel's plane.
TEST(PanelGradientsIdentity, SlopesLieInThePanel) {
  const SurfaceMesh wet = wetHemisphere(1.0, 12, 6);
  const PanelMesh mesh = makePanels(wet, true);
  const PanelGradients gradients(wet, mesh);
  for (int i = 0; i < static_cast<int>(mesh.panels.size()); ++i) {
    const Vec3& n = mesh.panels[static_cast<std::size_t>(i)].normal;
    EXPECT_LT((n.transpose() * gradients.of(i).columns).norm(), 1e-12) << i;
    EXPECT_EQ(gradientOfValues(gradients, mesh, i, [](const Vec3&) { return 7.0; }), Vec3::Zero());
  }
}

// On a sphere the gradient of z is e_z less its normal part. Between neighbours at unequal
// distances the slope is of first order at least.
TEST(PanelGradientsConvergence, SlopeOnASphere) {
  const auto worst = [](int around, int down) {
    const SurfaceMesh wet = wetHemisphere(1.0, around, down);
    const PanelMesh mesh = makePanels(wet, true);
    const PanelGradients gradients(wet, mesh);
    double error = 0.0;
    for (int i = 0; i < static_cast<int>(mesh.panels.size()); ++i) {
      const Vec3 n = mesh.panels[static_cast<std::size_t>(i)].normal;
      const Vec3 exact = Vec3::UnitZ() - n.z() * n;
      const Vec3 got = gradientOfValues(gradients, mesh, i, [](const Vec3& x) { return x.z(); });
      error += (got - exact).squaredNorm() / static_cast<double>(mesh.panels.size());
    }
    return std::sqrt(error);
  };
  const double coarse = worst(12, 6), fine = worst(24, 12);
  EXPECT_GT(std::log2(coarse / fine), 0.9) << coarse << ' ' << fine;
  EXPECT_LT(fine, 0.05);
}

// The side of a box does not know its bottom: beyond a right angle ∇φ jumps.
TEST(PanelGradientsIdentity, NeighboursBeyondACreaseDoNotCount) {
  const SurfaceMesh wet = wetBox({8.0, 4.0, 3.0, 0.0}, 6, 3, 4);
  const PanelMesh mesh = makePanels(wet, true);
  const PanelGradients gradients(wet, mesh);
  int creases = 0;
  for (int i = 0; i < static_cast<int>(mesh.panels.size()); ++i) {
    const Panel& own = mesh.panels[static_cast<std::size_t>(i)];
    for (const auto& [other, isImage, away] : gradients.of(i).neighbours) {
      const Panel& beside = mesh.panels[static_cast<std::size_t>(other)];
      EXPECT_NEAR(imageInY(beside.normal, isImage).dot(own.normal), 1.0, 1e-12);
      EXPECT_EQ(away, imageInY(beside.centroid, isImage) - own.centroid);
    }
    for (int edge = 0; edge < own.corners; ++edge)
      for (const int other : gradients.sharing(i, edge))
        creases +=
            mesh.panels[static_cast<std::size_t>(other)].normal.dot(own.normal) < 0.5 ? 1 : 0;
  }
  EXPECT_GT(creases, 0);  // they share the edge all the same
}

// Next to the centre plane a panel of a half hull has its own image for a neighbour, so that an
// even function has no slope across it there and an odd one its full slope. A hull solved whole has
// none.
TEST(PanelGradientsIdentity, CentreplaneHasTheMirrorImageBeyond) {
  const SurfaceMesh wet = unevenSheet(4, 3);
  const PanelMesh half = makePanels(wet, true), whole = makePanels(wet, false);
  const PanelGradients gradients(wet, half), without(wet, whole);
  const auto odd = [](const Vec3& x) { return 4.0 * x.y(); };
  const auto even = [](const Vec3& x) { return 2.0 * x.x(); };
  for (int i = 0; i < 12; ++i) {
    std::set<int> images;
    for (const auto& neighbour : gradients.of(i).neighbours)
      if (neighbour.isImage) images.insert(neighbour.panel);
    EXPECT_EQ(images, i < 4 ? std::set<int>{i} : std::set<int>{}) << i;
    for (const auto& neighbour : without.of(i).neighbours) EXPECT_FALSE(neighbour.isImage) << i;
    EXPECT_LT((gradientOfValues(gradients, half, i, odd, -1.0) - Vec3(0, 4, 0)).norm(), 1e-12);
    EXPECT_LT((gradientOfValues(gradients, half, i, even) - Vec3(2, 0, 0)).norm(), 1e-12);
    for (int edge = 0; edge < 4; ++edge) {
      const bool onPlane = std::abs(gradients.middle(i, edge).y()) < 1e-12;
      EXPECT_EQ(gradients.onCentreline(i, edge), onPlane) << i << ' ' << edge;
      EXPECT_FALSE(without.onCentreline(i, edge));
    }
  }
}

// Of the edges inside a sheet each is shared by two panels, and its middle is the same from either.
TEST(PanelGradientsIdentity, PanelsShareTheirEdges) {
  const SurfaceMesh wet = unevenSheet(3, 2);
  const PanelMesh mesh = makePanels(wet, false);
  const PanelGradients gradients(wet, mesh);
  int inner = 0;
  for (int i = 0; i < 6; ++i)
    for (int edge = 0; edge < 4; ++edge) {
      const std::vector<int>& shared = gradients.sharing(i, edge);
      EXPECT_EQ(std::count(shared.begin(), shared.end(), i), 1);
      if (shared.size() == 1) continue;
      ++inner;
      const int other = shared[0] == i ? shared[1] : shared[0];
      bool met = false;
      for (int back = 0; back < 4; ++back)
        met = met || gradients.middle(other, back) == gradients.middle(i, edge);
      EXPECT_TRUE(met) << i << ' ' << edge;
    }
  EXPECT_EQ(inner, 2 * 7);  // 3 + 4 lines between panels, seen from both sides
}

}  // namespace
}  // namespace cutwater::test
