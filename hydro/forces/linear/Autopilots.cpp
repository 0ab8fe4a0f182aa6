#include "hydro/forces/linear/Autopilots.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "hydro/Errors.h"
#include "hydro/database/Coefficients.h"

namespace cutwater {

namespace {

constexpr double kThrustOfWeight = 0.03, kMomentOfWeight = 0.02;
constexpr double kAgainstMunk = 1.5;

void check(bool good, const char* what, double value) {
  if (good && std::isfinite(value)) return;
  throw HydroError(Fault::ValueOutOfRange,
                   std::string("autopilot: ") + what + " = " + std::to_string(value));
}

}  // namespace

Autopilots::Autopilots(const ShipParticulars& ship, const Mat6& addedMassInf, double length,
                       bool free)
    : massSurge_(ship.mass + addedMassInf(Surge, Surge)),
      inertia_(ship.massMatrix()(Yaw, Yaw) + addedMassInf(Yaw, Yaw)),
      weight_(ship.mass * ship.gravity),
      length_(length),
      munk_(addedMassInf(Sway, Sway)),
      free_(free) {
  check(length > 0.0, "length", length);
}

Autopilots::Autopilots(const Coefficients& c, double length)
    : Autopilots(c.ship, c.addedMass.atInfinity, length, true) {
  const Mat6& atRest = c.addedMass.atZero;
  munk_ = kAgainstMunk * std::max(0.0, atRest(Sway, Sway) - atRest(Surge, Surge));
}

void Autopilots::hold(const SpeedKeeper& speed, double drag) {
  check(true, "speed", speed.speed);
  check(true, "drag", drag);
  check(speed.maxThrust >= 0.0, "max thrust", speed.maxThrust);
  check(speed.rate > 0.0, "rate", speed.rate);
  speed_ = speed;
  drag_ = drag;
  if (speed_.maxThrust == 0.0) speed_.maxThrust = kThrustOfWeight * weight_;
  if (!holdsSpeed_) integral_ = 0.0;
  holdsSpeed_ = true;
}

void Autopilots::hold(const CourseKeeper& course) {
  check(true, "heading", course.heading);
  check(course.maxMoment >= 0.0, "max moment", course.maxMoment);
  check(course.rate > 0.0, "rate", course.rate);
  course_ = course;
  if (course_.maxMoment == 0.0) course_.maxMoment = kMomentOfWeight * weight_ * length_;
  holdsCourse_ = true;
}

double Autopilots::thrust(double speedNow, double lastStep) noexcept {
  const double error = speed_.speed - speedNow;
  const double step = running_ ? lastStep : 0.0;
  const double next = integral_ + step * error;
  const double nu = speed_.rate;
  const double wanted = drag_ + massSurge_ * nu * (2.0 * error + nu * next);
  double ahead = speed_.maxThrust, astern = speed_.maxThrust;
  if (ordersEngine()) {
    ahead = std::min(ahead, helm_->fullThrust(false, speedNow));
    astern = std::min(astern, helm_->fullThrust(true, speedNow));
  }
  const double given = std::clamp(wanted, -astern, ahead);
  // At the limit the integral only moves back from it.
  if (given == wanted || std::abs(next) < std::abs(integral_)) integral_ = next;
  return given;
}

double Autopilots::moment(double error, double rate, double speed) const noexcept {
  const double stiffness = inertia_ * course_.rate * course_.rate + munk_ * speed * speed;
  return std::clamp(stiffness * error - 2.0 * std::sqrt(stiffness * inertia_) * rate,
                    -course_.maxMoment, course_.maxMoment);
}

void Autopilots::orderEngine(double thrust, double speed) noexcept {
  const double most = helm_->fullThrust(thrust < 0.0, speed);
  helm_->throttle = most > 0.0 ? thrust / most : 0.0;
}

// A rudder that the water hardly meets is not turned the more for it: a radian of helm for a radian
// of error at most. Astern it is turned the other way.
void Autopilots::orderRudder(double moment) noexcept {
  const double bite = helm_->momentPerAngle, least = inertia_ * course_.rate * course_.rate;
  const double square = std::max(bite * bite, least * least);
  helm_->angle = std::clamp(moment * bite / square, -helm_->rudderLimit, helm_->rudderLimit);
}

Wrench Autopilots::evaluate(const TickInput& now) noexcept {
  Vec6 force = Vec6::Zero();
  const double yaw = free_ ? 0.0 : now.eta[Yaw];  // from the heading that is kept
  if (holdsSpeed_) {
    const double pull = thrust(now.speed + (free_ ? 0.0 : now.etaDotNow[Surge]), now.lastStep);
    if (ordersEngine()) {
      orderEngine(pull, now.speed);
    } else {
      force[Surge] += pull * std::cos(yaw);
      force[Sway] += pull * std::sin(yaw);
    }
  }
  if (holdsCourse_) {
    const double error = std::remainder(course_.heading - now.meanHeading - yaw, 2.0 * kPi);
    const double rate = now.turnRate + (free_ ? 0.0 : now.etaDotNow[Yaw]);
    const double turning = moment(error, rate, now.speed);
    if (ordersRudder()) {
      orderRudder(turning);
    } else {
      force[Yaw] = turning;
    }
  }
  running_ = true;
  return {force};
}

void Autopilots::reset() noexcept {
  integral_ = 0.0;
  running_ = false;
}

void Autopilots::save(std::span<double> state) const noexcept {
  const std::array<double, kStateSize> numbers{speed_.speed,
                                               speed_.maxThrust,
                                               speed_.rate,
                                               course_.heading,
                                               course_.maxMoment,
                                               course_.rate,
                                               holdsSpeed_ ? 1.0 : 0.0,
                                               holdsCourse_ ? 1.0 : 0.0,
                                               integral_,
                                               running_ ? 1.0 : 0.0,
                                               drag_};
  std::copy(numbers.begin(), numbers.end(), state.begin());
}

void Autopilots::restore(std::span<const double> state) noexcept {
  speed_ = {state[0], state[1], state[2]};
  course_ = {state[3], state[4], state[5]};
  holdsSpeed_ = state[6] != 0.0;
  holdsCourse_ = state[7] != 0.0;
  integral_ = state[8];
  running_ = state[9] != 0.0;
  drag_ = state[10];
}

}  // namespace cutwater
