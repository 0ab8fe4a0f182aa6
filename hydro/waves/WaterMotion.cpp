#include "hydro/waves/WaterMotion.h"

#include <algorithm>
#include <cmath>

#include "hydro/waves/WaveSums.h"

namespace cutwater {

namespace {

/// sin 2πx, |x| ≤ ½: cos 2π(|x| − ¼) with the sign of x.
template <class Single>
CUTWATER_INLINE Single sineOfTurns(Single x) {
  const Single size = x < 0.0F ? -x : x;
  const Single sine = cosineOfTurns(size - 0.25F);
  return x < 0.0F ? -sine : sine;
}

/// N sums over so many waves; term(i, sums) adds a wave's.
template <class Single, std::size_t N>
CUTWATER_INLINE void sumsOver(std::size_t waves, double (*to)[16], std::size_t first,
                              const auto& term) {
  decltype(toDouble(Single{})) total[N] = {};
  for (std::size_t begin = 0; begin < waves; begin += wave_sums::kGroup) {
    const std::size_t end = std::min(begin + wave_sums::kGroup, waves);
    Single group[N] = {};
    for (std::size_t i = begin; i < end; ++i) term(i, group);
    for (std::size_t j = 0; j < N; ++j) total[j] = total[j] + toDouble(group[j]);
  }
  for (std::size_t j = 0; j < N; ++j) total[j].store(to[j] + first);
}

/// The water at the points from `first` on, as many as Double holds.
template <class Double>
CUTWATER_INLINE void motionAt(const auto& sea, const auto& wanted, std::size_t first, auto& batch) {
  using Single = decltype(toSingle(Double{}));
  const Double x = Double::load(batch.x + first), y = Double::load(batch.y + first);
  const auto* waves = sea.waves.data();
  auto *heights = sea.heights.data(), *risings = sea.risings.data();
  const std::size_t count = sea.waves.size();
  double surface[3][16];
  sumsOver<Single, 3>(count, surface, first, [&](std::size_t i, Single* sums) CUTWATER_INLINED {
    const Single turns = wave_sums::turnsAt(waves[i], x, y);
    const Single height = waves[i].height * cosineOfTurns(turns);
    sums[0] += height;
    storeAs(heights + i, height);
    if (!wanted.slopes && !wanted.velocities) return;
    const Single rising = waves[i].height * sineOfTurns(turns);
    sums[1] += waves[i].slopeX * rising;
    sums[2] += waves[i].slopeY * rising;
    storeAs(risings + i, rising);
  });
  const Double zeta = Double::load(surface[0] + first);
  zeta.store(batch.elevation + first);
  for (std::size_t j = 0; j < 2; ++j)
    Double::load(surface[1 + j] + first).store(batch.slope[j] + first);
  if (!wanted.velocities && !wanted.head) return;
  const Double z = wanted.onSurface ? zeta : least(Double::load(batch.z + first), zeta);
  const Double level = sea.profile == WaveProfile::Wheeler    ? z - zeta
                       : sea.profile == WaveProfile::Constant ? least(z, Double{})
                                                              : z;
  const Single height = toSingle(level);
  double below[4][16];
  sumsOver<Single, 4>(count, below, first, [&](std::size_t i, Single* sums) CUTWATER_INLINED {
    const Single share = powerOfTwo(waves[i].octaves * height);
    const Single level4 = loadAs<Single>(heights + i) * share;
    sums[0] += level4;
    if (!wanted.velocities) return;
    sums[1] += waves[i].speedX * level4;
    sums[2] += waves[i].speedY * level4;
    sums[3] -= waves[i].speedZ * (loadAs<Single>(risings + i) * share);
  });
  (Double::load(below[0] + first) - z).store(batch.head + first);
  for (std::size_t j = 0; j < 3; ++j)
    Double::load(below[1 + j] + first).store(batch.velocity[j] + first);
}

void copyOut(std::span<double> to, std::size_t first, std::size_t count, const double* from) {
  if (!to.empty()) std::copy_n(from, count, to.begin() + static_cast<std::ptrdiff_t>(first));
}

}  // namespace

CUTWATER_WIDE void WaterMotion::evaluateWide(const Sea& sea, const Wanted& wanted,
                                             Batch& batch) noexcept {
  motionAt<Doubles16>(sea, wanted, 0, batch);
}

CUTWATER_VECTOR void WaterMotion::evaluate(const Sea& sea, const Wanted& wanted,
                                           Batch& batch) noexcept {
  motionAt<Doubles8>(sea, wanted, 0, batch);
  motionAt<Doubles8>(sea, wanted, kLanes / 2, batch);
}

WaterMotion::WaterMotion(const SeaState& sea, bool wide)
    : sea_(sea),
      wide_(wide && wideRegisters()),
      heights_(sea.components().size()),
      risings_(heights_.size()) {
  const auto single = [](double value) { return static_cast<float>(value); };
  waves_.resize(heights_.size());
  for (std::size_t i = 0; i < waves_.size(); ++i) {
    const WaveComponent& c = sea_.components()[i];
    const double k = sea_.waveNumber(i), along = std::cos(c.heading), across = -std::sin(c.heading);
    Wave& wave = waves_[i];
    wave_sums::setLength(sea_, i, wave);
    wave.slopeX = single(k * along);
    wave.slopeY = single(k * across);
    wave.speedX = single(c.omega * along);
    wave.speedY = single(c.omega * across);
    wave.speedZ = single(c.omega);
  }
}

void WaterMotion::evaluateSteep(double time, const Wanted& wanted, Batch& batch) const noexcept {
  const StokesWave::Series series = sea_.stokes()->series(sea_.growth(0, time));
  const Wave& wave = waves_.front();
  const double towards[2] = {wave.turnsX, wave.turnsY};
  const double k = std::hypot(wave.turnsX, wave.turnsY);
  for (std::size_t i = 0; i < kLanes; ++i) {
    const double theta = wave_sums::phaseOf(wave, batch.x[i], batch.y[i]);
    batch.elevation[i] = series.elevationAt(theta);
    const double z =
        wanted.onSurface ? batch.elevation[i] : std::min(batch.z[i], batch.elevation[i]);
    const double slope = series.slopeAt(theta);
    const auto [along, up] = series.velocityAt(theta, z);
    for (std::size_t j = 0; j < 2; ++j) {
      batch.slope[j][i] = slope * towards[j] / k;
      batch.velocity[j][i] = along * towards[j] / k;
    }
    batch.velocity[2][i] = up;
    batch.head[i] = series.headAt(theta, z) - z;
  }
}

void WaterMotion::at(double time, double originX, double originY, const Points& points,
                     const Water& water) noexcept {
  wave_sums::meet(sea_, time, originX, originY, std::span(waves_));
  const Wanted wanted{
      !water.slopeX.empty() || !water.slopeY.empty(),
      !water.velocityX.empty() || !water.velocityY.empty() || !water.velocityZ.empty(),
      !water.pressureHead.empty(), points.z.empty()};
  const Sea sea{waves_, heights_, risings_, sea_.profile()};
  Batch batch;
  for (std::size_t first = 0; first < points.x.size(); first += kLanes) {
    const std::size_t count = std::min(kLanes, points.x.size() - first);
    for (std::size_t i = 0; i < kLanes; ++i) {
      const std::size_t from = first + std::min(i, count - 1);
      batch.x[i] = points.x[from];
      batch.y[i] = points.y[from];
      batch.z[i] = wanted.onSurface ? 0.0 : points.z[from];
    }
    if (sea_.stokes()) {
      evaluateSteep(time, wanted, batch);
    } else if (wide_) {
      evaluateWide(sea, wanted, batch);
    } else {
      evaluate(sea, wanted, batch);
    }
    for (std::size_t i = 0; i < count; ++i) {
      const bool dry = wanted.onSurface || batch.z[i] >= batch.elevation[i];
      batch.head[i] = dry ? 0.0 : batch.head[i];
    }
    copyOut(water.elevation, first, count, batch.elevation);
    copyOut(water.slopeX, first, count, batch.slope[0]);
    copyOut(water.slopeY, first, count, batch.slope[1]);
    copyOut(water.velocityX, first, count, batch.velocity[0]);
    copyOut(water.velocityY, first, count, batch.velocity[1]);
    copyOut(water.velocityZ, first, count, batch.velocity[2]);
    copyOut(water.pressureHead, first, count, batch.head);
  }
}

}  // namespace cutwater
