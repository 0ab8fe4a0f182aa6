#include "hydro/forces/linear/FreeRadiation.h"

#include <algorithm>
#include <cmath>

#include "hydro/memory/RadiationModel.h"

namespace cutwater {

namespace {

Vec3 steadyOf(const TickInput& now) { return {now.speed, now.leeway, now.turnRate}; }

Vec6 velocityOf(const Vec3& steady) {
  Vec6 velocity = Vec6::Zero();
  velocity[Surge] = steady[0];
  velocity[Sway] = steady[1];
  velocity[Yaw] = steady[2];
  return velocity;
}

}  // namespace

FreeRadiation::FreeRadiation(std::shared_ptr<const RadiationModel> model,
                             std::shared_ptr<const PredictedMotion> predicted, MemoryModel memory)
    : model_(std::move(model)), predicted_(std::move(predicted)), memoryModel_(memory) {
  // Takes ticks of any length, so it is made now, not in the first tick.
  if (memory == MemoryModel::Exponential) memory_ = model_->makeMemory(1.0 / 60.0);
}

FreeRadiation::~FreeRadiation() = default;

void FreeRadiation::prepare(double step) {
  if (memory_ && !needsFixedTicks()) return;
  memory_.reset();
  reset();
  const bool convolution = memoryModel_ == MemoryModel::Convolution;
  memory_ = convolution ? model_->makeConvolution(step) : model_->makeMemory(step);
}

// A ship that is put somewhere has always had its way; one whose way is set had that way always,
// and keeps the waves it has made.
void FreeRadiation::begin(const TickInput& now) noexcept {
  const Vec6 velocity = velocityOf(now.immersion * steadyOf(now) - steady_);
  if (velocity.allFinite()) memory_->addSteady(velocity);
}

Vec6 FreeRadiation::momentumOf(const Vec3& steady) const noexcept {
  const Mat6 remembered = predicted_->response().addedMassAtRest() - model_->addedMassInf();
  return momentum_ + remembered * velocityOf(immersion_ * steady - steady_);
}

// Of V × R p_F about the level y, what the steady way has: a steady trim, of which this theory does
// not know the rest.
double FreeRadiation::steadyTrim(const TickInput& now) const noexcept {
  const Mat6& atRest = predicted_->response().addedMassAtRest();
  return -now.speed * (atRest(Heave, Surge) * now.speed + atRest(Heave, Sway) * now.leeway);
}

// About the vertical, what the predicted motion has at second order.
double FreeRadiation::meanYaw(const TickInput& now) const noexcept {
  const PredictedMotion::Sums& wave = predicted_->now();
  const Mat6& atRest = predicted_->response().addedMassAtRest();
  const double turn = wave.displacement[2];
  const double ahead = wave.velocity[0] + now.leeway * turn;
  const double across = wave.velocity[1] - now.speed * turn;
  return ahead * wave.momentumAcross - across * wave.momentumAhead -
         now.speed * (atRest(Sway, Sway) - atRest(Surge, Surge)) * turn * ahead;
}

Wrench FreeRadiation::evaluate(const TickInput& now) noexcept {
  if (!memory_) return {};
  memory_->setStep(now.lastStep);  // the convolution has been prepared for it
  const bool first = !begun_ || now.courseBegins;
  if (first) begin(now);
  const Mat3& own = now.ownAxes;
  const double s = now.immersion;
  const Vec6 after = memory_->momentum(s * now.ownVelocity, now.step);
  const double share = now.turningShare;
  const Vec6 before =
      first ? after
            : Vec6(share * carried(momentum_, now.ownAxesBefore, now.ownAxesBefore, own, own) +
                   (1.0 - share) * momentum_);
  const Vec6 rate = (before - after) / now.step;

  // V × R q_F at t_n, between the two.
  const Vec3 q = 0.5 * (before + after).head<3>();
  const Vec3 cross = share * (own * now.ownVelocityNow.head<3>().cross(q));
  Vec3 moment = generalisedMoment(own, own * rate.tail<3>());
  moment[1] -= own.col(1).dot(cross) - share * steadyTrim(now);
  moment[2] -= cross.z() - meanYaw(now);

  momentum_ = after;
  immersion_ = s;
  steady_ = s * steadyOf(now);
  begun_ = true;
  Wrench wrench{.axes = Axes::Earth};
  wrench.load << own * rate.head<3>(), momentOf(own, moment);
  wrench.load *= s;
  return wrench;
}

void FreeRadiation::reset() noexcept {
  if (memory_) memory_->reset();
  momentum_.setZero();
  steady_.setZero();
  begun_ = false;
}

std::size_t FreeRadiation::stateSize() const noexcept {
  return memory_ ? kOwnState + memory_->stateSize() : 0;
}

void FreeRadiation::save(std::span<double> state) const noexcept {
  if (!memory_) return;
  std::copy(momentum_.begin(), momentum_.end(), state.begin());
  std::copy(steady_.begin(), steady_.end(), state.begin() + 6);
  state[9] = begun_ ? 1.0 : 0.0;
  memory_->save(state.subspan(kOwnState));
}

bool FreeRadiation::fits(std::span<const double> state) const noexcept {
  if (!memory_ || state.size() < kOwnState) return state.empty() && !memory_;
  return memory_->fits(state.subspan(kOwnState));
}

void FreeRadiation::restore(std::span<const double> state) noexcept {
  if (!memory_) return;
  std::copy_n(state.begin(), 6, momentum_.begin());
  std::copy_n(state.begin() + 6, 3, steady_.begin());
  begun_ = state[9] != 0.0;
  memory_->restore(state.subspan(kOwnState));
}

}  // namespace cutwater
