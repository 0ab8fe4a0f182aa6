#include "hydro/forces/MeanCourse.h"

#include <cmath>

namespace cutwater {

MeanCourse::Place MeanCourse::ahead(double step) const noexcept {
  const double c = std::cos(heading()), s = std::sin(heading());
  return {x() + step * (speed() * c - leeway() * s), y() + step * (speed() * s + leeway() * c),
          heading() + step * turnRate()};
}

void MeanCourse::set(const Place& place, const Way& way) noexcept {
  const double all = place.x + place.y + place.heading + way.speed + way.leeway + way.turnRate;
  if (!std::isfinite(all)) return;
  place_ = place;
  way_ = way;
}

void MeanCourse::save(std::span<double, kStateSize> state) const noexcept {
  state[0] = place_.x;
  state[1] = place_.y;
  state[2] = place_.heading;
  state[3] = way_.speed;
  state[4] = way_.leeway;
  state[5] = way_.turnRate;
}

void MeanCourse::restore(std::span<const double, kStateSize> state) noexcept {
  place_ = {state[0], state[1], state[2]};
  way_ = {state[3], state[4], state[5]};
}

}  // namespace cutwater
