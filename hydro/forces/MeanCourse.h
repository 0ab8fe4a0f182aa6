#pragma once
#include <span>

#include "hydro/Conventions.h"

namespace cutwater {

/// The mean course that linear theory is about: place x̄, ȳ, heading ψ̄ and speed U of frame H in E.
///     const MeanCourse& course = ship.course();  // plugin/Ship.h
///     const double ahead = course.speed(), turning = course.turnRate();
///     const MeanCourse::Place soon = course.ahead(10.0);
///
/// Fixed: a straight line at constant speed, as in [M03]. Filtered: it follows the ship slowly,
/// each of x, y, ψ by a low-pass filter of third order with all poles at −ν,
///     x̄⃛ = ν³(x − x̄) + 3ν²(ẋ − x̄˙) − 3ν x̄¨,      x̄/x = (3ν²s + ν³)/(s + ν)³
/// It keeps up with steady motion without lag and moves with continuous acceleration. Of a motion
/// of frequency ω it lets 3(ν/ω)² through: at ν = 1/15 s and ω = 0.6 rad/s 4 %. A step of velocity
/// is followed in 1.6/ν, with 25 % of overshoot, which is the price of catching up in place.
/// U = x̄˙ cos ψ̄ + ȳ˙ sin ψ̄. Leeway, the part across, is left to the motion about the course.
class MeanCourse {
 public:
  /// @param followTime 1/ν [s]; 0: fixed.  @throws HydroError ValueOutOfRange: negative, not
  ///         finite.
  explicit MeanCourse(double followTime = 0.0);

  bool follows() const noexcept { return rate_ > 0.0; }
  double x() const noexcept { return along_[0].place; }        ///< x̄ [m] in E
  double y() const noexcept { return along_[1].place; }        ///< ȳ [m] in E
  double heading() const noexcept { return along_[2].place; }  ///< ψ̄ [rad], not wrapped
  double speed() const noexcept { return speed_; }             ///< U [m/s]
  /// dψ̄/dt [rad/s].
  double turnRate() const noexcept { return along_[2].velocity; }

  /// Where the mean will be in `step` [s] if it goes on as it does.
  struct Place {
    double x, y, heading;
  };
  Place ahead(double step) const noexcept {
    return {x() + step * along_[0].velocity, y() + step * along_[1].velocity,
            heading() + step * along_[2].velocity};
  }

  /// Begins anew at a place, on a heading, at a steady speed.
  void reset(double x, double y, double heading, double speed, double turnRate = 0.0) noexcept;

  /// Where the ship is at the end of a tick, and its mean velocity over it.
  struct Observed {
    double x, y, heading;                   ///< [m], [rad] modulo 2π
    double velocityX, velocityY, turnRate;  ///< [m/s] in E, [rad/s]
  };
  /// One tick of `step` [s]. Semi-implicit, stable for ν·step < 1; a ship in steady motion at the
  /// place of the mean is followed without error. Non-finite input is ignored.
  void advance(double step, const Observed& ship) noexcept;

  /// Exact state.
  static constexpr std::size_t kStateSize = 10;
  void save(std::span<double, kStateSize> state) const noexcept;
  void restore(std::span<const double, kStateSize> state) noexcept;

 private:
  struct Follower {
    double place = 0.0, velocity = 0.0, acceleration = 0.0;
    void follow(double rate, double step, double error, double velocitySeen) noexcept;
  };
  void setSpeed() noexcept;

  double rate_ = 0.0;   // ν
  Follower along_[3];   // x, y, ψ
  double speed_ = 0.0;  // U
};

}  // namespace cutwater
