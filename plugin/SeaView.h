#pragma once
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "hydro/waves/WaterMotion.h"
#include "plugin/WorldFrame.h"

CUTWATER_PLUGIN_BEGIN

class SeaWatch;

/// The sea of a Seaway for another thread: a renderer's, an audio engine's. All in the world's own
/// axes and units, and the very sea that moves the ships.
///     SeaView view = seaway.view();          // on the world's thread; then pass it on
///     view.update();                         // on any thread: sea and time of the last tick
///     view.at(places, {.surface = surface, .normal = normals});
///     for (const SeaView::Wave& w : view.waves(camera)) ...   // for a shader
/// A view outlives its Seaway; the sea then stays as it was. One thread at a time for each view.
class SeaView {
 public:
  explicit SeaView(std::shared_ptr<const SeaWatch> watch);

  /// Takes sea and time as the last tick left them. Allocates if the sea is another one.
  void update();
  /// Takes another time [s]: half a tick back, for a frame that is drawn between two.
  void setTime(double time) noexcept { time_ = time; }
  double time() const noexcept { return time_; }
  const SeaState& sea() const noexcept { return *sea_; }

  /// What there is at each place. What is left empty is not made.
  struct Water {
    std::span<btVector3> surface = {};   ///< the point of the surface above or below the place
    std::span<btVector3> normal = {};    ///< of the surface there, upwards, of length 1
    std::span<btVector3> velocity = {};  ///< of the water at the place [units/s]; above the water,
                                         ///< that at the surface
    std::span<btScalar> pressure = {};   ///< at the place, above the air's [Pa]; 0 out of the water
  };
  /// @param density  of the water [kg/m³], for the pressure.
  /// @pre Arrays that are not empty are as long as `places`. No allocation.
  void at(std::span<const btVector3> places, const Water& water, double density = 1025.0) noexcept;

  /// One regular wave: height Σ amplitude cos(phase − kx dx − ky dy) above calm water, dx, dy from
  /// the place that waves() was asked for, along the world's two level axes: x and y, or x and z
  /// where y is up. Four floats for a shader.
  struct Wave {
    float kx, ky;     ///< [1/unit]
    float amplitude;  ///< [units], as it is now
    float phase;      ///< [rad], −π..π, reduced in double precision: good after days
  };
  /// All waves about a place, near which a float then has all its digits. Of a steep wave the
  /// harmonics of its surface. The reference lives until the next call.
  const std::vector<Wave>& waves(const btVector3& about);

 private:
  std::shared_ptr<const SeaWatch> watch_;
  std::shared_ptr<const SeaState> sea_;
  WorldFrame frame_;
  double time_ = 0.0;
  WaterMotion motion_;
  std::vector<Wave> waves_;
};

/// Internal: what a Seaway tells its views.
class SeaWatch {
 public:
  SeaWatch(std::shared_ptr<const SeaState> sea, const WorldFrame& frame)
      : sea_(std::move(sea)), frame_(frame) {}
  /// @param sea  null: it stays.
  void set(const std::shared_ptr<const SeaState>& sea, double time) noexcept;
  /// @param level  of calm water [units].
  void setLevel(double level) noexcept;
  struct Seen {
    std::shared_ptr<const SeaState> sea;
    double time = 0.0;
    WorldFrame frame;
  };
  Seen seen() const noexcept;

 private:
  mutable std::mutex mutex_;
  std::shared_ptr<const SeaState> sea_;  // guarded
  double time_ = 0.0;                    // guarded
  WorldFrame frame_;                     // guarded
};

CUTWATER_PLUGIN_END
