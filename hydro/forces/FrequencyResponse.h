#pragma once
#include <array>

#include "hydro/database/Coefficients.h"
#include "hydro/forces/WaveExcitation.h"

namespace cutwater {

/// Motions in regular waves by the frequency domain, U = 0:
///   {−ω²(M + A) + iω(B + B_s) + (C + C_s)} η̂ = F_I + F_D                          [M03] (5)
/// with A, B the solver's own values interpolated in ω, and B_s, C_s the linear supplementary
/// terms; a quadratic roll damping is not linear and is left out.
class FrequencyResponse {
 public:
  /// @param coefficients must outlive this object.
  /// @param restrained   modes held: their η̂ is 0 and their equations are dropped.
  explicit FrequencyResponse(const Coefficients& coefficients, std::array<bool, 6> restrained = {});

  /// η̂ [m/m, rad/m] about G per metre of wave amplitude, crest over G's mean position at t = 0.
  /// @throws HydroError as WaveExcitation::at; MatrixSingular if a free mode has no stiffness,
  ///         inertia or damping at all.
  CVec6 at(double omega, double heading) const;

 private:
  const Coefficients& coefficients_;
  WaveExcitation excitation_;
  std::array<bool, 6> restrained_;
};

}  // namespace cutwater
