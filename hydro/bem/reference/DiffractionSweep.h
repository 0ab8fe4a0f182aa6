#pragma once
#include "hydro/bem/settings/SolveSettings.h"
#include "hydro/bem/solution/Diffraction.h"

namespace cutwater {

/// What all systems of one ship share.
struct SolverParts {
  const InfluenceMatrices& matrices;
  const ModeNormals& normals;
  const XDerivative& stokes;
  const ShipParticulars& ship;
};

/// F_D of every speed, heading and wave frequency of the settings, by the means that
/// settings.influence names. For each distinct encounter frequency ω_e
///   Direct   assembles and factors its own system;
///   Matrix   factors D(ω_e), linear between the two grid frequencies around it    [M03] (80)-(83)
///   Inverse  solves with the factors of those two and takes D⁻¹ linear between    [M03] (84)-(87)
/// the grid being 0 and `grid`; beyond its end all are direct. Form: settings.forwardSpeed.
/// @param grid  [rad/s], increasing, > 0: settings.omega without what a mask leaves out.
/// @pre settings.influence is not Adjoint.  @throws as buildCoefficients.
DiffractionTable solveDiffractionTable(const SolverParts& parts, const SolveSettings& settings,
                                       const std::vector<double>& grid, int threads);

}  // namespace cutwater
