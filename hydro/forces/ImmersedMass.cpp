#include "hydro/forces/ImmersedMass.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "hydro/base/SymmetricEigen.h"

namespace cutwater {

namespace {

using Mat2 = Eigen::Matrix2d;
using Vec2 = Eigen::Vector2d;

constexpr double kWholeMean = 0.8;   // of all strips: the hull counts as immersed
constexpr double kSameArm = 1e-6;    // of the arms' size: strips at one place
constexpr double kSingular = 1e-12;  // of the larger eigenvalue

// Symmetric, without what is below 0.
Mat6 positivePart(const Mat6& given) {
  // In units in which all directions are alike: those of its diagonal.
  Vec6 unit = given.diagonal().cwiseAbs().cwiseSqrt();
  for (double& u : unit) u = u > 0.0 ? u : 1.0;
  const Vec6 inverse = unit.cwiseInverse();
  const Mat6 scaled =
      inverse.asDiagonal() * (0.5 * (given + given.transpose())) * inverse.asDiagonal();
  const SymmetricEigen eigen = symmetricEigen(scaled);
  if (eigen.values[0] >= 0.0) return 0.5 * (given + given.transpose());
  const Vec6 kept = eigen.values.cwiseMax(0.0);
  const Mat6 positive = eigen.vectors * kept.asDiagonal() * eigen.vectors.transpose();
  return unit.asDiagonal() * positive * unit.asDiagonal();
}

bool regular(const Mat2& m) {
  return m(0, 0) > 0.0 && m.determinant() > kSingular * m(0, 0) * m(1, 1);
}

Mat2 lower(const Mat2& m) { return Eigen::LLT<Mat2>(m).matrixL(); }

}  // namespace

// With A₂ the heave-pitch part and B = A₂⁻¹A₂ₒ the coupling to the other modes o,
//   νᵀA∞ν = (ν₂ + Bνₒ)ᵀA₂(ν₂ + Bνₒ) + νₒᵀ(Aₒₒ − Aₒ₂B)νₒ.
ImmersedMass::ImmersedMass(const Mat6& addedMass, std::span<const double> weights,
                           std::span<const double> arms)
    : weights_(weights.begin(), weights.end()), rest_(positivePart(addedMass)) {
  Mat2 gram = Mat2::Zero();
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const Vec2 at(1.0, -arms[i]);
    gram += weights[i] * at * at.transpose();
  }
  const auto [first, last] = std::minmax_element(arms.begin(), arms.end());
  Mat2 pair;
  pair << rest_(Heave, Heave), rest_(Heave, Pitch), rest_(Pitch, Heave), rest_(Pitch, Pitch);
  const bool apart = !arms.empty() && *last - *first > kSameArm * std::abs(*last);
  if (!apart || !regular(gram) || !regular(pair)) return;
  const Mat2 turn = lower(pair) * lower(gram).inverse();
  Eigen::Matrix<double, 2, 6> rows;
  rows << rest_.row(Heave), rest_.row(Pitch);
  const Eigen::Matrix<double, 2, 6> coupling = pair.inverse() * rows;  // 1 at heave and pitch
  Mat6 sum = Mat6::Zero();
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const Vec2 strip = std::sqrt(weights[i]) * (turn * Vec2(1.0, -arms[i]));
    strips_.push_back(coupling.transpose() * strip);
    sum += strips_.back() * strips_.back().transpose();
  }
  rest_ -= sum;
  // Heave and pitch have nothing left.
  for (const int mode : {Heave, Pitch}) {
    rest_.row(mode).setZero();
    rest_.col(mode).setZero();
  }
}

double ImmersedMass::mean(std::span<const double> shares) const noexcept {
  double sum = 0.0, all = 0.0;
  for (std::size_t i = 0; i < weights_.size(); ++i) {
    sum += weights_[i] * shares[i];
    all += weights_[i];
  }
  return all > 0.0 ? std::min(1.0, sum / (kWholeMean * all)) : 1.0;
}

Mat6 ImmersedMass::at(std::span<const double> shares) const noexcept {
  Mat6 sum = mean(shares) * rest_;
  for (std::size_t i = 0; i < strips_.size(); ++i)
    sum += shares[i] * strips_[i] * strips_[i].transpose();
  return sum;
}

ImmersedMass::Change ImmersedMass::change(std::span<const double> before,
                                          std::span<const double> now,
                                          std::span<const double> rise) const noexcept {
  const double mean = this->mean(now), lost = this->mean(before) - mean;
  Change change;
  change.now = mean * rest_;
  if (lost > 0.0) change.left = lost * rest_;
  for (std::size_t i = 0; i < strips_.size(); ++i) {
    const Vec6& strip = strips_[i];
    const Mat6 mass = strip * strip.transpose();
    change.now += now[i] * mass;
    const double gained = now[i] - before[i];
    if (gained < 0.0) change.gone -= gained * mass;
    if (gained > 0.0) change.met += gained * rise[i] * strip[Heave] * strip;
  }
  change.left += change.gone;
  return change;
}

}  // namespace cutwater
