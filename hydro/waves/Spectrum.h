#pragma once
#include <cstdint>
#include <utility>
#include <vector>

#include "hydro/waves/SeaState.h"

namespace cutwater {

/// Irregular seas from a significant height and a peak period.
///     const Spectrum rough{.hs = 4.0, .tp = 10.0};
///     const SeaState sea = makeSeaState(rough, {.heading = kPi, .seed = 7});

/// Wave energy spectra S(ω) [m²s] with ∫₀^∞ S dω = hs²/16.
///   Bretschneider     S = (5/16) hs² ω_p⁴ ω⁻⁵ e^{−(5/4)(ω_p/ω)⁴}                    [ITTC 1978]
///   PiersonMoskowitz  the same; ω_p = 0.4 √(g/hs) of a fully developed sea unless tp is given.
///   Jonswap           Bretschneider × γ^{exp(−(ω/ω_p − 1)²/2σ²)}, σ = 0.07 below ω_p, 0.09 above,
///                     normalised to hs numerically                    [Hasselmann et al. 1973]
enum class SpectrumShape { Jonswap, Bretschneider, PiersonMoskowitz };

struct Spectrum {
  SpectrumShape shape = SpectrumShape::Jonswap;
  double hs = 3.0;     ///< significant wave height [m] ≥ 0
  double tp = 9.0;     ///< peak period [s] > 0; 0 with PiersonMoskowitz: from hs
  double gamma = 3.3;  ///< peak enhancement of Jonswap, 1..20
  double gravity = kStandardGravity;

  /// ω_p [rad/s].
  double peakFrequency() const;
  /// S(ω) [m²s]; 0 for ω ≤ 0.
  double operator()(double omega) const;
};

/// How a spectrum becomes a sum of regular waves. The same numbers give the same sea on every
/// machine.
/// THEORY.md, chapter 3.
struct SeaStateSettings {
  double heading = 0.0;    ///< mean β [rad], −2π..2π
  double spreading = 0.0;  ///< s of D(θ) ∝ cos^{2s}(θ/2); 0 = long-crested
  int components = 200;    ///< ≥ 1
  std::uint64_t seed = 1;
  double omegaMin = 0.0;  ///< [rad/s]; 0: 0.5 ω_p
  double omegaMax = 0.0;  ///< [rad/s]; 0: 4 ω_p
  double ramp = 0.0;      ///< [s]
  /// As SeaState's. Extrapolated, short waves of a storm press twenty times too much on top of its
  /// crests.
  WaveProfile profile = WaveProfile::Wheeler;
};

/// ω [rad/s] from which and up to which a sea has components: as given, or as ω_p has it.
std::pair<double, double> cutOffs(const Spectrum& spectrum, const SeaStateSettings& settings);

/// Share of m0 = hs²/16 between two frequencies [rad/s], 0..1, to 1e-3.
double shareOfEnergy(const Spectrum& spectrum, double from, double to);

/// Bins of equal width in ω, one component at a random place in each, so that the sea does not
/// repeat; its amplitude carries the whole energy of the bin: Σ a²/2 = ∫ S dω between the two
/// limits.
/// @throws HydroError ValueOutOfRange naming the field and its value.
SeaState makeSeaState(const Spectrum& spectrum, const SeaStateSettings& settings);

}  // namespace cutwater
