#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "hydro/Errors.h"
#include "hydro/database/Interpolation.h"
#include "hydro/memory/FourierPieces.h"
#include "hydro/memory/RetardationFunction.h"

namespace cutwater {

namespace {

constexpr double kZeroPair = 1e-8;        // of √(B_jj B_kk): vanishes by symmetry
constexpr double kNegligibleRest = 1e-3;  // of ∫|K|: may lie beyond the duration

/// Size of B_jj of each mode: its maximum over ω, but not less than a trifle of the translations',
/// so that a mode without damping (a sphere's roll) does not make round-off look significant.
Vec6 dampingScale(const Coefficients& coefficients) {
  Vec6 scale = Vec6::Zero();
  for (const Mat6& b : coefficients.damping) scale = scale.cwiseMax(b.diagonal().cwiseAbs());
  const double length = std::cbrt(std::max(coefficients.ship.volume, 1e-12));
  const double least = 1e-8 * scale.head<3>().maxCoeff();
  scale.head<3>() = scale.head<3>().cwiseMax(least);
  scale.tail<3>() = scale.tail<3>().cwiseMax(least * length * length);
  return scale;
}

double medianStep(const std::vector<double>& nodes) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < nodes.size(); ++i) steps.push_back(nodes[i] - nodes[i - 1]);
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return *middle;
}

}  // namespace

RetardationMatrix::RetardationMatrix(const Coefficients& coefficients) {
  const Vec6 scale = dampingScale(coefficients);
  const std::size_t count = resolvedCount(coefficients);
  const std::span omega(coefficients.omega.data(), count);
  const std::span matrices(coefficients.damping.data(),
                           std::min(count, coefficients.damping.size()));
  std::vector<double> values(matrices.size());
  for (int j = 0; j < 6; ++j) {
    for (int k = j; k < 6; ++k) {
      double largest = 0.0;
      for (std::size_t i = 0; i < values.size(); ++i) {
        values[i] = 0.5 * (matrices[i](j, k) + matrices[i](k, j));
        largest = std::isfinite(values[i]) ? std::max(largest, std::abs(values[i])) : HUGE_VAL;
      }
      if (largest <= kZeroPair * std::sqrt(scale(j) * scale(k)) && !values.empty()) continue;
      entries_.push_back({j, k, RetardationFunction(omega, values)});
    }
  }
  duration_ = findDuration();
}

bool RetardationMatrix::isZero(int j, int k) const noexcept {
  return std::none_of(entries_.begin(), entries_.end(), [&](const Entry& e) {
    return e.j == std::min(j, k) && e.k == std::max(j, k);
  });
}

Mat6 RetardationMatrix::at(double tau) const {
  Mat6 result = Mat6::Zero();
  if (entries_.empty()) return result;
  const auto& nodes = entries_.front().function.nodes_;
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
    const auto weights = fourier::cellWeights(nodes[i], nodes[i + 1], tau).cosine;
    for (const Entry& entry : entries_) {
      result(entry.j, entry.k) += fourier::dot(entry.function.pieces_[i].b, weights);
    }
  }
  const auto tails = fourier::tailIntegrals(nodes.back() * tau);
  for (const Entry& entry : entries_) {
    const RetardationFunction& f = entry.function;
    result(entry.j, entry.k) += nodes.back() * f.tailTransform(tails, 0).real();
  }
  return (2.0 / kPi) * Mat6(result.selfadjointView<Eigen::Upper>());
}

Mat6 RetardationMatrix::integral(double tau) const {
  Mat6 result = Mat6::Zero();
  if (entries_.empty()) return result;
  const auto& nodes = entries_.front().function.nodes_;
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
    const auto weights = fourier::cellWeights(nodes[i], nodes[i + 1], tau).sine;
    for (const Entry& entry : entries_) {
      result(entry.j, entry.k) += fourier::dot(entry.function.pieces_[i].q, weights);
    }
  }
  const auto tails = fourier::tailIntegrals(nodes.back() * tau);
  for (const Entry& entry : entries_) {
    result(entry.j, entry.k) += entry.function.tailTransform(tails, 1).imag();
  }
  return (2.0 / kPi) * Mat6(result.selfadjointView<Eigen::Upper>());
}

Mat6 RetardationMatrix::sineTransform(double omega) const {
  Mat6 result = Mat6::Zero();
  for (const Entry& entry : entries_) {
    result(entry.j, entry.k) = entry.function.sineTransform(omega);
  }
  return result.selfadjointView<Eigen::Upper>();
}

Mat6 RetardationMatrix::damping(double omega) const {
  Mat6 result = Mat6::Zero();
  for (const Entry& entry : entries_) result(entry.j, entry.k) = entry.function.damping(omega);
  return result.selfadjointView<Eigen::Upper>();
}

Mat6 RetardationMatrix::addedMassInf(double omega, const Mat6& addedMass) const {
  return 0.5 * (addedMass + addedMass.transpose()) + sineTransform(omega) / omega;
}

ImpulseResponse RetardationMatrix::table(double step, double duration) const {
  if (!(step > 0.0 && step <= duration && duration <= 1e6 * step)) {
    throw HydroError(
        Fault::ValueOutOfRange,
        fmt::format("RetardationMatrix::table: step {} s for a duration of {} s", step, duration));
  }
  const auto last = static_cast<std::size_t>(std::floor(duration / step + 1e-9));
  ImpulseResponse response{step, {}};
  for (std::size_t i = 0; i <= last; ++i) {
    response.values.push_back(at(static_cast<double>(i) * step));
  }
  return response;
}

double RetardationMatrix::findDuration() const {
  if (entries_.empty()) return 0.0;
  const auto& nodes = entries_.front().function.nodes_;
  const double longest = kPi / medianStep(nodes);
  // K holds frequencies up to about Ω: eight points to the shortest period.
  const auto count =
      static_cast<std::size_t>(std::ceil(longest * nodes.back() * 8.0 / (2.0 * kPi)));
  const double step = longest / static_cast<double>(count);
  std::vector<Mat6> cells;  // |K| Δτ, at cell centres
  Mat6 total = Mat6::Zero();
  for (std::size_t i = 0; i < count; ++i) {
    cells.push_back(at((static_cast<double>(i) + 0.5) * step).cwiseAbs() * step);
    total += cells.back();
  }
  const Vec6 size = total.diagonal().cwiseSqrt();
  const Mat6 allowed = kNegligibleRest * size * size.transpose();
  Mat6 rest = Mat6::Zero();
  std::size_t kept = count;
  while (kept > 1) {
    rest += cells[kept - 1];
    const bool tooMuch = std::any_of(entries_.begin(), entries_.end(), [&](const Entry& e) {
      return rest(e.j, e.k) > allowed(e.j, e.k);
    });
    if (tooMuch) break;
    --kept;
  }
  return static_cast<double>(kept) * step;
}

}  // namespace cutwater
