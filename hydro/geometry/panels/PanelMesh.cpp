#include "hydro/geometry/panels/PanelMesh.h"

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

/// Normal, area and centroid of a flat polygon from its vector area; the centroid from the
/// triangles about its first corner, exact also if one corner is re-entrant.
void finish(Panel& panel, const Vec3& normalArea, const std::string& name) {
  const Vec3& a = panel.corner[0];
  double size2 = 0.0;
  for (const Vec3& p : panel.corner) size2 = std::max(size2, (p - a).squaredNorm());
  // 1e-10 of the square of its size: far below any panel that a solver can use, far above
  // round-off.
  if (!(normalArea.norm() > 1e-10 * size2))
    throw HydroError(Fault::ValueOutOfRange,
                     name + " has area " + std::to_string(normalArea.norm()) + " m²");
  panel.normal = normalArea.normalized();
  Vec3 moment = Vec3::Zero();
  for (std::size_t i = 1; i + 1 < static_cast<std::size_t>(panel.corners); ++i) {
    const Vec3 b = panel.corner[i] - a, c = panel.corner[i + 1] - a;
    const double part = 0.5 * b.cross(c).dot(panel.normal);
    panel.area += part;
    moment += part * (b + c) / 3.0;
  }
  panel.centroid = a + moment / panel.area;
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
  if (panel.corners == 3) panel.corner[3] = panel.corner[2];
  finish(panel, normalArea, "makePanels: face " + std::to_string(index));
  return panel;
}

/// What a face has before it is flattened: two triangles, as `triangulated` makes them.
PanelPatch patchOf(const SurfaceMesh& mesh, const Face& face, const Vec3& centroid) {
  PanelPatch patch;
  for (int i = 1; i + 1 < face.size(); ++i) {
    const Vec3 &a = mesh.corner(face, 0), &b = mesh.corner(face, i), &c = mesh.corner(face, i + 1);
    const Vec3 part = 0.5 * (b - a).cross(c - a);
    patch.vectorArea += part;
    patch.couple += ((a + b + c) / 3.0 - centroid).cross(part);
  }
  return patch;
}

}  // namespace

Panel flatPanel(const std::vector<Vec3>& corners) {
  if (corners.size() != 3 && corners.size() != 4)
    throw HydroError(Fault::BadArgument,
                     "flatPanel: " + std::to_string(corners.size()) + " corners, not 3 or 4");
  SurfaceMesh one{corners, {{{0, 1, 2, corners.size() == 4 ? 3 : -1}}}};
  Panel panel;
  panel.corners = one.faces[0].size();
  std::copy(corners.begin(), corners.end(), panel.corner.begin());
  if (panel.corners == 3) panel.corner[3] = panel.corner[2];
  finish(panel, vectorArea(one, one.faces[0]), "flatPanel");
  return panel;
}

double diameter(const Panel& panel) {
  double size = 0.0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(panel.corners); ++i)
    for (std::size_t j = 0; j < i; ++j)
      size = std::max(size, (panel.corner[i] - panel.corner[j]).norm());
  return size;
}

PanelMesh makePanels(const SurfaceMesh& wet, bool symmetric) {
  PanelMesh mesh;
  mesh.symmetric = symmetric;
  mesh.panels.reserve(wet.faces.size());
  mesh.patches.reserve(wet.faces.size());
  for (std::size_t i = 0; i < wet.faces.size(); ++i) {
    mesh.panels.push_back(flatten(wet, wet.faces[i], i));
    mesh.patches.push_back(patchOf(wet, wet.faces[i], mesh.panels.back().centroid));
  }
  return mesh;
}

}  // namespace cutwater
