#pragma once
#include <span>

#include "hydro/Conventions.h"

namespace cutwater {

/// Where and how frame H moves in E, about which linear theory is: place x̄, ȳ, heading ψ̄, speed U
/// along it, leeway V across it.
///     const MeanCourse& course = ship.course();  // plugin/Ship.h
///     const double ahead = course.speed(), turning = course.turnRate();
///     const MeanCourse::Place soon = course.ahead(10.0);
///
/// Of a ship on a fixed course a straight line at constant speed. Of a free ship its slow motion:
/// the actual one less the motion with which linear theory has it answer the waves. In calm water
/// that is the ship's own place and velocity.
class MeanCourse {
 public:
  struct Place {
    double x = 0.0, y = 0.0, heading = 0.0;  ///< [m] in E, [rad]
  };
  /// In axes of the heading.
  struct Way {
    double speed = 0.0, leeway = 0.0, turnRate = 0.0;  ///< [m/s], [m/s], [rad/s]
  };

  double x() const noexcept { return place_.x; }              ///< x̄ [m] in E
  double y() const noexcept { return place_.y; }              ///< ȳ [m] in E
  double heading() const noexcept { return place_.heading; }  ///< ψ̄ [rad], not wrapped
  double speed() const noexcept { return way_.speed; }        ///< U [m/s]
  double leeway() const noexcept { return way_.leeway; }      ///< V [m/s], to port
  double turnRate() const noexcept { return way_.turnRate; }  ///< dψ̄/dt [rad/s]

  /// Where it will be in `step` [s] if it goes on along this heading.
  Place ahead(double step) const noexcept;

  /// Is here now, and moves like this; what is not finite is ignored.
  void set(const Place& place, const Way& way) noexcept;
  /// Goes on for `step` [s].
  void advance(double step) noexcept { place_ = ahead(step); }

  /// Exact state.
  static constexpr std::size_t kStateSize = 6;
  void save(std::span<double, kStateSize> state) const noexcept;
  void restore(std::span<const double, kStateSize> state) noexcept;

 private:
  Place place_;
  Way way_;
};

}  // namespace cutwater
