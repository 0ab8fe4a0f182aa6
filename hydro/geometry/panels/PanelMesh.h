#pragma once
#include <array>
#include <vector>

#include "hydro/geometry/SurfaceMesh.h"

namespace cutwater {

/// One flat panel of the wetted hull or of the lid.
struct Panel {
  std::array<Vec3, 4> corner;  ///< [m], counter-clockwise about the normal, in one plane
  int corners = 4;             ///< 3 or 4
  Vec3 centroid = Vec3::Zero();
  Vec3 normal = Vec3::Zero();  ///< unit, out of the hull
  double area = 0.0;           ///< [m²]
};

/// The surface for which a flat panel stands, as far as integrals of its normal need it: the face
/// of the mesh, or a curved surface over it,
///     n(x) = n₀ − bend·(x − centroid),   n₀ the panel's normal
/// Patches of neighbours meet; flattened quadrilaterals do not, and lack some of the vector area.
struct PanelPatch {
  Vec3 vectorArea = Vec3::Zero();                  ///< ∫ n dS [m²]
  Vec3 couple = Vec3::Zero();                      ///< ∫ (x − centroid) × n dS [m³]
  Eigen::Matrix3d bend = Eigen::Matrix3d::Zero();  ///< symmetric, in the panel's plane [1/m]
  double curved = 0.0;  ///< 0 … 1: so well is the surface known by its bend; a plane has none
};

/// What the solver works on: flat panels of the hull below calm water (hull axes, z ≤ 0), and of a
/// lid on the interior waterplane z = 0 whose normals point up.
/// A symmetric hull stores its port half (y ≥ 0); starboard is the mirror image.
/// panels[i] comes from face i of the wet surface it was made from.
struct PanelMesh {
  std::vector<Panel> panels;
  std::vector<Panel> lid;           ///< may be empty
  std::vector<PanelPatch> patches;  ///< of each panel; empty: the panels are the surface
  bool symmetric = false;

  /// ∫ n dS of the surface for which panel i stands [m²].
  Vec3 vectorArea(std::size_t i) const {
    return patches.empty() ? Vec3(panels[i].area * panels[i].normal) : patches[i].vectorArea;
  }
};

/// Flattens each face about its centroid and mean normal. The plane of a face with an edge on the
/// waterline contains that edge, so that its vertices stay on z = 0 ([M03] 5.1). The faces' own
/// vector areas are in `patches`.
/// @param wet  hull below calm water, hull axes; its port half if `symmetric`.
/// @throws HydroError ValueOutOfRange for a face of no area, naming it.
PanelMesh makePanels(const SurfaceMesh& wet, bool symmetric);

/// The panel with these 3 or 4 corners, which lie in one plane.
/// @throws HydroError ValueOutOfRange if it has no area, BadArgument for another number of corners.
Panel flatPanel(const std::vector<Vec3>& corners);

/// Greatest distance between two corners [m].
double diameter(const Panel& panel);

}  // namespace cutwater
