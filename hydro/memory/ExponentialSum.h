#pragma once
#include <array>
#include <complex>
#include <vector>

#include "hydro/memory/RadiationMemory.h"

namespace cutwater {

class RetardationMatrix;

/// All 36 retardation functions, at rest and under way, as sums of damped oscillations with common
/// poles:
///     K⁰(τ) ≈ Re Σ_m R⁰_m e^{s_m τ},  Re s_m < 0
/// K^U and K^UU likewise with residues of their own, so that the whole memory is one complex number
/// for each pole and mode. Poles by vector fitting of all transforms together [Gustavsen99;
/// Deschrijver08], at ω evenly up to the last that the data resolve and, in growing steps, ten
/// times as far. Residues: weighted least squares with ∫K⁰ dτ = 0 and ∫K^U dτ kept exactly: a
/// steady velocity feels no memory, and A(0) and c(U) do not change. An error at ω is measured
/// against the largest of B_jk(U), and of ωA_jk(U), from ω/1.5 to 1.5 ω, at that speed of 0 to
/// 15 m/s at which it is largest. ∫∫K⁰ = A(0) − A(∞) is kept as well, so that a ship that is pushed
/// for long moves with M + A(0). Immutable. Building costs about a quarter of a second.
/// THEORY.md, chapter 7.
class ExponentialSum {
 public:
  /// @param addedMassInf A(∞), against which errors are measured.
  /// @param poles  how many, a conjugate pair counted once; kMostPoles/2 at most.
  explicit ExponentialSum(const RetardationMatrix& retardation, const Mat6& addedMassInf,
                          std::size_t poles = 20);

  std::size_t size() const noexcept { return poles_.size(); }  ///< poles
  const std::vector<Complex>& poles() const noexcept { return poles_; }
  /// A pair (j, k) that is not zero: its residues by pole, at rest and under way.
  struct Pair : SpeedParts<std::vector<Complex>> {
    int j, k;
  };
  const std::vector<Pair>& pairs() const noexcept { return pairs_; }

  /// Poles, rounded up to a multiple of four.
  std::size_t width() const noexcept { return (poles_.size() + 3) / 4 * 4; }
  /// −Re R, then +Im R of part 0, 1, 2 (K⁰, K^U, K^UU): two runs of width() for each pair.
  const std::vector<double>& runs(std::size_t part) const noexcept { return runs_[part]; }

  /// +Re R/s, then −Im R/s of K⁰: of L⁰ = ∫K⁰, for each pair as above.
  const std::vector<double>& momentumRuns() const noexcept { return momentumRuns_; }

  Mat6 at(double tau, double speed) const;  ///< K(U, τ)
  /// ∫₀^∞ L⁰(τ) e^{−iωτ} dτ, L⁰ = ∫₀^τ K⁰: A(ω) − A(∞) + B(ω)/iω.  @param omega  any sign, 0 too.
  /// Allocates nothing; some tenths of a microsecond.
  CMat6 momentumTransform(double omega) const noexcept;
  static constexpr std::size_t kMostPoles = 64;
  /// ∫₀^∞ K(U, τ) e^{−iωτ} dτ.
  CMat6 transform(double omega, double speed) const;

  /// Largest error of K⁰, K^U or K^UU, in that measure; 0 without any memory.
  double error() const noexcept { return error_; }

 private:
  void makeRuns();
  Pair& pairOf(int j, int k);

  std::vector<Complex> poles_;
  std::vector<Pair> pairs_;
  std::array<std::vector<double>, 3> runs_;
  std::vector<double> momentumRuns_;
  double error_ = 0.0;
};

/// The memory by that sum; for any tick exactly the convolution of its functions:
///     z_mk ← e^{s_m h} z_mk + (e^{s_m h} − 1)/s_m η̇_k,   F_j = −Re Σ_m Σ_k R_jkm(U) z_mk
/// Stable for every tick, as |e^{s h}| < 1. State: 6 complex numbers a pole. A tick costs about
/// 0.2 µs.
class ExponentialMemory final : public RadiationMemory {
 public:
  /// @param sum must outlive it.  @throws HydroError ValueOutOfRange: step not positive.
  ExponentialMemory(const ExponentialSum& sum, double step);

  double step() const noexcept override { return step_; }
  bool setStep(double h) noexcept override;
  using RadiationMemory::advance;
  Vec6 advance(const Vec6& etaDot, double speed) noexcept override;
  Parts advanceParts(const Vec6& etaDot) noexcept override;
  Vec6 momentum(const Vec6& velocity, double next) noexcept override;
  void addSteady(const Vec6& velocity) noexcept override;
  void reset() noexcept override;
  std::size_t stateSize() const noexcept override { return 1 + states_.size(); }
  void save(std::span<double> state) const noexcept override;
  bool fits(std::span<const double> state) const noexcept override;
  void restore(std::span<const double> state) override;

 private:
  void weigh(double speed) noexcept;
  void enterAll(const Vec6& etaDot) noexcept;
  Vec6 sumOver(const std::vector<double>& runs) const noexcept;
  void makeAdvance() noexcept;
  void lookAhead(double half) noexcept;

  const ExponentialSum& sum_;
  double step_;
  double half_ = 0.0;             // of the tick to come, for which the next two are
  std::vector<double> halfRuns_;  // of L⁰ half a tick ahead: those of (R/s) e^{s h/2}
  Mat6 newest_ = Mat6::Zero();    // what the newest velocity adds in that half tick
  std::size_t width_;             // poles, rounded up to a multiple of four
  std::vector<double> advance_;  // Re, Im of e^{sh}; Re, Im of (e^{sh} − 1)/s: four runs of width_
  std::vector<double> states_;   // per mode Re z, Im z: two runs of width_
  std::vector<double> residues_;  // per pair −Re R(U), +Im R(U): two runs of width_
  double weighed_ = 0.0;          // U of residues_
};

}  // namespace cutwater
