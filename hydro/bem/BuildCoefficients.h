#pragma once
#include <functional>

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

/// Called at the start with what the journal holds, then after each finished frequency, by one thread
/// at a time, not always the same one. What it throws stops the sweep and comes out of
/// buildCoefficients.
using SolveProgress = std::function<void(int done, int total)>;

/// Radiation and diffraction of a ship at rest in deep water: A, B, A(0), A(∞), F_I, F_D, ∂A, ∂B,
/// adjoint vectors and condition numbers; at forward speed what settings.influence asks for. Panel
/// method (InfluenceMatrices.h). Condition limits are copied into the result, on which applyMask
/// (IrregularFrequencies.h) acts; here they only keep irregular frequencies from being nodes between
/// which influence = Matrix or Inverse interpolates.
///
/// A hull with `symmetric` set is solved by its port half; if G lies off its centre plane the modes
/// mix, so it is solved whole and the result's wetSurface is the whole surface. Everything of
/// `ship` is copied into the result; restoring and masses are not looked at.
///
/// Time: per frequency two LU factorizations of (n + m)³ and (n + m)² wave terms, n panels a side,
/// m on the lid; frequencies are solved in parallel. Memory: 64(n + m)² bytes a thread and as much
/// again.
/// @param journal  a file in which finished frequencies are kept, and from which those of an
///        interrupted sweep of the same ship and settings are taken, to the same bits; "": none. It
///        stays; remove it when the result is safe.
/// @throws HydroError FileNotWritable (journal), FrequenciesNotIncreasing, ValueOutOfRange, MeshEmpty, BadArgument,
/// MatrixSingular, HullNotClosed (no lid fits the waterline).
Coefficients buildCoefficients(const ShipParticulars& ship, const SolveSettings& settings,
                               const SolveProgress& progress = {}, const std::string& journal = {});

}  // namespace cutwater
