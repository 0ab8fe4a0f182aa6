#include "hydro/forces/SeaCache.h"

#include <algorithm>

namespace cutwater {

bool SeaCache::isOf(const SeaState& sea) const noexcept {
  const auto same = [](const WaveComponent& a, const WaveComponent& b) {
    return a.omega == b.omega && a.heading == b.heading;
  };
  const auto mine = waves.components(), other = sea.components();
  return waves.gravity() == sea.gravity() && waves.order() == sea.order() &&
         std::equal(mine.begin(), mine.end(), other.begin(), other.end(), same);
}

}  // namespace cutwater
