#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "hydro/waves/SeaState.h"
#include "hydro/waves/Spreading.h"

namespace cutwater {

/// Irregular seas in deep water from a significant height and a peak period, a table, or several.
///     const Spectrum rough{.hs = 4.0, .tp = 10.0};
///     const SeaState sea = makeSeaState(rough, {.heading = kPi, .seed = 7});
///     const SeaSystem wind{{.hs = 2.0, .tp = 6.0}, {.heading = kPi, .spreading = 4.0}};
///     const SeaSystem swell{{.hs = 1.5, .tp = 14.0, .gamma = 7.0}, {.heading = 2.0}};
///     const SeaState both = makeSeaState(std::vector{wind, swell});
/// Deep water is the theory, of waves and of ships. Where the water is less deep than half a wave's
/// length, real waves are shorter and steeper than these of the same period.

/// Wave energy spectra S(ω) [m²s], one-sided, m_n = ∫₀^∞ ω^n S dω; m0 = hs²/16 but where it is
/// said.
///   Bretschneider     S = (5/16) hs² ω_p⁴ ω⁻⁵ e^{−(5/4)(ω_p/ω)⁴}                    [ITTC 1978]
///   PiersonMoskowitz  the same; ω_p = 0.4 √(g/hs) of a fully developed sea unless tp is given.
///   Jonswap           Bretschneider × A γ^{exp(−(ω/ω_p − 1)²/2σ²)}, σ = 0.07 up to ω_p, 0.09
///                     above; A is JonswapNormalisation                [Hasselmann et al. 1973]
///   OchiHubble        one of a family of eleven that hs alone chooses: a swell and a wind sea,
///                     S = (1/4) Σ_j ((4λ_j + 1)/4 ω_j⁴)^λ_j/Γ(λ_j) hs_j²/ω^{4λ_j + 1}
///                         e^{−(4λ_j + 1)/4 (ω_j/ω)⁴}                    [OchiHubble76]
///                     Its published shares hs_1² + hs_2² are 0.995 to 1.006 of hs²; both are
///                     scaled here, so that m0 = hs²/16.
///   Table             straight lines between given points, 0 beyond them. It has its own hs.
enum class SpectrumShape { Jonswap, Bretschneider, PiersonMoskowitz, OchiHubble, Table };
inline constexpr std::array kSpectrumNames{"jonswap", "bretschneider", "pierson-moskowitz",
                                           "ochi-hubble", "table"};

/// The factor A of Jonswap.
///   Exact  by quadrature: m0 = hs²/16
///   Dnv    1 − 0.287 ln γ [DNV-RP-C205]: significantHeight() is 0.12 % above hs for γ = 3.3, 0.9 %
///          below for γ = 7, 3.5 % below for γ = 10
enum class JonswapNormalisation { Exact, Dnv };
inline constexpr std::array kNormalisationNames{"exact", "dnv"};

/// Points of a spectrum.
struct SpectrumTable {
  std::vector<double> omega = {};    ///< [rad/s] ≥ 0, increasing, two or more
  std::vector<double> density = {};  ///< S [m²s] ≥ 0, not all 0
};

/// A table from a CSV file: a line `omega,S`, then a line for each point; lines that begin with #
/// are skipped.
/// @throws HydroError FileNotReadable; FileMalformed naming file, line and value.
SpectrumTable readSpectrumTable(const std::string& path);

/// Its functions throw HydroError ValueOutOfRange, naming a field that is out of range and its
/// value. S of Jonswap costs some hundred exponentials each time, for its A.
struct Spectrum {
  SpectrumShape shape = SpectrumShape::Jonswap;
  double hs = 3.0;     ///< significant wave height [m] ≥ 0; not of Table
  double tp = 9.0;     ///< peak period [s] > 0; 0 with PiersonMoskowitz: from hs
  double gamma = 3.3;  ///< peak enhancement of Jonswap, 1..20
  double gravity = kStandardGravity;
  JonswapNormalisation normalisation = JonswapNormalisation::Exact;
  int member = 0;            ///< of OchiHubble, 0..10; 0 is the most probable
  SpectrumTable table = {};  ///< of Table

  /// ω_p [rad/s]: where S is greatest; of OchiHubble the higher of the two ω_j.
  double peakFrequency() const;
  /// S(ω) [m²s]; 0 for ω ≤ 0.
  double operator()(double omega) const;
  /// 4 √m0 [m]: hs, but for Table and JonswapNormalisation::Dnv.
  double significantHeight() const;
  /// m_n [m²/sⁿ], n = −1..3, in closed form (Jonswap: and by quadrature of its peak, to 1e-9);
  /// infinite where the tail makes it so: of OchiHubble with 4λ_j ≤ n.
  double moment(int n) const;
};

/// How a spectrum becomes a sum of regular waves. The same numbers give the same sea on every
/// machine.
/// THEORY.md, chapter 3.
struct SeaStateSettings {
  double heading = 0.0;    ///< mean β [rad], −2π..2π
  double spreading = 0.0;  ///< exponent of the law below; 0 = long-crested
  int components = 200;    ///< ≥ 1
  std::uint64_t seed = 1;
  double omegaMin = 0.0;  ///< [rad/s]; 0: 0.5 ω_p
  double omegaMax = 0.0;  ///< [rad/s]; 0: 4 ω_p
  double ramp = 0.0;      ///< [s]
  /// As SeaState's. Extrapolated, short waves of a storm press twenty times too much on top of its
  /// crests.
  WaveProfile profile = WaveProfile::Wheeler;
  SpreadingLaw law = SpreadingLaw::Cos2s;
};

/// ω [rad/s] from which and up to which a sea has components: as given, or as ω_p has it. Of
/// OchiHubble: half the lower ω_j, four times the higher one; of Table: its ends.
std::pair<double, double> cutOffs(const Spectrum& spectrum, const SeaStateSettings& settings);

/// Share of m0 between two frequencies [rad/s], 0..1, to 1e-9.
double shareOfEnergy(const Spectrum& spectrum, double from, double to);

/// Bins of equal width in ω, one component in each, at a place that is drawn as S is distributed in
/// it. The mean over seeds of the sea's correlation is that of the spectrum at every lag, for any
/// number of components: nothing repeats but by chance (SeaStatistics.h).
/// An amplitude goes with the root of its bin's energy, and all are scaled so that Σ a²/2 = m0 for
/// any number of components. What the cut-offs leave out, 1 − shareOfEnergy (0.5 % of Jonswap by
/// default), is thereby spread over the waves between them.
/// @throws HydroError ValueOutOfRange naming the field and its value.
SeaState makeSeaState(const Spectrum& spectrum, const SeaStateSettings& settings);

/// One of several: swell, wind sea.
struct SeaSystem {
  Spectrum spectrum = {};
  SeaStateSettings settings = {};
};

/// Their sum: m0 is the sum of theirs. The first one alone is makeSeaState of it; the others draw
/// their own numbers, whatever their seeds. Gravity, ramp and profile must be the same of all.
/// @throws HydroError as above, and BadArgument: no system, or such a field that differs.
SeaState makeSeaState(std::span<const SeaSystem> systems);
inline SeaState makeSeaState(const std::vector<SeaSystem>& systems) {
  return makeSeaState(std::span<const SeaSystem>(systems));
}

}  // namespace cutwater
