#include "hydro/ship/FloatingAttitude.h"

#include <cmath>

#include "hydro/Errors.h"
#include "hydro/base/FindRoot.h"
#include "hydro/base/Radians.h"
#include "hydro/ship/Righting.h"

namespace cutwater {
namespace {

constexpr double kMostHeel = 45 * kDegree;

/// The heel next to upright at which the lever vanishes and turns back on both sides of it.
double restingHeel(Righting& righting) {
  const auto lever = [&](double heel) { return righting.at(heel).gz; };
  const double upright = lever(0.0);
  // A lever above 0 turns the ship to port, to smaller heels.
  const double step = upright > 0 ? -kDegree : kDegree;
  for (double heel = 0.0; std::abs(heel) < kMostHeel; heel += step) {
    const double here = lever(heel), next = lever(heel + step);
    if ((next > 0) != (upright > 0) || next == 0.0)
      return findRoot(lever, {heel, here}, {heel + step, next}, 1e-10);
  }
  throw HydroError(Fault::ValueOutOfRange,
                   "the ship finds no heel within 45 deg at which it rests");
}

void requireStable(Righting& righting, double heel) {
  constexpr double kAside = 0.1 * kDegree;
  if (righting.at(heel + kAside).gz > righting.at(heel - kAside).gz) return;
  throw HydroError(Fault::ValueOutOfRange,
                   "the ship does not float as it is loaded: it falls over, G is too high");
}

}  // namespace

FloatingAttitude floatingAttitude(const ShipParticulars& ship, bool mayHeel) {
  Righting righting(ship, RightingTrim::Free);
  const double heel = mayHeel ? restingHeel(righting) : 0.0;
  requireStable(righting, heel);
  const RightingLever rest = righting.at(heel);
  const Mat3 turn = Attitude{.roll = heel, .pitch = rest.trim}.rotation();
  return {rest.heightOfG - (turn * ship.cog).z(), rest.trim, heel};
}

}  // namespace cutwater
