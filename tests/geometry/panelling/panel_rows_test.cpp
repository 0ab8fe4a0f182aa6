#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "hydro/geometry/MeshIntegrals.h"
#include "hydro/geometry/panelling/PanelRows.h"
#include "tests/support/Meshes.h"

namespace cutwater {
namespace {

/// Vertices at these y on the line x, z = −1.
std::vector<int> addRow(SurfaceMesh& mesh, double x, const std::vector<double>& y) {
  std::vector<int> row;
  for (const double value : y) {
    row.push_back(static_cast<int>(mesh.vertices.size()));
    mesh.vertices.emplace_back(x, value, -1.0);
  }
  return row;
}

/// From y = 0 to 6 in equal parts.
std::vector<double> sixIn(int parts) {
  std::vector<double> y;
  for (int i = 0; i <= parts; ++i) y.push_back(6.0 * i / parts);
  return y;
}

/// Panels between the lines x = 0 and x = 2 cover the strip once and use each edge of either row.
void expectStrip(const SurfaceMesh& mesh, double area, std::size_t edges) {
  for (const Face& f : mesh.faces) EXPECT_GT(vectorArea(mesh, f).z(), 1e-9);
  EXPECT_NEAR(surfaceArea(mesh), area, 1e-12);  // round-off
  EXPECT_EQ(openEdges(mesh).size(), edges + 2);
}

TEST(PanelRowsClosedForm, WithoutCrowdingPartsAreEqual) {
  const Division d = divided(10.0, {}, 5.0, {});
  EXPECT_EQ(d.breaks, (std::vector<int>{0, 5}));
  ASSERT_EQ(d.place.size(), 6u);
  for (int i = 0; i <= 5; ++i) EXPECT_NEAR(d.place[static_cast<std::size_t>(i)], 2.0 * i, 1e-14);
}

TEST(PanelRows, AHalfIsRoundedDown) {
  for (const auto& [count, parts] : std::vector<std::pair<double, int>>{
           {0.0, 1}, {1.4, 1}, {1.5, 1}, {1.6, 2}, {7.5, 7}, {7.51, 8}})
    EXPECT_EQ(divided(3.0, {}, count, {}).breaks.back(), parts) << count;
}

TEST(PanelRows, CornersArePlacesAndEachPartHasOneAtLeast) {
  const Division d = divided(10.0, {4.0, 4.1, 9.0}, 5.0, {});
  ASSERT_EQ(d.breaks.size(), 5u);
  const double wanted[] = {0.0, 4.0, 4.1, 9.0, 10.0};
  for (std::size_t i = 0; i < 5; ++i)
    EXPECT_EQ(d.place[static_cast<std::size_t>(d.breaks[i])], wanted[i]);
  EXPECT_EQ(d.breaks, (std::vector<int>{0, 2, 3, 5, 6}));  // 2, 0.05, 2.45 and 0.5 parts are due
  EXPECT_TRUE(std::is_sorted(d.place.begin(), d.place.end(), std::less_equal<>()));
}

// place(u) = L (u − c sin(2πu)/2π) with both ends crowded, L (u − c sin(πu)/π) with the start.
TEST(PanelRowsClosedForm, CrowdingFollowsItsFormula) {
  for (const double c : {0.2, 0.6, 0.95}) {
    const Division both = divided(7.0, {}, 16.0, {true, true, c}),
                   start = divided(7.0, {}, 16.0, {true, false, c});
    for (std::size_t i = 0; i <= 16; ++i) {
      const double u = static_cast<double>(i) / 16;
      EXPECT_NEAR(both.place[i], 7 * (u - c * std::sin(2 * kPi * u) / (2 * kPi)), 1e-14);
      EXPECT_NEAR(start.place[i], 7 * (u - c * std::sin(kPi * u) / kPi), 1e-14);
    }
    // The first part is about 1 − c of the mean: 1 − cos(π/16) and less of c is lacking.
    EXPECT_NEAR(start.place[1] / (7.0 / 16), 1 - c, 0.02 * c);
  }
}

TEST(PanelRowsIdentity, TheMirrorImageOfADivisionIsThatOfTheMirrorImage) {
  const std::vector<double> corners{2.0, 5.5}, mirrored{10 - 5.5, 10 - 2.0};
  for (const bool start : {false, true})
    for (const bool end : {false, true})
      for (const double count : {3.0, 8.5, 20.0}) {
        const Division a = divided(10, corners, count, {start, end, 0.6}),
                       b = divided(10, mirrored, count, {end, start, 0.6});
        ASSERT_EQ(a.place.size(), b.place.size());
        // The places of corners in the count are found by bisection to 2⁻⁵⁰.
        for (std::size_t i = 0; i < a.place.size(); ++i)
          EXPECT_NEAR(a.place[i], 10 - b.place[b.place.size() - 1 - i], 1e-13);
      }
}

TEST(PanelRows, ACurveWithoutLengthIsDividedToo) {
  const Division d = divided(0.0, {}, 3.0, {true, true, 0.6});
  EXPECT_EQ(d.breaks, (std::vector<int>{0, 3}));
  for (const double place : d.place) EXPECT_EQ(place, 0.0);
}

TEST(PanelRowsClosedForm, EqualRowsAreJoinedByQuadrilaterals) {
  SurfaceMesh mesh;
  const PanelRow a{addRow(mesh, 0, sixIn(4)), {0, 4}}, b{addRow(mesh, 2, sixIn(4)), {0, 4}};
  addPanelsBetween(a, b, mesh);
  ASSERT_EQ(mesh.faces.size(), 4u);
  for (const Face& f : mesh.faces) {
    EXPECT_EQ(f.size(), 4);
    EXPECT_LT((vectorArea(mesh, f) - Vec3(0, 0, 3)).norm(), 1e-13);  // (a → b) × (along): up
  }
  expectStrip(mesh, 12.0, 8);
}

TEST(PanelRowsClosedForm, WhereOneRowHasMoreThereAreTriangles) {
  for (const auto& [m, n] :
       std::vector<std::pair<int, int>>{{4, 5}, {5, 4}, {2, 7}, {7, 1}, {1, 2}}) {
    SurfaceMesh mesh;
    const PanelRow a{addRow(mesh, 0, sixIn(m)), {0, m}}, b{addRow(mesh, 2, sixIn(n)), {0, n}};
    addPanelsBetween(a, b, mesh);
    expectStrip(mesh, 12.0, static_cast<std::size_t>(m + n));
    const auto triangles = std::count_if(mesh.faces.begin(), mesh.faces.end(),
                                         [](const Face& f) { return f.size() == 3; });
    EXPECT_GE(triangles, std::abs(m - n));
  }
}

TEST(PanelRowsClosedForm, ARowOfOneVertexMakesAFan) {
  for (const bool first : {false, true}) {
    SurfaceMesh mesh;
    const PanelRow point{addRow(mesh, first ? 0 : 2, {3.0}), {0}},
        row{addRow(mesh, first ? 2 : 0, sixIn(5)), {0, 5}};
    addPanelsBetween(first ? point : row, first ? row : point, mesh);
    EXPECT_EQ(mesh.faces.size(), 5u);
    expectStrip(mesh, 6.0, 5);
  }
}

TEST(PanelRows, RowsWithCommonVerticesMakeNoFaceWithoutArea) {
  SurfaceMesh mesh;
  std::vector<int> a = addRow(mesh, 0, sixIn(3)), b = addRow(mesh, 2, sixIn(3));
  b[0] = a[0];
  b[1] = a[1];
  addPanelsBetween(PanelRow{a, {0, 3}}, PanelRow{b, {0, 3}}, mesh);
  ASSERT_EQ(mesh.faces.size(), 2u);  // nothing lies between the first two of either row
  EXPECT_EQ(mesh.faces[0].size(), 3);
  EXPECT_EQ(mesh.faces[1].size(), 4);
  for (const Face& f : mesh.faces) EXPECT_GT(vectorArea(mesh, f).z(), 1e-9);
}

bool hasEdge(const SurfaceMesh& mesh, int a, int b) {
  return std::any_of(mesh.faces.begin(), mesh.faces.end(), [&](const Face& f) {
    for (int i = 0; i < f.size(); ++i)
      if (std::minmax(f[i], f[(i + 1) % f.size()]) == std::minmax(a, b)) return true;
    return false;
  });
}

// The knuckle runs from the third vertex of one row to the fifth of the other.
TEST(PanelRows, KnucklesAreJoinedWhereRowsHaveAsMany) {
  SurfaceMesh mesh;
  const PanelRow a{addRow(mesh, 0, sixIn(6)), {0, 2, 6}}, b{addRow(mesh, 2, sixIn(6)), {0, 4, 6}};
  addPanelsBetween(a, b, mesh);
  EXPECT_TRUE(hasEdge(mesh, a.vertex[2], b.vertex[4]));
  expectStrip(mesh, 12.0, 12);
  SurfaceMesh other = mesh;
  other.faces.clear();
  addPanelsBetween(a, PanelRow{b.vertex, {0, 2, 4, 6}}, other);  // one knuckle ends: as if none
  EXPECT_FALSE(hasEdge(other, a.vertex[2], b.vertex[4]));
  EXPECT_TRUE(hasEdge(other, a.vertex[2], b.vertex[2]));
  expectStrip(other, 12.0, 12);
}

TEST(PanelRows, PanelsJoinWhatHasTheSameParameter) {
  SurfaceMesh mesh;
  const std::vector<double> ya{0, 1, 2, 4, 6}, yb{0, 4, 6};
  const std::vector<int> a = addRow(mesh, 0, ya), b = addRow(mesh, 2, yb);
  addPanelsBetween(a, ya, b, yb, mesh);
  expectStrip(mesh, 12.0, 6);
  EXPECT_TRUE(hasEdge(mesh, a[3], b[1]));  // both at 4
}

}  // namespace
}  // namespace cutwater
