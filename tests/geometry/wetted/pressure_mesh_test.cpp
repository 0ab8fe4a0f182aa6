#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "hydro/geometry/MeshIntegrals.h"
#include "hydro/geometry/SurfaceTree.h"
#include "hydro/geometry/shapes/Shapes.h"
#include "hydro/geometry/wetted/PressureMesh.h"
#include "tests/support/Hulls.h"
#include "tests/support/Meshes.h"
#include "tests/support/Refusal.h"

namespace cutwater {
namespace {

struct NamedMesh {
  const char* name;
  SurfaceMesh mesh;
};

/// Closed surfaces: a box, a sphere, a frigate; two shells; one without symmetry; one with a
/// triangle of no area.
std::vector<NamedMesh> closedSurfaces() {
  const SurfaceMesh box = evenTriangles(closedBox({8, 4, 2, 1}, 1, 1, 1));
  const SurfaceMesh sphere = closedSphere(5.0, 8, 8), frigate = closedFrigate(16, 4);
  SurfaceMesh flat = box;  // a vertex on an edge, and the triangle of no area that closes the gap
  const Face f = flat.faces[0];
  const int middle = static_cast<int>(flat.vertices.size());
  flat.vertices.push_back(0.5 * (flat.corner(f, 0) + flat.corner(f, 1)));
  flat.faces[0] = {{f[0], middle, f[2], -1}};
  flat.faces.push_back({{middle, f[1], f[2], -1}});
  flat.faces.push_back({{f[0], f[1], middle, -1}});
  return {{"box", box},
          {"sphere", sphere},
          {"frigate", frigate},
          {"catamaran", test::testCatamaran().hull.surface},
          {"skewed", test::shaken(sphere, 0.4)},
          {"flat triangle", flat}};
}

void expectSameSurface(const SurfaceMesh& before, const SurfaceMesh& after) {
  const double size = bounds(before).diagonal();
  EXPECT_TRUE(openEdges(after).empty());
  // New vertices lie on edges to round-off of the coordinates, 2e-16 of the size each.
  const double roundOff = 1e-14;
  const VolumeIntegrals v = volumeIntegrals(before), w = volumeIntegrals(after);
  EXPECT_NEAR(w.volume, v.volume, roundOff * size * size * size);
  EXPECT_LT((w.moment - v.moment).norm(), roundOff * std::pow(size, 4));
  // Of a sum of so many areas.
  const double area = surfaceArea(before), sum = 2e-16 * static_cast<double>(after.faces.size());
  EXPECT_NEAR(surfaceArea(after), area, (roundOff + sum) * area);
  const SurfaceTree tree(before);
  for (const Vec3& p : after.vertices) EXPECT_LT(tree.distance(p), roundOff * size);
}

double longestEdge(const SurfaceMesh& mesh) {
  double longest = 0.0;
  for (const Face& f : mesh.faces)
    for (int i = 0; i < f.size(); ++i)
      longest = std::max(longest, (mesh.corner(f, i) - mesh.corner(f, (i + 1) % f.size())).norm());
  return longest;
}

/// The least angle of the triangles [rad]; those of no area left out.
double leastAngle(const SurfaceMesh& mesh) {
  double least = kPi;
  for (const Face& f : mesh.faces)
    for (int i = 0; i < 3; ++i) {
      const Vec3 a = mesh.corner(f, (i + 1) % 3) - mesh.corner(f, i),
                 b = mesh.corner(f, (i + 2) % 3) - mesh.corner(f, i);
      if (a.cross(b).norm() > 1e-9 * a.norm() * b.norm())
        least = std::min(least, std::atan2(a.cross(b).norm(), a.dot(b)));
    }
  return least;
}

TEST(PressureMeshIdentity, EvenTrianglesKeepTheVolumeOfTwistedFaces) {
  const SurfaceMesh frigate = closedFrigate(32, 7);
  const SurfaceMesh even = evenTriangles(frigate);
  double largest = 0.0;  // what one face may leave
  for (const Face& f : frigate.faces)
    if (f.size() == 4) {
      const Vec3 a = frigate.corner(f, 0);
      largest = std::max(largest, std::abs((frigate.corner(f, 1) - a)
                                               .cross(frigate.corner(f, 2) - a)
                                               .dot(frigate.corner(f, 3) - a)) /
                                      12);
    }
  EXPECT_NEAR(volumeIntegrals(even).volume, volumeIntegrals(frigate).volume, 1.0001 * largest);
  EXPECT_TRUE(openEdges(even).empty());
  for (const Face& f : even.faces) EXPECT_EQ(f.size(), 3);
}

TEST(PressureMeshIdentity, SplitAtStationsIsTheSameSurface) {
  for (const NamedMesh& each : closedSurfaces()) {
    SCOPED_TRACE(each.name);
    const SurfaceMesh whole = evenTriangles(each.mesh);
    const Bounds box = bounds(whole);
    const double length = box.high.x() - box.low.x();
    std::vector<double> stations{box.low.x(), 0.0, box.high.x(), box.high.x() + 1.0};
    for (int i = 0; i < 13; ++i) stations.push_back(box.low.x() + length * (0.077 * i + 0.003));
    const SurfaceMesh split = splitAt(whole, stations);
    expectSameSurface(whole, split);
    const double tolerance = 1e-9 * box.diagonal();  // as in the header
    for (const Face& f : split.faces)
      for (const double station : stations) {
        double low = length, high = -length;
        for (int i = 0; i < 3; ++i) {
          low = std::min(low, split.corner(f, i).x() - station);
          high = std::max(high, split.corner(f, i).x() - station);
        }
        EXPECT_FALSE(low < -tolerance && high > tolerance);
      }
  }
}

TEST(PressureMesh, ABoxOfTwelveTrianglesAtAStation) {
  // A plane between its ends cuts the eight triangles of the four long sides into three each.
  const SurfaceMesh box = test::cubes({{0, 0, 0}});
  const std::vector<double> between{0.3}, end{1.0};
  EXPECT_EQ(splitAt(box, between).faces.size(), 12 + 8 * 2);
  EXPECT_EQ(splitAt(box, end).faces.size(), 12);
  EXPECT_EQ(splitAt(box, {}).faces.size(), 12);
}

TEST(PressureMeshIdentity, RefinedIsTheSameSurfaceWithShortEdges) {
  for (const NamedMesh& each : closedSurfaces()) {
    SCOPED_TRACE(each.name);
    const SurfaceMesh whole = evenTriangles(each.mesh);
    const double longest = 0.03 * bounds(whole).diagonal();
    const RefinedMesh fine = refined(whole, longest, std::numeric_limits<std::size_t>::max());
    expectSameSurface(whole, fine.mesh);
    EXPECT_LE(fine.longestEdge, longest);
    EXPECT_DOUBLE_EQ(fine.longestEdge, longestEdge(fine.mesh));
    // The bound of [Rosenberg & Stenger 1975]; round-off of the angle.
    EXPECT_GT(leastAngle(fine.mesh), 0.5 * leastAngle(whole) * (1 - 1e-9));
  }
}

TEST(PressureMesh, RefinementEndsAtItsBound) {
  const SurfaceMesh whole = evenTriangles(closedFrigate(16, 4));
  for (const std::size_t most : {whole.faces.size() - 10, whole.faces.size() + 7, 3001ul}) {
    const RefinedMesh fine = refined(whole, 0.01, most);
    EXPECT_LE(fine.mesh.faces.size(), std::max(most, whole.faces.size()));
    EXPECT_GE(fine.mesh.faces.size() + 1, most);  // two triangles are added at a time
    EXPECT_DOUBLE_EQ(fine.longestEdge, longestEdge(fine.mesh));
    EXPECT_TRUE(openEdges(fine.mesh).empty());
  }
  EXPECT_EQ(refined(whole, 1e3, 0).mesh.faces.size(), whole.faces.size());
}

TEST(PressureMesh, RefusesWhatIsNoLength) {
  const SurfaceMesh box = closedBox({8, 4, 2, 1}, 1, 1, 1);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double bad : {0.0, -1.0, nan}) {
    test::expectRefusal(Fault::ValueOutOfRange, {"refined"}, [&] { refined(box, bad, 100); });
    test::expectRefusal(Fault::ValueOutOfRange, {"edgeFor"}, [&] { edgeFor(bad, 1.0); });
    test::expectRefusal(Fault::ValueOutOfRange, {"edgeFor"}, [&] { edgeFor(0.1, bad); });
  }
  test::expectRefusal(Fault::ValueOutOfRange, {"splitAt", "nan"},
                      [&] { splitAt(box, std::vector<double>{nan}); });
}

/// Mean over a triangle of cos kx, and of the linear function with its values at the corners, by a
/// grid of 400² points.
double missed(const std::array<Vec3, 3>& corner, double k) {
  const auto wave = [&](const Vec3& p) { return std::cos(k * p.x()); };
  double exact = 0.0;
  int count = 0;
  const int n = 400;
  for (int i = 0; i < n; ++i)
    for (int j = 0; i + j < n; ++j)
      for (const double third : {1.0 / 3, 2.0 / 3}) {
        if (third > 0.5 && i + j > n - 2) continue;
        const double s = (i + third) / n, t = (j + third) / n;
        exact += wave(corner[0] + s * (corner[1] - corner[0]) + t * (corner[2] - corner[0]));
        ++count;
      }
  return exact / count - (wave(corner[0]) + wave(corner[1]) + wave(corner[2])) / 3;
}

TEST(PressureMeshClosedForm, LinearPressureErrorBoundsWhatATriangleMisses) {
  const double h = 0.3, k = 1.0;
  const double bound = linearPressureError(h, k);
  EXPECT_DOUBLE_EQ(bound, 0.0075);
  // At the crest: an equilateral triangle has 3/4 of the bound, a thin one along the wave all of
  // it. The next term of the series is below (kh)²/24 = 0.4 % of it.
  const double root = 0.5 * std::sqrt(3.0);
  EXPECT_NEAR(missed({Vec3(-h / 2, 0, 0), Vec3(h / 2, 0, 0), Vec3(0, root * h, 0)}, k),
              0.75 * bound, 0.004 * bound);
  const double thin = missed({Vec3(-h / 2, 0, 0), Vec3(h / 2, 0, 0), Vec3(h / 2, 1e-3, 0)}, k);
  EXPECT_NEAR(thin, bound, 0.02 * bound);  // the crest is only at its middle
  EXPECT_LT(thin, bound);
  EXPECT_DOUBLE_EQ(linearPressureError(edgeFor(0.01, 0.25), 0.25), 0.01);
}

}  // namespace
}  // namespace cutwater
