#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "hydro/geometry/MeshIntegrals.h"
#include "hydro/geometry/panelling/FlatEnd.h"
#include "hydro/geometry/panelling/PanelQuality.h"
#include "tests/support/Meshes.h"

namespace cutwater {
namespace {

/// Corners of half an end in the plane x = 3, from calm water down the port side to the centreline.
struct EndCorner {
  double y, z;
};
using EndOutline = std::vector<EndCorner>;

/// The outline divided into edges of about `size`, in a mesh of its vertices alone.
SurfaceMesh outlineMesh(const EndOutline& corners, double size) {
  SurfaceMesh mesh;
  for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
    const EndCorner &a = corners[i], &b = corners[i + 1];
    const int parts =
        std::max(1, static_cast<int>(std::lround(std::hypot(b.y - a.y, b.z - a.z) / size)));
    for (int k = 0; k < parts; ++k) {
      const double t = static_cast<double>(k) / parts;
      mesh.vertices.emplace_back(3.0, a.y + t * (b.y - a.y), a.z + t * (b.z - a.z));
    }
  }
  mesh.vertices.emplace_back(3.0, corners.back().y, corners.back().z);
  return mesh;
}

EndOutline bothSides(const EndOutline& half) {
  EndOutline whole = half;
  for (std::size_t k = half.size() - 1; k-- > 0;) whole.push_back({-half[k].y, half[k].z});
  return whole;
}

std::vector<int> allVertices(const SurfaceMesh& mesh) {
  std::vector<int> all;
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) all.push_back(static_cast<int>(v));
  return all;
}

/// Area, ∫ y dA and ∫ z dA.
Vec3 momentsOf(const SurfaceMesh& mesh) {
  Vec3 sum = Vec3::Zero();
  for (const Face& f : triangulated(mesh).faces) {
    const Vec3 centre = (mesh.corner(f, 0) + mesh.corner(f, 1) + mesh.corner(f, 2)) / 3;
    sum += std::abs(vectorArea(mesh, f).x()) * Vec3(1, centre.y(), centre.z());
  }
  return sum;
}

/// The same of what the outline and calm water, or the centreline too, enclose.
Vec3 momentsWithin(const SurfaceMesh& outline, bool half) {
  std::vector<Vec3> p = outline.vertices;
  if (half) p.emplace_back(3.0, 0.0, 0.0);
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 1; i + 1 < p.size(); ++i) {
    const double area = -0.5 * (p[i] - p[0]).cross(p[i + 1] - p[0]).x();
    const Vec3 centre = (p[0] + p[i] + p[i + 1]) / 3;
    sum += area * Vec3(1, centre.y(), centre.z());
  }
  return sum;
}

/// Panels face aft or forward, cover what the outline encloses once, and have each of its edges.
void expectFilled(const EndOutline& corners, double size, bool half) {
  const SurfaceMesh outline = outlineMesh(corners, size);
  for (const bool aft : {true, false}) {
    SurfaceMesh mesh = outline;
    addFlatEnd(allVertices(outline), aft, size, mesh);
    for (const Face& f : mesh.faces) EXPECT_GT((aft ? -1 : 1) * vectorArea(mesh, f).x(), 1e-9);
    for (std::size_t v = 0; v < outline.vertices.size(); ++v)
      EXPECT_EQ(mesh.vertices[v], outline.vertices[v]);
    for (const Vec3& p : mesh.vertices) EXPECT_EQ(p.x(), 3.0);
    // Covered once: area and first moments are those of the polygon, to round-off of 50 m³.
    const Vec3 wanted = momentsWithin(outline, half);
    EXPECT_LT((momentsOf(mesh) - wanted).norm(), 1e-10) << momentsOf(mesh).transpose();
    int shared = 0;
    for (const OpenEdge& e : openEdges(mesh)) {
      const Vec3 &a = mesh.vertices[static_cast<std::size_t>(e.from)],
                 &b = mesh.vertices[static_cast<std::size_t>(e.to)];
      const bool ofOutline = std::abs(e.from - e.to) == 1 &&
                             std::max(e.from, e.to) < static_cast<int>(outline.vertices.size());
      const bool ofPlanes = (a.z() == 0 && b.z() == 0) || (half && a.y() == 0 && b.y() == 0);
      EXPECT_TRUE(ofOutline || ofPlanes) << a.transpose() << ", " << b.transpose();
      shared += ofOutline ? 1 : 0;
    }
    EXPECT_EQ(shared, static_cast<int>(outline.vertices.size()) - 1);
  }
}

EndOutline roundEnd(double breadth, double depth) {
  EndOutline half;
  for (int i = 0; i <= 12; ++i) {
    const double a = 0.5 * kPi * i / 12;
    half.push_back({i == 12 ? 0.0 : breadth * std::cos(a), i == 0 ? 0.0 : -depth * std::sin(a)});
  }
  return half;
}

TEST(FlatEndClosedForm, ARectangleIsDividedInRowsAndColumns) {
  const SurfaceMesh outline = outlineMesh({{4, 0}, {4, -3}, {0, -3}}, 1.0);
  SurfaceMesh mesh = outline;
  addFlatEnd(allVertices(outline), true, 1.0, mesh);
  EXPECT_EQ(mesh.faces.size(), 12u);
  for (const Face& f : mesh.faces)
    EXPECT_LT((vectorArea(mesh, f) - Vec3(-1, 0, 0)).norm(), 1e-14) << f.size();
}

TEST(FlatEndClosedForm, HalfEndsAreCoveredOnce) {
  for (const double size : {0.4, 1.0, 2.5})
    for (const EndOutline& half :
         {EndOutline{{4, 0}, {4, -3}, {0, -3}}, EndOutline{{4, 0}, {3, -2}, {0, -3}},
          EndOutline{{5, 0}, {0, -2}}, EndOutline{{1, 0}, {4, -4}, {0, -5}}, roundEnd(4, 4),
          roundEnd(6, 2), roundEnd(1.5, 6)})
      expectFilled(half, size, true);
}

TEST(FlatEndClosedForm, WholeEndsAreCoveredOnce) {
  for (const double size : {0.4, 1.0, 2.5})
    for (const EndOutline& half :
         {EndOutline{{4, 0}, {4, -3}, {0, -3}}, EndOutline{{4, 0}, {3, -2}, {0, -3}},
          EndOutline{{1, 0}, {4, -4}, {0, -5}}, roundEnd(4, 4), roundEnd(6, 2)})
      expectFilled(bothSides(half), size, false);
}

// As of a ship that heels: one side is deep, the other shallow.
TEST(FlatEndClosedForm, AHeeledEndIsCoveredOnce) {
  for (const double size : {0.5, 1.0, 2.0})
    for (const EndOutline& outline :
         {EndOutline{{4, 0}, {4, -1}, {-4, -4}, {-5, 0}},
          EndOutline{{6, 0}, {5, -4}, {-4, -1}, {-4, 0}}, EndOutline{{4, 0}, {-3, -5}, {-4, 0}}})
      expectFilled(outline, size, false);
}

TEST(FlatEnd, PanelsAreNotStretched) {
  for (const EndOutline& half : {roundEnd(4, 4), EndOutline{{4, 0}, {4, -3}, {0, -3}}}) {
    SurfaceMesh mesh = outlineMesh(half, 0.5);
    addFlatEnd(allVertices(mesh), false, 0.5, mesh);
    const auto stretched = std::count_if(mesh.faces.begin(), mesh.faces.end(), [&](const Face& f) {
      return aspectRatio(mesh, f) > kStretched;
    });
    EXPECT_LE(static_cast<double>(stretched), 0.05 * static_cast<double>(mesh.faces.size()));
  }
}

TEST(FlatEnd, WhereNothingIsEnclosedThereAreNoPanels) {
  for (const EndOutline& outline :
       {EndOutline{{4, 0}, {0, 0}},                  // calm water
        EndOutline{{0, 0}, {0, -3}},                 // a stem
        EndOutline{{1e-4, 0}, {1e-4, -3}, {0, -3}},  // as good as a stem
        EndOutline{{4, 0}, {-4, 0}}}) {
    SurfaceMesh mesh = outlineMesh(outline, 1.0);
    const std::size_t vertices = mesh.vertices.size();
    addFlatEnd(allVertices(mesh), true, 1.0, mesh);
    EXPECT_TRUE(mesh.faces.empty());
    EXPECT_EQ(mesh.vertices.size(), vertices);
  }
  SurfaceMesh point{{{3, 0, 0}}, {}};
  addFlatEnd({0}, true, 1.0, point);
  EXPECT_TRUE(point.faces.empty());
}

TEST(FlatEndIdentity, AForwardEndIsAnAfterEndTurnedOver) {
  for (const double size : {0.5, 1.0})
    for (const EndOutline& half : {roundEnd(4, 4), EndOutline{{4, 0}, {4, -3}, {0, -3}},
                                   EndOutline{{4, 0}, {3, -2}, {0, -3}}}) {
      SurfaceMesh aft = outlineMesh(half, size), forward = aft;
      addFlatEnd(allVertices(aft), true, size, aft);
      addFlatEnd(allVertices(forward), false, size, forward);
      EXPECT_TRUE(test::sameFaces(turnedOver(aft), forward)) << size;
    }
}

TEST(FlatEndIdentity, FacesOfTheMeshStayAndComeFirst) {
  SurfaceMesh mesh = outlineMesh({{4, 0}, {4, -3}, {0, -3}}, 1.0);
  mesh.faces.push_back({{0, 1, 2, -1}});
  addFlatEnd({0, 1, 2, 3, 4, 5, 6, 7}, true, 1.0, mesh);
  EXPECT_EQ(mesh.faces.front().v, (std::array<int, 4>{0, 1, 2, -1}));
  EXPECT_EQ(mesh.faces.size(), 13u);
}

}  // namespace
}  // namespace cutwater
