#pragma once
#include <array>

namespace cutwater {

/// How the energy of a short-crested sea lies about its mean direction, ∫D dθ = 1.
///   Cos2s  D(θ) = 2^{2s−1} Γ²(s+1)/(π Γ(2s+1)) cos^{2s}(θ/2), |θ| ≤ π
///                                                                [LonguetHiggins63]
///   CosN   D(θ) = Γ(n/2+1)/(√π Γ(n/2+1/2)) cosⁿ θ, |θ| < π/2           [ITTC: n = 2 or 4]
/// What other programs call cos^{2s} θ is CosN with n = 2s.
enum class SpreadingLaw { Cos2s, CosN };
inline constexpr std::array kSpreadingNames{"cos2s", "cosn"};

/// D(θ) [1/rad].  @param exponent  s or n, 0..1000.  @param theta θ [rad], −π..π.
double spreadingDensity(SpreadingLaw law, double exponent, double theta);

/// Circular width σ = √(2(1 − ∫D cos θ dθ)) [rad]; s/(s + 1) is that integral of Cos2s. [Kuik88]
double spreadingWidth(SpreadingLaw law, double exponent);

}  // namespace cutwater
