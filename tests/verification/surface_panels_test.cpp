#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "hydro/geometry/MeshCut.h"
#include "hydro/geometry/anyhull/AnyHull.h"
#include "tests/support/Hulls.h"
#include "tests/support/Results.h"
#include "tests/verification/WetBody.h"

// Panels laid over the surface of columns give the forces of rows and rings on the same polygons.
namespace cutwater::test {
namespace {

/// A closed column standing in the water: rings on its bottom, rows on its side, 5 m of it above.
SurfaceMesh column(int sides, double radius, double draught, int rings, int rows) {
  SurfaceMesh mesh;
  const auto addRing = [&](double r, double z) {
    for (int i = 0; i < sides; ++i)
      mesh.vertices.emplace_back(r * std::cos(2 * kPi * i / sides),
                                 r * std::sin(2 * kPi * i / sides), z);
  };
  mesh.vertices.emplace_back(0, 0, -draught);
  for (int k = 1; k <= rings; ++k) addRing(radius * k / rings, -draught);
  for (int k = 1; k <= rows; ++k) addRing(radius, -draught * (rows - k) / rows);
  addRing(radius, 5.0);
  mesh.vertices.emplace_back(0, 0, 5.0);
  const int last = rings + rows, top = static_cast<int>(mesh.vertices.size()) - 1;
  const auto at = [&](int ring, int i) { return 1 + ring * sides + i % sides; };
  for (int i = 0; i < sides; ++i) {
    mesh.faces.push_back({{0, at(0, i + 1), at(0, i), -1}});
    for (int k = 0; k < last; ++k)
      mesh.faces.push_back({{at(k, i), at(k, i + 1), at(k + 1, i + 1), at(k + 1, i)}});
    mesh.faces.push_back({{top, at(last, i), at(last, i + 1), -1}});
  }
  return mesh;
}

SurfaceMesh fourColumns(int rings, int rows) {
  SurfaceMesh all;
  for (const double x : {-25.0, 25.0})
    for (const double y : {-25.0, 25.0})
      all = joined(all, moved(column(24, 6.0, 20.0, rings, rows), {x, y, 0.0}));
  return all;
}

SurfaceMesh portHalfOf(const SurfaceMesh& closed) {
  return cutAbove(cutBelow(closed), {Vec3::UnitY(), 0.0});
}

/// The polygons are the body, not the circle around them.
SolverOutput flat(const SurfaceMesh& wetPort, const std::vector<double>& omega) {
  return solved(wetPort, omega, PanelShape::Flat);
}

double difference(const SolverOutput& a, const SolverOutput& b, char what, int mode) {
  double most = 0.0, off = 0.0;
  for (std::size_t i = 0; i < a.omega.size(); ++i) {
    const auto of = [&](const SolverOutput& s) {
      return (what == 'A' ? s.addedMass[i] : s.damping[i])(mode, mode);
    };
    most = std::max(most, std::abs(of(b)));
    off = std::max(off, std::abs(of(a) - of(b)));
  }
  return off / most;
}

struct Compared {
  std::string name;
  SurfaceMesh body, structured;
  int count;
  double line;  // the acceptance line
};

void compare(const Compared& c, const std::vector<double>& omega) {
  const AnyHull laid = anyHull(c.body, c.count, c.name, Symmetry::Auto, PanelsBy::Surface);
  ASSERT_TRUE(laid.hull.symmetric);
  const SolverOutput a = flat(laid.panels, omega), b = flat(portHalfOf(c.structured), omega);
  for (const char what : {'A', 'B'})
    for (const int mode : {2, 1}) {
      const std::string name = fmt::format("{}, {} panels a side over the surface: {}{}{}", c.name,
                                           laid.panels.faces.size(), what, mode + 1, mode + 1);
      const double reached = difference(a, b, what, mode);
      EXPECT_LE(reached, c.line) << name;
      recordResult("Panelling", name, "structured panels", reached, fmt::format("≤ {}", c.line));
    }
}

std::vector<double> frequencies() {
  if (!fullSize()) return {0.4, 0.7, 1.1};
  std::vector<double> omega;
  for (int i = 0; i <= 18; ++i) omega.push_back(0.2 + 0.1 * i);
  return omega;
}

TEST(SurfacePanelsVerification, FourColumnsHaveTheForcesOfStructuredPanels) {
  compare({"four columns", fourColumns(1, 1), fourColumns(2, 7), 433, 0.03}, frequencies());
  if (fullSize())
    compare({"four columns", fourColumns(1, 1), fourColumns(4, 17), 1040, 0.02}, frequencies());
}

// By sections too, where these follow it.
TEST(SurfacePanelsVerification, ATruncatedCylinderHasThoseForcesEitherWay) {
  const SurfaceMesh body = column(48, 10.0, 10.0, 1, 1), rows = column(48, 10.0, 10.0, 8, 10);
  compare({"truncated cylinder", body, rows, 433, 0.02}, frequencies());
  const AnyHull sections = anyHull(body, 433, "cylinder");
  const SolverOutput a = flat(sections.panels, frequencies()),
                     b = flat(portHalfOf(rows), frequencies());
  if (sections.by != PanelsBy::Sections) return;  // by itself it took the surface
  for (const char what : {'A', 'B'})
    for (const int mode : {2, 1}) EXPECT_LE(difference(a, b, what, mode), 0.02) << what << mode;
}

TEST(SurfacePanelsVerification, ASparHasTheForcesOfStructuredPanels) {
  if (!fullSize()) return;
  const SurfaceMesh body = column(36, 5.0, 60.0, 1, 1);
  compare({"spar", body, column(36, 5.0, 60.0, 4, 26), 433, 0.02}, frequencies());
  compare({"spar", body, column(36, 5.0, 60.0, 6, 56), 1040, 0.02}, frequencies());
}

}  // namespace
}  // namespace cutwater::test
