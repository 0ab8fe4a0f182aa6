#include "hydro/geometry/panels/WetSurface.h"

#include "hydro/geometry/panels/Lid.h"
#include "hydro/geometry/panels/SolverPanels.h"

namespace cutwater {

SurfaceMesh WetSurface::whole() const {
  const SurfaceMesh triangles = triangulated(mesh_);
  return symmetric_ ? bothHalves(triangles) : triangles;
}

PanelMesh WetSurface::panels() const { return solverPanels(mesh_, symmetric_, shape_); }

PanelMesh WetSurface::panelsWithLid(double lidPanelLength) const {
  PanelMesh mesh = panels();
  mesh.lid = makeLid(mesh_, symmetric_, lidPanelLength);
  return mesh;
}

PanelMesh WetSurface::faces() const { return makePanels(triangulated(mesh_), symmetric_); }

}  // namespace cutwater
