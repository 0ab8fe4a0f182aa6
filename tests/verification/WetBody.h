#pragma once
#include <vector>

#include "hydro/bem/BuildCoefficients.h"
#include "hydro/geometry/MeshIntegrals.h"

namespace cutwater::test {

/// Radiation of a symmetric body at rest that is known by the panels of its port half alone.
inline SolverOutput solved(const SurfaceMesh& wetPort, const std::vector<double>& omega,
                           PanelShape shape = PanelShape::Auto) {
  ShipParticulars ship;
  ship.wetSurface = wetPort;
  ship.symmetric = true;
  ship.volume = 2 * volumeIntegrals(wetPort).volume;
  ship.mass = ship.density * ship.volume;
  SolveSettings settings;
  settings.omega = omega;
  settings.panelShape = shape;
  return buildCoefficients(ship, settings);
}

}  // namespace cutwater::test
