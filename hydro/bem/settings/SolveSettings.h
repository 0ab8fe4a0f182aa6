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

/// Frequencies that suit a ship of any size, by Froude's law: sixty steps of 0.36 √(g/L) [rad/s], L
/// the length of the wet surface; 0.1 to 6 rad/s for 125 m, 0.8 to 48 rad/s for a model of 2 m. A
/// ship under way needs steps no longer, and 3 √(g/B), which they reach (decision 0070).
std::vector<double> usualOmega(const ShipParticulars& ship);
/// Waves that matter to it: 0.72 to 7.2 √(g/L) in steps of 0.18, so the ship is 0.08 to 8 waves
/// long; 0.2 to 2 rad/s for 125 m.
std::vector<double> usualWaveOmega(const ShipParticulars& ship);

/// What to solve for. Only `omega` must be set; the other defaults suit any ship.
///     SolveSettings settings;
///     settings.omega = usualOmega(ship);
///     settings.headings = {kPi};
struct SolveSettings {
  std::vector<double> omega;     ///< ω_e [rad/s]: finite, > 0, strictly increasing
  std::vector<double> headings;  ///< β [rad], −2π..2π, for the excitation tables; may be empty
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
