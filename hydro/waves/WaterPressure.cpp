#include "hydro/waves/WaterPressure.h"

#include <algorithm>
#include <cmath>

#include "hydro/waves/WaveSums.h"

namespace cutwater {

namespace {

using wave_sums::elevationAt, wave_sums::headAt, wave_sums::sumOver, wave_sums::turnsAt;

/// r Σ f a e^{kz} cos θ with both factors f of each wave.
template <class Double>
CUTWATER_INLINE void weighedAt(const auto& sea, const Double& z, double* first, double* second) {
  const auto level = toSingle(z);
  using Single = decltype(toSingle(z));
  const auto* waves = sea.waves.data();
  const auto* heights = sea.heights.data();
  Single one = {}, two = {};
  for (std::size_t i = 0; i < sea.waves.size(); ++i) {
    const Single height = loadAs<Single>(heights + i) * powerOfTwo(waves[i].octaves * level);
    one += waves[i].first * height;
    two += waves[i].second * height;
  }
  toDouble(one).store(first);
  toDouble(two).store(second);
}

/// −Σ f r a sin θ with the third factor.
template <class Double>
CUTWATER_INLINE Double rateAt(const auto& sea, const Double& x, const Double& y) {
  using Single = decltype(toSingle(x));
  const auto* waves = sea.waves.data();
  return sumOver<Single>(sea.waves.size(), [&](std::size_t i) CUTWATER_INLINED {
    // sin θ is cos θ a quarter of a turn later.
    auto turned = waves[i];
    turned.turns -= 0.25;
    return -(waves[i].rate * waves[i].height) * cosineOfTurns(turnsAt(turned, x, y));
  });
}

/// The water at the points from `first` on, as many as Double holds. Where the point and the
/// surface are at one height, so are the two exponents, to the bit, and with them both heads.
template <class Double>
CUTWATER_INLINE void waterAt(const auto& sea, const auto& points, std::size_t first, double near,
                             const auto& water) {
  const Double z = Double::load(&points.z[first]);
  const Double zeta =
      elevationAt(sea, Double::load(&points.x[first]), Double::load(&points.y[first]));
  zeta.store(&water.elevation[first]);
  const bool wheeler = sea.profile == WaveProfile::Wheeler;
  const Double surface = sea.profile == WaveProfile::Constant ? least(zeta, Double{}) : zeta;
  const Double level = wheeler ? least(z, zeta) - zeta : least(z, surface);
  headAt(sea, level).store(&water.head[first]);
  bool isNear = false;
  for (std::size_t i = first; i < first + sizeof(Double) / sizeof(double); ++i)
    isNear |= points.z[i] > -near;
  if (!water.first.empty()) {
    weighedAt(sea, level, &water.first[first], &water.second[first]);
    if (isNear)
      rateAt(sea, Double::load(&points.x[first]), Double::load(&points.y[first]))
          .store(&water.rate[first]);
  }
  if (wheeler) {
    zeta.store(&water.surfaceHead[first]);
    return;
  }
  (isNear ? headAt(sea, surface) : zeta).store(&water.surfaceHead[first]);
}

}  // namespace

CUTWATER_WIDE void WaterPressure::evaluateWide(const Sea& sea, const Points& points, double near,
                                               const Water& water) noexcept {
  static_assert(sizeof(Doubles16) == kLanes * sizeof(double));
  for (std::size_t first = 0; first + kLanes <= points.z.size(); first += kLanes)
    waterAt<Doubles16>(sea, points, first, near, water);
}

CUTWATER_VECTOR void WaterPressure::evaluate(const Sea& sea, const Points& points, double near,
                                             const Water& water) noexcept {
  for (std::size_t first = 0; first + kLanes <= points.z.size(); first += kLanes) {
    waterAt<Doubles8>(sea, points, first, near, water);
    waterAt<Doubles8>(sea, points, first + kLanes / 2, near, water);
  }
}

WaterPressure::WaterPressure(const SeaState& sea, bool wide)
    : sea_(sea), wide_(wide && wideRegisters()), heights_(sea.components().size()) {
  waves_.resize(heights_.size());
  for (std::size_t i = 0; i < waves_.size(); ++i) wave_sums::setLength(sea_, i, waves_[i]);
}

void WaterPressure::weigh(std::span<const double> first, std::span<const double> second,
                          std::span<const double> rate) noexcept {
  for (std::size_t i = 0; i < waves_.size(); ++i) {
    waves_[i].first = static_cast<float>(first[i]);
    waves_[i].second = static_cast<float>(second[i]);
    waves_[i].rate = static_cast<float>(rate[i]);
  }
}

void WaterPressure::at(double time, double originX, double originY, const Points& points,
                       double near, const Water& water) noexcept {
  wave_sums::meet(sea_, time, originX, originY, std::span(waves_));
  const Sea sea{waves_, heights_, sea_.profile()};
  if (wide_) {
    evaluateWide(sea, points, near, water);
  } else {
    evaluate(sea, points, near, water);
  }
  if (sea_.stokes()) pressSteep(time, points, water);
}

// What the first harmonic alone has left: elevation and heads. The sums that stand for the mean of
// the level force stay its own.
void WaterPressure::pressSteep(double time, const Points& points, const Water& water) noexcept {
  const StokesWave::Series series = sea_.stokes()->series(sea_.growth(0, time));
  const Wave& wave = waves_.front();
  for (std::size_t i = 0; i < points.z.size(); ++i) {
    const double theta = wave_sums::phaseOf(wave, points.x[i], points.y[i]);
    const double zeta = series.elevationAt(theta);
    water.elevation[i] = zeta;
    water.head[i] = series.headAt(theta, std::min(points.z[i], zeta));
    water.surfaceHead[i] = series.headAt(theta, zeta);
  }
}

}  // namespace cutwater
