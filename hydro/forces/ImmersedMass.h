#pragma once
#include <span>
#include <vector>

#include "hydro/Conventions.h"

namespace cutwater {

/// Added mass of a hull that is not wholly in the water: which part of it each strip of the hull
/// has.
///     A(s) = Σ_i s_i F_i F_iᵀ + s̄ A_rest,   A(1) = A∞,   s_i = 0 out of the water, 1 in it
/// F_i is what strip i has of heave and pitch, so that a bow that comes down is met at the bow. It
/// begins with the mass g_i and the arm x_i of the strip, G = Σ g_i (1, −x_i)(1, −x_i)ᵀ, and is
/// made to add up: F_i = √g_i T (1, −x_i) with T G Tᵀ the heave-pitch part of A∞. Surge, sway, roll
/// and yaw follow by their couplings, and what is left of them, A_rest ≥ 0, goes with the mean s̄.
/// All terms are ≥ 0: strips that come in add mass, strips that leave take theirs away. Axes and
/// units of A∞. Immutable.
/// THEORY.md, chapter 9.
class ImmersedMass {
 public:
  /// @param addedMass  A∞ about G; its antisymmetric part and what of it is below 0 are dropped.
  /// @param weights  g_i > 0, in any unit, and arms  x_i [m]: of each strip. Fewer than two
  ///        different arms: all of A∞ goes with the mean.
  ImmersedMass(const Mat6& addedMass, std::span<const double> weights,
               std::span<const double> arms);

  std::size_t strips() const noexcept { return weights_.size(); }
  /// s̄ = min(1, Σ g_i s_i / 0.8 Σ g_i): a bow that comes out now and then leaves it at 1, so that
  /// in ordinary waves it does not change, and no force times it has a mean.  @param shares  s_i.
  double mean(std::span<const double> shares) const noexcept;
  Mat6 at(std::span<const double> shares) const noexcept;  ///< A(s)

  /// From one tick to the next.
  struct Change {
    Mat6 now = Mat6::Zero();   ///< A(s)
    Mat6 left = Mat6::Zero();  ///< of what came out meanwhile: its water goes its own way
    Mat6 gone = Mat6::Zero();  ///< of that what belongs to strips: heave, pitch, what follows them
    /// Momentum that the water had which came in, of the waves [kg·m/s, kg·m²/s].
    Vec6 met = Vec6::Zero();
  };
  /// @param rise  upward velocity of the water at each strip [m/s].
  Change change(std::span<const double> before, std::span<const double> now,
                std::span<const double> rise) const noexcept;

 private:
  std::vector<double> weights_;
  std::vector<Vec6> strips_;  // F_i; none: all goes with the mean
  Mat6 rest_;
};

}  // namespace cutwater
