#include "hydro/waves/Spectrum.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>

#include "hydro/Errors.h"
#include "hydro/base/Radians.h"

namespace cutwater {

namespace {

void require(bool good, const char* field, double value) {
  if (good) return;
  throw HydroError(Fault::ValueOutOfRange,
                   "Spectrum: " + std::string(field) + " = " + std::to_string(value));
}

double peakedness(double ratio, double gamma) {
  const double sigma = ratio <= 1.0 ? 0.07 : 0.09;
  const double distance = (ratio - 1.0) / sigma;
  return std::pow(gamma, std::exp(-0.5 * distance * distance));
}

// Bretschneider's shape in ω/ω_p with ∫ = 1/16.
double unitShape(double ratio) {
  return ratio <= 0.0
             ? 0.0
             : 5.0 / 16.0 * std::pow(ratio, -5.0) * std::exp(-1.25 * std::pow(ratio, -4.0));
}

template <class Function>
double gauss5(double a, double b, const Function& f) {
  constexpr std::array<double, 5> x{-0.9061798459386640, -0.5384693101056831, 0.0,
                                    0.5384693101056831, 0.9061798459386640};
  constexpr std::array<double, 5> w{0.2369268850561891, 0.4786286704993665, 0.5688888888888889,
                                    0.4786286704993665, 0.2369268850561891};
  double sum = 0.0;
  for (std::size_t i = 0; i < 5; ++i) sum += w[i] * f(0.5 * (a + b) + 0.5 * (b - a) * x[i]);
  return 0.5 * (b - a) * sum;
}

// 16 ∫ shape × peakedness: 1 for γ = 1. Cells are narrow beside σ; beyond 30 ω_p is 1e-6 of the
// energy.
double enhancement(double gamma) {
  if (gamma == 1.0) return 1.0;
  const auto density = [gamma](double r) { return unitShape(r) * peakedness(r, gamma); };
  double sum = 0.0;
  for (int i = 0; i < 150; ++i) sum += gauss5(0.02 * i, 0.02 * (i + 1), density);
  for (int i = 0; i < 108; ++i) sum += gauss5(3.0 + 0.25 * i, 3.25 + 0.25 * i, density);
  return 16.0 * sum;
}

double norm(const Spectrum& s) {
  return s.shape == SpectrumShape::Jonswap ? enhancement(s.gamma) : 1.0;
}

double scaled(const Spectrum& s, double scale, double omega) {
  const double ratio = omega / s.peakFrequency();
  const double base = scale * s.hs * s.hs * unitShape(ratio) / s.peakFrequency();
  return s.shape == SpectrumShape::Jonswap ? base * peakedness(ratio, s.gamma) : base;
}

// Uniform in [0, 1), the same on every standard library.
double uniform(std::mt19937_64& random) { return static_cast<double>(random() >> 11U) * 0x1.0p-53; }

// θ with density ∝ cos^{2s}(θ/2) by rejection.
double spreadAngle(std::mt19937_64& random, double s) {
  while (true) {
    const double theta = kPi * (2.0 * uniform(random) - 1.0);
    if (uniform(random) < std::pow(std::cos(0.5 * theta), 2.0 * s)) return theta;
  }
}

// The same direction, within a turn.
double withinATurn(double heading) {
  return std::abs(heading) <= kTurn ? heading : std::remainder(heading, 2.0 * kPi);
}

void check(const SeaStateSettings& s, double from, double to) {
  // NaN would be taken for "not given".
  require(s.omegaMin >= 0.0, "omega_min", s.omegaMin);
  require(s.omegaMax >= 0.0, "omega_max", s.omegaMax);
  require(s.components >= 1 && s.components <= 1000000, "components", s.components);
  require(s.spreading >= 0.0 && s.spreading <= 1000.0, "spreading", s.spreading);
  requireRadians("Spectrum: heading", s.heading, kTurn);
  require(from > 0.0 && std::isfinite(from), "omega_min", from);
  require(to > from && std::isfinite(to), "omega_max", to);
}

}  // namespace

double Spectrum::peakFrequency() const {
  if (tp > 0.0) return 2.0 * kPi / tp;
  return 0.4 * std::sqrt(gravity / std::max(hs, 1e-6));
}

double Spectrum::operator()(double omega) const { return scaled(*this, 1.0 / norm(*this), omega); }

std::pair<double, double> cutOffs(const Spectrum& spectrum, const SeaStateSettings& settings) {
  const double peak = spectrum.peakFrequency();
  return {settings.omegaMin > 0.0 ? settings.omegaMin : 0.5 * peak,
          settings.omegaMax > 0.0 ? settings.omegaMax : 4.0 * peak};
}

// In cells that are narrow beside the peak; beyond 30 ω_p is 1e-6 of the energy.
double shareOfEnergy(const Spectrum& spectrum, double from, double to) {
  Spectrum unit = spectrum;
  unit.hs = 4.0;  // m0 = 1
  unit.tp = 2.0 * kPi / spectrum.peakFrequency();
  const double peak = spectrum.peakFrequency();
  const double last = std::min(to, 30.0 * peak), width = 0.02 * peak;
  const double scale = 1.0 / norm(unit);
  const auto density = [&](double omega) { return scaled(unit, scale, omega); };
  double sum = 0.0;
  for (double left = std::max(from, 0.0); left < last; left += width)
    sum += gauss5(left, std::min(left + width, last), density);
  return std::min(sum, 1.0);
}

SeaState makeSeaState(const Spectrum& spectrum, const SeaStateSettings& settings) {
  require(spectrum.hs >= 0.0 && spectrum.hs <= 1e3, "hs", spectrum.hs);
  const bool follows = spectrum.shape == SpectrumShape::PiersonMoskowitz && spectrum.tp == 0.0;
  require(follows || (spectrum.tp > 0.0 && std::isfinite(spectrum.tp)), "tp", spectrum.tp);
  require(spectrum.gamma >= 1.0 && spectrum.gamma <= 20.0, "gamma", spectrum.gamma);
  require(spectrum.gravity > 0.0 && std::isfinite(spectrum.gravity), "gravity", spectrum.gravity);
  const auto [from, to] = cutOffs(spectrum, settings);
  check(settings, from, to);

  const double scale = 1.0 / norm(spectrum);
  const auto density = [&](double omega) { return scaled(spectrum, scale, omega); };
  std::mt19937_64 random(settings.seed);
  std::vector<WaveComponent> components(static_cast<std::size_t>(settings.components));
  const double width = (to - from) / settings.components;
  for (std::size_t i = 0; i < components.size(); ++i) {
    const double left = from + width * static_cast<double>(i);
    const double energy = gauss5(left, left + width, density);
    components[i].omega = left + width * uniform(random);
    components[i].amplitude = std::sqrt(2.0 * energy);
    components[i].phase = 2.0 * kPi * uniform(random);
    components[i].heading = settings.heading;
    if (settings.spreading > 0.0)
      components[i].heading =
          withinATurn(settings.heading + spreadAngle(random, settings.spreading));
  }
  return SeaState(std::move(components), spectrum.gravity, settings.ramp, settings.profile);
}

}  // namespace cutwater
