#pragma once
#include <vector>

#include "hydro/Conventions.h"

namespace cutwater {

class RetardationMatrix;

/// Force of the radiated waves' memory at fixed ticks, the exact sum (30):
///   F(t_n) = −∫₀^{T} K(τ) η̇(t_n − τ) dτ ≈ −Σ_i K̄_i η̇_{n−i},   K̄_i = ∫ K over [i h, (i+1) h].
/// η̇_n is the mean velocity over the tick that ends at t_n (in Bullet: the velocity after the solve,
/// which moved the body over that tick), so the sum is second order in h and sees ∫K dτ exactly.
/// State: a ring of past velocities. No allocation after construction. One thread at a time.
class Convolution {
 public:
  /// @param step h [s] > 0.  @param duration [s]: memory is cut off there (default: K's own).
  /// @throws HydroError ValueOutOfRange.
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
    std::vector<Vec6> past;
    std::size_t next = 0;
  };
  Snapshot save() const { return {past_, next_}; }
  /// @throws HydroError BadArgument if it was taken with another length.
  void restore(const Snapshot& snapshot);

 private:
  double step_;
  std::size_t length_;
  std::vector<Vec6> past_;
  std::size_t next_ = 0;
  struct Pair {
    int j, k;
    std::size_t offset;
  };
  std::vector<Pair> pairs_;      // only those that are not zero
  std::vector<double> weights_;  // K̄, one run per pair
};

}  // namespace cutwater
