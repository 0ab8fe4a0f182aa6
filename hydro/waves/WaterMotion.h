#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "hydro/waves/SeaState.h"

namespace cutwater {

/// A sea at many points in one call: its surface, and the water's velocity and pressure below it.
/// What a renderer, a float or a probe asks for.
///     WaterMotion water(sea);
///     water.at(t, 0.0, 0.0, {x, y, z}, {.elevation = zeta, .slopeX = sx, .slopeY = sy});
///
/// Formulas are SeaState's, with its profile for what depends on z: with Wheeler's, e^{k(z − ζ)}.
/// A point above the surface has the water at the surface. Phases are in double precision, sums in
/// single: errors of ζ, head are below 2e-6 of r Σ a, of slopes below 2e-6 of r Σ ka, of velocities
/// below 2e-6 of r Σ aω, below calm water. About 1 ns a point and wave.
/// One object for each thread, as it has its own scratch; it may be kept for as long as the sea.
class WaterMotion {
 public:
  /// Places [m] in E: x and y from an origin, z above calm water. Any number, three alike; without
  /// z the points are on the surface.
  struct Points {
    std::span<const double> x, y, z = {};
  };
  /// What there is at each. What is left empty is not made.
  struct Water {
    std::span<double> elevation = {};            ///< ζ [m]
    std::span<double> slopeX = {}, slopeY = {};  ///< ∂ζ/∂x, ∂ζ/∂y: normal (−∂x, −∂y, 1)
    std::span<double> velocityX = {}, velocityY = {}, velocityZ = {};  ///< [m/s] in E
    /// p/ρg [m] above the air's, weight of the water included: 0 at and above the surface.
    std::span<double> pressureHead = {};
  };

  /// @param wide  false: does without the widest registers that a machine may have, for tests.
  explicit WaterMotion(const SeaState& sea, bool wide = true);

  const SeaState& sea() const noexcept { return sea_; }

  /// The water at time t [s], x and y from originX, originY [m]: take one near the points.
  /// @pre All arrays that are not empty have one length. No allocation.
  void at(double time, double originX, double originY, const Points& points,
          const Water& water) noexcept;

 private:
  static constexpr std::size_t kLanes = 16;
  /// A component as it is at the time and origin of one call (WaveSums.h), and what belongs to its
  /// slopes and velocities.
  struct Wave {
    double turns = 0.0, turnsX = 0.0, turnsY = 0.0;
    float height = 0.0F, octaves = 0.0F;
    float slopeX = 0.0F, slopeY = 0.0F;                 // k_x, k_y [1/m]
    float speedX = 0.0F, speedY = 0.0F, speedZ = 0.0F;  // ω k_x/k, ω k_y/k, ω [1/s]
  };
  struct alignas(4 * kLanes) Lanes {
    float value[kLanes];
  };
  /// Sixteen points and what there is at them.
  struct Batch {
    double x[kLanes], y[kLanes], z[kLanes];
    double elevation[kLanes], head[kLanes], slope[2][kLanes], velocity[3][kLanes];
  };
  /// What is asked for: sums are made for that only.
  struct Wanted {
    bool slopes, velocities, head, onSurface;
  };
  struct Sea {
    std::span<const Wave> waves;
    std::span<Lanes> heights, risings;
    WaveProfile profile;
  };
  static void evaluate(const Sea& sea, const Wanted& wanted, Batch& batch) noexcept;
  static void evaluateWide(const Sea& sea, const Wanted& wanted, Batch& batch) noexcept;
  void evaluateSteep(double time, const Wanted& wanted, Batch& batch) const noexcept;

  SeaState sea_;
  bool wide_;
  std::vector<Wave> waves_;
  std::vector<Lanes> heights_, risings_;
};

}  // namespace cutwater
