#pragma once
#include "hydro/forces/ForceGenerator.h"

namespace cutwater {

struct ShipParticulars;

/// Two helpers so that a ship can be driven at once. They stand for propeller and rudder, which potential
/// flow lacks; a simulator with models of its own leaves them off.
/// Both are proportional-integral or proportional-differential rules with the limits that a ship has.

/// Holds a speed by a thrust in G along the bow:
///   T = m'(2ν e + ν² ∫e dt),  e = speed wanted − speed now,  m' = m + A_11(∞),  |T| ≤ limit
/// Surge at wave frequency ω ≫ ν is hardly felt: it is damped by 2ν/ω of her inertia.
struct SpeedKeeper {
  double speed = 0.0;      ///< wanted [m/s]
  double maxThrust = 0.0;  ///< [N], ahead and astern; 0: 3 % of her weight
  double rate = 0.02;      ///< ν [1/s]
};

/// Holds a heading by a moment about G:
///   N = k e − 2√(k I') r,  e = heading wanted − heading now,  I' = I_66 + A_66(∞),
///   k = I'ν² + U² A_22(∞), the last term against the Munk moment that turns a hull without rudder
///   broadside on;  |N| ≤ limit
struct CourseKeeper {
  double heading = 0.0;    ///< wanted [rad], angle of the bow from E's x axis, about +z
  double maxMoment = 0.0;  ///< [N·m]; 0: 2 % of weight times length
  double rate = 0.1;       ///< ν [1/s]
};

/// The forces of both, in H (moment in upright axes).
class Keepers final : public ForceGenerator {
 public:
  /// @param addedMassInf A(∞) [kg, kg·m, kg·m²].  @param length of the ship [m] > 0.
  Keepers(const ShipParticulars& ship, const Mat6& addedMassInf, double length);

  /// @throws HydroError ValueOutOfRange: a value that is not finite, a negative limit or rate.
  void hold(const SpeedKeeper& speed);
  void hold(const CourseKeeper& course);
  void releaseSpeed() noexcept { holdsSpeed_ = false; }
  void releaseCourse() noexcept { holdsCourse_ = false; }
  bool holdsSpeed() const noexcept { return holdsSpeed_; }
  bool holdsCourse() const noexcept { return holdsCourse_; }
  const SpeedKeeper& speed() const noexcept { return speed_; }
  const CourseKeeper& course() const noexcept { return course_; }

  /// Velocities at t_n are used; the integral of the speed's error grows from tick to tick.
  Vec6 at(const ShipMotion& motion) noexcept override;

  /// ∫e dt [m] of the speed keeper, held while its thrust is at the limit.
  double integral() const noexcept { return integral_; }

  /// Exact state, orders included.
  struct State {
    SpeedKeeper speed;
    CourseKeeper course;
    bool holdsSpeed = false, holdsCourse = false;
    double integral = 0.0, time = 0.0;
    bool running = false;
  };
  State save() const noexcept;
  void restore(const State& state) noexcept;

 private:
  double thrust(double speedNow, double time) noexcept;

  double massSurge_, inertia_, addedSway_, weight_, length_;
  SpeedKeeper speed_;
  CourseKeeper course_;
  bool holdsSpeed_ = false, holdsCourse_ = false;
  double integral_ = 0.0;
  double time_ = 0.0;  // of the last tick
  bool running_ = false;
};

}  // namespace cutwater
