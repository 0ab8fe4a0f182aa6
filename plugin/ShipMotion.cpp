// What a ship knows of its motion at the start of a tick.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "hydro/forces/Hydrodynamics.h"
#include "hydro/forces/OwnAxes.h"
#include "hydro/forces/PredictedMotion.h"
#include "hydro/forces/SeaTables.h"
#include "hydro/forces/WettedHull.h"
#include "plugin/Rig.h"
#include "plugin/Ship.h"
#include "plugin/ShipAxes.h"

CUTWATER_PLUGIN_BEGIN

namespace {

constexpr int kMostPasses = 4;       // to find the slow place
constexpr double kSamePlace = 1e-5;  // of the length: 1 mm of a frigate, 10⁻⁴ rad of its waves

double turnTo(double angle, double from) { return from + std::remainder(angle - from, 2.0 * kPi); }

}  // namespace

// Bullet moves x_{n+1} = x_n + h v_{n+1}: v_n is the mean over the tick that ended at t_n, centred
// at t_n − h_n/2, and v_n + (v_n − v_{n−1}) h_n/(h_n + h_{n−1}) is second order at t_n, of equal
// ticks (3 v_n − v_{n−1})/2. Blows since the last solve are not in it.
Vec6 Ship::velocityNow() const noexcept {
  const double ahead = stepBefore_ > 0.0 ? lastStep_ / (lastStep_ + stepBefore_) : 0.5;
  return (1.0 + ahead) * velocityAfter_ - ahead * velocityBefore_;
}

// About H as it is.
void Ship::findMotion(TickInput& input) const noexcept {
  const Mat3 course = toCourse();
  const Vec3 mean(course_.x(), course_.y(), coefficients().ship.cog.z());
  Vec6 steady = Vec6::Zero();
  steady[Surge] = course_.speed();
  steady[Sway] = course_.leeway();
  steady[Yaw] = course_.turnRate();
  input.eta << course * (position() - mean), motionAngles(course * bodyAxes());
  input.etaDot = rotated(course, input.ownAxesBefore.transpose(), velocityAfter_) - steady;
  input.etaDotNow = -steady;
  input.etaDotNow.head<3>() += course * velocityNow().head<3>();
  input.etaDotNow.tail<3>() += input.ownVelocityNow.tail<3>();
}

// Own axes half a tick ahead: where the solver's velocity will be centred.
void Ship::findOwnMotion() noexcept {
  TickInput& now = input_;
  const Vec3 angles = ownAngles(now.attitude);
  const Mat3 own = ownAxes(angles.z(), angles.y()), toOwn = own.transpose();
  const AddedMassConstraint::TurningAxes& solved = added().pastAxes();
  const Mat3 world = frame_.axes();
  now.ownAxesBefore = world.transpose() * solved.angular * world;
  const Mat3 before = now.ownAxesBefore.transpose();
  now.ownVelocity = rotated(before, before, velocityAfter_);
  now.ownVelocityNow = rotated(toOwn, toOwn, velocityNow());
  const bool upright = now.attitude(2, 2) > std::cos(kLargestTilt);
  const double half = upright ? 0.5 * now.step : 0.0;
  now.ownAxes = ownAxes(angles.z() + half * now.ownVelocityNow[Yaw] / own(2, 2),
                        angles.y() + half * now.ownVelocityNow[Pitch]);
  const double bow = std::hypot(now.attitude(0, 0), now.attitude(1, 0));
  const TurningLimits limits{fastest_, 0.5 * length()};
  now.turningShare =
      free() ? limits.share(now.ownVelocityNow, nonlinear() ? bow : now.attitude(2, 2)) : 1.0;
}

// Where x = x_s + R_s d(x_s); returns d. The place that is expected is right but for what a tick
// changes, so one pass does, but for a ship that was set somewhere.
Vec3 Ship::findSlowPlace() noexcept {
  const SeaState& sea = tables_->sea();
  const Vec3 at = position();
  const double heading = turnTo(this->heading(), course_.heading());
  MeanCourse::Place place{course_.x(), course_.y(), course_.heading()};
  Vec3 displacement = Vec3::Zero();
  for (int pass = 0; pass < kMostPasses; ++pass) {
    sea.phasors(input_.time, place.x, place.y, phasors_);
    displacement = input_.ramp * predicted_->displacement(phasors_);
    place.heading = heading - displacement.z();
    const Vec3 way = rotationZ(place.heading) * Vec3(displacement.x(), displacement.y(), 0.0);
    const double moved = std::hypot(at.x() - way.x() - place.x, at.y() - way.y() - place.y);
    place.x = at.x() - way.x();
    place.y = at.y() - way.y();
    if (!(moved > kSamePlace * length())) break;
  }
  course_.set(place, {course_.speed(), course_.leeway(), course_.turnRate()});
  return displacement;
}

// Slow place, heading and way of a free ship: the actual ones less those that its linear answer to
// the waves has.
void Ship::findSlowMotion() noexcept {
  const double headingRate = input_.ownVelocityNow[Yaw] / std::max(0.1, input_.ownAxes(2, 2));
  const Vec3 velocity = velocityNow().head<3>();
  const int rounds = input_.courseBegins ? 2 : 1;  // amplitudes belong to the way that is sought
  for (int round = 0; round < rounds; ++round) {
    const PredictedMotion::Way now{course_.heading(), {course_.speed(), course_.leeway()}};
    if (input_.courseBegins) {
      predicted_->renewAll(now, anew_);
    } else {
      predicted_->follow(now, course_.turnRate(), input_.step);
    }
    const Vec3 swing = findSlowPlace();
    predicted_->sum(phasors_, input_.ramp);
    const Vec3& rate = predicted_->now().velocity;
    const double turn = headingRate - rate.z();
    const Vec3 along = toCourse() * velocity;
    course_.set(
        {course_.x(), course_.y(), course_.heading()},
        {along.x() - rate.x() + turn * swing.y(), along.y() - rate.y() - turn * swing.x(), turn});
  }
  if (input_.courseBegins) anew_ = false;
  const Vec3 along = toCourse() * velocity;
  predicted_->compare({along.x(), along.y(), headingRate}, input_.step, input_.courseBegins);
}

// Diffraction and what else is known of an upright hull at the surface alone ends between 45 and 90
// degrees of tilt, and with depth as a wave of the ship's length does.
void Ship::findWetted() noexcept {
  if (!nonlinear()) return;
  const WettedHull::Place actual{input_.position, input_.attitude};
  WettedHull::Place slow = actual;
  slow.position.x() = course_.x();
  slow.position.y() = course_.y();
  slow.attitude = rotationZ(course_.heading() - heading()) * input_.attitude;
  const Vec3 way = rotationZ(course_.heading()) * Vec3(course_.speed(), course_.leeway(), 0.0);
  wetted_->look(input_.time, actual, slow, velocityNow(), {way.x(), way.y()});
  input_.immersion = wetted_->immersion();
  input_.deckUnderWater = wetted_->deckUnderWater();
  const double beyond = 1.0 - std::clamp(input_.attitude(2, 2) / std::sqrt(0.5), 0.0, 1.0);
  const double deep = std::exp(-2.0 * kPi * wetted_->depthOfTop() / length());
  input_.upright = deep * (1.0 - beyond * beyond * (3.0 - 2.0 * beyond));
}

// The database's, but of a body that somebody has made heavier or lighter.
double Ship::mass() const noexcept {
  const btScalar inverse = body_->getInvMass();
  if (inverse == inverseMass_ || !(inverse > 0)) return coefficients().ship.mass;
  return frame_.kilogramsPerUnit / static_cast<double>(inverse);
}

void Ship::findInput(double time, double step) noexcept {
  TickInput& now = input_;
  now.time = time;
  now.step = step;
  now.lastStep = lastStep_ > 0.0 ? lastStep_ : step;
  now.position = position();
  now.attitude = bodyAxes();
  now.sea = &tables_->sea();
  now.ramp = now.sea->ramp(time);
  now.phasors = phasors_;
  findOwnMotion();
  if (free()) {
    findSlowMotion();
  } else {
    now.sea->phasors(time, course_.x(), course_.y(), phasors_);
  }
  findWetted();
  now.meanX = course_.x();
  now.meanY = course_.y();
  now.meanHeading = course_.heading();
  now.speed = course_.speed();
  now.leeway = course_.leeway();
  now.turnRate = course_.turnRate();
  findMotion(now);
  now.gravity = toCourse() * frame_.lengthToEarth(world_.getGravity());
  now.weight = mass() * now.gravity;
  const Mat3 toBody = now.attitude.transpose();
  now.velocityNow = rotated(toBody, toBody, velocityNow());
  elevation_ = now.sea->elevation(now.phasors, time);
}

CUTWATER_PLUGIN_END
