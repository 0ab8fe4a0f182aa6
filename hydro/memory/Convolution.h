#pragma once
#include <vector>

#include "hydro/Conventions.h"

namespace cutwater {

class RetardationMatrix;

/// Force of the radiated waves' memory at fixed ticks, the exact sum of [M03] (30):
///   F(t_n) = −∫₀^{T} K(τ) η̇(t_n − τ) dτ ≈ −Σ_i K̄_i η̇_{n−i},   K̄_i = ∫ K over [i h, (i+1) h].
/// η̇_n is the mean velocity over the tick that ends at t_n (in Bullet: the velocity after the
/// solve, which moved the body over that tick), so the sum is second order in h and sees ∫K dτ
/// exactly.
///
/// ∫₀^∞ K dτ = 0, but ∫₀^T K is only small. What is missing is added to the last quarter of the
/// weights, as a smooth bump, so that Σ K̄ = 0: a steady velocity feels no memory at all, however
/// short the duration.
///
/// Frame H; forces and moments about G. State: a ring of past velocities. No allocation after
/// construction. One thread at a time. A tick costs 18 dot products of `length()` for a symmetric
/// hull: about 10 µs at 1500 ticks. A velocity that is not finite spoils the ring: reset() or
/// restore() after it.
class Convolution {
 public:
  /// @param step h [s] > 0.  @param duration [s] ≥ 0: memory is cut off there (0: K's own).
  /// @throws HydroError ValueOutOfRange, also for more than 10⁶ ticks of memory.
  Convolution(const RetardationMatrix& retardation, double step, double duration = 0.0);

  double step() const noexcept { return step_; }
  /// Number of past ticks remembered.
  std::size_t length() const noexcept { return length_; }
  /// Enters the velocity of the tick just ended and returns F(t_n) [N, N·m].
  Vec6 advance(const Vec6& etaDot) noexcept;
  /// Forgets: as if at rest on the mean course for ever.
  void reset() noexcept;

  /// Exact state. restore(save()) gives the same bits ever after.
  struct Snapshot {
    std::vector<Vec6> past;  ///< η̇ by place in the ring
    std::size_t next = 0;    ///< place of the newest; older ones follow, cyclically
    double step = 0.0;       ///< h [s]
  };
  Snapshot save() const;
  /// @throws HydroError BadArgument if it was taken with another length or tick.
  void restore(const Snapshot& snapshot);

 private:
  struct Pair {
    int j, k;
    std::size_t offset;  // of its run in weights_
  };
  void balance(double* run, double missing) const;
  double* ringOf(int mode) noexcept {
    return past_.data() + static_cast<std::size_t>(mode) * 2 * ring_;
  }

  double step_;
  std::size_t length_;        // ticks remembered
  std::size_t ring_;          // places in the ring: length_ rounded up to a multiple of 8
  std::vector<double> past_;  // per mode the ring twice over: any window of it is one straight run
  std::size_t next_ = 0;      // place of the newest
  std::vector<Pair> pairs_;   // only those that are not zero
  std::vector<double> weights_;  // −K̄, one run of ring_ per pair, newest tick first
};

}  // namespace cutwater
