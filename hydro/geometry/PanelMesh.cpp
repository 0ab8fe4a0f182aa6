#include "hydro/geometry/PanelMesh.h"

#include <algorithm>
#include <string>

#include "hydro/Errors.h"

namespace cutwater {
namespace {

/// Where the plane of a panel passes: through `anchor`, and along `edge` if that is not zero.
struct PlaneChoice {
  Vec3 anchor = Vec3::Zero();
  Vec3 edge = Vec3::Zero();
};

/// The plane passes through the corners on calm water as far as a plane can: through the first and
/// the last of them (one only: through it), else through the mean of all corners.
PlaneChoice choosePlane(const std::array<Vec3, 4>& p, int n) {
  PlaneChoice plane;
  for (int i = 0; i < n; ++i) plane.anchor += p[static_cast<std::size_t>(i)] / n;
  std::vector<Vec3> onWater;
  for (int i = 0; i < n; ++i)
    if (p[static_cast<std::size_t>(i)].z() == 0.0)
      onWater.push_back(p[static_cast<std::size_t>(i)]);
  if (onWater.empty()) return plane;
  plane.anchor = onWater[0];
  double longest = 0.0;
  for (const Vec3& a : onWater)
    for (const Vec3& b : onWater)
      if ((b - a).norm() > longest) {
        longest = (b - a).norm();
        plane.anchor = a;
        plane.edge = (b - a) / longest;
      }
  return plane;
}

/// Area and centroid of a flat polygon, from the triangles about its first corner; exact also if
/// one corner is re-entrant.
void measure(Panel& panel) {
  double area = 0.0;
  Vec3 moment = Vec3::Zero();
  const Vec3& a = panel.corner[0];
  for (std::size_t i = 1; i + 1 < static_cast<std::size_t>(panel.corners); ++i) {
    const Vec3 &b = panel.corner[i], &c = panel.corner[i + 1];
    const double part = 0.5 * (b - a).cross(c - a).dot(panel.normal);
    area += part;
    moment += part * ((b - a) + (c - a)) / 3.0;
  }
  panel.area = area;
  panel.centroid = a + moment / area;
}

Panel flatten(const SurfaceMesh& mesh, const Face& face, std::size_t index) {
  Panel panel;
  panel.corners = face.size();
  double extent2 = 0.0;
  for (int i = 0; i < panel.corners; ++i) {
    panel.corner[static_cast<std::size_t>(i)] = mesh.corner(face, i);
    extent2 = std::max(extent2, (mesh.corner(face, i) - mesh.corner(face, 0)).squaredNorm());
  }
  Vec3 normalArea = vectorArea(mesh, face);
  if (panel.corners == 4) {
    const PlaneChoice plane = choosePlane(panel.corner, 4);
    normalArea -= normalArea.dot(plane.edge) * plane.edge;
    const Vec3 n = normalArea.normalized();
    double above = 0.0;
    for (Vec3& p : panel.corner) {
      const bool onWater = p.z() == 0.0;
      p -= n.dot(p - plane.anchor) * n;
      if (onWater && std::abs(p.z()) < 1e-12 * std::sqrt(extent2)) p.z() = 0.0;
      above = std::max(above, p.z());
    }
    for (Vec3& p : panel.corner) p.z() -= above;
  }
  // 1e-10 of the square of its size: far below any panel that a solver can use, far above
  // round-off.
  if (!(normalArea.norm() > 1e-10 * extent2))
    throw HydroError(Fault::ValueOutOfRange, "makePanels: face " + std::to_string(index) +
                                                 " has area " + std::to_string(normalArea.norm()) +
                                                 " m²");
  panel.normal = normalArea.normalized();
  if (panel.corners == 3) panel.corner[3] = panel.corner[2];
  measure(panel);
  return panel;
}

}  // namespace

PanelMesh makePanels(const SurfaceMesh& wet, bool symmetric) {
  PanelMesh mesh;
  mesh.symmetric = symmetric;
  mesh.panels.reserve(wet.faces.size());
  for (std::size_t i = 0; i < wet.faces.size(); ++i)
    mesh.panels.push_back(flatten(wet, wet.faces[i], i));
  return mesh;
}

}  // namespace cutwater
