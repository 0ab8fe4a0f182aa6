#include "hydro/forces/WettedHull.h"

#include <algorithm>
#include <cmath>

#include "hydro/base/SimdMath.h"
#include "hydro/forces/FreeResponse.h"
#include "hydro/forces/Hydrodynamics.h"

namespace cutwater {

namespace {

constexpr double kMetTooSlowly = 1e-9;  // of w, to be told from a steady motion

}  // namespace

WettedHull::WettedHull(std::shared_ptr<const PressureHull> hull,
                       std::shared_ptr<const SeaTables> tables, bool scaled)
    : hull_(std::move(hull)),
      tables_(std::move(tables)),
      water_(tables_->sea()),
      density_(tables_->hydrodynamics()->ship().density),
      gravity_(tables_->hydrodynamics()->ship().gravity),
      scaled_(scaled),
      calm_(tables_->sea().components().empty()),
      slow_(FreeResponse::slowFrequency(tables_->hydrodynamics()->ship())),
      state_(hull_->triangles()),
      shares_(hull_->mass().strips(), 1.0),
      before_(shares_),
      rise_(shares_.size(), 0.0) {
  for (auto* column : {&columns_.x, &columns_.y, &columns_.z, &columns_.elevation, &columns_.head,
                       &columns_.surfaceHead})
    column->resize(hull_->triangles().points().size(), 0.0);
  const auto& waves = tables_->sea().components();
  weightX_.resize(waves.size(), 0.0);
  weightY_ = meets_ = weightX_;
  change_.now = hull_->mass().at(shares_);
  near_ = hull_->triangles().longestEdge();
  for (const WaveComponent& wave : waves) {
    near_ += wave.amplitude;
    towards_.push_back({std::cos(wave.heading), -std::sin(wave.heading)});
  }
}

// In double precision, four at a time: the pressure over thousands of vertices is a small
// difference of large numbers.
CUTWATER_VECTOR void WettedHull::placePoints(const WettedTriangles::Points& points, const Place& at,
                                             Columns& columns) noexcept {
  const Mat3& R = at.attitude;
  const double xx = R(0, 0), xy = R(0, 1), xz = R(0, 2), yx = R(1, 0), yy = R(1, 1), yz = R(1, 2);
  const double zx = R(2, 0), zy = R(2, 1), zz = R(2, 2), height = at.position.z();
  for (std::size_t i = 0; i < points.size(); i += 4) {
    const Double4 x = load4(&points.x[i]), y = load4(&points.y[i]), z = load4(&points.z[i]);
    store4(&columns.x[i], xx * x + xy * y + xz * z);
    store4(&columns.y[i], yx * x + yy * y + yz * z);
    store4(&columns.z[i], zx * x + zy * y + zz * z + height);
  }
}

CUTWATER_VECTOR void WettedHull::pressPoints(double gradient, const Columns& columns,
                                             WettedTriangles::State& state) noexcept {
  for (std::size_t i = 0; i < columns.x.size(); i += 4) {
    const Double4 x = load4(&columns.x[i]), y = load4(&columns.y[i]), z = load4(&columns.z[i]);
    const Double4 zeta = load4(&columns.elevation[i]);
    store4(&state.depth[i], zeta - z);
    store4(&state.pressure[i], gradient * (load4(&columns.head[i]) - z));
    store4(&state.surfacePressure[i], gradient * (load4(&columns.surfaceHead[i]) - zeta));
    store4(&state.onSurface[i], zeta);
    const Double4 along = load4(&state.carried[0][i]), across = load4(&state.carried[1][i]);
    store4(&state.carried[2][i], x * across - y * along);
  }
}

void WettedHull::findWater(double time) noexcept {
  placePoints(hull_->triangles().points(), met_, columns_);
  if (!calm_)
    water_.at(time, met_.position.x(), met_.position.y(), {columns_.x, columns_.y, columns_.z},
              near_,
              {columns_.elevation, columns_.head, columns_.surfaceHead, state_.carried[0],
               state_.carried[1], state_.rise});
  pressPoints(density_ * gravity_, columns_, state_);
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
    change_.gone.setZero();
    return;
  }
  for (std::size_t i = 0; i < shares_.size(); ++i) {
    if (calm_ || !(shares_[i] > before_[i])) continue;
    const Vec3 at = met_.position + met_.attitude * Vec3(hull_->arms()[i], 0.0, 0.0);
    rise_[i] = tables_->sea().velocity(time, {at.x(), at.y(), 0.0}).z();
  }
  change_ = hull_->mass().change(before_, shares_, rise_);
}

// Each wave's orbital velocity is ω e^{kz} a cos θ; what of the force it is the rate of, in the
// slow frame, is ω/ω′ times that.
void WettedHull::weighWaves(const std::array<double, 2>& way) noexcept {
  const auto& waves = tables_->sea().components();
  for (std::size_t i = 0; i < waves.size(); ++i) {
    const auto& [x, y] = towards_[i];
    const double omega = waves[i].omega;
    const double met = omega - tables_->sea().waveNumber(i) * (way[0] * x + way[1] * y);
    const double share = FreeResponse::share(met, slow_);
    const double factor = share > kMetTooSlowly ? share * omega * omega / met : 0.0;
    meets_[i] = met;
    weightX_[i] = factor * x;
    weightY_[i] = factor * y;
  }
  water_.weigh(weightX_, weightY_, meets_);
}

// The force stays in the axes of the slow heading, as that of linear waves does; the moment turns
// the hull about its own.
void WettedHull::see(double time, const Place& actual, const Place& slow, const Vec6& velocity,
                     const std::array<double, 2>& way) noexcept {
  actual_ = actual;
  met_ = slow;
  measured_ = false;
  if (!calm_) weighWaves(way);
  findWater(time);
  const Vec3 up = met_.attitude.row(2);
  const Mat3 turn = met_.attitude * actual.attitude.transpose();
  Vec6 motion;
  motion << velocity[Heave] * up,
      met_.attitude.transpose() * (turn * Vec3(velocity[Roll], velocity[Pitch], 0.0));
  hull_->triangles().press(up, motion, state_);
  load_ << met_.attitude * state_.load.head<3>(), actual_.attitude * state_.load.tail<3>();
  if (!calm_) takeMeanOff();
}

void WettedHull::look(double time, const Place& actual, const Place& slow, const Vec6& velocity,
                      const std::array<double, 2>& way) noexcept {
  see(time, actual, slow, velocity, way);
  if (scaled_) {
    findImmersion(time);
    return;
  }
  begins_ = massChanged_ = !begun_;
  begun_ = true;
}

// Level force and turning moment as the rate of the undisturbed water's momentum within the hull:
// its flow through the hull that moves, and what of it is in the crest that the waterline sweeps.
void WettedHull::takeMeanOff() noexcept {
  const Vec3 rate = density_ * (state_.flow - 0.5 * state_.edge);
  load_.head<2>() += rate.head<2>();
  load_[Yaw] += rate[2];
}

// In calm water nobody asks for it again.
void WettedHull::enterSea(WettedHull& other) noexcept {
  tables_.swap(other.tables_);
  std::swap(water_, other.water_);
  std::swap(calm_, other.calm_);
  std::swap(near_, other.near_);
  towards_.swap(other.towards_);
  weightX_.swap(other.weightX_);
  weightY_.swap(other.weightY_);
  meets_.swap(other.meets_);
  if (!calm_) return;
  for (auto* column : {&columns_.elevation, &columns_.head, &columns_.surfaceHead})
    std::fill(column->begin(), column->end(), 0.0);
  for (auto& carried : state_.carried) std::fill(carried.begin(), carried.end(), 0.0);
  std::fill(state_.rise.begin(), state_.rise.end(), 0.0);
}

double WettedHull::depthOfTop() const noexcept {
  if (state_.wetVertices < hull_->triangles().vertices()) return 0.0;
  return *std::min_element(state_.depth.begin(), state_.depth.end());
}

const WettedTriangles::State& WettedHull::measured() noexcept {
  if (!measured_) hull_->triangles().measure(met_.attitude.row(2), state_);
  measured_ = true;
  return state_;
}

void WettedHull::save(std::span<double> state) const noexcept {
  std::copy(shares_.begin(), shares_.end(), state.begin());
  state[shares_.size()] = begun_ ? 1.0 : 0.0;
}

void WettedHull::restore(std::span<const double> state) noexcept {
  if (scaled_) std::copy_n(state.begin(), shares_.size(), shares_.begin());
  begun_ = state[shares_.size()] != 0.0;
  mean_ = hull_->mass().mean(shares_);
  change_ = {hull_->mass().at(shares_), Mat6::Zero(), Mat6::Zero(), Vec6::Zero()};
}

}  // namespace cutwater
