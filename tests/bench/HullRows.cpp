// From a mesh to panels.
#include "hydro/geometry/MeshIntegrals.h"
#include "hydro/geometry/anyhull/AnyHull.h"
#include "hydro/geometry/shapes/Shapes.h"
#include "tests/bench/Rows.h"
#include "tests/support/Hulls.h"

namespace cutwater::bench {
namespace {

constexpr int kPanels = 433;

/// Sixty boxes put through a hull's sides and bottom: no repair of faces joins them.
SurfaceMesh withBoxes(SurfaceMesh hull) {
  for (int i = 0; i < 60; ++i) {
    SurfaceMesh box = closedBox({1.5, 16.0, 1.0, 2.0}, 1, 1, 1);
    for (Vec3& p : box.vertices) p += Vec3(-45.0 + 1.5 * i, 0.0, -1.0);
    hull = joined(hull, box);
  }
  return hull;
}

void benchHull(std::string& csv, const std::string& name, const SurfaceMesh& mesh, double budget) {
  Row row{name, kPanels, 2};
  AnyHull made;
  const Time time = timeOf([&] { made = anyHull(mesh, kPanels, "hull"); });
  row.seconds = time.seconds;
  row.processor = time.processor;
  row.budget = budget;
  row.checksum = made.panelVolume;
  add(csv, row);
}

}  // namespace

void benchHulls(std::string& csv) {
  const SurfaceMesh small = closedFrigate(90, 24), large = closedFrigate(300, 82);
  benchHull(csv, "panels by sections, 9000 triangles", test::turnedAtRandom(small), 1.0);
  benchHull(csv, "panels by sections, 100 000 triangles", test::turnedAtRandom(large), 3.0);
  benchHull(csv, "panels by surface, 9000 triangles", withBoxes(small), 1.0);
  benchHull(csv, "panels by surface, 100 000 triangles", withBoxes(large), 3.0);
}

}  // namespace cutwater::bench
