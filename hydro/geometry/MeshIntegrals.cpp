#include "hydro/geometry/MeshIntegrals.h"

namespace cutwater {
namespace {

/// Calls add(p, weight vector) so that Σ f(p)·weight = ∫ f n dS for every f of degree ≤ 2: the
/// mid-points of a triangle's edges, a third of its vector area each.
template <class Add>
void overTriangle(const Vec3& a, const Vec3& b, const Vec3& c, double share, Add add) {
  const Vec3 third = share / 6.0 * (b - a).cross(c - a);
  add(0.5 * (a + b), third);
  add(0.5 * (b + c), third);
  add(0.5 * (c + a), third);
}

/// The same over a whole face; a quadrilateral is the mean of its two triangulations.
template <class Add>
void overFace(const SurfaceMesh& mesh, const Face& f, Add add) {
  const auto p = [&](int i) { return mesh.corner(f, i); };
  if (f.size() == 3) {
    overTriangle(p(0), p(1), p(2), 1.0, add);
    return;
  }
  for (int i = 0; i < 4; ++i) overTriangle(p(i), p((i + 1) % 4), p((i + 2) % 4), 0.5, add);
}

}  // namespace

VolumeIntegrals volumeIntegrals(const SurfaceMesh& mesh) {
  VolumeIntegrals total;
  for (const Face& f : mesh.faces)
    overFace(mesh, f, [&](const Vec3& p, const Vec3& w) {
      total.volume += p.z() * w.z();
      total.moment += p.z() * w.z() * Vec3(p.x(), p.y(), 0.5 * p.z());
    });
  return total;
}

double surfaceArea(const SurfaceMesh& mesh) {
  double area = 0.0;
  for (const Face& f : mesh.faces)
    overFace(mesh, f, [&](const Vec3&, const Vec3& w) { area += w.norm(); });
  return area;
}

WaterplaneIntegrals waterplaneIntegrals(const SurfaceMesh& wet) {
  WaterplaneIntegrals total;
  for (const Face& f : wet.faces)
    overFace(wet, f, [&](const Vec3& p, const Vec3& w) {
      total.area -= w.z();
      total.x -= w.z() * p.x();
      total.y -= w.z() * p.y();
      total.xx -= w.z() * p.x() * p.x();
      total.xy -= w.z() * p.x() * p.y();
      total.yy -= w.z() * p.y() * p.y();
    });
  return total;
}

}  // namespace cutwater
