#include "hydro/forces/MeanCourse.h"

#include <cmath>
#include <string>

#include "hydro/Errors.h"

namespace cutwater {

MeanCourse::MeanCourse(double followTime) : rate_(followTime > 0.0 ? 1.0 / followTime : 0.0) {
  if (followTime >= 0.0 && std::isfinite(rate_)) return;
  throw HydroError(Fault::ValueOutOfRange,
                   "MeanCourse: follow time = " + std::to_string(followTime) + " s");
}

void MeanCourse::reset(double x, double y, double heading, double speed, double turnRate) noexcept {
  along_[0] = {x, speed * std::cos(heading), 0.0};
  along_[1] = {y, speed * std::sin(heading), 0.0};
  along_[2] = {heading, follows() ? turnRate : 0.0, 0.0};
  speed_ = speed;
}

void MeanCourse::Follower::follow(double rate, double step, double error,
                                  double velocitySeen) noexcept {
  const double pull = rate * rate * error + 3.0 * rate * (velocitySeen - velocity);
  acceleration = (acceleration + step * rate * pull) / (1.0 + 3.0 * step * rate);
  velocity += step * acceleration;
  place += step * velocity;
}

void MeanCourse::advance(double step, const Observed& ship) noexcept {
  const double seen[3] = {ship.x, ship.y, ship.heading};
  const double velocity[3] = {ship.velocityX, ship.velocityY, ship.turnRate};
  for (int i = 0; i < 3; ++i) {
    Follower& mean = along_[i];
    const double expected = mean.place + step * mean.velocity;
    double error = seen[i] - expected;
    if (i == 2) error = std::remainder(error, 2.0 * kPi);
    if (follows() && std::isfinite(error) && std::isfinite(velocity[i])) {
      mean.follow(rate_, step, error, velocity[i]);
    } else {
      mean.place = expected;
    }
  }
  if (follows()) setSpeed();
}

void MeanCourse::setSpeed() noexcept {
  speed_ = along_[0].velocity * std::cos(heading()) + along_[1].velocity * std::sin(heading());
}

void MeanCourse::save(std::span<double, kStateSize> state) const noexcept {
  for (std::size_t i = 0; i < 3; ++i) {
    state[3 * i] = along_[i].place;
    state[3 * i + 1] = along_[i].velocity;
    state[3 * i + 2] = along_[i].acceleration;
  }
  state[9] = speed_;
}

void MeanCourse::restore(std::span<const double, kStateSize> state) noexcept {
  for (std::size_t i = 0; i < 3; ++i) {
    along_[i] = {state[3 * i], state[3 * i + 1], state[3 * i + 2]};
  }
  speed_ = state[9];
}

}  // namespace cutwater
