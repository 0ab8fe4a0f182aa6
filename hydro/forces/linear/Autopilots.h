#pragma once
#include <memory>

#include "hydro/forces/ForceGenerator.h"
#include "hydro/forces/Helm.h"
#include "hydro/forces/ShipSettings.h"

namespace cutwater {

struct Coefficients;
struct ShipParticulars;

/// Two simple autopilots: one holds a speed (SpeedKeeper), one a heading (CourseKeeper).
/// Proportional-integral and proportional-differential rules, with the limits that a ship has. They
/// order the engine and the rudder of a ship that has them (Helm.h); others they push themselves. A
/// simulator with models of its own leaves both off.
class Autopilots final : public ForceGenerator {
 public:
  /// @param addedMassInf A(∞) [kg, kg·m, kg·m²].  @param length of the ship [m] > 0.
  /// @param free  Mean::Free: they see the slow motion.
  Autopilots(const ShipParticulars& ship, const Mat6& addedMassInf, double length,
             bool free = false);
  /// Of a free ship.
  Autopilots(const Coefficients& coefficients, double length);

  /// @param drag  that the ship is expected to have at that speed [N], negative astern: thrust to
  ///   begin with.
  /// @throws HydroError ValueOutOfRange: a value that is not finite, a negative limit or rate.
  void hold(const SpeedKeeper& speed, double drag = 0.0);
  void hold(const CourseKeeper& course);
  /// From now on they order the ship's engine and rudder, where it has them, and push it no more.
  void steerBy(std::shared_ptr<Helm> helm) noexcept { helm_ = std::move(helm); }
  void releaseSpeed() noexcept { holdsSpeed_ = false; }
  void releaseCourse() noexcept { holdsCourse_ = false; }
  bool holdsSpeed() const noexcept { return holdsSpeed_; }
  bool holdsCourse() const noexcept { return holdsCourse_; }
  const SpeedKeeper& speed() const noexcept { return speed_; }
  const CourseKeeper& course() const noexcept { return course_; }
  /// ∫e dt [m] of the speed's error, held while the thrust is at its limit.
  double integral() const noexcept { return integral_; }

  std::string_view name() const noexcept override { return "autopilots"; }
  /// Takes velocities at t_n; the integral of the speed's error grows from tick to tick.
  Wrench evaluate(const TickInput& now) noexcept override;
  /// Forgets the integral; the orders stay.
  void reset() noexcept override;
  std::size_t stateSize() const noexcept override { return kStateSize; }
  void save(std::span<double> state) const noexcept override;
  void restore(std::span<const double> state) noexcept override;

 private:
  static constexpr std::size_t kStateSize = 11;
  double thrust(double speedNow, double lastStep) noexcept;
  double moment(double error, double rate, double speed) const noexcept;
  bool ordersEngine() const noexcept { return helm_ && helm_->engine; }
  bool ordersRudder() const noexcept { return helm_ && helm_->rudder; }
  void orderEngine(double thrust, double speed) noexcept;
  void orderRudder(double moment) noexcept;

  double massSurge_, inertia_, weight_, length_;
  double munk_;  // moment per U² and radian of leeway against which a course is held [kg]
  bool free_;
  std::shared_ptr<Helm> helm_;
  SpeedKeeper speed_;
  CourseKeeper course_;
  bool holdsSpeed_ = false, holdsCourse_ = false;
  double integral_ = 0.0, drag_ = 0.0;
  bool running_ = false;
};

}  // namespace cutwater
