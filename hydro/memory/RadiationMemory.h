#pragma once
#include <span>

#include "hydro/Conventions.h"
#include "hydro/memory/SpeedParts.h"

namespace cutwater {

/// Force of the radiated waves' memory at ticks of h, the sum of [M03] (30), here of equal ones:
///   F(t_n) = −∫₀^∞ K(U, τ) η̇(t_n − τ) dτ = −Σ_i K̄_i η̇_{n−i},   K̄_i = ∫ K over [i h, (i+1) h]
/// η̇_n is the mean velocity over the tick that ends at t_n (in Bullet: the velocity after the
/// solve, which moved the body over that tick), so the sum is second order in h and sees ∫K dτ
/// exactly. K = K⁰ + U K^U + U² K^UU with the present speed for the whole past: as U changes only
/// the weights of the three parts change. Frame H; forces and moments about G. No allocation after
/// construction. One thread at a time.
/// THEORY.md, chapter 7.
class RadiationMemory {
 public:
  virtual ~RadiationMemory() = default;
  virtual double step() const noexcept = 0;  ///< h [s]
  /// The tick that advance() will enter is h long [s] > 0; the past stays as it is. The sum of
  /// exponentials can: each is known at every instant. The convolution, whose weights are those of
  /// equal ticks, cannot.  @return whether the memory has that step now.
  virtual bool setStep(double h) noexcept { return h == step(); }
  /// Enters the velocity of the tick just ended and returns F(t_n) [N, N·m]. A velocity that is not
  /// finite spoils the memory: reset() or restore() after it.   @param speed U [m/s].
  virtual Vec6 advance(const Vec6& etaDot, double speed) noexcept = 0;
  Vec6 advance(const Vec6& etaDot) noexcept { return advance(etaDot, 0.0); }
  /// The same with separate parts: F = atRest + U linear + U² squared.
  using Parts = SpeedParts<Vec6>;
  virtual Parts advanceParts(const Vec6& etaDot) noexcept = 0;

  /// The water's momentum beside A^∞ν of a ship of full velocities ν [kg·m/s, kg·m²/s]:
  ///   q(t_n + h/2) = ∫₀^∞ L⁰(τ) ν(t_n + h/2 − τ) dτ,   L⁰(τ) = ∫₀^τ K⁰
  /// Enters the velocity of the tick just ended; it is taken to last over the half tick that is
  /// looked ahead, of which L⁰, 0 at τ = 0, sees little.
  /// @param next  length h of the tick to come [s] > 0.
  virtual Vec6 momentum(const Vec6& velocity, double next) noexcept = 0;
  /// From now on as if the velocity had always been larger by this.
  virtual void addSteady(const Vec6& velocity) noexcept = 0;
  /// Forgets the past, as if the ship had always been at rest on the mean course.
  virtual void reset() noexcept = 0;

  /// Exact state as numbers: restore(save()) gives the same bits ever after.
  virtual std::size_t stateSize() const noexcept = 0;
  /// @pre state.size() == stateSize().
  virtual void save(std::span<double> state) const noexcept = 0;
  /// Whether these numbers are a state of this memory, at its length of tick.
  virtual bool fits(std::span<const double> state) const noexcept = 0;
  /// @throws HydroError BadArgument unless fits(state).
  virtual void restore(std::span<const double> state) = 0;
};

}  // namespace cutwater
