#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "hydro/waves/SeaState.h"

namespace cutwater {

/// Elevation and pressure of a sea at many points at once: what a wetted hull asks for in each
/// tick.
///     p = ρg (H − z), ζ = r Σ a cos θ, H as SeaState::profile() has it, times the ramp r
/// H is taken at z = ζ for points above the surface: no e^{kz} is taken higher than the water is.
/// Of a steep wave (SeaState::steep) H and ζ are those of its series, all in double precision.
///
/// Phases are in double precision, so that neither the time nor the place nor the length of a ship
/// costs digits; cosines, exponentials and sums of sixteen waves are in single precision. Errors
/// of ζ are below 2e-6 of r Σ a, those of H below 2e-6 of r Σ a max(1, (1 + kz) e^{kz}), and a
/// tenth of that as a rule; of one wave as of many. In calm water both are exactly 0.
/// A wave that is short beside the height of others, kζ > 3, say, is far outside linear theory;
/// with the extrapolated profile e^{kζ} shows it. Above 2⁶⁴ it is taken as 2⁶⁴, which is finite.
/// Costs in hydro/decisions/0102-water-at-many-points.md. One object for each thread, as it has
/// its own scratch.
/// THEORY.md, chapter 9.
class WaterPressure {
 public:
  /// Points are so many at a time: arrays of them are a multiple of this long. Who has fewer
  /// repeats one.
  static constexpr std::size_t kLanes = 16;

  /// Places [m] in E: x and y from an origin, z above calm water.
  struct Points {
    std::span<const double> x, y, z;
  };
  /// What there is at each: ζ [m]; H [m]; and H at the surface above or below the point [m].
  struct Water {
    std::span<double> elevation, head, surfaceHead;
    /// Sums like H, but each wave times its factors of weigh(). Empty: not made.
    std::span<double> first = {}, second = {};
    /// −Σ f r a sin θ with the third factor, where surfaceHead is made: the rate of ζ, of an
    /// observer who meets each wave at that frequency. With the other two.
    std::span<double> rate = {};
  };

  /// Allocates all that it needs.
  /// @param wide  false: does without the widest registers that a machine may have, for tests.
  explicit WaterPressure(const SeaState& sea, bool wide = true);

  /// Factors of each wave for Water::first, second and rate. 0 before the first call.
  /// @pre All have one number for each component of the sea.
  void weigh(std::span<const double> first, std::span<const double> second,
             std::span<const double> rate) noexcept;

  /// The water at time t [s], x and y from originX, originY [m].
  /// @param near  [m] surfaceHead is made for points whose z is above −near, so that a ship can
  ///        leave it out where no surface comes. At others it is finite and means nothing.
  /// @pre All arrays have one length, a multiple of kLanes.
  /// No allocation. O(points × components).
  void at(double time, double originX, double originY, const Points& points, double near,
          const Water& water) noexcept;

 private:
  /// A component as it is at the time and origin of one call.
  struct Wave {
    double turns = 0.0;                 ///< θ/2π at the origin, −½..½
    double turnsX = 0.0, turnsY = 0.0;  ///< k_x/2π, k_y/2π [1/m]
    float height = 0.0F;                ///< r a [m]
    float octaves = 0.0F;               ///< k/ln 2 [1/m]: e^{kz} = 2^{octaves z}
    float first = 0.0F, second = 0.0F, rate = 0.0F;
  };
  struct alignas(4 * kLanes) Lanes {
    float value[kLanes];
  };
  /// What the loops over points need; they see no more of this class.
  struct Sea {
    std::span<const Wave> waves;
    std::span<Lanes> heights;  ///< r a cos θ of each wave at the points that are worked on
    WaveProfile profile;
  };
  static void evaluate(const Sea& sea, const Points& points, double near,
                       const Water& water) noexcept;
  static void evaluateWide(const Sea& sea, const Points& points, double near,
                           const Water& water) noexcept;

  void pressSteep(double time, const Points& points, const Water& water) noexcept;

  SeaState sea_;
  bool wide_;
  std::vector<Wave> waves_;
  std::vector<Lanes> heights_;
};

}  // namespace cutwater
