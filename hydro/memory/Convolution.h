#pragma once
#include <array>
#include <memory>
#include <vector>

#include "hydro/memory/RadiationMemory.h"

namespace cutwater {

class RetardationMatrix;

/// Weights K̄_i of a convolution, shared by all ships of one database. Immutable.
///
/// ∫₀^∞ K dτ is known (0 for K⁰), but the memory ends at T. What is missing of K⁰ and K^U is added
/// to the last quarter of the weights as a smooth bump, so that a steady velocity feels no memory
/// at rest, however short the duration; of L⁰ likewise, so that A(0) is kept.
/// THEORY.md, chapter 7.
class ConvolutionWeights {
 public:
  /// @param step h [s] > 0.
  /// @param duration [s] ≥ 0: the memory is cut off there; 0: twice RetardationMatrix::duration(),
  ///        because K^U and K^UU, which are integrals of K⁰, die more slowly.
  /// @throws HydroError ValueOutOfRange, also for more than 10⁶ ticks of memory.
  ConvolutionWeights(const RetardationMatrix& retardation, double step, double duration = 0.0);

  double step() const noexcept { return step_; }
  std::size_t length() const noexcept { return length_; }  ///< ticks remembered
  std::size_t ring() const noexcept { return ring_; }  ///< length, rounded up to a multiple of 8

  struct Pair {
    int j, k;
    std::size_t offset;         ///< of its run
    std::array<bool, 4> holds;  ///< of K⁰, K^U, K^UU, L⁰: what is not zero
  };
  const std::vector<Pair>& pairs() const noexcept { return pairs_; }
  /// −K̄ of part 0, 1, 2 (K⁰, K^U, K^UU), of part 3 L̄ half a tick ahead; ring() numbers from the
  /// newest tick on.
  const double* run(std::size_t part, const Pair& pair) const noexcept {
    return weights_[part].data() + pair.offset;
  }

 private:
  void fill(const std::vector<SpeedParts<Mat6>>& cells, const Mat6& linearTotal);
  void fillMomentum(const RetardationMatrix& retardation);
  void balance(double* run, double missing) const;

  double step_;
  std::size_t length_, ring_;
  std::vector<Pair> pairs_;
  std::array<std::vector<double>, 4> weights_;
};

/// The memory as the convolution itself, with which faster ways are compared. State: a ring of past
/// velocities. A tick costs up to three dot products of length() for each of the 18 pairs of a
/// symmetric hull: about 10 µs at rest with 1500 ticks.
class Convolution final : public RadiationMemory {
 public:
  explicit Convolution(std::shared_ptr<const ConvolutionWeights> weights);
  /// Weights of its own.  @throws as ConvolutionWeights.
  Convolution(const RetardationMatrix& retardation, double step, double duration = 0.0)
      : Convolution(std::make_shared<ConvolutionWeights>(retardation, step, duration)) {}

  double step() const noexcept override { return weights_->step(); }
  std::size_t length() const noexcept { return weights_->length(); }
  using RadiationMemory::advance;
  Vec6 advance(const Vec6& etaDot, double speed) noexcept override;
  Parts advanceParts(const Vec6& etaDot) noexcept override;
  Vec6 momentum(const Vec6& velocity, double next) noexcept override;
  void addSteady(const Vec6& velocity) noexcept override;
  void reset() noexcept override;
  std::size_t stateSize() const noexcept override { return 2 + 6 * weights_->ring(); }
  void save(std::span<double> state) const noexcept override;
  bool fits(std::span<const double> state) const noexcept override;
  void restore(std::span<const double> state) override;

 private:
  void enter(const Vec6& etaDot) noexcept;
  Vec6 force(std::size_t part) noexcept;
  double* ringOf(std::size_t mode) noexcept { return past_.data() + mode * 2 * weights_->ring(); }

  std::shared_ptr<const ConvolutionWeights> weights_;
  std::vector<double> past_;  // per mode the ring twice over: any window of it is one straight run
  std::size_t next_ = 0;      // place of the newest
};

}  // namespace cutwater
