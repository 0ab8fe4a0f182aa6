#pragma once
#include "hydro/forces/ForceGenerator.h"
#include "hydro/forces/ShipSettings.h"

namespace cutwater {

struct ShipParticulars;

/// Two simple autopilots, so that a ship can be steered without a propulsion model: one holds a
/// speed (SpeedKeeper), one a heading (CourseKeeper). Proportional-integral and
/// proportional-differential rules, with the limits that a ship has. A simulator with models of its
/// own leaves both off.
class Autopilots final : public ForceGenerator {
 public:
  /// @param addedMassInf A(∞) [kg, kg·m, kg·m²].  @param length of the ship [m] > 0.
  /// @param free  Mean::Free: they see the slow motion.
  Autopilots(const ShipParticulars& ship, const Mat6& addedMassInf, double length,
             bool free = false);

  /// @throws HydroError ValueOutOfRange: a value that is not finite, a negative limit or rate.
  void hold(const SpeedKeeper& speed);
  void hold(const CourseKeeper& course);
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
  static constexpr std::size_t kStateSize = 10;
  double thrust(double speedNow, double lastStep) noexcept;

  double massSurge_, inertia_, addedSway_, weight_, length_;
  bool free_;
  SpeedKeeper speed_;
  CourseKeeper course_;
  bool holdsSpeed_ = false, holdsCourse_ = false;
  double integral_ = 0.0;
  bool running_ = false;
};

}  // namespace cutwater
