#include "hydro/forces/linear/Autopilots.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "hydro/Errors.h"
#include "hydro/database/Coefficients.h"

namespace cutwater {

namespace {

constexpr double kThrustOfWeight = 0.03, kMomentOfWeight = 0.02;

void check(bool good, const char* what, double value) {
  if (good && std::isfinite(value)) return;
  throw HydroError(Fault::ValueOutOfRange,
                   std::string("Keepers: ") + what + " = " + std::to_string(value));
}

}  // namespace

Keepers::Keepers(const ShipParticulars& ship, const Mat6& addedMassInf, double length)
    : massSurge_(ship.mass + addedMassInf(Surge, Surge)),
      inertia_(ship.massMatrix()(Yaw, Yaw) + addedMassInf(Yaw, Yaw)),
      addedSway_(addedMassInf(Sway, Sway)),
      weight_(ship.mass * ship.gravity),
      length_(length) {
  check(length > 0.0, "length", length);
}

void Keepers::hold(const SpeedKeeper& speed) {
  check(true, "speed", speed.speed);
  check(speed.maxThrust >= 0.0, "max thrust", speed.maxThrust);
  check(speed.rate > 0.0, "rate", speed.rate);
  speed_ = speed;
  if (speed_.maxThrust == 0.0) speed_.maxThrust = kThrustOfWeight * weight_;
  if (!holdsSpeed_) integral_ = 0.0;
  holdsSpeed_ = true;
}

void Keepers::hold(const CourseKeeper& course) {
  check(true, "heading", course.heading);
  check(course.maxMoment >= 0.0, "max moment", course.maxMoment);
  check(course.rate > 0.0, "rate", course.rate);
  course_ = course;
  if (course_.maxMoment == 0.0) course_.maxMoment = kMomentOfWeight * weight_ * length_;
  holdsCourse_ = true;
}

double Keepers::thrust(double speedNow, double time) noexcept {
  const double error = speed_.speed - speedNow;
  const double step = running_ ? std::max(0.0, time - time_) : 0.0;
  const double next = integral_ + step * error;
  const double nu = speed_.rate;
  const double wanted = massSurge_ * nu * (2.0 * error + nu * next);
  const double given = std::clamp(wanted, -speed_.maxThrust, speed_.maxThrust);
  // At the limit the integral only moves back from it.
  if (given == wanted || std::abs(next) < std::abs(integral_)) integral_ = next;
  return given;
}

Vec6 Keepers::at(const ShipMotion& motion) noexcept {
  Vec6 force = Vec6::Zero();
  const double ahead = motion.speed + motion.etaDotNow[Surge];
  if (holdsSpeed_) {
    const double pull = thrust(ahead, motion.time);
    force[Surge] += pull * std::cos(motion.eta[Yaw]);
    force[Sway] += pull * std::sin(motion.eta[Yaw]);
  }
  if (holdsCourse_) {
    const double error =
        std::remainder(course_.heading - motion.meanHeading - motion.eta[Yaw], 2.0 * kPi);
    const double rate = motion.turnRate + motion.etaDotNow[Yaw];
    const double stiffness =
        inertia_ * course_.rate * course_.rate + addedSway_ * motion.speed * motion.speed;
    force[Yaw] = std::clamp(stiffness * error - 2.0 * std::sqrt(stiffness * inertia_) * rate,
                            -course_.maxMoment, course_.maxMoment);
  }
  time_ = motion.time;
  running_ = true;
  return force;
}

Keepers::State Keepers::save() const noexcept {
  return {speed_, course_, holdsSpeed_, holdsCourse_, integral_, time_, running_};
}

void Keepers::restore(const State& s) noexcept {
  speed_ = s.speed;
  course_ = s.course;
  holdsSpeed_ = s.holdsSpeed;
  holdsCourse_ = s.holdsCourse;
  integral_ = s.integral;
  time_ = s.time;
  running_ = s.running;
}

}  // namespace cutwater
