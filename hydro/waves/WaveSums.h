#pragma once
#include <cmath>
#include <cstddef>

#include "hydro/base/SimdSingle.h"
#include "hydro/waves/SeaState.h"

// Sums over the waves of a sea at eight or sixteen points at once, in single precision but for the
// phases: what WaterPressure and WaterMotion are made of. `wave` and `sea` are types of theirs:
//   wave.turns  θ/2π at the origin, −½..½;  turnsX, turnsY  k_x/2π, k_y/2π [1/m]
//   wave.height  r a [m];  octaves  k/ln 2 [1/m]: e^{kz} = 2^{octaves z}
//   sea.waves  all of them;  sea.heights  r a cos θ of each, kept by elevationAt

namespace cutwater::wave_sums {

inline constexpr std::size_t kGroup = 16;  // waves whose sum is kept in single precision
inline constexpr double kPerRadian = 1.0 / (2.0 * kPi);  // turns

/// What of component i does not change with time and origin.
template <class Wave>
void setLength(const SeaState& sea, std::size_t i, Wave& wave) {
  const WaveComponent& c = sea.components()[i];
  const double k = sea.waveNumber(i);
  wave.turnsX = kPerRadian * k * std::cos(c.heading);
  wave.turnsY = -kPerRadian * k * std::sin(c.heading);
  wave.octaves = static_cast<float>(k / std::log(2.0));
}

/// All components at a time [s], about an origin [m].
template <class Wave>
void meet(const SeaState& sea, double time, double x, double y, std::span<Wave> waves) noexcept {
  const SeaState::Growths growths = sea.growths(time);
  for (std::size_t i = 0; i < waves.size(); ++i) {
    const WaveComponent& c = sea.components()[i];
    Wave& wave = waves[i];
    wave.turns = partOfTurn(kPerRadian * c.omega * time + kPerRadian * c.phase - wave.turnsX * x -
                            wave.turnsY * y);
    wave.height = static_cast<float>(sea.amplitude(i, growths));
  }
}

/// θ of a wave at x, y from the origin [rad].
template <class Wave>
double phaseOf(const Wave& wave, double x, double y) noexcept {
  return 2.0 * kPi * (wave.turns - wave.turnsX * x - wave.turnsY * y);
}

/// Σ term(i) over so many waves, in groups.
template <class Single>
CUTWATER_INLINE auto sumOver(std::size_t waves, const auto& term) {
  decltype(toDouble(Single{})) sum = {};
  for (std::size_t begin = 0; begin < waves; begin += kGroup) {
    const std::size_t end = begin + kGroup < waves ? begin + kGroup : waves;
    Single group = {};
    for (std::size_t i = begin; i < end; ++i) group += term(i);
    sum = sum + toDouble(group);
  }
  return sum;
}

/// θ/2π of a wave, −½..½.
template <class Half>
CUTWATER_INLINE auto turnsAt(const auto& wave, const Doubles<Half>& x, const Doubles<Half>& y) {
  return toSingle(
      Doubles<Half>{partOfTurn(wave.turns - wave.turnsX * x.low - wave.turnsY * y.low),
                    partOfTurn(wave.turns - wave.turnsX * x.high - wave.turnsY * y.high)});
}

/// ζ; keeps what each wave has of it for headAt.
template <class Double>
CUTWATER_INLINE Double elevationAt(const auto& sea, const Double& x, const Double& y) {
  using Single = decltype(toSingle(x));
  const auto* waves = sea.waves.data();
  auto* heights = sea.heights.data();
  return sumOver<Single>(sea.waves.size(), [&](std::size_t i) CUTWATER_INLINED {
    const Single height = waves[i].height * cosineOfTurns(turnsAt(waves[i], x, y));
    storeAs(heights + i, height);
    return height;
  });
}

/// r Σ a e^{kz} cos θ.
template <class Double>
CUTWATER_INLINE Double headAt(const auto& sea, const Double& z) {
  const auto level = toSingle(z);
  using Single = decltype(toSingle(z));
  const auto* waves = sea.waves.data();
  const auto* heights = sea.heights.data();
  return sumOver<Single>(sea.waves.size(), [&](std::size_t i) CUTWATER_INLINED {
    return loadAs<Single>(heights + i) * powerOfTwo(waves[i].octaves * level);
  });
}

}  // namespace cutwater::wave_sums
