#include "hydro/waves/UnitSpectrum.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "hydro/Errors.h"

namespace cutwater {

namespace {

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

// In cells of 2 % of ω, narrow beside the sharpest peak, that meet at `corner`, where Jonswap's σ
// jumps.
template <class Function>
double overCells(double from, double to, double corner, const Function& f) {
  constexpr double kRatio = 1.02;
  double sum = 0.0, left = from;
  double cell = std::floor(std::log(from / corner) / std::log(kRatio));
  while (left < to) {
    const double end = corner * std::pow(kRatio, ++cell);
    if (end <= left) continue;
    const double right = std::min(end, to);
    sum += gauss5(left, right, f);
    left = right;
  }
  return sum;
}

// The family of Ochi & Hubble (1976): hs_j = h_j hs, ω_j = w_j e^{−b_j hs}, λ_1 = l_1,
// λ_2 = l_2 e^{c_2 hs}, hs in metres.
struct Member {
  double h1, h2, w1, w2, b1, b2, l1, l2, c2;
};
constexpr std::array<Member, 11> kFamily{{
    {0.84, 0.54, 0.70, 1.15, 0.046, 0.039, 3.00, 1.54, -0.062},
    {0.84, 0.54, 0.93, 1.50, 0.056, 0.046, 3.00, 2.77, -0.112},
    {0.84, 0.54, 0.41, 0.88, 0.016, 0.026, 2.55, 1.82, -0.089},
    {0.84, 0.54, 0.74, 1.30, 0.052, 0.039, 2.65, 3.90, -0.085},
    {0.84, 0.54, 0.62, 1.03, 0.039, 0.030, 2.60, 0.53, -0.069},
    {0.95, 0.31, 0.70, 1.50, 0.046, 0.046, 1.35, 2.48, -0.102},
    {0.65, 0.76, 0.61, 0.94, 0.039, 0.036, 4.95, 2.48, -0.102},
    {0.90, 0.44, 0.81, 1.60, 0.052, 0.033, 1.80, 2.95, -0.105},
    {0.77, 0.64, 0.54, 0.61, 0.039, 0.000, 4.50, 1.95, -0.082},
    {0.73, 0.68, 0.70, 0.99, 0.046, 0.039, 6.40, 1.78, -0.069},
    {0.92, 0.39, 0.70, 1.37, 0.046, 0.039, 0.70, 1.78, -0.069},
}};

void checkSpectrum(const Spectrum& s) {
  requireOfSpectrum(s.hs >= 0.0 && s.hs <= 1e3, "hs", s.hs);
  requireOfSpectrum(s.gravity > 0.0 && std::isfinite(s.gravity), "gravity", s.gravity);
  const bool none = s.shape == SpectrumShape::OchiHubble || s.shape == SpectrumShape::Table;
  const bool follows = s.shape == SpectrumShape::PiersonMoskowitz && s.tp == 0.0;
  requireOfSpectrum(none || follows || (s.tp > 0.0 && std::isfinite(s.tp)), "tp", s.tp);
  requireOfSpectrum(s.gamma >= 1.0 && s.gamma <= 20.0, "gamma", s.gamma);
  requireOfSpectrum(s.member >= 0 && s.member < static_cast<int>(kFamily.size()), "member",
                    s.member);
}

[[noreturn]] void refuseTable(std::size_t point, const std::string& what) {
  throw HydroError(Fault::ValueOutOfRange,
                   "Spectrum: table: point " + std::to_string(point) + ": " + what);
}

void checkTable(const SpectrumTable& t) {
  if (t.omega.size() < 2 || t.omega.size() != t.density.size())
    refuseTable(t.omega.size(), "a table needs two points or more, and as many S as omega");
  for (std::size_t i = 0; i < t.omega.size(); ++i) {
    if (!(t.omega[i] >= 0.0 && std::isfinite(t.omega[i])))
      refuseTable(i, "omega = " + std::to_string(t.omega[i]));
    if (i > 0 && !(t.omega[i] > t.omega[i - 1]))
      refuseTable(i, "omega = " + std::to_string(t.omega[i]) + " is not above the one before");
    if (!(t.density[i] >= 0.0 && std::isfinite(t.density[i])))
      refuseTable(i, "S = " + std::to_string(t.density[i]));
  }
  if (*std::max_element(t.density.begin(), t.density.end()) <= 0.0) refuseTable(0, "all S are 0");
}

}  // namespace

void requireOfSpectrum(bool good, const char* field, double value) {
  if (good) return;
  throw HydroError(Fault::ValueOutOfRange,
                   "Spectrum: " + std::string(field) + " = " + std::to_string(value));
}

UnitSpectrum::Part::Part(double ofAll, double at, double exponent)
    : share(ofAll), peak(at), lambda(exponent), c((exponent + 0.25) * std::pow(at, 4.0)) {
  logScale = std::log(4.0 * share / std::tgamma(lambda)) + lambda * std::log(c);
}

double UnitSpectrum::Part::operator()(double omega) const {
  return std::exp(logScale - (4.0 * lambda + 1.0) * std::log(omega) - c * std::pow(omega, -4.0));
}

double UnitSpectrum::Part::moment(int n) const {
  const double rest = lambda - 0.25 * n;
  if (rest <= 0.0) return std::numeric_limits<double>::infinity();
  return share * std::pow(c, 0.25 * n) * std::tgamma(rest) / std::tgamma(lambda);
}

UnitSpectrum::UnitSpectrum(const Spectrum& s) {
  checkSpectrum(s);
  variance_ = s.hs * s.hs / 16.0;
  if (s.shape == SpectrumShape::Table) {
    makeTable(s.table);
    return;
  }
  if (s.shape == SpectrumShape::OchiHubble) {
    makeOchiHubble(s);
  } else {
    peak_ = s.tp > 0.0 ? 2.0 * kPi / s.tp : 0.4 * std::sqrt(s.gravity / std::max(s.hs, 1e-6));
    parts_.emplace_back(1.0, peak_, 1.0);
    if (s.shape == SpectrumShape::Jonswap) makeJonswap(s);
  }
  const auto [low, high] = std::minmax_element(
      parts_.begin(), parts_.end(), [](const Part& a, const Part& b) { return a.peak < b.peak; });
  usualMin_ = 0.5 * low->peak;
  usualMax_ = 4.0 * high->peak;
}

void UnitSpectrum::makeOchiHubble(const Spectrum& s) {
  const Member& m = kFamily.at(static_cast<std::size_t>(s.member));
  const double all = m.h1 * m.h1 + m.h2 * m.h2;
  parts_.emplace_back(m.h1 * m.h1 / all, m.w1 * std::exp(-m.b1 * s.hs), m.l1);
  parts_.emplace_back(m.h2 * m.h2 / all, m.w2 * std::exp(-m.b2 * s.hs),
                      m.l2 * std::exp(m.c2 * s.hs));
  const double first = parts_[0].peak, second = parts_[1].peak;
  peak_ = (*this)(first) >= (*this)(second) ? first : second;
}

void UnitSpectrum::makeJonswap(const Spectrum& s) {
  gamma_ = s.gamma;
  if (gamma_ == 1.0) return;
  const double enhanced = 1.0 + momentOfPeak(0);
  scale_ = s.normalisation == JonswapNormalisation::Exact ? 1.0 / enhanced
                                                          : 1.0 - 0.287 * std::log(gamma_);
  energy_ = scale_ * enhanced;
}

void UnitSpectrum::makeTable(const SpectrumTable& table) {
  checkTable(table);
  table_ = table;
  variance_ = tableMoment(0, table.omega.front(), table.omega.back());
  for (double& density : table_.density) density /= variance_;
  const auto highest = std::max_element(table.density.begin(), table.density.end());
  peak_ = table.omega[static_cast<std::size_t>(highest - table.density.begin())];
  usualMin_ = table.omega.front();
  usualMax_ = table.omega.back();
}

double UnitSpectrum::peakedness(double omega) const {
  const double ratio = omega / peak_, sigma = ratio <= 1.0 ? 0.07 : 0.09;
  const double distance = (ratio - 1.0) / sigma;
  return std::pow(gamma_, std::exp(-0.5 * distance * distance));
}

double UnitSpectrum::momentOfPeak(int n) const {
  return overCells(0.2 * peak_, 2.0 * peak_, peak_, [&](double omega) {
    return std::pow(omega, n) * (peakedness(omega) - 1.0) * parts_[0](omega);
  });
}

double UnitSpectrum::operator()(double omega) const {
  if (!(omega > 0.0)) return 0.0;
  if (parts_.empty()) return fromTable(omega);
  double sum = 0.0;
  for (const Part& part : parts_) sum += part(omega);
  return gamma_ == 1.0 ? scale_ * sum : scale_ * sum * peakedness(omega);
}

// Below a tenth of the lowest peak S is e^{−7500} at most; beyond 10⁵ of the highest one, 1e-9 of
// the energy is left of the flattest tail of the family, λ = 0.45.
double UnitSpectrum::between(double from, double to) const {
  if (parts_.empty()) return tableMoment(0, from, to);
  const double least = 0.2 * usualMin_, most = 0.25e5 * usualMax_;
  return overCells(std::max(from, least), std::min(to, most), peak_, *this);
}

double UnitSpectrum::moment(int n) const {
  if (parts_.empty()) {
    if (n < 0 && table_.omega.front() == 0.0 && table_.density.front() > 0.0)
      return std::numeric_limits<double>::infinity();
    return tableMoment(n, table_.omega.front(), table_.omega.back());
  }
  double sum = 0.0;
  for (const Part& part : parts_) sum += part.moment(n);
  return gamma_ == 1.0 ? scale_ * sum : scale_ * (sum + momentOfPeak(n));
}

double UnitSpectrum::fromTable(double omega) const {
  const auto& at = table_.omega;
  if (omega < at.front() || omega > at.back()) return 0.0;
  const auto after = std::upper_bound(at.begin(), at.end() - 1, omega);
  const auto i = static_cast<std::size_t>(after - at.begin());
  const double share = (omega - at[i - 1]) / (at[i] - at[i - 1]);
  return (1.0 - share) * table_.density[i - 1] + share * table_.density[i];
}

// Straight lines times ω^n: exact for n ≥ 0.
double UnitSpectrum::tableMoment(int n, double from, double to) const {
  const auto& at = table_.omega;
  const auto first = std::upper_bound(at.begin(), at.end(), from);
  double sum = 0.0;
  for (auto i = first == at.begin() ? first : first - 1; i + 1 < at.end() && *i < to; ++i) {
    const double left = std::max(from, *i), right = std::min(to, *(i + 1));
    const auto density = [&](double omega) { return std::pow(omega, n) * fromTable(omega); };
    if (n >= 0) {
      sum += gauss5(left, right, density);
    } else if (right > left) {
      sum += overCells(std::max(left, 1e-9 * right), right, right, density);
    }
  }
  return sum;
}

}  // namespace cutwater
