#pragma once
#include "hydro/geometry/panels/PanelMesh.h"

namespace cutwater {

/// The hull below calm water, and every mesh of panels that is made of it. What the solver sees,
/// what its results are used with later, and what Froude-Krylov forces are integrated over come
/// from here, so that they cannot differ.
///     const WetSurface wet = coefficients.wet();   // or WetSurface(mesh, symmetric, shape)
///     const PanelMesh panels = wet.panels();
/// Each call makes its mesh anew, O(faces).
class WetSurface {
 public:
  /// @param mesh      hull below calm water, hull axes; its port half if `symmetric`. Must outlive
  ///                  this object.
  /// @param shape     of the solver's panels (SolverPanels.h).
  WetSurface(const SurfaceMesh& mesh, bool symmetric, PanelShape shape = PanelShape::Flat) noexcept
      : mesh_(mesh), symmetric_(symmetric), shape_(shape) {}

  bool empty() const noexcept { return mesh_.faces.empty(); }
  /// The triangles of faces() as a mesh, both sides.
  SurfaceMesh whole() const;
  /// Panels of the hull on which the solver works; adjoint vectors belong to them.
  /// @throws HydroError as makePanels.
  PanelMesh panels() const;
  /// The same with a lid on the interior waterplane.
  /// @param lidPanelLength [m]; 0: as the waterline's edges.  @throws HydroError as makeLid.
  PanelMesh panelsWithLid(double lidPanelLength = 0.0) const;
  /// The surface without the gaps that flattening leaves between panels: triangles, for integrals
  /// over the undisturbed wave.  @throws HydroError as makePanels.
  PanelMesh faces() const;

 private:
  const SurfaceMesh& mesh_;
  bool symmetric_;
  PanelShape shape_;
};

}  // namespace cutwater
