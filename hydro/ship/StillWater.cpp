#include "hydro/ship/StillWater.h"

#include <algorithm>

#include "hydro/base/FindRoot.h"
#include "hydro/geometry/wetted/SymmetricTriangles.h"

namespace cutwater {

Mat3 Attitude::rotation() const {
  return (Eigen::AngleAxisd(pitch, Vec3::UnitY()) * Eigen::AngleAxisd(roll, Vec3::UnitX()))
      .toRotationMatrix();
}

StillWater::StillWater(const ShipParticulars& ship)
    : hull_(symmetricTriangles(ship.hull), ship.cog),
      state_(hull_),
      weightOfWater_(ship.density * ship.gravity) {}

void StillWater::setDepths(const Attitude& pose, const Vec3& up) {
  const WettedTriangles::Points& p = hull_.points();
  for (std::size_t i = 0; i < p.size(); ++i)
    state_.depth[i] = -(pose.height + up.x() * p.x[i] + up.y() * p.y[i] + up.z() * p.z[i]);
}

Immersed StillWater::at(const Attitude& pose) {
  const Mat3 R = pose.rotation();
  const Vec3 up = R.row(2);
  setDepths(pose, up);
  for (std::size_t i = 0; i < state_.depth.size(); ++i)
    state_.pressure[i] = weightOfWater_ * state_.depth[i];
  std::fill(state_.surfacePressure.begin(), state_.surfacePressure.end(), 0.0);
  hull_.cut(up, state_);
  return {state_.volume, R * state_.centre, R * state_.load.head<3>(), R * state_.load.tail<3>()};
}

// By the divergence theorem, the waterplane closing the wet surface, e the vertical:
//   a pressure of 1:  F = A e
//   a pressure of x:  F = −V e_x + ∫x dA e,   M_y = −V z_B − ∫x² dA
ImmersedSlopes StillWater::slopes(const Attitude& pose) {
  const Mat3 R = pose.rotation();
  const Vec3 up = R.row(2), forward = R.row(0);
  const WettedTriangles::Points& p = hull_.points();
  setDepths(pose, up);
  ImmersedSlopes slopes;
  std::fill(state_.pressure.begin(), state_.pressure.end(), 1.0);
  state_.surfacePressure = state_.pressure;
  hull_.cut(up, state_);
  slopes.area = up.dot(state_.load.head<3>());
  for (std::size_t i = 0; i < p.size(); ++i)
    state_.pressure[i] = forward.x() * p.x[i] + forward.y() * p.y[i] + forward.z() * p.z[i];
  state_.surfacePressure = state_.pressure;
  hull_.cut(up, state_);
  slopes.areaMoment = up.dot(state_.load.head<3>());
  slopes.momentSlope = -R.row(1).dot(state_.load.tail<3>());
  return slopes;
}

Attitude StillWater::afloat(double volume, const Attitude& guess) {
  const Vec3 up = guess.rotation().row(2);
  const WettedTriangles::Points& p = hull_.points();
  double low = 0.0, high = 0.0;  // of the hull above G: it holds G in no attitude beyond these
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double z = up.x() * p.x[i] + up.y() * p.y[i] + up.z() * p.z[i];
    low = i == 0 ? z : std::min(low, z);
    high = i == 0 ? z : std::max(high, z);
  }
  Attitude pose = guess;
  const auto excess = [&](double height) {
    pose.height = height;
    return at(pose).volume - volume;
  };
  // Under water at −high, out of it at −low; outwards from the guess in growing steps.
  const double first = std::clamp(guess.height, -high, -low);
  const Sample middle{first, excess(first)};
  const double side = middle.y > 0.0 ? 1.0 : -1.0;  // too deep: upwards
  Sample near = middle, far = middle;
  for (double step = 1e-3 * (high - low); far.y * side > 0.0; step *= 8.0) {
    near = far;
    far.x = std::clamp(first + side * step, -high, -low);
    far.y = excess(far.x);
    if (far.x == near.x) break;  // round-off at the last height
  }
  pose.height = findRoot(excess, near, far, 1e-15 * (high - low));
  return pose;
}

Vec6 buoyancyLoad(StillWater& water, const Attitude& pose) {
  const Immersed wet = water.at(pose);
  const Vec3 ownX = pose.rotation().col(0);
  Vec6 load;
  load << wet.force, ownX.dot(wet.moment), wet.moment.y(), wet.moment.z();
  return load;
}

Vec6 linearBuoyancyLoad(const ShipParticulars& ship, const Attitude& shift) {
  const Vec3 force(0.0, 0.0, ship.density * ship.gravity * ship.volume);
  Vec6 atRest, eta = Vec6::Zero();
  atRest << force, (ship.centreOfBuoyancy - ship.cog).cross(force);
  eta[Heave] = shift.height;
  eta[Roll] = shift.roll;
  eta[Pitch] = shift.pitch;
  return atRest - ship.restoring * eta;
}

}  // namespace cutwater
