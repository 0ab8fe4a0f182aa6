#include "hydro/forces/appendages/Engine.h"

#include <algorithm>
#include <cmath>

namespace cutwater {

namespace {

constexpr double kHullSpeedFroude = 0.4, kDiameterOfDraught = 0.7;

}  // namespace

double Engine::hullSpeed(const ShipParticulars& ship) {
  return kHullSpeedFroude * std::sqrt(ship.gravity * ship.length());
}

Engine::Engine(const ShipParticulars& ship, const EngineParticulars& engine, double resistance,
               std::shared_ptr<Helm> helm)
    : helm_(std::move(helm)),
      timeConstant_(engine.timeConstant.value_or(2.0 * std::sqrt(ship.length() / ship.gravity))),
      arm_(engine.place.value_or(Vec3(ship.sternX(), 0.0, ship.cog.z())) - ship.cog) {
  requireUsable(engine, "Engine");
  const double diameter = engine.diameter.value_or(kDiameterOfDraught * ship.draught());
  jetOfThrust_ = 2.0 / (ship.density * 0.25 * kPi * diameter * diameter);
  helm_->engine = true;
  helm_->noThrustSpeed = engine.noThrustSpeed.value_or(2.0 * hullSpeed(ship));
  helm_->thrustAhead = engine.maxThrust.value_or(2.0 * resistance);
  helm_->thrustAstern = engine.astern * helm_->thrustAhead;
}

double Engine::thrust(double share, double speed) const noexcept {
  return share * helm_->fullThrust(share < 0.0, speed);
}

// The lag is that of its equation, whatever the length of the tick.
Wrench Engine::evaluate(const TickInput& now) noexcept {
  const double order = std::clamp(helm_->throttle, -1.0, 1.0);
  if (running_) {
    const double left = timeConstant_ > 0.0 ? std::exp(-now.lastStep / timeConstant_) : 0.0;
    share_ = order + left * (share_ - order);
  }
  running_ = true;
  const double push = now.immersion * thrust(share_, now.speed);
  helm_->jet = std::max(0.0, push) * jetOfThrust_;
  Vec6 force = Vec6::Zero();
  force[Surge] = push;
  force[Pitch] = arm_.z() * push;
  force[Yaw] = -arm_.y() * push;
  return {force};
}

void Engine::reset() noexcept {
  share_ = 0.0;
  running_ = false;
}

void Engine::save(std::span<double> state) const noexcept {
  state[0] = helm_->throttle;
  state[1] = share_;
  state[2] = running_ ? 1.0 : 0.0;
}

void Engine::restore(std::span<const double> state) noexcept {
  helm_->throttle = state[0];
  share_ = state[1];
  running_ = state[2] != 0.0;
}

}  // namespace cutwater
