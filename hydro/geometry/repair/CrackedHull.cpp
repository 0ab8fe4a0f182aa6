#include "hydro/geometry/repair/CrackedHull.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "hydro/Errors.h"
#include "hydro/geometry/HullShells.h"
#include "hydro/geometry/MeshCut.h"
#include "hydro/geometry/MeshEdges.h"
#include "hydro/geometry/MeshIntegrals.h"
#include "hydro/geometry/repair/CrackClosing.h"

namespace cutwater {
namespace {

constexpr double kWidestGap = 1e-3;  // of the length
constexpr double kAgree = 0.005;     // of the volume
constexpr double kSkew = 1e-3;       // of V and the half breadth: as of a repaired hull

Vec3 threeVolumes(const SurfaceMesh& wet) {
  const SurfaceMesh triangles = triangulated(wet);
  Vec3 sum = Vec3::Zero();
  for (const Face& f : triangles.faces)
    sum += meanCorner(triangles, f).cwiseProduct(vectorArea(triangles, f));
  return sum;
}

int looseBelowWater(const SurfaceMesh& wet, bool half) {
  int count = 0;
  for (const OpenEdge& e : looseEdges(wet)) {
    const Vec3 &p = wet.vertices[static_cast<std::size_t>(e.from)],
               &q = wet.vertices[static_cast<std::size_t>(e.to)];
    const bool onWater = p.z() == 0.0 && q.z() == 0.0, onCentre = p.y() == 0.0 && q.y() == 0.0;
    if (!onWater && !(half && onCentre)) ++count;
  }
  return count;
}

/// The port half of what is drawn: as it is, mirrored, or cut out of both sides.
SurfaceMesh portHalf(const SurfaceMesh& wet) {
  const Bounds box = bounds(wet);
  if (box.low.y() >= 0) return wet;
  if (box.high.y() <= 0) return mirroredInY(wet);
  return cutAbove(wet, {Vec3::UnitY(), 0.0});
}

/// The faces with their cracks closed; where that does not close the hull, with vertices as near as
/// that made one before.
Hull closedHull(const SurfaceMesh& triangles, double tolerance, const std::string& name,
                Symmetry symmetry) {
  const auto made = [&](const SurfaceMesh& mesh) {
    return makeHull(withoutCracks(mesh, tolerance, mesh.faces.size()), name, symmetry);
  };
  try {
    return made(triangles);
  } catch (const HydroError&) {
    return made(triangulated(welded(triangles, tolerance)));
  }
}

/// Every vertex has a mirror image, and so has the volume. What closes the cracks need not have
/// one.
bool isMirrorImage(const SurfaceMesh& wet, const Hull& hull, double tolerance) {
  if (welded(joined(wet, mirroredInY(wet)), tolerance).vertices.size() != wet.vertices.size())
    return false;
  const VolumeIntegrals v = volumeIntegrals(wholeWetSurface(hull));
  return std::abs(v.moment.y()) <= kSkew * v.volume * bounds(wet).high.y();
}

void requireAgreement(const CrackedHull& made, const std::string& name) {
  const Vec3& v = made.volumes;
  const double hull = volumeIntegrals(displacingSurface(made.hull)).volume;
  const double least = std::min(v.minCoeff(), hull), most = std::max(v.maxCoeff(), hull);
  if (least > (1 - kAgree) * most) return;
  throw HydroError(Fault::HullNotClosed,
                   fmt::format("{}: the faces below water do not close the hull: their volumes are "
                               "{:.6g}, {:.6g} and {:.6g} m3 by x, y and z, with gaps up to {:.2g} "
                               "m closed {:.6g} m3",
                               name, v.x(), v.y(), v.z(), made.tolerance, hull));
}

}  // namespace

CrackedHull crackedHull(const SurfaceMesh& raw, const std::string& name, Symmetry symmetry) {
  checkVertices(raw, name);
  const Bounds box = bounds(raw);
  const double snap = kSnap * box.diagonal();
  const SurfaceMesh mesh = withoutDoubles(welded(snapped(snapped(raw, 2, snap), 1, snap), snap));
  CrackedHull made;
  made.tolerance = kWidestGap * (box.high.x() - box.low.x());
  const SurfaceMesh triangles = triangulated(mesh);
  made.hull = closedHull(triangles, made.tolerance, name, symmetry);
  const SurfaceMesh wet = cutBelow(mesh);
  made.hull.symmetric =
      made.hull.symmetric || (symmetry == Symmetry::Auto && isMirrorImage(wet, made.hull, snap));
  const bool half = made.hull.symmetric;
  made.panels = half ? portHalf(wet) : wet;
  made.volumes = (half ? 2 : 1) * threeVolumes(made.panels);
  if (made.volumes.sum() < 0) {
    made.panels = turnedOver(made.panels);
    made.volumes = -made.volumes;
  }
  made.looseEdges = looseBelowWater(made.panels, half);
  requireAgreement(made, name);
  return made;
}

}  // namespace cutwater
