#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "hydro/Conventions.h"
#include "hydro/files/MeshIO.h"
#include "hydro/geometry/Hydrostatics.h"
#include "hydro/geometry/MeshCut.h"
#include "hydro/geometry/MeshEdges.h"
#include "hydro/geometry/MeshIntegrals.h"
#include "hydro/geometry/shapes/Shapes.h"
#include "hydro/geometry/wetted/PressureMesh.h"
#include "hydro/geometry/wetted/ThinnedHull.h"
#include "tests/support/Hulls.h"
#include "tests/support/Meshes.h"
#include "tests/support/Refusal.h"
#include "tests/support/Results.h"

namespace cutwater {
namespace {

struct NamedMesh {
  const char* name;
  SurfaceMesh mesh;
};

/// A ring of round section around the z axis, half in the water.
SurfaceMesh torus(double radius, double section, int around, int across) {
  SurfaceMesh mesh;
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < across; ++j) {
      const double a = 2 * kPi * i / around, b = 2 * kPi * (j + 0.3) / across;
      const double r = radius + section * std::cos(b);
      mesh.vertices.emplace_back(r * std::cos(a), r * std::sin(a), section * std::sin(b));
      const auto index = [&](int k, int l) { return (k % around) * across + l % across; };
      mesh.faces.push_back({{index(i, j), index(i + 1, j), index(i + 1, j + 1), index(i, j + 1)}});
    }
  return mesh;
}

/// The icosahedron, each triangle divided in four and put on the sphere, `times` times.
SurfaceMesh icosphere(double radius, int times) {
  const double g = 0.5 * (1 + std::sqrt(5.0));
  SurfaceMesh mesh;
  mesh.vertices = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                   {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  for (const std::array<int, 3>& f : std::vector<std::array<int, 3>>{
           {0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
           {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
           {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}})
    mesh.faces.push_back({{f[0], f[1], f[2], -1}});
  for (int k = 0; k < times; ++k) {
    SurfaceMesh fine;
    for (const Face& f : mesh.faces) {
      const int n = static_cast<int>(fine.vertices.size());
      for (int i = 0; i < 3; ++i) {
        fine.vertices.push_back(mesh.corner(f, i));
        fine.vertices.push_back(0.5 * (mesh.corner(f, i) + mesh.corner(f, (i + 1) % 3)));
      }
      for (const auto& c : {std::array{0, 1, 5}, {1, 2, 3}, {3, 4, 5}, {1, 3, 5}})
        fine.faces.push_back({{n + c[0], n + c[1], n + c[2], -1}});
    }
    for (Vec3& p : fine.vertices) p.normalize();
    mesh = welded(fine, 1e-9);
  }
  for (Vec3& p : mesh.vertices) p *= radius / p.norm();
  return mesh;
}

SurfaceMesh boat() {
  const std::string file = CUTWATER_MESHES "/boat/boat.glb";
  return readRepaired(file, {.up = "y", .forward = "z"}).hull.surface;
}

/// Round, sharp and flat hulls; two shells; a hole through it; no symmetry; no part in the water.
std::vector<NamedMesh> closedHulls() {
  return {{"frigate", closedFrigate(30, 10)},
          {"icosphere", icosphere(5.0, 3)},
          {"boat", boat()},
          {"catamaran", test::testCatamaran().hull.surface},
          {"ring", torus(5.0, 1.5, 40, 18)},
          {"skewed", test::shaken(closedSphere(5.0, 16, 16), 0.05)},
          {"sunk", test::moved(icosphere(5.0, 3), {0, 1, -20})}};
}

/// V − E + F: 2 for each closed shell, less 2 for each hole through one.
long euler(const SurfaceMesh& mesh) {
  std::set<int> vertices;
  std::set<std::uint64_t> edges;
  for (const Face& f : mesh.faces)
    for (int i = 0; i < f.size(); ++i) vertices.insert(f[i]);
  for (const EdgeUse& use : edgeUses(mesh)) edges.insert(use.edge);
  return static_cast<long>(vertices.size() + mesh.faces.size()) - static_cast<long>(edges.size());
}

TEST(ThinnedHullIdentity, StaysClosedKeepsItsVolumeAndItsTopology) {
  for (const NamedMesh& each : closedHulls()) {
    SCOPED_TRACE(each.name);
    const SurfaceMesh whole = evenTriangles(each.mesh);
    const std::size_t most = whole.faces.size() / 5;
    const ThinnedHull thin = thinned(each.mesh, most);
    EXPECT_LE(thin.mesh.faces.size(), most);
    EXPECT_GE(thin.mesh.faces.size() + 4, most);  // two triangles go at a time, on each side
    EXPECT_TRUE(openEdges(thin.mesh).empty());
    EXPECT_EQ(euler(thin.mesh), euler(whole));
    // Round-off of some thousand small changes.
    EXPECT_LT(std::abs(thin.volumeError), 1e-12);
    // evenTriangles leaves what one quadrilateral may be off; it goes another way over a half.
    const double volume = volumeIntegrals(each.mesh).volume;
    EXPECT_NEAR(volumeIntegrals(thin.mesh).volume, volume, 1e-6 * volume);
    EXPECT_LT(thin.distance, 0.02 * bounds(whole).diagonal());
    const ThinnedHull again = thinned(each.mesh, most);
    EXPECT_EQ(again.mesh.vertices, thin.mesh.vertices);
    EXPECT_TRUE(test::sameFaces(again.mesh, thin.mesh));
  }
}

TEST(ThinnedHullIdentity, FlatSidesAndEdgesStayWhereTheyAre) {
  // Merging over an edge would cost volume, along it nothing. A new vertex is drawn towards the
  // middle of the old ones by (kToMiddle a)² of their distance, where a is how many times larger
  // the squared areas of the long sides are than those of the ends: here 100, so 1e-6 of 10 m.
  const SurfaceMesh box = evenTriangles(closedBox({10, 4, 2, 1}, 20, 6, 5));
  const ThinnedHull thin = thinned(box, 100);
  EXPECT_LE(thin.mesh.faces.size(), 100u);
  EXPECT_LT(thin.distance, 1e-5);
  EXPECT_LT(thin.submergedError, 1e-6);
  EXPECT_LT(thin.waterplaneError, 1e-6);
  EXPECT_NEAR(surfaceArea(thin.mesh), 2 * (10 * 4 + 10 * 3 + 4 * 3), 1e-6 * 164);
}

TEST(ThinnedHullIdentity, AMirrorImageStaysOne) {
  for (const SurfaceMesh& hull : {closedFrigate(30, 10), test::testCatamaran().hull.surface}) {
    for (const std::size_t most : {400ul, 100000ul}) {
      const SurfaceMesh thin = thinned(hull, most).mesh;
      EXPECT_TRUE(test::sameFaces(thin, mirroredInY(thin)));
    }
  }
}

TEST(ThinnedHull, AHullWithFewTrianglesComesBack) {
  const SurfaceMesh sphere = icosphere(5.0, 2);
  const SurfaceMesh skewed = test::shaken(sphere, 0.1);
  const ThinnedHull same = thinned(skewed, skewed.faces.size());
  EXPECT_EQ(same.mesh.vertices, skewed.vertices);
  EXPECT_EQ(same.distance, 0.0);
  // A bound that no closed surface can meet.
  EXPECT_GE(thinned(sphere, 2).mesh.faces.size(), 4u);
  EXPECT_TRUE(openEdges(thinned(sphere, 2).mesh).empty());
  test::expectRefusal(Fault::MeshEmpty, {"thinned"}, [] { thinned({}, 100); });
}

TEST(ThinnedHull, TrianglesOfNoAreaAndOpenEdgesDoNoHarm) {
  SurfaceMesh sphere = test::shaken(icosphere(5.0, 3), 0.01);
  // Every tenth triangle gets a vertex on its edge, and beside it the one of no area.
  const std::size_t count = sphere.faces.size();
  for (std::size_t k = 0; k < count; k += 10) {
    const Face f = sphere.faces[k];
    const int middle = static_cast<int>(sphere.vertices.size());
    sphere.vertices.push_back(0.5 * (sphere.corner(f, 0) + sphere.corner(f, 1)));
    sphere.faces[k] = {{f[0], middle, f[2], -1}};
    sphere.faces.push_back({{middle, f[1], f[2], -1}});
    sphere.faces.push_back({{f[0], f[1], middle, -1}});
  }
  const ThinnedHull thin = thinned(sphere, 300);
  EXPECT_LE(thin.mesh.faces.size(), 300u);
  EXPECT_TRUE(openEdges(thin.mesh).empty());
  EXPECT_LT(std::abs(thin.volumeError), 1e-12);
  EXPECT_LT(thin.distance, 0.5);
  sphere.faces.erase(sphere.faces.begin() + 17);
  const std::size_t open = openEdges(sphere).size();
  const SurfaceMesh holed = thinned(sphere, 300).mesh;
  EXPECT_LE(holed.faces.size(), 300u);
  EXPECT_EQ(openEdges(holed).size(), open);
}

TEST(ThinnedHullConvergence, AreaOfASphereInFirstOrderOfTheTriangles) {
  // Triangles of edge h leave the surface by h², and h² is area over triangles. The area is that of
  // the sphere with the volume that is kept, (36π V²)^⅓; no other body has less.
  const SurfaceMesh sphere = icosphere(5.0, 5);  // 20 480 triangles
  const double area = std::cbrt(36 * kPi * std::pow(volumeIntegrals(sphere).volume, 2));
  std::vector<double> error;
  for (const std::size_t most : {4000ul, 2000ul, 1000ul, 500ul})
    error.push_back(surfaceArea(thinned(sphere, most).mesh) / area - 1.0);
  EXPECT_GT(error.front(), 0.0);
  for (std::size_t i = 1; i < error.size(); ++i)
    EXPECT_NEAR(std::log2(error[i] / error[i - 1]), 1.0, 0.1);
}

// Thinned to 2000 triangles a hull floats as before: each entry within 0.1 % of the hydrostatics
// that a ship is told, as little as its whole volume may differ from its mass.
TEST(ThinnedHullConvergence, AHullFloatsAsBeforeWithFewTriangles) {
  const bool full = test::fullSize();
  const std::size_t many = full ? 100'000 : 25'000;
  const std::vector<NamedMesh> hulls{
      {"frigate", full ? closedFrigate(280, 36) : closedFrigate(140, 18)},
      {"boat", refined(boat(), 0.01, many).mesh},
      {"catamaran", refined(test::testCatamaran().hull.surface, 0.1, many).mesh}};
  for (const NamedMesh& each : hulls) {
    SCOPED_TRACE(each.name);
    // G in calm water, so that GM is of the size of ships'.
    const auto floating = [cog = Vec3(volumeIntegrals(cutBelow(each.mesh)).centroid().x(), 0, 0)](
                              const SurfaceMesh& hull) {
      return hydrostatics(cutBelow(hull), cog, kSeaWaterDensity, kStandardGravity);
    };
    const Hydrostatics whole = floating(each.mesh);
    double before = 0.0;
    for (const std::size_t most : {6000ul, 2000ul, 500ul}) {
      const ThinnedHull thin = thinned(each.mesh, most);
      const Hydrostatics now = floating(thin.mesh);
      const auto error = [&](int i) {
        return std::abs(now.restoring(i, i) / whole.restoring(i, i) - 1.0);
      };
      const double volume = std::abs(now.volume / whole.volume - 1.0);
      const double worst = std::max({volume, error(2), error(3), error(4)});
      const double centre = (now.buoyancy - whole.buoyancy).norm() / whole.draft;
      EXPECT_LE(before, 2.0 * worst) << most;  // it falls with the triangles
      before = worst;
      if (most != 2000) continue;
      EXPECT_LT(worst, 1e-3);
      EXPECT_LT(centre, 1e-3);
      EXPECT_NEAR(thin.submergedError, volume, 1e-6);
      const std::string hull = each.name;
      test::recordResult("Wetted hull", hull + ", thinned to 2000 triangles: V, C33, C44, C55",
                         "all triangles", worst, "1e-3");
      test::recordResult("Wetted hull", hull + ", the same: centre of buoyancy over draught",
                         "all triangles", centre, "1e-3");
    }
  }
}

}  // namespace
}  // namespace cutwater
