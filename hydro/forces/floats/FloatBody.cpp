#include "hydro/forces/floats/FloatBody.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace cutwater {

namespace {

// Share of h²C that the tick takes implicitly: from ¼ on no tick is too long for any stiffness, ½
// keeps a body that is much too light for its tick from hopping.
constexpr double kImplicitStiffness = 0.5;
constexpr double kTurnLimit = 4.0;  // 1/rad of turning in a tick

Mat3 crossOf(const Vec3& v) {
  Mat3 m;
  m << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
  return m;
}

Vec6 wrenchAt(const Vec3& force, const Vec3& at) {
  Vec6 wrench;
  wrench << force, at.cross(force);
  return wrench;
}

/// A 3×3 matrix that acts at a point, about the origin.
Mat6 actingAt(const Mat3& matrix, const Vec3& at) {
  const Mat3 arm = crossOf(at);
  Mat6 m;
  m.topLeftCorner<3, 3>() = matrix;
  m.bottomLeftCorner<3, 3>() = arm * matrix;
  m.topRightCorner<3, 3>() = m.bottomLeftCorner<3, 3>().transpose();
  m.bottomRightCorner<3, 3>() = -(m.bottomLeftCorner<3, 3>() * arm);
  return m;
}

}  // namespace

struct FloatBody::Forces {
  Vec6 load = Vec6::Zero();       // explicit, body axes [N, N·m]
  Mat6 damping = Mat6::Zero();    // of the velocity through the water
  Mat6 stiffness = Mat6::Zero();  // C
};

FloatBody::FloatBody(std::shared_ptr<const FloatHull> hull, const FloatProperties& properties)
    : hull_(std::move(hull)), properties_(properties), state_(hull_->triangles()) {
  faces_.reserve(2 * hull_->triangles().triangles());
}

void FloatBody::place(const Pose& pose, const Columns& columns) noexcept {
  pose_ = pose;
  const auto& points = hull_->triangles().points();
  const Mat3& R = pose.attitude;
  const Vec3& at = pose.position;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double x = points.x[i], y = points.y[i], z = points.z[i];
    columns.x[i] = at.x() + R(0, 0) * x + R(0, 1) * y + R(0, 2) * z;
    columns.y[i] = at.y() + R(1, 0) * x + R(1, 1) * y + R(1, 2) * z;
    columns.z[i] = at.z() + R(2, 0) * x + R(2, 1) * y + R(2, 2) * z;
  }
}

void FloatBody::press(double gravity, const Water& water) noexcept {
  gravity_ = gravity;
  const double gradient = properties_.density * gravity;
  double surface = 0.0;
  for (std::size_t i = 0; i < state_.depth.size(); ++i) {
    surface += water.elevation[i];
    state_.depth[i] = water.elevation[i] - water.z[i];
    state_.pressure[i] = gradient * (water.head[i] - water.z[i]);
    state_.surfacePressure[i] = gradient * (water.surfaceHead[i] - water.elevation[i]);
  }
  surface_ = surface / static_cast<double>(state_.depth.size());
  hull_->triangles().cut(pose_.attitude.row(2), state_);
  share_ = std::clamp(state_.volume / hull_->volume(), 0.0, 1.0);
}

Vec3 FloatBody::centre() const noexcept { return pose_.position + pose_.attitude * state_.centre; }

Vec6 FloatBody::pressure() const noexcept {
  Vec6 load;
  load << pose_.attitude * state_.load.head<3>(), pose_.attitude * state_.load.tail<3>();
  return load;
}

// The ellipsoid's share, about the middle of what is wet.
Mat6 FloatBody::addedMass() const noexcept {
  const double wet = properties_.density * share_;
  Mat6 mass = actingAt(wet * hull_->linear(), state_.centre);
  mass.bottomRightCorner<3, 3>() += wet * hull_->angular();
  return mass;
}

// What of the undisturbed water's motion that mass has: A of its velocity and of Ω_w.
Vec6 FloatBody::momentumOf(const FloatWater::Motion& water) const noexcept {
  const double wet = properties_.density * share_;
  const Mat3 toBody = pose_.attitude.transpose();
  Vec6 momentum = wrenchAt(wet * (hull_->linear() * (toBody * water.velocity)), state_.centre);
  momentum.tail<3>() += wet * hull_->strained(toBody * water.gradient * pose_.attitude);
  return momentum;
}

// −½ρ(C/2) S v_n|v_n| n − ½ρ C_F S |v_t| v_t on each wet face, as −D v with D of the speeds at the
// start. Faces that look down carry the stiffness: ρg ∫q qᵀ dA of the waterplane, q = (e, r × e),
// as long as no wet face looks up, and more than it otherwise.
void FloatBody::addFaces(const Velocity& own, const FloatWater::Motion& water,
                         Forces& forces) const noexcept {
  const Vec3 up = pose_.attitude.row(2);
  const double normal = 0.25 * properties_.density * properties_.normalDrag;
  const double along = 0.5 * properties_.density * properties_.friction;
  const double lift = properties_.density * gravity_;
  for (const auto& face : faces_) {
    const double size = face.area.norm();
    if (!(size > 0.0)) continue;
    const Vec3 n = face.area / size;
    const Vec3 through = own.linear + own.angular.cross(face.middle) - water.velocity -
                         water.gradient * (face.middle - state_.centre);
    const double out = through.dot(n);
    const Vec3 slides = through - out * n;
    const double c = normal * size * std::abs(out), f = along * size * slides.norm();
    Mat3 drag = (c - f) * n * n.transpose();
    drag.diagonal().array() += f;
    forces.damping += actingAt(drag, face.middle);
    forces.load -= wrenchAt(c * out * n + f * slides, face.middle);
    const double down = -face.area.dot(up);
    if (!(down > 0.0)) continue;
    const Vec6 q = wrenchAt(up, face.middle);
    forces.stiffness.noalias() += (lift * down) * q * q.transpose();
  }
}

// Of a body that heaves by itself, by Haskind's relation with the long waves' force ρgA_w e^{−kd}:
//   B = ½ρ ω³A_w²/g e^{−2kd},   ω² = ρgA_w/(m + A33), k = ω²/g, d the depth of the wet middle
void FloatBody::addRadiation(const Velocity& own, const FloatWater::Motion& water, double mass,
                             Forces& forces) const noexcept {
  const double plane =
      std::accumulate(state_.beamArea.begin(), state_.beamArea.end(), 0.0) - state_.deckArea;
  if (!(plane > 0.0) || !(gravity_ > 0.0)) return;
  const Vec3 up = pose_.attitude.row(2);
  const double rho = properties_.density;
  const double whole = mass + rho * share_ * up.dot(hull_->linear() * up);
  const double k = rho * plane / whole, omega = std::sqrt(k * gravity_);
  const double depth = std::max(0.0, surface_ - centre().z());
  const double b =
      0.5 * rho * omega * omega * omega * plane * plane / gravity_ * std::exp(-2.0 * k * depth);
  const Vec6 q = wrenchAt(up, state_.centre);
  const double rise = up.dot(own.linear + own.angular.cross(state_.centre) - water.velocity);
  forces.damping.noalias() += b * q * q.transpose();
  forces.load -= b * rise * q;
}

FloatBody::Tick FloatBody::tick(const Velocity& velocity, double mass,
                                const FloatWater::Motion& water, double h) noexcept {
  Tick tick;
  const double came = begun_ ? std::max(0.0, share_ - before_) : 0.0;
  const FloatWater::Motion past = begun_ ? water_ : water;
  begun_ = true;
  before_ = share_;
  water_ = water;
  if (!(share_ > 0.0)) return tick;
  const Mat3& R = pose_.attitude;
  const Mat3 toBody = R.transpose();
  const Velocity own{toBody * velocity.linear, toBody * velocity.angular};
  const FloatWater::Motion flow{toBody * water.velocity, toBody * water.gradient * R};
  hull_->triangles().wetFaces(state_, faces_);
  Forces forces;
  forces.load = state_.load;
  addFaces(own, flow, forces);
  addRadiation(own, flow, mass, forces);

  const Mat6 added = addedMass();
  const Vec6 momentum = momentumOf(water);
  Vec6 twist;
  twist << own.linear, own.angular;
  // The water's own acceleration; and what has come in is set going, or sets the body going.
  const double fresh = came / share_;
  Vec6 impulse = (1.0 - fresh) * (momentum - momentumOf(past)) - fresh * (added * twist - momentum);

  // Turning of the relative momentum: −Ω × P, −Ω × H − v × P. They do no work together, so they are
  // taken in one share, less where a tick turns far.
  const Vec6 relative = added * twist - momentum;
  const Vec3 p = relative.head<3>(), spin = own.angular;
  const Vec3 slip = own.linear - flow.velocity + spin.cross(state_.centre);
  const double rate = spin.norm() + slip.norm() / hull_->size();
  const double part = 1.0 / (1.0 + std::pow(kTurnLimit * h * rate, 2));
  Vec6 turning;
  turning << -spin.cross(p),
      -spin.cross(Vec3(relative.tail<3>())) - (slip - spin.cross(state_.centre)).cross(p);
  impulse += h * part * turning;

  tick.inertia = added + h * forces.damping + kImplicitStiffness * h * h * forces.stiffness;
  const double munk = part * properties_.density * share_ * hull_->linearSpread();
  tick.inertia.bottomRightCorner<3, 3>() +=
      kImplicitStiffness * h * h * munk *
      (slip.squaredNorm() * Mat3::Identity() - slip * slip.transpose());
  impulse += h * forces.load;
  tick.impulse << R * impulse.head<3>(), R * impulse.tail<3>();
  return tick;
}

void FloatBody::setPast(const Past& past) noexcept {
  before_ = past.share;
  water_ = {past.velocity, past.gradient};
  begun_ = past.begun;
}

}  // namespace cutwater
