#include "hydro/geometry/wetted/ThinnedHull.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "hydro/Errors.h"
#include "hydro/geometry/HullShells.h"
#include "hydro/geometry/MeshCut.h"
#include "hydro/geometry/MeshIntegrals.h"
#include "hydro/geometry/SurfaceTree.h"
#include "hydro/geometry/wetted/EdgeMerging.h"
#include "hydro/geometry/wetted/PressureMesh.h"

namespace cutwater {
namespace {

/// The largest distance of a vertex of one surface from the other.
double farthest(const SurfaceMesh& from, const SurfaceMesh& to) {
  const SurfaceTree tree(to);
  double distance = 0.0;
  for (const Vec3& p : from.vertices) distance = std::max(distance, tree.distance(p));
  return distance;
}

/// Does the mirror image of every vertex lie on the surface?
bool isMirrorImage(const SurfaceMesh& mesh) {
  const double tolerance = kSnap * bounds(mesh).diagonal();
  const SurfaceTree tree(mesh);
  return std::all_of(mesh.vertices.begin(), mesh.vertices.end(), [&](const Vec3& p) {
    return tree.distance(Vec3(p.x(), -p.y(), p.z())) <= tolerance;
  });
}

/// The axes moved on by one: splitAt then cuts at z = const.
SurfaceMesh dividedAtWater(SurfaceMesh mesh) {
  for (Vec3& p : mesh.vertices) p = Vec3(p.z(), p.x(), p.y());
  mesh = splitAt(mesh, std::vector<double>{0.0});
  for (Vec3& p : mesh.vertices) p = Vec3(p.y(), p.z(), p.x());
  return mesh;
}

double relative(double now, double before) {
  return before == 0.0 ? 0.0 : std::abs(now - before) / std::abs(before);
}

/// Fills the errors; a port half has those of the whole.
void compare(const SurfaceMesh& from, const SurfaceMesh& mesh, ThinnedHull& out) {
  out.distance = std::max(farthest(from, mesh), farthest(mesh, from));
  const double before = volumeIntegrals(from).volume;
  out.volumeError = (volumeIntegrals(mesh).volume - before) / before;
  const SurfaceMesh wet = cutBelow(mesh), wetBefore = cutBelow(from);
  const WaterplaneIntegrals a = waterplaneIntegrals(wet), b = waterplaneIntegrals(wetBefore);
  out.submergedError = relative(volumeIntegrals(wet).volume, volumeIntegrals(wetBefore).volume);
  out.waterplaneError =
      std::max({relative(a.area, b.area), relative(a.xx, b.xx), relative(a.yy, b.yy)});
}

}  // namespace

ThinnedHull thinned(const SurfaceMesh& closed, std::size_t most) {
  if (closed.faces.empty()) throw HydroError(Fault::MeshEmpty, "thinned: the hull has no faces");
  const bool half = isMirrorImage(closed);
  const SurfaceMesh whole = evenTriangles(half ? cutAbove(closed, {Vec3::UnitY(), 0.0}) : closed);
  ThinnedHull out;
  const std::size_t bound = half ? most / 2 : most;
  if (whole.faces.size() <= bound) {
    out.mesh = half ? bothHalves(whole) : whole;
    return out;
  }
  EdgeMerging merging(snapped(dividedAtWater(whole), 2, 1e-9 * bounds(closed).diagonal()), half);
  merging.mergeTo(bound);
  const SurfaceMesh mesh = merging.result();
  compare(whole, mesh, out);
  out.mesh = half ? bothHalves(mesh) : mesh;
  return out;
}

}  // namespace cutwater
