#include "hydro/forces/WettedHull.h"

#include <algorithm>
#include <cmath>

namespace cutwater {

namespace {

constexpr double kNoShare = 1e-9;

}  // namespace

WettedHull::WettedHull(std::shared_ptr<const PressureHull> hull,
                       std::shared_ptr<const SeaTables> tables, double length, double density,
                       double gravity, bool scaled)
    : hull_(std::move(hull)),
      tables_(std::move(tables)),
      water_(tables_->sea()),
      density_(density),
      gravity_(gravity),
      scaled_(scaled),
      calm_(tables_->sea().components().empty()),
      slow_(0.53 * std::sqrt(gravity / length)),
      state_(hull_->triangles()),
      shares_(hull_->mass().strips(), 1.0),
      before_(shares_),
      rise_(shares_.size(), 0.0) {
  for (auto* column : {&x_, &y_, &z_, &elevation_, &head_, &surfaceHead_, &along_, &across_})
    column->resize(hull_->triangles().points().size(), 0.0);
  weightX_.resize(tables_->sea().components().size(), 0.0);
  weightY_ = weightX_;
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
              {elevation_, head_, surfaceHead_, along_, across_});
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
    change_.came.setZero();
    return;
  }
  for (std::size_t i = 0; i < shares_.size(); ++i) {
    if (calm_ || !(shares_[i] > before_[i])) continue;
    const Vec3 at = met_.position + met_.attitude * Vec3(hull_->arms()[i], 0.0, 0.0);
    rise_[i] = tables_->sea().velocity(time, {at.x(), at.y(), 0.0}).z();
  }
  change_ = hull_->mass().change(before_, shares_, rise_);
}

// Each wave's orbital velocity is ω e^{kz} a cos θ; what of the force it is the rate of, in the slow
// frame, is ω/ω′ times that.
void WettedHull::weighWaves(const std::array<double, 2>& way) noexcept {
  const auto& waves = tables_->sea().components();
  double fast = 0.0, all = 0.0;
  for (std::size_t i = 0; i < waves.size(); ++i) {
    const double cosine = std::cos(waves[i].heading), sine = std::sin(waves[i].heading);
    const double omega = waves[i].omega;
    const double met = omega - tables_->sea().waveNumber(i) * (way[0] * cosine - way[1] * sine);
    const double square = met * met, slow = slow_ * slow_;
    const double share = square * square / (square * square + slow * slow);
    const double factor = share > kNoShare ? share * omega * omega / met : 0.0;
    const double energy = waves[i].amplitude * waves[i].amplitude;
    fast += share * energy;
    all += energy;
    weightX_[i] = factor * cosine;
    weightY_[i] = -factor * sine;
  }
  fast_ = all > 0.0 ? fast / all : 0.0;
  water_.weigh(weightX_, weightY_);
}

// The force stays in the axes of the slow heading, as that of linear waves does; the moment turns
// the hull about its own.
void WettedHull::look(double time, const Place& actual, const Place& slow, const Vec6& velocity,
                      const std::array<double, 2>& way) noexcept {
  actual_ = actual;
  met_ = slow;
  if (!calm_) weighWaves(way);
  findWater(time);
  const Vec3 up = met_.attitude.row(2);
  if (calm_) {
    hull_->triangles().cut(up, state_);
  } else {
    const Mat3 turn = met_.attitude * actual.attitude.transpose();
    const Vec3 spin = turn * Vec3(velocity[Roll], velocity[Pitch], 0.0);
    Vec6 motion;
    motion << velocity[Heave] * up, met_.attitude.transpose() * spin;
    for (std::size_t i = 0; i < x_.size(); ++i) {
      state_.onSurface[i] = elevation_[i] * elevation_[i];
      state_.carried[i] = {along_[i], across_[i], x_[i] * across_[i] - y_[i] * along_[i]};
    }
    hull_->triangles().cut(up, motion, state_);
  }
  load_ << met_.attitude * state_.load.head<3>(), actual_.attitude * state_.load.tail<3>();
  if (!calm_) {
    const double half = 0.5 * density_ * gravity_ * fast_;
    const Vec3 edge = met_.attitude * state_.edge.head<3>();
    load_.head<2>() += density_ * state_.flow.head<2>() - half * edge.head<2>();
    load_[Yaw] += density_ * state_.flow[2] - half * up.dot(state_.edge.tail<3>());
  }
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
  change_ = {hull_->mass().at(shares_), Mat6::Zero(), Mat6::Zero(), Vec6::Zero()};
}

}  // namespace cutwater
