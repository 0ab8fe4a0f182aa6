// Height of calm water: it moves E, and every ship's place in it.
#include <algorithm>
#include <cmath>
#include <sstream>

#include "hydro/Errors.h"
#include "plugin/FloatFleet.h"
#include "plugin/SeaView.h"
#include "plugin/Seaway.h"

CUTWATER_PLUGIN_BEGIN

namespace {

constexpr double kHighestLevel = 1e5;  // [m]

[[noreturn]] void refuseLevel(const char* what, double value, const char* rule) {
  std::ostringstream line;
  line << "Seaway::setCalmLevel: " << what << " = " << value << ": " << rule;
  throw HydroError(Fault::ValueOutOfRange, line.str());
}

}  // namespace

void Seaway::setCalmLevel(double height, double rate) {
  if (!(std::abs(height) <= kHighestLevel)) refuseLevel("height", height, "must be in -1e5..1e5 m");
  if (!(rate > 0.0))
    refuseLevel("rate", rate, "must be positive [m/s], both ways, or infinity for at once");
  calm_.wanted = height;
  calm_.rate = rate;
  if (!std::isinf(rate)) return;
  calm_.level = height;
  calm_.now = 0.0;
  placeWater();
  floats_->wake();
}

// The rate of this tick: the last one only as fast as it takes to arrive.
void Seaway::beginCalmLevel(double step) noexcept {
  if (!(step > 0.0) || !std::isfinite(step)) return;
  const double way = calm_.wanted - calm_.level;
  const double rate = way == 0.0 ? 0.0 : std::clamp(way / step, -calm_.rate, calm_.rate);
  if (rate == calm_.now) return;
  calm_.now = rate;
  placeWater();
}

void Seaway::endCalmLevel(double step) noexcept {
  if (calm_.now == 0.0 || !(step > 0.0) || !std::isfinite(step)) return;
  const double left = calm_.wanted - calm_.level, moved = calm_.now * step;
  calm_.level = std::abs(moved) >= std::abs(left) ? calm_.wanted : calm_.level + moved;
  placeWater();
}

void Seaway::placeWater() noexcept {
  frame_.seaLevel = firstLevel_ + calm_.level / frame_.metresPerUnit;
  for (const auto& ship : ships_) ship->setWater(frame_.seaLevel, calm_.now);
  floats_->setWater(frame_.seaLevel, calm_.now);
  watch_->setLevel(frame_.seaLevel);
}

void Seaway::saveCalmLevel(Snapshot& snapshot) const noexcept {
  snapshot.calmLevel = {calm_.level, calm_.wanted, calm_.rate, calm_.now};
}

void Seaway::restoreCalmLevel(const Snapshot& snapshot) noexcept {
  const auto& [level, wanted, rate, now] = snapshot.calmLevel;
  calm_ = {level, wanted, rate, now};
  placeWater();
}

CUTWATER_PLUGIN_END
