#include "hydro/forces/appendages/Rudder.h"

#include <algorithm>
#include <cmath>

#include "hydro/base/Radians.h"

namespace cutwater {

namespace {

constexpr double kAreaOfLateral = 0.025;
constexpr double kRate = 65.0 / 28.0 * kDegree, kRateLength = 100.0;
constexpr double kPlate = 1.17;       // C_N of a square plate across the flow [Hoerner65]
constexpr double kFriction = 0.0065;  // C_D0 [WhickerFehlner58]
constexpr double kSeparates = 10.0 * kDegree;

double usualArea(const ShipParticulars& ship) {
  return kAreaOfLateral * ship.length() * ship.draught();
}

double usualRate(const ShipParticulars& ship) {
  return kRate * std::sqrt(std::max(1.0, kRateLength / ship.length()));
}

}  // namespace

Rudder::Rudder(const ShipParticulars& ship, const RudderParticulars& rudder,
               std::shared_ptr<Helm> helm)
    : helm_(std::move(helm)),
      given_(rudder),
      area_(rudder.area.value_or(usualArea(ship))),
      rate_(rudder.rate.value_or(usualRate(ship))),
      slope_(6.13 * rudder.aspectRatio / (rudder.aspectRatio + 2.25)),
      pressure_(0.5 * ship.density * area_),
      arm_(rudder.place.value_or(Vec3(ship.sternX(), 0.0, ship.cog.z())) - ship.cog) {
  requireUsable(rudder, "Rudder");
  lightness_ = 1.0 / ship.mass + arm_.x() * arm_.x() / ship.massMatrix()(Yaw, Yaw);
  helm_->rudder = true;
  helm_->rudderLimit = rudder.limit;
}

// sin α cos α and sin² α have the period of a half turn: the blade works either way round.
Rudder::Lift Rudder::coefficients(double incidence) const noexcept {
  const double s = std::sin(incidence), both = s * std::cos(incidence);
  const double beyond = std::clamp((std::asin(std::abs(s)) - given_.stall) / kSeparates, 0.0, 1.0);
  const double separated = beyond * beyond * (3.0 - 2.0 * beyond), attached = 1.0 - separated;
  const double lift = slope_ * both;
  return {
      attached * lift + separated * kPlate * both,
      kFriction + attached * lift * lift / (kPi * given_.aspectRatio) + separated * kPlate * s * s};
}

void Rudder::turn(double seconds) noexcept {
  const double wanted = std::clamp(helm_->angle, -given_.limit, given_.limit);
  const double most = rate_ * seconds;
  angle_ += std::clamp(wanted - angle_, -most, most);
}

// At u_R = 0 the incidence is ±90° whatever γ, so it may change there. The force is held to what
// stops the blade in a tick.
Wrench Rudder::evaluate(const TickInput& now) noexcept {
  if (running_) turn(now.lastStep);
  running_ = true;
  const double along = now.speed - arm_.y() * now.turnRate;
  const double v = now.leeway + arm_.x() * now.turnRate;
  const double u =
      along + std::sqrt(along * along + given_.slipstream * helm_->jet) - std::abs(along);
  helm_->jet = 0.0;
  helm_->momentPerAngle = -arm_.x() * pressure_ * slope_ * u * std::abs(u);
  const double straightened = u > 0.0 ? given_.flowStraightening * v : v;
  const Lift c = coefficients(angle_ + std::atan2(straightened, u));
  const double speed = std::hypot(u, v);
  const double stops = now.step * lightness_ * pressure_ * speed * std::hypot(c.lift, c.drag);
  const double scale = now.immersion * pressure_ * speed / std::max(1.0, stops);
  const double ahead = scale * (c.lift * v - c.drag * u);
  const double side = -scale * (c.lift * u + c.drag * v);
  Vec6 force = Vec6::Zero();
  force[Surge] = ahead;
  force[Sway] = side;
  force[Roll] = -arm_.z() * side;
  force[Pitch] = arm_.z() * ahead;
  force[Yaw] = arm_.x() * side - arm_.y() * ahead;
  return {force};
}

void Rudder::reset() noexcept {
  angle_ = 0.0;
  helm_->jet = helm_->momentPerAngle = 0.0;
  running_ = false;
}

void Rudder::save(std::span<double> state) const noexcept {
  state[0] = helm_->angle;
  state[1] = angle_;
  state[2] = helm_->momentPerAngle;
  state[3] = running_ ? 1.0 : 0.0;
}

void Rudder::restore(std::span<const double> state) noexcept {
  helm_->angle = state[0];
  angle_ = state[1];
  helm_->momentPerAngle = state[2];
  running_ = state[3] != 0.0;
}

}  // namespace cutwater
