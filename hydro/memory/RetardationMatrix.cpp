#include "hydro/memory/RetardationMatrix.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "hydro/Errors.h"
#include "hydro/base/SymmetricEigen.h"
#include "hydro/database/ForwardSpeed.h"
#include "hydro/database/Interpolation.h"
#include "hydro/memory/FourierPieces.h"
#include "hydro/memory/MiddleBand.h"

namespace cutwater {

namespace {

constexpr double kZeroPair = 1e-8;        // of √(B_jj B_kk): vanishes by symmetry
constexpr double kPositive = 0.005;       // of a tail: negative by less is left
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

std::optional<Mat6> meanOverMiddleBand(const Coefficients& c,
                                       const std::function<Mat6(std::size_t frequency)>& value) {
  const std::vector<Mat6> values = overMiddleBand(c, value);
  if (values.empty()) return {};
  Mat6 sum = Mat6::Zero();
  for (const Mat6& one : values) sum += one;
  return sum / static_cast<double>(values.size());
}

/// The functions of those pairs (j, k) that do not vanish by symmetry.
template <class Value>
struct Sampler {
  std::span<const double> omega;
  const Vec6& scale;
  Value value;  // of (frequency, j, k)

  std::optional<RetardationFunction> function(int j, int k) const {
    std::vector<double> values(omega.size());
    double largest = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i) {
      values[i] = value(i, j, k);
      largest = std::isfinite(values[i]) ? std::max(largest, std::abs(values[i])) : HUGE_VAL;
    }
    if (largest <= kZeroPair * std::sqrt(scale(j) * scale(k)) && !values.empty()) return {};
    return RetardationFunction(omega, values);
  }
};
template <class Value>  // Clang 14 does not deduce aggregates
Sampler(std::span<const double>, const Vec6&, Value)->Sampler<Value>;

}  // namespace

RetardationMatrix::RetardationMatrix(const Coefficients& coefficients, ForwardSpeedForm form)
    : form_(form) {
  requireFinished(coefficients, "RetardationMatrix");
  const Vec6 scale = dampingScale(coefficients);
  const std::size_t count = std::min(resolvedCount(coefficients), coefficients.damping.size());
  const auto& B = coefficients.damping;
  const auto mean = [&](std::size_t i, int j, int k) { return 0.5 * (B[i](j, k) + B[i](k, j)); };
  const std::span<const double> omega(coefficients.omega.data(), count);
  const Sampler sampler{omega, scale, mean};
  for (int j = 0; j < 6; ++j) {
    for (int k = j; k < 6; ++k) {
      if (auto found = sampler.function(j, k)) entries_.push_back({j, k, std::move(*found)});
    }
  }
  keepTailsPositive();
  duration_ = findDuration();
  addSpeedTerms(coefficients, scale);
}

/// Far beyond Ω a tail is (1 + c) B(Ω) uⁿ, with c from the slope of each entry by itself. B stays
/// positive definite there if the matrix of these is. Where it is not, its couplings are lessened
/// until it is, each by a d, so that value and slope at Ω stay.
void RetardationMatrix::keepTailsPositive() {
  const auto far = [](const RetardationFunction& f) { return (1.0 + f.tailMix_) * f.tailValue_; };
  Vec6 own = Vec6::Zero(), power = own;
  for (const Entry& e : entries_) {
    if (e.j != e.k || far(e.function) <= 0.0) continue;
    own[e.j] = std::sqrt(far(e.function));
    power[e.j] = e.function.tailPower_;
  }
  // A coupling that dies at a greater power than its modes is nothing beside them; one that dies at
  // a smaller power outlasts them, and none of its leading term can stay.
  const auto excess = [&](const Entry& e) {
    return own[e.j] > 0.0 && own[e.k] > 0.0 && e.j != e.k
               ? power[e.j] + power[e.k] - 2.0 * e.function.tailPower_
               : -1.0;
  };
  const auto beside = [&](const Entry& e) { return far(e.function) / (own[e.j] * own[e.k]); };
  // Modes of one parity by themselves, if those of the other are not coupled with them: they have
  // no part in what is wrong there.
  const bool mixed = std::any_of(entries_.begin(), entries_.end(), [&](const Entry& e) {
    return excess(e) >= 0.0 && (e.j + e.k) % 2 == 1;
  });
  for (const int group : {0, 1}) {
    const auto belongs = [&](const Entry& e) {
      return excess(e) >= 0.0 && (mixed ? 0 : e.j % 2) == group;
    };
    Mat6 matrix = Mat6::Identity();
    for (const Entry& e : entries_)
      if (belongs(e) && excess(e) == 0.0)
        matrix(e.j, e.k) = matrix(e.k, e.j) = std::clamp(beside(e), -1.0, 1.0);
    // I + s(M − I) has no eigenvalue below 0.
    const double share = 1.0 / (1.0 - std::min(0.0, symmetricEigenvalues(matrix)[0]));
    for (Entry& e : entries_) {
      if (!belongs(e)) continue;
      const double kept = share * matrix(e.j, e.k) / beside(e);
      if (kept < 1.0 - kPositive) e.function.tailBend_ = (kept - 1.0) * (1.0 + e.function.tailMix_);
    }
  }
}

void RetardationMatrix::addSpeedTerms(const Coefficients& c, const Vec6& scale) {
  const Mat6 T = tuckMatrix(),
             A = 0.5 * (c.addedMass.atInfinity + c.addedMass.atInfinity.transpose());
  if (form_ == ForwardSpeedForm::Tuck) {
    addedMassXInf_ = T * A;
  } else {
    if (c.addedMassX.empty() || c.dampingX.empty()) return;
    const std::size_t count = std::min(resolvedCount(c), c.dampingX.size());
    const auto value = [&](std::size_t i, int j, int k) { return c.dampingX[i](j, k); };
    const Sampler sampler{std::span(c.omega.data(), count), scale, value};
    for (int n = 0; n < 36; ++n) {
      if (auto found = sampler.function(n / 6, n % 6))
        entriesX_.push_back({n / 6, n % 6, std::move(*found)});
    }
    const auto seen = [&](std::size_t i) {
      return Mat6(c.addedMassX[i] + sineTransformX(c.omega[i]) / c.omega[i]);
    };
    // With a consistent limit it is that mean already, of ∂A before it went over to ∂B's.
    addedMassXInf_ = c.hasConsistentLimit()
                         ? c.addedMassX.atInfinity
                         : meanOverMiddleBand(c, seen).value_or(c.addedMassX.atInfinity);
  }
  hasSpeedTerms_ = true;
  rise_ = ofX(Level::Remaining, 0.0);
  speedDamping_ = A * T.transpose() - addedMassXInf_;
  speedStiffness_ = -(addedMassXInf_ + rise_) * T.transpose();
}

bool RetardationMatrix::isZero(int j, int k) const noexcept {
  return std::none_of(entries_.begin(), entries_.end(), [&](const Entry& e) {
    return e.j == std::min(j, k) && e.k == std::max(j, k);
  });
}

Mat6 RetardationMatrix::sum(const Entries& entries, Level level, double tau) const {
  Mat6 result = Mat6::Zero();
  if (entries.empty()) return result;
  const auto& nodes = entries.front().function.nodes_;
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
    const auto weights = fourier::cellWeights(nodes[i], nodes[i + 1], tau);
    const auto longer = level == Level::Remaining
                            ? fourier::cosineWeights(nodes[i], nodes[i + 1], tau)
                            : std::array<double, 8>{};
    for (const Entry& e : entries) {
      const auto& piece = e.function.pieces_[i];
      result(e.j, e.k) += level == Level::Value      ? fourier::dot(piece.b, weights.cosine)
                          : level == Level::Integral ? fourier::dot(piece.q, weights.sine)
                                                     : fourier::dot(piece.r, longer);
    }
  }
  const double end = nodes.back();
  const auto tails = fourier::tailIntegrals(end * tau);
  for (const Entry& e : entries) {
    const RetardationFunction& f = e.function;
    result(e.j, e.k) += level == Level::Value      ? end * f.tailTransform(tails, 0).real()
                        : level == Level::Integral ? f.tailTransform(tails, 1).imag()
                                                   : f.tailTransform(tails, 2).real() / end;
  }
  return (2.0 / kPi) * result;
}

Mat6 RetardationMatrix::atRest(Level level, double tau) const {
  return Mat6(sum(entries_, level, tau).selfadjointView<Eigen::Upper>());
}

Mat6 RetardationMatrix::ofX(Level level, double tau) const {
  return form_ == ForwardSpeedForm::Tuck ? Mat6(tuckMatrix() * atRest(level, tau))
                                         : sum(entriesX_, level, tau);
}

Mat6 RetardationMatrix::at(double tau) const { return atRest(Level::Value, tau); }

Mat6 RetardationMatrix::integral(double tau) const { return atRest(Level::Integral, tau); }

Mat6 RetardationMatrix::squared(double tau) const {
  return ofX(Level::Remaining, tau) * tuckMatrix().transpose();
}

SpeedKernels RetardationMatrix::kernels(double tau) const {
  SpeedKernels k{at(tau), Mat6::Zero(), Mat6::Zero()};
  if (!hasSpeedTerms_) return k;
  k.linear = integral(tau) * tuckMatrix().transpose() - ofX(Level::Integral, tau);
  k.squared = squared(tau);
  return k;
}

Mat6 RetardationMatrix::momentumIntegral(double a, double b) const {
  const Mat6 all = atRest(Level::Remaining, a);
  return std::isfinite(b) ? Mat6(all - atRest(Level::Remaining, b)) : all;
}

SpeedKernels RetardationMatrix::integrals(double a, double b) const {
  SpeedKernels k{integral(b) - integral(a), Mat6::Zero(), Mat6::Zero()};
  if (!hasSpeedTerms_) return k;
  k.linear = linearBeyond(a) - linearBeyond(b);
  const double half = 0.5 * (b - a), middle = 0.5 * (a + b), out = half * std::sqrt(0.6);
  k.squared = half / 9.0 *
              (5.0 * squared(middle - out) + 8.0 * squared(middle) + 5.0 * squared(middle + out));
  return k;
}

Mat6 RetardationMatrix::linearBeyond(double tau) const {
  return atRest(Level::Remaining, tau) * tuckMatrix().transpose() - ofX(Level::Remaining, tau);
}

Mat6 RetardationMatrix::linearTotal() const {
  return hasSpeedTerms_ ? linearBeyond(0.0) : Mat6(Mat6::Zero());
}

// With D = ∂A − ∂A^∞ − i ∂B/ω the transform of ∫₀^τK⁰ is that of K⁰ over iω, and that of ∫_τ^∞ D
// what D lacks of its value at ω = 0, over iω.
RetardationMatrix::Transforms RetardationMatrix::transforms(double omega) const {
  const Complex iw(0.0, omega);
  Transforms result{
      damping(omega).cast<Complex>() - Complex(0.0, 1.0) * sineTransform(omega).cast<Complex>(),
      CMat6::Zero(), CMat6::Zero()};
  if (!hasSpeedTerms_) return result;
  const CMat6 Tt = tuckMatrix().transpose().cast<Complex>();
  const CMat6 D = (dampingX(omega).cast<Complex>() -
                   Complex(0.0, 1.0) * sineTransformX(omega).cast<Complex>()) /
                  iw;
  result.linear = result.atRest * Tt / iw - D;
  result.squared = (rise_.cast<Complex>() - D) * Tt / iw;
  return result;
}

template <class Value>
Mat6 RetardationMatrix::ofAll(const Entries& entries, Value value) const {
  Mat6 result = Mat6::Zero();
  for (const Entry& e : entries) result(e.j, e.k) = value(e.function);
  return result;
}

template <class Value>
Mat6 RetardationMatrix::atRest(Value value) const {
  return Mat6(ofAll(entries_, value).template selfadjointView<Eigen::Upper>());
}

template <class Value>
Mat6 RetardationMatrix::ofX(Value value) const {
  return form_ == ForwardSpeedForm::Tuck ? Mat6(tuckMatrix() * atRest(value))
                                         : ofAll(entriesX_, value);
}

Mat6 RetardationMatrix::sineTransform(double omega) const {
  return atRest([=](const RetardationFunction& f) { return f.sineTransform(omega); });
}

Mat6 RetardationMatrix::sineTransformX(double omega) const {
  return ofX([=](const RetardationFunction& f) { return f.sineTransform(omega); });
}

Mat6 RetardationMatrix::damping(double omega) const {
  return atRest([=](const RetardationFunction& f) { return f.damping(omega); });
}

Mat6 RetardationMatrix::dampingX(double omega) const {
  return ofX([=](const RetardationFunction& f) { return f.damping(omega); });
}

Mat6 RetardationMatrix::addedMassX(double omega) const {
  return addedMassXInf_ - sineTransformX(omega) / omega;
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
