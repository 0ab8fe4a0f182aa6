#include "hydro/geometry/repair/CleanSurface.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "hydro/Errors.h"
#include "hydro/geometry/HullShells.h"
#include "hydro/geometry/MeshEdges.h"
#include "hydro/geometry/PlaceText.h"

namespace cutwater {
namespace {

void mergeVertices(CleanSurface& s, const std::string& name) {
  const auto say = [&](std::string line) { s.done.push_back(std::move(line)); };
  const std::size_t faces = s.mesh.faces.size();
  s.size = bounds(s.mesh).diagonal();
  s.mesh = welded(s.mesh, 0.0);
  const std::size_t vertices = s.mesh.vertices.size();
  s.mesh = welded(snapped(std::move(s.mesh), 2, kWeld * s.size), kWeld * s.size);
  if (s.mesh.vertices.size() < vertices)
    say(fmt::format("merged {} with others less than {:.2g} m away",
                    counted(vertices - s.mesh.vertices.size(), "vertex", "vertices"),
                    kWeld * s.size));
  const std::size_t before = s.mesh.faces.size();
  std::size_t triangles = 0;
  for (const Face& f : s.mesh.faces) triangles += static_cast<std::size_t>(f.size() - 2);
  s.mesh = triangulated(s.mesh);
  const std::size_t empty = faces - before + triangles - s.mesh.faces.size();
  const std::size_t withDoubles = s.mesh.faces.size();
  s.mesh = withoutDoubles(s.mesh);
  const std::size_t doubles = withDoubles - s.mesh.faces.size();
  if (empty > 0) say(fmt::format("left out {} without area", counted(empty, "face")));
  if (doubles > 0) say(fmt::format("left out {}", counted(doubles, "double face")));
  if (s.mesh.faces.empty()) throw HydroError(Fault::MeshEmpty, name + ": no face has an area");
}

bool opensToCentreplane(const SurfaceMesh& mesh, double near) {
  double open = 0.0;
  for (const OpenEdge& e : looseEdges(mesh)) {
    const Vec3 &p = mesh.vertices[static_cast<std::size_t>(e.from)],
               &q = mesh.vertices[static_cast<std::size_t>(e.to)];
    if (std::max(p.z(), q.z()) <= 0 && std::min(p.z(), q.z()) < 0 &&
        std::max(std::abs(p.y()), std::abs(q.y())) < near)
      open += std::abs(p.x() - q.x());
  }
  const Bounds box = bounds(mesh);
  return open > 0.3 * (box.high.x() - box.low.x());
}

/// One half, open below water along the centreplane or near it.
void mirror(CleanSurface& s, const std::string& name, Symmetry symmetry) {
  if (symmetry == Symmetry::None) return;
  const Bounds box = bounds(s.mesh);
  const double tolerance = kWeld * s.size, near = kWidestHole * (box.high.x() - box.low.x());
  const bool oneSided = box.low.y() >= -tolerance || box.high.y() <= tolerance;
  if (symmetry == Symmetry::Half && !oneSided)
    throw HydroError(Fault::HullNotSymmetric,
                     fmt::format("{}: symmetric = \"half\", but y goes from {:.6g} to {:.6g} m",
                                 name, box.low.y(), box.high.y()));
  if (!oneSided || (symmetry == Symmetry::Auto && !opensToCentreplane(s.mesh, near))) return;
  s.mesh = withMirrorImage(snapped(std::move(s.mesh), 1, tolerance));
  s.done.emplace_back("mirrored the half hull");
}

}  // namespace

CleanSurface cleanSurface(const SurfaceMesh& raw, const std::string& name, Symmetry symmetry) {
  CleanSurface s{raw, 0.0, {}};
  checkVertices(s.mesh, name);
  const Bounds box = bounds(s.mesh);
  if (box.high.z() < 0)
    s.done.push_back(fmt::format("is wholly below calm water, z from {:.6g} to {:.6g} m",
                                 box.low.z(), box.high.z()));
  else
    checkInWater(box, name);
  mergeVertices(s, name);
  mirror(s, name, symmetry);
  return s;
}

}  // namespace cutwater
