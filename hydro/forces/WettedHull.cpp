#include "hydro/forces/WettedHull.h"

#include <algorithm>

namespace cutwater {

WettedHull::WettedHull(std::shared_ptr<const PressureHull> hull,
                       std::shared_ptr<const SeaTables> tables, double density, double gravity,
                       bool scaled)
    : hull_(std::move(hull)),
      tables_(std::move(tables)),
      water_(tables_->sea()),
      density_(density),
      gravity_(gravity),
      scaled_(scaled),
      calm_(tables_->sea().components().empty()),
      state_(hull_->triangles()),
      shares_(hull_->mass().strips(), 1.0),
      before_(shares_),
      rise_(shares_.size(), 0.0) {
  for (auto* column : {&x_, &y_, &z_, &elevation_, &head_, &surfaceHead_})
    column->resize(hull_->triangles().points().size(), 0.0);
  change_.now = hull_->mass().at(shares_);
  near_ = hull_->triangles().longestEdge();
  for (const WaveComponent& wave : tables_->sea().components()) near_ += wave.amplitude;
}

void WettedHull::findWater(double time) noexcept {
  const WettedTriangles::Points& points = hull_->triangles().points();
  const Mat3& R = met_.attitude;
  const std::size_t count = points.size();
  for (std::size_t i = 0; i < count; ++i) {
    const double x = points.x[i], y = points.y[i], z = points.z[i];
    x_[i] = R(0, 0) * x + R(0, 1) * y + R(0, 2) * z;
    y_[i] = R(1, 0) * x + R(1, 1) * y + R(1, 2) * z;
    z_[i] = R(2, 0) * x + R(2, 1) * y + R(2, 2) * z + met_.position.z();
  }
  if (!calm_)
    water_.at(time, met_.position.x(), met_.position.y(), {x_, y_, z_}, near_,
              {elevation_, head_, surfaceHead_});
  const double gradient = density_ * gravity_;
  for (std::size_t i = 0; i < count; ++i) {
    state_.depth[i] = elevation_[i] - z_[i];
    state_.pressure[i] = gradient * (head_[i] - z_[i]);
    state_.surfacePressure[i] = gradient * (surfaceHead_[i] - elevation_[i]);
  }
}

// Of a strip that comes in: the water there may rise towards it.
void WettedHull::findImmersion(double time) noexcept {
  before_.swap(shares_);
  hull_->shares(state_, shares_);
  begins_ = !begun_;
  if (begins_) before_ = shares_;
  massChanged_ = begins_ || before_ != shares_;
  mean_ = hull_->mass().mean(shares_);
  begun_ = true;
  if (!massChanged_) {
    change_.left.setZero();
    change_.met.setZero();
    return;
  }
  for (std::size_t i = 0; i < shares_.size(); ++i) {
    if (calm_ || !(shares_[i] > before_[i])) continue;
    const Vec3 at = met_.position + met_.attitude * Vec3(hull_->arms()[i], 0.0, 0.0);
    rise_[i] = tables_->sea().velocity(time, {at.x(), at.y(), 0.0}).z();
  }
  change_ = hull_->mass().change(before_, shares_, rise_);
}

// The force stays in the axes of the slow heading, as that of linear waves does; the moment turns
// the hull about its own.
void WettedHull::look(double time, const Place& actual, const Place& slow) noexcept {
  actual_ = actual;
  met_ = slow;
  findWater(time);
  hull_->triangles().cut(met_.attitude.row(2), state_);
  load_ << met_.attitude * state_.load.head<3>(), actual_.attitude * state_.load.tail<3>();
  if (scaled_) findImmersion(time);
}

void WettedHull::save(std::span<double> state) const noexcept {
  std::copy(shares_.begin(), shares_.end(), state.begin());
  state[shares_.size()] = begun_ ? 1.0 : 0.0;
}

void WettedHull::restore(std::span<const double> state) noexcept {
  std::copy_n(state.begin(), shares_.size(), shares_.begin());
  begun_ = state[shares_.size()] != 0.0;
  mean_ = hull_->mass().mean(shares_);
  change_ = {hull_->mass().at(shares_), Mat6::Zero(), Vec6::Zero()};
}

}  // namespace cutwater
