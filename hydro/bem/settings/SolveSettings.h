#pragma once
#include <utility>
#include <vector>

#include "hydro/bem/settings/Formulation.h"
#include "hydro/database/Coefficients.h"

namespace cutwater {

/// An upper envelope of condition numbers: (ω [rad/s], limit [–]), ω increasing, linear between,
/// constant outside; empty: no mask.                                             [M03] 5.7
using ConditionLimit = std::vector<std::pair<double, double>>;

/// What to solve for. Plain data; the defaults suit any ship.
struct SolveSettings {
  std::vector<double> omega;      ///< ω_e [rad/s]: finite, > 0, strictly increasing
  std::vector<double> headings;   ///< β [rad] for the excitation tables; may be empty
  std::vector<double> waveOmega;  ///< ω_I [rad/s] for `Coefficients::diffractionTable`
  std::vector<double> speeds;     ///< U [m/s] ≥ 0 for the same
  Formulation formulation = Formulation::Potential;
  Derivatives derivatives = Derivatives::Stokes;
  ForwardSpeedForm forwardSpeed = ForwardSpeedForm::Report;
  int sourcePoints = 0;    ///< Gauss points of the wave term on a source panel: 1, 4, 9; 0: by ω
  int galerkinPoints = 4;  ///< points of a field panel that share its equation: 1, 4, 9
  bool curvedPanels =
      false;        ///< panels moved out to the surface through the vertices (SolverPanels.h)
  bool lid = true;  ///< lid panels on the interior waterplane: no irregular frequencies
  double lidPanelLength = 0.0;  ///< [m]; 0: as the hull's panels along the waterline
  bool xDerivatives = true;     ///< ∂A, ∂B, and adjoint vectors of ∂φ/∂x
  /// Anything but Adjoint fills `Coefficients::diffractionTable` for speeds × headings × waveOmega
  /// instead of the adjoint vectors.
  Influence influence = Influence::Adjoint;
  ConditionLimit conditionLimitEven, conditionLimitOdd;
  int threads = 0;  ///< 0: as many as the machine has. Results do not depend on it.
};

}  // namespace cutwater
