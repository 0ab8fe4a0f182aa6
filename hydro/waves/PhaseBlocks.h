#pragma once
#include <cmath>

#include "hydro/base/SimdMath.h"
#include "hydro/waves/SeaState.h"

/// Waves of a sea in blocks of four components, for sums over all of them; internal to hydro. A block begins with four runs of
/// four: ω, ε, k cos β, −k sin β; what else it holds is its owner's.
namespace cutwater::phase_blocks {

inline constexpr std::size_t kLanes = 4, kPhase = 4 * kLanes;  ///< numbers of the phase

/// How many blocks hold `components`.
constexpr std::size_t blocksOf(std::size_t components) {
  return (components + kLanes - 1) / kLanes;
}

/// Component i in blocks of `size` numbers: its place in the first run; the others follow kLanes apart.
inline double* placeOf(std::vector<double>& blocks, std::size_t size, std::size_t i) {
  return blocks.data() + i / kLanes * size + i % kLanes;
}

/// Fills the first four runs of all blocks of `size` numbers; the rest is 0.
inline std::vector<double> phaseBlocks(const SeaState& sea, std::size_t size) {
  std::vector<double> blocks(blocksOf(sea.components().size()) * size, 0.0);
  for (std::size_t i = 0; i < sea.components().size(); ++i) {
    const WaveComponent& wave = sea.components()[i];
    double* at = placeOf(blocks, size, i);
    at[0] = wave.omega;
    at[kLanes] = wave.phase;
    at[2 * kLanes] = sea.waveNumber(i) * std::cos(wave.heading);
    at[3 * kLanes] = -sea.waveNumber(i) * std::sin(wave.heading);
  }
  return blocks;
}

/// ω t + ε − k_x x − k_y y of the four of a block.
CUTWATER_INLINE Double4 phaseAt(const double* block, double t, double x, double y) noexcept {
  return load4(block) * t + load4(block + kLanes) - load4(block + 2 * kLanes) * x -
         load4(block + 3 * kLanes) * y;
}

}  // namespace cutwater::phase_blocks
