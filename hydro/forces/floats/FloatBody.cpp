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

/// Weights at points: Σw, Σw r and Σw r rᵀ, and the 6×6 matrices Σ w J Jᵀ of them.
struct PointSums {
  double weight = 0.0;
  Vec3 first = Vec3::Zero();
  Mat3 second = Mat3::Zero();
  void add(double w, const Vec3& r) {
    weight += w;
    first += w * r;
    second.noalias() += (w * r) * r.transpose();
  }
  /// J of all three directions at r.
  Mat6 everyWay() const {
    Mat6 m;
    m.topLeftCorner<3, 3>() = weight * Mat3::Identity();
    m.bottomLeftCorner<3, 3>() = crossOf(first);
    m.topRightCorner<3, 3>() = -m.bottomLeftCorner<3, 3>();
    m.bottomRightCorner<3, 3>() = second.trace() * Mat3::Identity() - second;
    return m;
  }
  /// J = (e, r × e).
  Mat6 along(const Vec3& e) const {
    const Mat3 turn = crossOf(e);
    Mat6 m;
    m.topLeftCorner<3, 3>() = weight * e * e.transpose();
    m.bottomLeftCorner<3, 3>() = first.cross(e) * e.transpose();
    m.topRightCorner<3, 3>() = m.bottomLeftCorner<3, 3>().transpose();
    m.bottomRightCorner<3, 3>() = turn * second * turn.transpose();
    return m;
  }
};

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

// The ellipsoid's share at the middle of what is wet, and what of the undisturbed water's motion it
// has: A of its velocity and of Ω_w.
FloatBody::Moving FloatBody::moving(const FloatWater::Motion& water) const noexcept {
  const double wet = properties_.density * share_;
  const Mat3& R = pose_.attitude;
  Moving moving;
  moving.linear = wet * (R * hull_->linear() * R.transpose());
  moving.angular = wet * (R * hull_->angular() * R.transpose());
  moving.arm = R * state_.centre;
  moving.waterLinear = moving.linear * water.velocity;
  moving.waterAngular = wet * (R * hull_->strained(R.transpose() * water.gradient * R));
  moving.share = share_;
  return moving;
}

// −½ρ(C/2) S √(v_n² + v₀²) v_n n − ½ρ C_F S |v_t| v_t on each wet face, as −D v with D of the
// speeds at the start. Faces that look down carry the stiffness: ρg ∫q qᵀ dA of the waterplane,
// q = (e, r × e), as long as no wet face looks up, and more than it otherwise.
void FloatBody::addFaces(const Velocity& own, const FloatWater::Motion& water,
                         Forces& forces) const noexcept {
  const Vec3 up = pose_.attitude.row(2);
  const double normal = 0.25 * properties_.density * properties_.normalDrag;
  const double along = 0.5 * properties_.density * properties_.friction;
  const double lift = properties_.density * gravity_;
  const double slow = properties_.slowDrag * properties_.slowDrag * gravity_ * hull_->size();
  PointSums rubbed, carried;
  for (const auto& face : faces_) {
    const double size = face.area.norm();
    if (!(size > 0.0)) continue;
    const Vec3 n = face.area / size;
    const Vec3 through = own.linear + own.angular.cross(face.middle) - water.velocity -
                         water.gradient * (face.middle - state_.centre);
    const double out = through.dot(n);
    const Vec3 slides = through - out * n;
    const double c = normal * size * std::sqrt(out * out + slow), f = along * size * slides.norm();
    const Vec6 j = wrenchAt(n, face.middle);
    forces.damping.noalias() += ((c - f) * j) * j.transpose();
    rubbed.add(f, face.middle);
    forces.load -= wrenchAt(c * out * n + f * slides, face.middle);
    carried.add(lift * std::max(0.0, -face.area.dot(up)), face.middle);
  }
  forces.damping += rubbed.everyWay();
  forces.stiffness = carried.along(up);
}

// What a body that heaves by itself gives to the waves that it makes, by Haskind's relation with
// the force of long waves on it, X = (ρgA_w − ω²A33) e^{−kd} e^{−(kR)²/8} = ρgA_w m/(m + A33) …:
//   B = ½kω|X|²/(ρg²),   ω² = ρgA_w/(m + A33), k = ω²/g, d the depth of the wet middle, A_w = πR²
// The last factor is the mean of a wave over the waterplane, 2J₁(kR)/(kR), nearly.
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
  const double force = plane * mass / whole;  // over ρg
  const double b = 0.5 * rho * k * omega * force * force *
                   std::exp(-2.0 * k * depth - k * k * plane / (4.0 * kPi));
  const Vec6 q = wrenchAt(up, state_.centre);
  const double rise = up.dot(own.linear + own.angular.cross(state_.centre) - water.velocity);
  forces.damping.noalias() += b * q * q.transpose();
  forces.load -= b * rise * q;
}

// Momentum of the water that the body moves, less what that water has by itself, at b:
// p = A(v + Ω × b − u), L = A_r Ω − A_r Ω_w. What acts on the body is its loss. What has come in
// since had none, what has gone took its own along. The engine does −A(v⁺ − v⁻) of it, the rest
// is here. Where a tick turns far, p⁻ turns with the body more than it stands still, so that no
// tick is too long.
Vec6 FloatBody::lostMomentum(const Moving& now, const Velocity& velocity,
                             double standing) const noexcept {
  const double kept = past_.share > share_ ? share_ / past_.share : 1.0;  // of what was wet
  const double old = std::min(1.0, past_.share / share_);                 // of what is wet
  const Vec3 own = velocity.linear + velocity.angular.cross(now.arm);
  const Vec3 before = velocity.linear + velocity.angular.cross(past_.arm);
  const auto mixed = [&](const Vec3& stands, const Vec3& turns) {
    return Vec3(standing * kept * stands + (1.0 - standing) * old * turns);
  };
  const Vec3 p = mixed(past_.linear * before, now.linear * own) - kept * past_.waterLinear;
  const Vec3 L = mixed(past_.angular * velocity.angular, now.angular * velocity.angular) -
                 kept * past_.waterAngular;
  const Vec3 force = p - (now.linear * own - now.waterLinear);
  Vec6 impulse = wrenchAt(force, now.arm);
  impulse.tail<3>() += L - (now.angular * velocity.angular - now.waterAngular);
  return impulse;
}

FloatBody::Tick FloatBody::tick(const Velocity& velocity, double mass,
                                const FloatWater::Motion& water, double h) noexcept {
  Tick tick;
  const Moving now = moving(water);
  if (!begun_) past_ = now;
  if (!(share_ > 0.0)) {
    past_ = now;
    begun_ = true;
    return tick;
  }
  const Mat3& R = pose_.attitude;
  const Mat3 toBody = R.transpose();
  const Velocity own{toBody * velocity.linear, toBody * velocity.angular};
  const FloatWater::Motion flow{toBody * water.velocity, toBody * water.gradient * R};
  hull_->triangles().wetFaces(state_, faces_);
  Forces forces;
  forces.load = state_.load;
  // ρV of the convective part of Du/Dt, which linear pressure does not have: without it a body as
  // heavy as water would sink in waves, by a²ω²k e^{2kz}.
  forces.load +=
      wrenchAt(properties_.density * state_.volume * (toBody * water.convective), state_.centre);
  addFaces(own, flow, forces);
  addRadiation(own, flow, mass, forces);

  const Vec3 slip = velocity.linear + velocity.angular.cross(now.arm) - water.velocity;
  const double rate = velocity.angular.norm() + slip.norm() / hull_->size();
  const double standing = 1.0 / (1.0 + std::pow(kTurnLimit * h * rate, 2));
  tick.impulse = lostMomentum(now, velocity, standing);
  // Munk's moment, −v × p: what keeps a long body from going on end first.
  const Vec3 p = now.linear * slip;
  tick.impulse.tail<3>() -= h * standing * slip.cross(p);
  past_ = now;
  begun_ = true;

  // Stiffness, by Newmark's rule; of a body too light for its tick more and more implicitly.
  const Vec3 up = R.row(2);
  const Mat6 added = addedMass();
  Vec6 upwards = Vec6::Zero();
  upwards.head<3>() = up;
  const double heave = mass + up.dot(added.topLeftCorner<3, 3>() * up);
  const double stiff = 0.25 * h * h * upwards.dot(forces.stiffness * upwards) / heave;
  const double implicit = stiff * stiff / (1.0 + stiff * stiff);
  Vec6 through;
  through << own.linear - flow.velocity, own.angular;
  forces.load -= implicit * h * (forces.stiffness * through);
  tick.inertia =
      added + h * forces.damping + (kImplicitStiffness + 0.5 * implicit) * h * h * forces.stiffness;
  const double munk = standing * properties_.density * share_ * hull_->linearSpread();
  const Vec3 slipInBody = toBody * slip;
  tick.inertia.bottomRightCorner<3, 3>() +=
      kImplicitStiffness * h * h * munk *
      (slip.squaredNorm() * Mat3::Identity() - slipInBody * slipInBody.transpose());
  const Vec6 load = h * forces.load;
  tick.impulse.head<3>() += R * load.head<3>();
  tick.impulse.tail<3>() += R * load.tail<3>();
  return tick;
}

Mat6 FloatBody::addedMass() const noexcept {
  const double wet = properties_.density * share_;
  Mat6 mass = actingAt(wet * hull_->linear(), state_.centre);
  mass.bottomRightCorner<3, 3>() += wet * hull_->angular();
  return mass;
}

}  // namespace cutwater
