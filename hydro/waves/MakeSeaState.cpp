#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "hydro/Errors.h"
#include "hydro/base/FindRoot.h"
#include "hydro/base/Radians.h"
#include "hydro/waves/Spectrum.h"
#include "hydro/waves/UnitSpectrum.h"

namespace cutwater {

namespace {

// Uniform in [0, 1), the same on every standard library.
double uniform(std::mt19937_64& random) { return static_cast<double>(random() >> 11U) * 0x1.0p-53; }

// θ distributed as the law has it, by rejection.
double spreadAngle(std::mt19937_64& random, const SeaStateSettings& s) {
  const bool half = s.law == SpreadingLaw::Cos2s;
  while (true) {
    const double theta = (half ? kPi : 0.5 * kPi) * (2.0 * uniform(random) - 1.0);
    const double share = half ? std::pow(std::cos(0.5 * theta), 2.0 * s.spreading)
                              : std::pow(std::cos(theta), s.spreading);
    if (uniform(random) < share) return theta;
  }
}

// The same direction, within a turn.
double withinATurn(double heading) {
  return std::abs(heading) <= kTurn ? heading : std::remainder(heading, 2.0 * kPi);
}

void checkSettings(const SeaStateSettings& s, double from, double to) {
  // NaN would be taken for "not given".
  requireOfSpectrum(s.omegaMin >= 0.0, "omega_min", s.omegaMin);
  requireOfSpectrum(s.omegaMax >= 0.0, "omega_max", s.omegaMax);
  requireOfSpectrum(s.components >= 1 && s.components <= 1000000, "components", s.components);
  requireOfSpectrum(s.spreading >= 0.0 && s.spreading <= 1000.0, "spreading", s.spreading);
  requireRadians("Spectrum: heading", s.heading, kTurn);
  requireOfSpectrum(from >= 0.0 && std::isfinite(from), "omega_min", from);
  requireOfSpectrum(to > from && std::isfinite(to), "omega_max", to);
}

// The frequency below which lies a share of a bin's energy.
double placeInBin(const UnitSpectrum& unit, double left, double right, double energy,
                  double share) {
  const double straight = left + (right - left) * share;
  if (!(energy > 0.0)) return straight;
  const auto rest = [&](double omega) { return unit.between(left, omega) / energy - share; };
  return findRoot(rest, {left, -share}, {right, 1.0 - share}, 1e-9 * (right - left));
}

// Components of one system. Three draws a component: place, phase, and direction if it is spread.
std::vector<WaveComponent> componentsOf(const Spectrum& spectrum, const SeaStateSettings& settings,
                                        std::uint64_t seed) {
  const UnitSpectrum unit(spectrum);
  const auto [from, to] = cutOffs(spectrum, settings);
  checkSettings(settings, from, to);
  std::mt19937_64 random(seed);
  std::vector<WaveComponent> components(static_cast<std::size_t>(settings.components));
  const double width = (to - from) / settings.components;
  double sum = 0.0;
  for (std::size_t i = 0; i < components.size(); ++i) {
    WaveComponent& wave = components[i];
    const double left = from + width * static_cast<double>(i), right = left + width;
    const double energy = unit.between(left, right);
    sum += energy;
    wave.omega = std::max(placeInBin(unit, left, right, energy, uniform(random)), 1e-6);
    wave.amplitude = std::sqrt(energy);
    wave.phase = 2.0 * kPi * uniform(random);
    wave.heading = settings.heading;
    if (settings.spreading > 0.0)
      wave.heading = withinATurn(settings.heading + spreadAngle(random, settings));
  }
  const double variance = unit.variance() * unit.energy();
  if (variance == 0.0) sum = 1.0;
  if (!(sum > 0.0))
    throw HydroError(Fault::ValueOutOfRange, "Spectrum: omega_max = " + std::to_string(to) +
                                                 ": no energy above omega_min "
                                                 "= " +
                                                 std::to_string(from) + " and below it");
  for (WaveComponent& wave : components) wave.amplitude *= std::sqrt(2.0 * variance / sum);
  return components;
}

}  // namespace

SeaState makeSeaState(const Spectrum& spectrum, const SeaStateSettings& settings) {
  return SeaState(componentsOf(spectrum, settings, settings.seed), spectrum.gravity, settings.ramp,
                  settings.profile);
}

SeaState makeSeaState(std::span<const SeaSystem> systems) {
  if (systems.empty()) throw HydroError(Fault::BadArgument, "makeSeaState: no system");
  const SeaSystem& first = systems.front();
  std::vector<WaveComponent> all;
  for (std::size_t i = 0; i < systems.size(); ++i) {
    const SeaSystem& system = systems[i];
    const auto same = [&](bool good, const char* field) {
      if (good) return;
      throw HydroError(Fault::BadArgument, "makeSeaState: system " + std::to_string(i) + ": " +
                                               field + " differs from the first system's");
    };
    same(system.spectrum.gravity == first.spectrum.gravity, "gravity");
    same(system.settings.ramp == first.settings.ramp, "ramp");
    same(system.settings.profile == first.settings.profile, "profile");
    // Far apart, so that systems of equal or neighbouring seeds share no numbers.
    const std::uint64_t seed = system.settings.seed + i * 0x9E3779B97F4A7C15U;
    const auto its = componentsOf(system.spectrum, system.settings, seed);
    all.insert(all.end(), its.begin(), its.end());
  }
  return SeaState(std::move(all), first.spectrum.gravity, first.settings.ramp,
                  first.settings.profile);
}

}  // namespace cutwater
