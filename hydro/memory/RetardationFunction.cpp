#include "hydro/memory/RetardationFunction.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "hydro/Errors.h"
#include "hydro/memory/FourierPieces.h"

namespace cutwater {

namespace {

constexpr double kTwoOverPi = 2.0 / kPi;
constexpr int kNoisePower = 8;       // a tail of noise dies fast
constexpr double kTailWindow = 0.7;  // of Ω: where the tail's slope is read

void check(std::span<const double> omega, std::span<const double> damping) {
  if (omega.size() < 2 || omega.size() != damping.size()) {
    throw HydroError(Fault::BadArgument,
                     fmt::format("RetardationFunction: {} frequencies, {} values of damping; at "
                                 "least 2 and as many of both are needed",
                                 omega.size(), damping.size()));
  }
  double before = 0.0;
  for (std::size_t i = 0; i < omega.size(); ++i) {
    if (!std::isfinite(omega[i]) || !std::isfinite(damping[i])) {
      throw HydroError(Fault::ValueOutOfRange,
                       fmt::format("RetardationFunction: omega[{0}] = {1}, damping[{0}] = {2}", i,
                                   omega[i], damping[i]));
    }
    if (omega[i] <= before) {
      throw HydroError(
          Fault::FrequenciesNotIncreasing,
          fmt::format("RetardationFunction: omega[{}] = {} after {}", i, omega[i], before));
    }
    before = omega[i];
  }
}

/// Slope −d log|B| / d log ω at the last point, from a parabola (a line if points are few) through
/// the window; NaN where B is not of one sign there.
double decayExponent(std::span<const double> omega, std::span<const double> damping) {
  const double last = omega.back();
  std::size_t first = omega.size();
  while (first > 0 && (omega[first - 1] >= kTailWindow * last || first + 3 > omega.size())) --first;
  const auto n = static_cast<Eigen::Index>(omega.size() - first);
  const int degree = n >= 6 ? 2 : 1;
  Eigen::MatrixXd powers(n, degree + 1);
  Eigen::VectorXd logs(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto at = first + static_cast<std::size_t>(i);
    if (damping[at] * damping.back() <= 0.0) return std::nan("");
    const double x = std::log(omega[at] / last);
    for (int d = 0; d <= degree; ++d) powers(i, d) = std::pow(x, d);
    logs(i) = std::log(std::abs(damping[at]));
  }
  return -powers.colPivHouseholderQr().solve(logs)(1);
}

/// Slopes of the cubic spline through (x, y), not-a-knot at the start, of given slope at the end.
std::vector<double> splineSlopes(std::span<const double> x, std::span<const double> y,
                                 double endSlope) {
  const std::size_t n = x.size();
  auto step = [&](std::size_t i) { return x[i + 1] - x[i]; };
  auto rise = [&](std::size_t i) { return (y[i + 1] - y[i]) / step(i); };
  std::vector<double> diagonal(n, 1.0), upper(n, 0.0), slope(n, 0.0);
  const double h0 = step(0), h1 = step(1);
  diagonal[0] = h1;
  upper[0] = h0 + h1;
  slope[0] = ((h0 + 2.0 * (h0 + h1)) * h1 * rise(0) + h0 * h0 * rise(1)) / (h0 + h1);
  for (std::size_t i = 1; i + 1 < n; ++i) {  // Thomas elimination, downwards
    const double below = step(i) / diagonal[i - 1];
    diagonal[i] = 2.0 * (step(i - 1) + step(i)) - below * upper[i - 1];
    upper[i] = step(i - 1);
    slope[i] = 3.0 * (step(i) * rise(i - 1) + step(i - 1) * rise(i)) - below * slope[i - 1];
  }
  slope[n - 1] = endSlope;
  for (std::size_t i = n - 1; i-- > 0;)
    slope[i] = (slope[i] - upper[i] * slope[i + 1]) / diagonal[i];
  return slope;
}

double legendre4(const std::array<double, 4>& q, double s) {
  const double p2 = 1.5 * s * s - 0.5, p3 = s * (2.5 * s * s - 1.5);
  return q[0] + q[1] * s + q[2] * p2 + q[3] * p3;
}

/// Legendre coefficients of q(ω)/ω over the cell c ± h, by the Gauss points of degree 15. In the
/// first cell, from ω = 0, q/ω is a polynomial too.
std::array<double, 8> overOmega(const std::array<double, 4>& q, double c, double h) {
  static const fourier::GaussRule<8> rule;
  std::array<double, 8> r{};
  for (std::size_t g = 0; g < 8; ++g) {
    const double s = rule.node[g], value = legendre4(q, s) / (c + h * s);
    double p = 1.0, before = 0.0;
    for (std::size_t n = 0; n < 8; ++n) {
      const double order = static_cast<double>(n);
      r[n] += (order + 0.5) * rule.weight[g] * value * p;
      const double next = ((2.0 * order + 1.0) * s * p - order * before) / (order + 1.0);
      before = p;
      p = next;
    }
  }
  return r;
}

}  // namespace

RetardationFunction::RetardationFunction(std::span<const double> omega,
                                         std::span<const double> damping) {
  check(omega, damping);
  nodes_.assign(1, 0.0);
  nodes_.insert(nodes_.end(), omega.begin(), omega.end());
  fitTail(damping);
  fitPieces(damping);
}

void RetardationFunction::fitTail(std::span<const double> damping) {
  tailValue_ = damping.back();
  const double found = decayExponent(std::span(nodes_).subspan(1), damping);
  const double exponent =
      std::isnan(found) ? kNoisePower
                        : std::clamp(found, 0.0, static_cast<double>(fourier::kGreatestPower));
  // Slope at Ω is −(n − c) B/Ω. With n ≤ exponent < n + 1 both terms are of one sign; below n = 3
  // the second term is negative and bends a slow start into (Ω/ω)³, without changing the sign.
  tailPower_ = std::max(fourier::kLeastPower, static_cast<int>(exponent));
  tailMix_ = tailPower_ - exponent;
}

void RetardationFunction::fitPieces(std::span<const double> damping) {
  const std::size_t n = nodes_.size();
  std::vector<double> q(n, 0.0);
  for (std::size_t i = 1; i < n; ++i) q[i] = damping[i - 1] / nodes_[i];
  const double tailSlope = -(tailPower_ - tailMix_ + 1.0) * q[n - 1] / nodes_[n - 1];
  auto slope = splineSlopes(nodes_, q, tailSlope);
  // Monotone first cell: slopes within 0..3 times the chord's [Fritsch & Carlson 1980].
  const double chord = q[1] / nodes_[1];
  if (slope[0] * chord < 0.0) slope[0] = 0.0;
  if (slope[0] / chord > 3.0) slope[0] = 3.0 * chord;
  if (slope[1] / chord > 3.0) slope[1] = 3.0 * chord;

  pieces_.reserve(n - 1);
  for (std::size_t i = 0; i + 1 < n; ++i) {
    const double h = 0.5 * (nodes_[i + 1] - nodes_[i]), c = 0.5 * (nodes_[i + 1] + nodes_[i]);
    const double d0 = h * slope[i], d1 = h * slope[i + 1], jump = q[i + 1] - q[i];
    // Hermite cubic m0 + m1 s + m2 s² + m3 s³ on s = −1..1, then times ω = c + h s.
    const double m2 = 0.25 * (d1 - d0), m0 = 0.5 * (q[i] + q[i + 1]) - m2;
    const double m3 = 0.25 * (d0 + d1 - jump), m1 = 0.5 * jump - m3;
    const double b0 = c * m0, b1 = c * m1 + h * m0, b2 = c * m2 + h * m1, b3 = c * m3 + h * m2;
    const double b4 = h * m3;
    pieces_.push_back({{b0 + b2 / 3.0 + b4 / 5.0, b1 + 0.6 * b3, b2 / 1.5 + b4 * (4.0 / 7.0),
                        0.4 * b3, b4 * (8.0 / 35.0)},
                       {m0 + m2 / 3.0, m1 + 0.6 * m3, m2 / 1.5, 0.4 * m3},
                       {}});
    pieces_.back().r = overOmega(pieces_.back().q, c, h);
  }
}

Complex RetardationFunction::tailTransform(const TailTable& table, int extraPower) const noexcept {
  const auto i = static_cast<std::size_t>(tailPower_ + extraPower - fourier::kLeastPower);
  return tailValue_ * ((1.0 + tailMix_ + tailBend_) * table[i] -
                       (tailMix_ + 2.0 * tailBend_) * table[i + 1] + tailBend_ * table[i + 2]);
}

double RetardationFunction::operator()(double tau) const noexcept {
  double sum = 0.0;
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    sum += fourier::dot(pieces_[i].b, fourier::cellWeights(nodes_[i], nodes_[i + 1], tau).cosine);
  }
  const double end = nodes_.back();
  return kTwoOverPi * (sum + end * tailTransform(fourier::tailIntegrals(end * tau), 0).real());
}

double RetardationFunction::integral(double tau) const noexcept {
  double sum = 0.0;
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    sum += fourier::dot(pieces_[i].q, fourier::cellWeights(nodes_[i], nodes_[i + 1], tau).sine);
  }
  const auto table = fourier::tailIntegrals(nodes_.back() * tau);
  return kTwoOverPi * (sum + tailTransform(table, 1).imag());
}

double RetardationFunction::remaining(double tau) const noexcept {
  double sum = 0.0;
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    sum += fourier::dot(pieces_[i].r, fourier::cosineWeights(nodes_[i], nodes_[i + 1], tau));
  }
  const double end = nodes_.back();
  return kTwoOverPi * (sum + tailTransform(fourier::tailIntegrals(end * tau), 2).real() / end);
}

double RetardationFunction::dampingInCell(std::size_t cell, double omega) const noexcept {
  const double a = nodes_[cell], b = nodes_[cell + 1];
  return omega * legendre4(pieces_[cell].q, (2.0 * omega - a - b) / (b - a));
}

double RetardationFunction::dampingInTail(double omega) const noexcept {
  const double u = nodes_.back() / omega, v = 1.0 - u;
  return tailValue_ * std::pow(u, tailPower_) * (1.0 + tailMix_ * v + tailBend_ * v * v);
}

double RetardationFunction::damping(double omega) const noexcept {
  if (omega >= nodes_.back()) return dampingInTail(omega);
  const auto above = std::upper_bound(nodes_.begin() + 1, nodes_.end() - 1, omega);
  return dampingInCell(static_cast<std::size_t>(above - nodes_.begin()) - 1, omega);
}

double RetardationFunction::sineTransform(double omega) const noexcept {
  // P∫₀^∞ ω/(ω² − x²) dx = 0, so B(x) may be replaced by B(x) − B(ω), which takes the pole away.
  static const fourier::GaussRule<8> cellRule;
  static const fourier::GaussRule<40> tailRule;
  const double here = damping(omega);
  double sum = 0.0;
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const double h = 0.5 * (nodes_[i + 1] - nodes_[i]), c = 0.5 * (nodes_[i + 1] + nodes_[i]);
    for (std::size_t g = 0; g < 8; ++g) {
      const double x = c + h * cellRule.node[g];
      if (x == omega) continue;  // a set of measure zero; one node of many cells
      sum += h * cellRule.weight[g] * (dampingInCell(i, x) - here) * omega /
             ((omega - x) * (omega + x));
    }
  }
  const double end = nodes_.back();
  for (std::size_t g = 0; g < 40; ++g) {  // x = Ω/u, u from 0 to 1
    const double u = 0.5 * (1.0 + tailRule.node[g]), x = end / u;
    if (x == omega) continue;
    sum += 0.5 * tailRule.weight[g] * (dampingInTail(x) - here) * omega * end /
           ((omega * u - end) * (omega * u + end));
  }
  return kTwoOverPi * sum;
}

}  // namespace cutwater
