#pragma once
#include <array>

#include "hydro/Conventions.h"

namespace cutwater {

/// One steep regular wave in deep water, as series in its steepness ε = ka, a half of its height
/// from trough to crest.
///     kζ  = Σ E_n cos nθ
///     φ   = −√(g/k³) Σ P_n e^{nkz} sin nθ,   θ = ωt − k(x cos β − y sin β) + phase
///     p   = −ρ(∂φ/∂t + ½|∇φ|² + gz) = ρg (H − z)
/// Of second order E = (ε, ½ε²), P = (ε, 0), ω = √(gk) (1 + ½ε²): the second-order potential
/// vanishes in deep water. Of fifth order the coefficients are Fenton's for infinite depth
/// [Fenton85, table 1, kd → ∞]:
///     E₁ = ε − ⅜ε³ − (422/384)ε⁵,  E₂ = ½ε² + ⅓ε⁴,  E₃ = ⅜ε³ + (297/384)ε⁵,  E₄ = ⅓ε⁴,
///     E₅ = (125/384)ε⁵,  P₁ = ε − ½ε³ − (37/24)ε⁵,  P₂ = ½ε⁴,  P₃ = ε⁵/12,
///     ω = √(gk) (1 + ½ε² + ⅛ε⁴)
/// There is no current: the mean velocity of the water at a point that is always wet is 0 (Stokes'
/// first definition of the wave's speed).
class StokesWave {
 public:
  static constexpr std::size_t kHarmonics = 5, kFlowHarmonics = 3;
  /// ka beyond which no wave is: it breaks at H/λ = 0.1411, ε = 0.443.
  static constexpr double kSteepest = 0.443;

  /// @param omega  [rad/s] > 0.  @param amplitude  a [m].  @param gravity  [m/s²].
  /// @param order  2 or 5.
  /// @throws HydroError ValueOutOfRange: another order, or a wave that would break.
  StokesWave(double omega, double amplitude, double gravity, int order);

  double waveNumber() const noexcept { return k_; }              ///< k [1/m]
  double steepness() const noexcept { return k_ * amplitude_; }  ///< ε

  /// What the water does, made for a height of the wave: r a, as it grows.
  struct Series {
    std::array<double, kHarmonics> elevation{};  ///< E_n/k [m]
    std::array<double, kFlowHarmonics> speed{};  ///< n k √(g/k³) P_n [m/s]
    double phaseSpeed = 0.0;                     ///< ω/k [m/s]
    double waveNumber = 0.0, gravity = kStandardGravity;

    double elevationAt(double theta) const noexcept;
    double slopeAt(double theta) const noexcept;  ///< of ζ, along the wave
    /// H [m] at phase θ and height z.
    double headAt(double theta, double z) const noexcept;
    /// Along the wave, and up [m/s].
    std::array<double, 2> velocityAt(double theta, double z) const noexcept;
    /// Its rate at a place that stays [m/s²].
    std::array<double, 2> velocityRateAt(double theta, double z) const noexcept;
  };
  /// @param growth  r, 0..1. The length of the wave stays that of its full height.
  Series series(double growth) const noexcept;

 private:
  double omega_, amplitude_, gravity_, k_;
  int order_;
};

}  // namespace cutwater
