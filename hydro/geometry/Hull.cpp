#include "hydro/geometry/Hull.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "hydro/Errors.h"
#include "hydro/geometry/HullShells.h"
#include "hydro/geometry/MeshCut.h"
#include "hydro/geometry/MeshEdges.h"
#include "hydro/geometry/MeshIntegrals.h"
#include "hydro/geometry/PlaceText.h"

namespace cutwater {
namespace {

Plane centreline() { return {Vec3::UnitY(), 0.0}; }

bool onCentreline(const SurfaceMesh& mesh, const OpenEdge& e) {
  return mesh.vertices[static_cast<std::size_t>(e.from)].y() == 0.0 &&
         mesh.vertices[static_cast<std::size_t>(e.to)].y() == 0.0;
}

/// All on one side, and open on the centreline below water (calm water itself does not count).
bool looksHalf(const SurfaceMesh& mesh) {
  const Bounds b = bounds(mesh);
  if (b.low.y() < 0 && b.high.y() > 0) return false;
  const auto depth = [&](int i) { return mesh.vertices[static_cast<std::size_t>(i)].z(); };
  for (const OpenEdge& e : looseEdges(mesh))
    if (onCentreline(mesh, e) && std::min(depth(e.from), depth(e.to)) < 0) return true;
  return false;
}

SurfaceMesh wholeFrom(const SurfaceMesh& mesh, const std::string& name, Symmetry symmetry,
                      double tolerance) {
  if (symmetry == Symmetry::None) return mesh;
  const SurfaceMesh centred = snapped(mesh, 1, tolerance);
  const Bounds b = bounds(centred);
  if (symmetry == Symmetry::Half) {
    if (b.low.y() < 0 && b.high.y() > 0)
      throw HydroError(Fault::HullNotSymmetric, name + ": symmetric = \"half\", but y goes from " +
                                                    std::to_string(b.low.y()) + " to " +
                                                    std::to_string(b.high.y()) + " m");
    return withMirrorImage(centred);
  }
  return looksHalf(centred) ? withMirrorImage(centred) : mesh;
}

bool onWater(const SurfaceMesh& wet, const OpenEdge& e) {
  return wet.vertices[static_cast<std::size_t>(e.from)].z() == 0.0 &&
         wet.vertices[static_cast<std::size_t>(e.to)].z() == 0.0;
}

/// Below water every edge must be shared by an even number of faces.
void checkHoles(const SurfaceMesh& wet, const std::string& name) {
  std::vector<OpenEdge> holes = looseEdges(wet);
  std::erase_if(holes, [&](const OpenEdge& e) { return onWater(wet, e); });
  if (holes.empty()) return;
  const OpenEdge& e = holes.front();
  throw HydroError(Fault::HullNotClosed,
                   name + ": hull has " + std::to_string(holes.size()) +
                       " open edges below water, the first from " +
                       placeText(wet.vertices[static_cast<std::size_t>(e.from)]) + " to " +
                       placeText(wet.vertices[static_cast<std::size_t>(e.to)]));
}

/// Turned outwards, the faces at every edge below water must run along it in opposite senses.
void checkAgreement(const SurfaceMesh& wet, const std::string& name) {
  for (const OpenEdge& e : openEdges(wet))
    if (!onWater(wet, e))
      throw HydroError(Fault::HullInverted,
                       name + ": pieces that meet at " +
                           placeText(wet.vertices[static_cast<std::size_t>(e.from)]) +
                           " do not agree on which side is outside");
  if (!(waterplaneIntegrals(wet).area > 0))
    throw HydroError(Fault::HullNotInWater, name + ": hull has no waterplane at z = 0");
}

/// Every vertex has a mirror image, and ∫ y dV is small against V times the half breadth.
bool isMirrorImage(const SurfaceMesh& wet, double tolerance) {
  const SurfaceMesh both = welded(joined(wet, mirroredInY(wet)), tolerance);
  if (both.vertices.size() != wet.vertices.size()) return false;
  const VolumeIntegrals v = volumeIntegrals(wet);
  return std::abs(v.moment.y()) <= 1e-4 * v.volume * bounds(wet).high.y();
}

}  // namespace

Hull makeHull(const SurfaceMesh& raw, const std::string& name, Symmetry symmetry) {
  checkVertices(raw, name);
  SurfaceMesh mesh = welded(raw, 0.0);
  const double tolerance = kSnap * bounds(mesh).diagonal();
  mesh = withoutDoubles(welded(snapped(mesh, 2, tolerance), tolerance));
  if (mesh.faces.empty())
    throw HydroError(Fault::MeshEmpty, name + ": all faces collapse when vertices are merged");
  checkInWater(bounds(mesh), name);
  mesh = wholeFrom(mesh, name, symmetry, tolerance);
  checkHoles(cutBelow(mesh), name);

  Hull hull;
  hull.surface = turnedOutwards(mesh, name);
  const SurfaceMesh wet = cutBelow(hull.surface);
  checkAgreement(wet, name);
  hull.closed = openEdges(hull.surface).empty();
  if (symmetry != Symmetry::None && isMirrorImage(wet, tolerance)) {
    hull.symmetric = true;
    hull.surface = welded(snapped(hull.surface, 1, tolerance), 0.0);
  }
  return hull;
}

SurfaceMesh wholeWetSurface(const Hull& hull) { return cutBelow(hull.surface); }

SurfaceMesh wetSurface(const Hull& hull) {
  const SurfaceMesh wet = wholeWetSurface(hull);
  return hull.symmetric ? cutAbove(wet, centreline()) : wet;
}

SurfaceMesh displacingSurface(const Hull& hull) {
  const SurfaceMesh wet = wetSurface(hull);
  return hull.symmetric ? bothHalves(wet) : wet;
}

}  // namespace cutwater
