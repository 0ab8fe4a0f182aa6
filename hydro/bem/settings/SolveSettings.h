#pragma once
#include <functional>
#include <utility>
#include <vector>

#include "hydro/bem/settings/Formulation.h"
#include "hydro/database/Coefficients.h"

namespace cutwater {

/// An upper envelope of condition numbers: (ω [rad/s], limit [–]), ω increasing, linear between,
/// constant outside; empty: no mask.                                             [M03] 5.7
using ConditionLimit = std::vector<std::pair<double, double>>;

/// What to solve for. Only `omega` must be set; the other defaults suit any ship. For a ship under
/// way choose steps up to 0.36 √(g/L) and frequencies up to 3 √(g/B): 0.1 rad/s for a length of
/// 120 m, 2.5 rad/s for a beam of 14 m.
///     SolveSettings settings;
///     for (int i = 1; i <= 60; ++i) settings.omega.push_back(0.1 * i);
///     settings.headings = {kPi};
struct SolveSettings {
  std::vector<double> omega;      ///< ω_e [rad/s]: finite, > 0, strictly increasing
  std::vector<double> headings;   ///< β [rad] for the excitation tables; may be empty
  std::vector<double> waveOmega;  ///< ω_I [rad/s] for `Coefficients::diffractionTable`
  std::vector<double> speeds;     ///< U [m/s] ≥ 0 for the same
  Formulation formulation = Formulation::Potential;
  Derivatives derivatives = Derivatives::Stokes;
  /// Report solves ∂A, ∂B and the adjoint vectors of ∂φ/∂x besides: a file twice as large.
  ForwardSpeedForm forwardSpeed = ForwardSpeedForm::Tuck;
  int sourcePoints = 0;    ///< Gauss points of the wave term on a source panel: 1, 4, 9; 0: by ω
  int galerkinPoints = 4;  ///< points of a field panel that share its equation: 1, 4, 9
  PanelShape panelShape = PanelShape::Auto;  ///< Flat, Curved or Auto
  bool lid = true;              ///< lid panels on the interior waterplane: no irregular frequencies
  double lidPanelLength = 0.0;  ///< [m]; 0: as the hull's panels along the waterline
  /// Anything but Adjoint fills `Coefficients::diffractionTable` for speeds × headings × waveOmega
  /// instead of the adjoint vectors.
  Influence influence = Influence::Adjoint;
  ConditionLimit conditionLimitEven, conditionLimitOdd;
  int threads = 0;  ///< 0: as many as the machine has. Results do not depend on it.

  bool xDerivatives() const noexcept { return forwardSpeed == ForwardSpeedForm::Report; }
};

/// Called at the start with what the journal holds, then after each finished frequency, by one
/// thread at a time, not always the same one. An exception from it stops the sweep and leaves the
/// solver.
using SolveProgress = std::function<void(int done, int total)>;

}  // namespace cutwater
