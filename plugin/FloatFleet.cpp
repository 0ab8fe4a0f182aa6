#include "plugin/FloatFleet.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "hydro/Errors.h"
#include "plugin/FloatRig.h"
#include "plugin/ShipBody.h"

CUTWATER_PLUGIN_BEGIN

namespace {

[[noreturn]] void refuseFloat(Fault fault, const std::string& what) {
  throw HydroError(fault, "Seaway::addFloat: " + what);
}

void requireGravity(const btDiscreteDynamicsWorld& world, const WorldFrame& frame,
                    const SeaState& sea) {
  const Vec3 g = frame.lengthToEarth(world.getGravity());
  const double down = -g.z();
  if (!(down >= 0.0 && std::hypot(g.x(), g.y()) <= 1e-6 * down))
    refuseFloat(Fault::ValueOutOfRange, "the world's gravity must point down, as WorldFrame says");
  if (down == 0.0 || sea.components().empty()) return;
  if (gravityFits(world.getGravity(), frame, sea.gravity())) return;
  refuseFloat(Fault::ValueOutOfRange, "the world's gravity is " + std::to_string(down) +
                                          " m/s2 and that of the sea " +
                                          std::to_string(sea.gravity()) + " m/s2");
}

}  // namespace

FloatFleet::FloatFleet(btDiscreteDynamicsWorld& world, const WorldFrame& frame,
                       std::shared_ptr<const SeaState> sea)
    : world_(world), frame_(frame), sea_(std::make_unique<FloatSea>(std::move(sea))) {}

// Constraints may stand in a world that is gone, or that lives on: they do nothing any more.
FloatFleet::~FloatFleet() {
  for (const auto& one : floats_) {
    if (worldLives_) {
      one->strikeOut();
    } else {
      one->retire();
    }
  }
  if (!worldLives_) return;
  sweep();
}

void FloatFleet::sweep() noexcept {
  for (btTypedConstraint* left : retired_) strike(world_, *left);
  retired_.clear();  // their memory is kept, as somebody else may have deleted them
}

FloatSea::FloatSea(std::shared_ptr<const SeaState> of)
    : sea(std::move(of)), pressure(*sea), water(*sea) {
  for (const WaveComponent& wave : sea->components()) heights += wave.amplitude;
}

void FloatFleet::checkSea(const SeaState& sea) const {
  if (!floats_.empty()) requireGravity(world_, frame_, sea);
}

// By the world's list: a body may be gone.
void FloatFleet::wake() noexcept {
  for (const auto& one : floats_) {
    if (one->findBody() && one->now_ == Float::Now::Asleep) one->body_->activate();
  }
}

void FloatFleet::enterSea(std::unique_ptr<FloatSea>& sea) noexcept { sea_.swap(sea); }

// All that a tick needs.
void FloatFleet::makeRoom() {
  std::size_t points = 0;
  longestEdge_ = 0.0;
  for (const auto& one : floats_) {
    points += one->water_->points();
    longestEdge_ = std::max(longestEdge_, one->hull_->triangles().longestEdge());
  }
  for (auto* column : {&x_, &y_, &z_, &elevation_, &head_, &surfaceHead_}) column->resize(points);
  places_.resize(floats_.size());
  motions_.resize(floats_.size());
  wet_.reserve(floats_.size());
  active_.reserve(floats_.size());
}

Float& FloatFleet::add(btRigidBody& body, const FloatSettings& settings) {
  if (of(body) != nullptr)
    refuseFloat(Fault::BadArgument, "the body is a float of this sea already");
  requireGravity(world_, frame_, *sea_->sea);
  if (world_.getCollisionObjectArray().findLinearSearch(&body) ==
      world_.getCollisionObjectArray().size())
    refuseFloat(Fault::BadArgument, "the body is not in the world; addRigidBody() it first");
  std::unique_ptr<Float> one;
  try {
    one = std::make_unique<Float>(world_, frame_, body, settings);
  } catch (const HydroError& error) {
    refuseFloat(error.fault(), error.what());
  }
  floats_.push_back(std::move(one));
  makeRoom();
  return *floats_.back();
}

void FloatFleet::remove(Float& one) {
  const auto at = std::find_if(floats_.begin(), floats_.end(),
                               [&](const auto& owned) { return owned.get() == &one; });
  if (at == floats_.end())
    throw HydroError(Fault::BadArgument, "Seaway::removeFloat: it is no float of this sea");
  if (btTypedConstraint* left = one.retire()) retired_.push_back(left);
  floats_.erase(at);
  wet_.clear();
  active_.clear();
}

Float* FloatFleet::of(const btCollisionObject& body) const noexcept {
  for (const auto& one : floats_) {
    if (one->body_ == &body) return one.get();
  }
  return nullptr;
}

std::uint32_t FloatFleet::lookAtAll() noexcept {
  std::uint32_t faults = kStepOk;
  active_.clear();
  const bool calm = !moves();
  for (const auto& one : floats_) {
    faults |= one->look();
    const bool looks = one->now_ == Float::Now::Ticks || (one->now_ == Float::Now::Asleep && !calm);
    if (looks) active_.push_back(one.get());
    if (one->now_ == Float::Now::Asleep && calm) one->rig_->added->forgetPast();
  }
  return faults;
}

void FloatFleet::pressAll(double time) noexcept {
  std::size_t count = 0;
  for (Float* one : active_) {
    const std::size_t size = one->water_->points();
    const btTransform& pose = one->body_->getWorldTransform();
    one->water_->place(
        {frame_.placeToEarth(pose.getOrigin()), frame_.rotationToEarth(pose.getBasis())},
        {{&x_[count], size}, {&y_[count], size}, {&z_[count], size}});
    count += size;
  }
  const auto of = [count](std::vector<double>& column) { return std::span(column.data(), count); };
  if (sea_->sea->components().empty()) {
    for (auto* column : {&elevation_, &head_, &surfaceHead_}) std::ranges::fill(of(*column), 0.0);
  } else {
    sea_->pressure.at(time, 0.0, 0.0, {of(x_), of(y_), of(z_)}, longestEdge_ + sea_->heights,
                      {of(elevation_), of(head_), of(surfaceHead_)});
  }
  const double gravity = -frame_.lengthToEarth(world_.getGravity()).z();
  std::size_t first = 0;
  for (Float* one : active_) {
    const std::size_t size = one->water_->points();
    one->water_->press(gravity, {{&z_[first], size},
                                 {&elevation_[first], size},
                                 {&head_[first], size},
                                 {&surfaceHead_[first], size}});
    first += size;
  }
}

std::uint32_t FloatFleet::beginTick(double time, btScalar step) noexcept {
  if (!retired_.empty()) sweep();
  if (floats_.empty()) return kStepOk;
  std::uint32_t faults = lookAtAll();
  if (!(step > 0)) return faults | kTickNotPositive;
  if (active_.empty()) return faults;
  pressAll(time);
  const bool waves = moves();
  wet_.clear();
  for (Float* one : active_) {
    if (one->now_ == Float::Now::Asleep && !one->wakesIn(waves, step)) continue;
    places_[wet_.size()] = {one->water_->centre(), one->hull_->reach()};
    wet_.push_back(one);
  }
  if (wet_.empty()) return faults;
  const std::size_t count = wet_.size();
  std::fill_n(motions_.begin(), count, FloatWater::Motion{});
  if (!sea_->sea->components().empty())
    sea_->water.motion(time, {places_.data(), count}, {motions_.data(), count});
  for (std::size_t i = 0; i < count; ++i) motions_[i].velocity.z() += rate_;
  for (std::size_t i = 0; i < count; ++i)
    faults |= wet_[i]->begin(waves, motions_[i].velocity, motions_[i].gradient,
                             motions_[i].convective, step);
  return faults;
}

std::uint32_t FloatFleet::endTick() noexcept {
  std::uint32_t faults = kStepOk;
  for (const auto& one : floats_) faults |= one->end();
  return faults;
}

CUTWATER_PLUGIN_END
