#include "plugin/AddedMassConstraint.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "hydro/Errors.h"
#include "hydro/base/SymmetricEigen.h"
#include "hydro/forces/OwnAxes.h"

CUTWATER_PLUGIN_BEGIN

namespace {

// Below this share of the body's own mass a direction has no added mass that matters; the split of
// its row (κ ~ 1/√(2l)) would also begin to lose digits in single precision.
constexpr double kSmallestRatio = 1e-6;

// M of each direction in body axes: Bullet's principal inertias are diagonal there.
Vec6 massOf(const btRigidBody& body) {
  if (!(body.getInvMass() > 0)) {
    throw HydroError(Fault::ValueOutOfRange, "AddedMassConstraint: body is static, 1/mass = 0");
  }
  const Vec3 inverseInertia = fromBullet(body.getInvInertiaDiagLocal());
  Vec6 mass;
  mass.head<3>().setConstant(1.0 / static_cast<double>(body.getInvMass()));
  for (int i = 0; i < 3; ++i) {
    if (!(inverseInertia[i] > 0.0)) {
      throw HydroError(Fault::ValueOutOfRange,
                       "AddedMassConstraint: body has no inertia about axis " + std::to_string(i));
    }
    mass[3 + i] = 1.0 / inverseInertia[i];
  }
  return mass;
}

void store(btScalar* axis, const btVector3& v, double factor) {
  for (int i = 0; i < 3; ++i) axis[i] = static_cast<btScalar>(factor) * v[i];
}

void clear(btJointFeedback& feedback) {
  feedback.m_appliedForceBodyA.setZero();
  feedback.m_appliedTorqueBodyA.setZero();
  feedback.m_appliedForceBodyB.setZero();
  feedback.m_appliedTorqueBodyB.setZero();
}

// J M⁻¹ Jᵀ of a row given in E.
double response(const btRigidBody& body, const btVector3& linear, const btVector3& angular) {
  return static_cast<double>(linear.length2() * body.getInvMass()) +
         static_cast<double>(angular.dot(body.getInvInertiaTensorWorld() * angular));
}

// Equal but for the rounding with which Bullet renews a body's attitude each tick.
bool same(const Mat3& a, const Mat3& b) {
  return (a - b).squaredNorm() <= 16.0 * static_cast<double>(SIMD_EPSILON * SIMD_EPSILON);
}

// Bullet's gyroscopic velocity change of this tick, which the solver adds on top of total torque.
btVector3 gyroscopicChange(const btRigidBody& body, btScalar step) {
  btVector3 change(0, 0, 0);
  const int flags = body.getFlags();
  if (flags & BT_ENABLE_GYROSCOPIC_FORCE_EXPLICIT) {
    change -=
        body.computeGyroscopicForceExplicit(SIMD_INFINITY) * body.getInvInertiaTensorWorld() * step;
  }
  if (flags & BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_WORLD) {
    change += body.computeGyroscopicImpulseImplicit_World(step);
  }
  if (flags & BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_BODY) {
    change += body.computeGyroscopicImpulseImplicit_Body(step);
  }
  return change;
}

}  // namespace

AddedMassConstraint::AddedMassConstraint(btRigidBody& body, const Mat6& addedMass)
    : AddedMassConstraint(body, addedMass, massOf(body)) {}

AddedMassConstraint::AddedMassConstraint(btRigidBody& body, const Mat6& addedMass, const Vec6& mass)
    : btTypedConstraint(MAX_CONSTRAINT_TYPE, body, body),
      addedMass_(0.5 * (addedMass + addedMass.transpose())),
      root_(mass.cwiseSqrt()) {
  if (!addedMass.allFinite()) {
    throw HydroError(Fault::ValueOutOfRange, "AddedMassConstraint: added mass is not finite");
  }
  findRows(addedMass_);
  largestRatio_ = count_ == 0 ? 0.0 : rows_[0].ratio;
  clear(feedback_);
  setJointFeedback(&feedback_);
  forgetPast();
}

// With y = √M x the generalised problem A∞ x = l M x is the symmetric one of √M⁻¹ A∞ √M⁻¹, whose
// unit eigenvectors y give xᵀMx = 1 and J = M x = √M y. Ratios fall from row to row.
void AddedMassConstraint::findRows(const Mat6& addedMass) noexcept {
  const Mat6 scaled =
      root_.cwiseInverse().asDiagonal() * addedMass * root_.cwiseInverse().asDiagonal();
  const SymmetricEigen eigen = symmetricEigen(scaled);
  count_ = 0;
  for (int r = 5; r >= 0; --r) {
    const double ratio = eigen.values[r];
    if (ratio < kSmallestRatio) continue;
    const Vec6 j = root_.cwiseProduct(eigen.vectors.col(r));
    const Vec6 x = j.cwiseQuotient(root_.cwiseAbs2());
    rows_[static_cast<std::size_t>(count_++)] = {j.head<3>(), j.tail<3>(), x.head<3>(), x.tail<3>(),
                                                 ratio};
  }
}

// A factor of 0 takes an axis of the world out of every impulse, and so out of what A∞ resists.
void AddedMassConstraint::heedFactors() noexcept {
  const Vec3 linear = fromBullet(m_rbA.getLinearFactor());
  const Vec3 angular = fromBullet(m_rbA.getAngularFactor());
  const bool held = (linear.array() == 0.0).any() || (angular.array() == 0.0).any();
  if (!held && !held_) return;
  held_ = held;
  if (!held) {
    findRows(total());
    return;
  }
  const TurningAxes toWorld = axes();
  const auto free = [](const Mat3& turn, const Vec3& factor) {
    const Vec3 kept = (factor.array() != 0.0).cast<double>();
    return Mat3(turn.transpose() * kept.asDiagonal() * turn);
  };
  Mat6 projection = Mat6::Zero();
  projection.topLeftCorner<3, 3>() = free(toWorld.linear, linear);
  projection.bottomRightCorner<3, 3>() = free(toWorld.angular, angular);
  projection_ = projection;
  findRows(projection * total() * projection);
}

Mat6 AddedMassConstraint::bodyMassIn(const Mat6& mass, const TurningAxes& axes,
                                     const Mat3& body) const noexcept {
  Mat6 turn = Mat6::Zero();
  turn.topLeftCorner<3, 3>() = axes.linear.transpose() * body;
  turn.bottomRightCorner<3, 3>() = axes.angular.transpose() * body;
  return turn * mass * turn.transpose();
}

// A∞ + L in the axes of A∞. L does not end where A∞ is switched off.
Mat6 AddedMassConstraint::total() const noexcept {
  if (!carries_) return addedMass_;
  Mat6 sum = bodyMassIn(carried_, axes(), body_);
  if (active_) sum += addedMass_;
  return 0.5 * (sum + sum.transpose());
}

void AddedMassConstraint::carry(const Mat6& mass, const Mat6& kept) noexcept {
  carries_ = carries_ || (mass.array() != 0.0).any();
  carried_ = mass;
  carriedKept_ = kept;
}

void AddedMassConstraint::setCarried(const Mat6& mass, const Mat3& pastBody,
                                     bool carries) noexcept {
  carries_ = carries;
  carried_ = carriedKept_ = mass;
  pastBody_ = pastBody;
  if (!carries_ && !held_) findRows(addedMass_);
}

void AddedMassConstraint::change(const Change& change) noexcept {
  kept_ = addedMass_ - change.left;
  met_ = change.met;
  changed_ = true;
  addedMass_ = change.now;
  if (!held_ && !carries_) findRows(addedMass_);
}

void AddedMassConstraint::setAddedMass(const Mat6& addedMass) noexcept {
  changed_ = false;
  addedMass_ = addedMass;
  if (!held_ && !carries_) findRows(addedMass_);
}

void AddedMassConstraint::setMass(const Vec6& mass) noexcept {
  root_ = mass.cwiseSqrt();
  if (!held_) findRows(addedMass_);
}

AddedMassConstraint::TurningAxes AddedMassConstraint::axes() const noexcept {
  if (follows_) return followed_;
  const Mat3 body = fromBullet(m_rbA.getWorldTransform().getBasis());
  return {body, body};
}

// integrateTransforms copies the solver's velocity into the interpolation velocity before any
// action runs; a vehicle's impulse in an action that ran before ours is thus still ahead of v⁻.
void AddedMassConstraint::endTick() noexcept {
  setPast(m_rbA.getInterpolationLinearVelocity(), m_rbA.getInterpolationAngularVelocity(), solved_);
  pastBody_ = body_;
  if (!carries_) return;
  carriedKept_ = carried_;
  carriedChange_ = momentumOfCarried() - carriedBefore_ + given_;
}

void AddedMassConstraint::forgetPast() noexcept {
  solved_ = axes();
  setPast(m_rbA.getLinearVelocity(), m_rbA.getAngularVelocity(), solved_);
  pastBody_ = fromBullet(m_rbA.getWorldTransform().getBasis());
}

void AddedMassConstraint::setPast(const btVector3& linear, const btVector3& angular,
                                  const TurningAxes& axes) noexcept {
  linear_ = linear;
  angular_ = angular;
  pastAxes_ = axes;
  changed_ = false;
}

Vec3 AddedMassConstraint::force() const noexcept {
  return fromBullet(feedback_.m_appliedForceBodyA) + fromBullet(feedback_.m_appliedForceBodyB);
}

Vec3 AddedMassConstraint::moment() const noexcept {
  return fromBullet(feedback_.m_appliedTorqueBodyA) + fromBullet(feedback_.m_appliedTorqueBodyB);
}

double AddedMassConstraint::largestRatio() const noexcept { return largestRatio_; }

int AddedMassConstraint::iterationsFor(double tolerance) const noexcept {
  const double l = largestRatio();
  if (l <= 0.0 || !(tolerance > 0.0) || tolerance >= 1.0) return 1;
  return std::max(1, static_cast<int>(std::ceil(std::log(tolerance) / std::log(l / (1.0 + l)))));
}

void AddedMassConstraint::setActive(bool on) noexcept {
  if (on && !active_ && !carries_) forgetPast();
  active_ = on;
  clear(feedback_);
}

void AddedMassConstraint::getInfo1(btConstraintInfo1* info) {
  heedFactors();
  info->m_numConstraintRows = active_ || carries_ ? count_ : 0;
  info->nub = 6 - info->m_numConstraintRows;
}

// What the tick will have added to v⁻ before the solver's own impulses: impulses applied since the
// last solve, and Bullet's forces, in Bullet's own arithmetic so that rest is exactly rest.
void AddedMassConstraint::pendingChange(Vec3& linear, Vec3& angular) const noexcept {
  const btVector3 byForce = m_rbA.getTotalForce() * m_rbA.getInvMass() * step_;
  const btVector3 byTorque = m_rbA.getTotalTorque() * m_rbA.getInvInertiaTensorWorld() * step_;
  linear = fromBullet(m_rbA.getLinearVelocity() - linear_) + fromBullet(byForce);
  angular = fromBullet(m_rbA.getAngularVelocity() - angular_) + fromBullet(byTorque) +
            fromBullet(gyroscopicChange(m_rbA, step_));
}

// A∞(v⁻ − V) in the axes of then: Σ l (J·(v⁻ − V)) J. Of an A∞ that has changed, what is left.
Vec6 AddedMassConstraint::pastMomentum() const noexcept {
  const Vec6 velocity = relativeVelocity(pastAxes_);
  if (changed_ && held_) return projection_ * (kept_ * (projection_ * velocity) + met_);
  if (changed_) return kept_ * velocity + met_;
  if (carries_ && held_) return projection_ * (addedMass_ * (projection_ * velocity));
  if (carries_) return addedMass_ * velocity;  // the rows are those of L as well
  Vec6 momentum = Vec6::Zero();
  for (int r = 0; r < count_; ++r) {
    const Row& row = rows_[static_cast<std::size_t>(r)];
    const double share =
        row.ratio * (row.linear.dot(velocity.head<3>()) + row.angular.dot(velocity.tail<3>()));
    momentum.head<3>() += share * row.linear;
    momentum.tail<3>() += share * row.angular;
  }
  return momentum;
}

Vec6 AddedMassConstraint::relativeVelocity(const TurningAxes& axes) const noexcept {
  Vec6 velocity;
  velocity << axes.linear.transpose() * (fromBullet(linear_) - mean_),
      axes.angular.transpose() * fromBullet(angular_);
  return velocity;
}

// Of what is left of L at v⁻, in W.
Vec6 AddedMassConstraint::momentumOfCarried() const noexcept {
  const Mat6 mass = bodyMassIn(carriedKept_, pastAxes_, pastBody_);
  const Vec6 velocity = relativeVelocity(pastAxes_);
  const Vec6 own =
      held_ ? Vec6(projection_ * (mass * (projection_ * velocity))) : Vec6(mass * velocity);
  Vec6 momentum;
  momentum << pastAxes_.linear * own.head<3>(), pastAxes_.angular * own.tail<3>();
  return momentum;
}

// Of water and carried mass, in the present axes: L's stands still in the world.
Vec6 AddedMassConstraint::momentumInto(const TurningAxes& now) const noexcept {
  if (!carries_) return carriedInto(now);
  Vec6 momentum = active_ ? carriedInto(now) : Vec6(Vec6::Zero());
  momentum.head<3>() += now.linear.transpose() * carriedBefore_.head<3>();
  momentum.tail<3>() += now.angular.transpose() * carriedBefore_.tail<3>();
  return momentum;
}

// The same in the present axes. Axes that turn with the body keep all of it in the world.
Vec6 AddedMassConstraint::carriedInto(const TurningAxes& now) const noexcept {
  const Vec6 then = pastMomentum();
  if (!follows_) {
    const Mat3 turn = now.linear.transpose() * pastAxes_.linear;
    Vec6 turned;
    turned << turn * then.head<3>(), turn * then.tail<3>();
    return turned;
  }
  const auto inEarth = [this](const Mat3& axes) {
    return Mat3(frame_.transpose() * axes * frame_);
  };
  const auto turned = [](const Mat3& turn, const Vec6& momentum) {
    Vec6 result;
    result << turn * momentum.head<3>(), turn * momentum.tail<3>();
    return result;
  };
  const Vec6 still = turned(
      frame_, carried(turned(frame_.transpose(), then), inEarth(pastAxes_.linear),
                      inEarth(pastAxes_.angular), inEarth(now.linear), inEarth(now.angular)));
  return share_ * still + (1.0 - share_) * then;
}

Vec6 AddedMassConstraint::momentum() const noexcept {
  Vec6 velocity;
  velocity << pastAxes_.linear.transpose() * fromBullet(linear_),
      pastAxes_.angular.transpose() * fromBullet(angular_);
  const Vec6 own = addedMass_ * velocity;
  Vec6 momentum;
  momentum << pastAxes_.linear * own.head<3>(), pastAxes_.angular * own.tail<3>();
  return momentum;
}

// Only where rows are missing: a hull without added mass in some direction.
void AddedMassConstraint::giveWhatNoRowCarries() noexcept {
  if (!(active_ || carries_) || count_ == 6 || (held_ && !changed_ && !carries_)) return;
  const TurningAxes now = axes();
  if (stands(now)) return;
  const Vec6 momentum = momentumInto(now);
  Vec6 rest = momentum;
  for (int r = 0; r < count_; ++r) {
    const Row& row = rows_[static_cast<std::size_t>(r)];
    const double share = row.linearX.dot(momentum.head<3>()) + row.angularX.dot(momentum.tail<3>());
    rest.head<3>() -= share * row.linear;
    rest.tail<3>() -= share * row.angular;
  }
  given_ << now.linear * rest.head<3>(), now.angular * rest.tail<3>();
  m_rbA.applyCentralImpulse(toBullet(Vec3(given_.head<3>())));
  m_rbA.applyTorqueImpulse(toBullet(Vec3(given_.tail<3>())));
}

// Nothing is returned or met: A∞ is as it was, and so are its axes.
bool AddedMassConstraint::stands(const TurningAxes& now) const noexcept {
  if (carries_ && !(same(body_, pastBody_) && carriedKept_ == carried_)) return false;
  return !changed_ && same(now.linear, pastAxes_.linear) && same(now.angular, pastAxes_.angular);
}

void AddedMassConstraint::beginTick(btScalar step) noexcept {
  step_ = step;
  solved_ = axes();  // Bullet asks for no rows where there are none
  given_.setZero();
  body_ = fromBullet(m_rbA.getWorldTransform().getBasis());
  if (carries_) {
    carriedBefore_ = momentumOfCarried();
    if (!held_) findRows(total());
  }
  giveWhatNoRowCarries();
}

// p⁻ in the present axes stands for the velocity x·p⁻/l along row r, which differs from J·v⁻ by
// what is returned. V's momentum stands for J·V itself.
Vec6 AddedMassConstraint::changeByTurning(const TurningAxes& now) const noexcept {
  Vec6 change = Vec6::Zero();
  if (stands(now)) return change;
  const Vec6 momentum = momentumInto(now);
  const Vec3 swung = now.linear.transpose() * (fromBullet(linear_) - mean_);
  const Vec3 turned = now.angular.transpose() * fromBullet(angular_);
  for (int r = 0; r < count_; ++r) {
    const Row& row = rows_[static_cast<std::size_t>(r)];
    change[r] =
        (row.linearX.dot(momentum.head<3>()) + row.angularX.dot(momentum.tail<3>())) / row.ratio -
        row.linear.dot(swung) - row.angular.dot(turned);
  }
  return change;
}

// We want λ = −l J(Δv_pending + Δv), Δv the solver's change so far; s = J M⁻¹ Jᵀ, 1 in body axes.
// Bullet iterates   λ += [e − J·Δv]/D − cfm·λ,    D = J₁M⁻¹J₁ᵀ + J₂M⁻¹J₂ᵀ, on two bodies; ours are
// the same one, so only J₁ + J₂ = J acts while D is ours to choose. At rest of the iteration
// cfm·D·λ = e − J·Δv: hence e = −J·Δv_pending (plus what turning changed) and cfm·D = 1/l. One step
// from λ = 0 gives e/D and must be the answer e/(s + 1/l): hence D = s + 1/l and cfm = 1/(1 + l s).
// With J₁ = (1+κ)J and J₂ = −κJ, D = s(1 + 2κ + 2κ²), so κ = (−1 + √(1 + 2/(l s)))/2. m_damping = 0
// keeps Bullet from adding −J·v of the whole velocity to e.
void AddedMassConstraint::getInfo2(btConstraintInfo2* info) {
  Vec3 linear, angular;
  pendingChange(linear, angular);
  solved_ = axes();
  const Vec6 turning = changeByTurning(solved_);
  info->m_damping = 0;
  for (int r = 0; r < count_; ++r) {
    const Row& row = rows_[static_cast<std::size_t>(r)];
    const btVector3 j = toBullet(Vec3(solved_.linear * row.linear));
    const btVector3 k = toBullet(Vec3(solved_.angular * row.angular));
    const double ratio = row.ratio * (follows_ ? response(m_rbA, j, k) : 1.0);  // l s
    const double kappa = 0.5 * (std::sqrt(1.0 + 2.0 / ratio) - 1.0);
    const int at = r * info->rowskip;
    store(info->m_J1linearAxis + at, j, 1.0 + kappa);
    store(info->m_J1angularAxis + at, k, 1.0 + kappa);
    store(info->m_J2linearAxis + at, j, -kappa);
    store(info->m_J2angularAxis + at, k, -kappa);
    info->m_constraintError[at] =
        static_cast<btScalar>(turning[r] - fromBullet(j).dot(linear) - fromBullet(k).dot(angular));
    info->cfm[at] = static_cast<btScalar>(1.0 / (1.0 + ratio));
  }
}

CUTWATER_PLUGIN_END
