#include "hydro/files/Polygons.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "hydro/geometry/MeshIntegrals.h"
#include "tests/support/Meshes.h"

namespace cutwater {
namespace {

struct PlaneCorner {
  double x, y;
};
using PlanePolygon = std::vector<PlaneCorner>;

/// Twice the enclosed area, by the shoelace formula.
double shoelace(const PlanePolygon& p) {
  double sum = 0.0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const PlaneCorner &a = p[i], &b = p[(i + 1) % p.size()];
    sum += a.x * b.y - b.x * a.y;
  }
  return sum;
}

const Vec3 kAcross = Vec3(1, 2, 2) / 3, kUp = Vec3(2, 1, -2) / 3;  // a plane that leans

/// The polygon in that plane, beginning with corner `first`, divided.
SurfaceMesh dividedPolygon(const PlanePolygon& p, std::size_t first = 0) {
  SurfaceMesh mesh;
  for (const PlaneCorner& c : p) mesh.vertices.push_back(c.x * kAcross + c.y * kUp);
  std::vector<int> corners(p.size());
  std::iota(corners.begin(), corners.end(), 0);
  std::rotate(corners.begin(), corners.begin() + static_cast<std::ptrdiff_t>(first), corners.end());
  addPolygon(mesh, corners);
  return mesh;
}

/// Parts that turn as the polygon does and have its area together neither overlap nor leave a gap,
/// and no part lies outside: open edges are those of the outline.
void expectDivided(const PlanePolygon& p) {
  for (std::size_t first = 0; first < p.size(); ++first) {
    const SurfaceMesh mesh = dividedPolygon(p, first);
    EXPECT_EQ(mesh.vertices.size(), p.size());
    double sum = 0.0;
    for (const Face& f : mesh.faces) {
      const double area = vectorArea(mesh, f).dot(kAcross.cross(kUp));
      EXPECT_GE(area, -1e-14);  // round-off of coordinates of 10
      sum += area;
    }
    EXPECT_NEAR(2 * sum / shoelace(p), 1.0, 1e-13);  // round-off of ten products
    std::vector<OpenEdge> open = openEdges(mesh);
    EXPECT_EQ(open.size(), p.size());
    for (const OpenEdge& e : open) EXPECT_EQ((e.from + 1) % static_cast<int>(p.size()), e.to);
  }
}

PlanePolygon star(int points, double inner) {
  PlanePolygon p;
  for (int i = 0; i < 2 * points; ++i) {
    const double r = i % 2 == 0 ? 5.0 : inner, angle = kPi * i / points;
    p.push_back({r * std::cos(angle), r * std::sin(angle)});
  }
  return p;
}

TEST(Polygons, FewerThanThreeCornersAreNoFace) {
  SurfaceMesh mesh{{Vec3::Zero(), Vec3::UnitX()}, {}};
  for (const std::vector<int>& corners : {std::vector<int>{}, {0}, {0, 1}})
    addPolygon(mesh, corners);
  EXPECT_TRUE(mesh.faces.empty());
}

TEST(Polygons, ATriangleAndAConvexQuadrilateralStayAsTheyAre) {
  const SurfaceMesh three = dividedPolygon({{0, 0}, {4, 0}, {1, 3}}, 1);
  ASSERT_EQ(three.faces.size(), 1u);
  EXPECT_EQ(three.faces[0].v, (std::array<int, 4>{1, 2, 0, -1}));
  const SurfaceMesh four = dividedPolygon({{0, 0}, {4, 0}, {5, 3}, {1, 3}}, 2);
  ASSERT_EQ(four.faces.size(), 1u);
  EXPECT_EQ(four.faces[0].v, (std::array<int, 4>{2, 3, 0, 1}));
}

TEST(Polygons, AReentrantQuadrilateralIsTwoTriangles) {
  const PlanePolygon dart{{0, 0}, {4, -3}, {1, 0}, {4, 3}};
  expectDivided(dart);
  EXPECT_EQ(dividedPolygon(dart).faces.size(), 2u);
}

TEST(PolygonsClosedForm, TrianglesCoverAStarOnce) {
  for (const int points : {3, 5, 12})
    for (const double inner : {0.5, 2.0, 4.9}) {
      expectDivided(star(points, inner));
      // n corners: n − 2 triangles.
      EXPECT_EQ(dividedPolygon(star(points, inner)).faces.size(),
                static_cast<std::size_t>(2 * points - 2));
    }
}

TEST(PolygonsClosedForm, TrianglesCoverACombAndASpiralOnce) {
  PlanePolygon comb{{0, -1}, {10, -1}};
  for (int tooth = 5; tooth-- > 0;) {
    comb.push_back({2.0 * tooth + 1.5, 4});
    comb.push_back({2.0 * tooth, 0});
  }
  expectDivided(comb);
  expectDivided({{0, 0},
                 {6, 0},
                 {6, 6},
                 {1, 6},
                 {1, 2},
                 {4, 2},
                 {4, 4},
                 {3, 4},
                 {3, 3},
                 {2, 3},
                 {2, 5},
                 {5, 5},
                 {5, 1},
                 {0, 1}});
}

TEST(PolygonsClosedForm, CornersInALineStayCorners) {
  expectDivided({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 2}, {2, 2}, {1, 2}, {0, 2}, {0, 1}});
}

TEST(Polygons, APolygonWithoutAreaStillUsesEveryEdgeOnce) {
  const SurfaceMesh mesh = dividedPolygon({{0, 0}, {1, 0}, {3, 0}, {5, 0}, {2, 0}});
  EXPECT_EQ(mesh.faces.size(), 3u);
  EXPECT_EQ(openEdges(mesh).size(), 5u);
}

TEST(PolygonsIdentity, TheMirrorImageHasTheOppositeNormal) {
  PlanePolygon p = star(7, 2.0);
  const SurfaceMesh mesh = dividedPolygon(p);
  std::reverse(p.begin(), p.end());
  const SurfaceMesh image = dividedPolygon(p);
  EXPECT_LT((test::vectorAreaOf(mesh) + test::vectorAreaOf(image)).norm(), 1e-13);  // of 24 m²
  EXPECT_NEAR(surfaceArea(image) / surfaceArea(mesh), 1.0, 1e-13);                  // round-off
}

}  // namespace
}  // namespace cutwater
