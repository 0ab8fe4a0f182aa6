#include "hydro/ship/StabilityRange.h"

#include <algorithm>
#include <cmath>

#include "hydro/base/FindRoot.h"
#include "hydro/base/Radians.h"

namespace cutwater {

namespace {

constexpr double kPlace = 1e-12;    // tolerance of angles [rad]
constexpr double kNothing = 1e-10;  // of the scale: a lever of round-off and no more
constexpr double kNearest = 1e-3 * kDegree;
constexpr double kKeelUp = 179.99 * kDegree;  // at 180 degrees gz is 0 again

/// Levers to one side: `turn` from upright, above 0 brings it back.
struct Side {
  Righting& righting;
  double sense;
  double operator()(double turn) const { return sense * righting.at(sense * turn).gz; }
};

/// The first place in [from, to] where gz rises through 0, or falls, in steps of a degree.
std::optional<double> crossing(const Side& side, double from, double to, bool rises) {
  const double least = kNothing * side.righting.scale(), sign = rises ? 1.0 : -1.0;
  Sample before{from, side(from)};
  bool begun = sign * before.y < -least;
  for (double x = from; x < to;) {
    x = std::min(to, (std::floor(x / kDegree + 1e-9) + 1.0) * kDegree);
    const Sample next{x, side(x)};
    if (begun && sign * next.y > least) {
      if (sign * before.y >= 0.0) return before.x;
      return findRoot(side, before, next, kPlace);
    }
    begun = begun || sign * next.y < -least;
    before = next;
  }
  return {};
}

/// The greatest lever in the open interval, by golden sections about the greatest of every degree.
std::optional<RightingLever> greatest(const Side& side, double from, double to) {
  double best = from, most = std::max(side(from), kNothing * side.righting.scale());
  for (double x = from; x < to;) {
    x = std::min(to, (std::floor(x / kDegree + 1e-9) + 1.0) * kDegree);
    const double y = side(x);
    if (!(y > most)) continue;
    best = x;
    most = y;
  }
  if (best == from || best == to) return {};
  double low = std::max(from, best - kDegree), high = std::min(to, best + kDegree);
  constexpr double kGolden = 0.6180339887498949;
  while (high - low > 1e-7) {  // the lever's top is flat: closer than √round-off nothing is told
    const double left = high - kGolden * (high - low), right = low + kGolden * (high - low);
    (side(left) < side(right) ? low : high) = side(left) < side(right) ? left : right;
  }
  return side.righting.at(side.sense * 0.5 * (low + high));
}

/// Where the ship comes to lie.
std::optional<double> restOf(const StabilityRange& range, Righting& righting, double sense) {
  const double least = kNothing * righting.scale();
  const bool staysUpright =
      range.gm > 0.0 || (range.gm == 0.0 && Side{righting, sense}(kDegree) > -least);
  if (staysUpright) {
    const double gz = righting.at(0.0).gz;
    if (std::abs(gz) <= least) return 0.0;
    sense = gz > 0.0 ? -1.0 : 1.0;  // a list: where the ship turns
  }
  const auto turn = crossing({righting, sense}, staysUpright ? 0.0 : kNearest, kKeelUp, true);
  if (!turn) return {};
  return sense * *turn;
}

}  // namespace

StabilityRange stabilityRange(Righting& righting, double last) {
  constexpr double kProbe = 1e-4;  // [rad]: gz is odd to its square, 1e-8
  const double sense = last < 0.0 ? -1.0 : 1.0;
  StabilityRange range;
  range.gm = (righting.at(kProbe).gz - righting.at(-kProbe).gz) / (2.0 * kProbe);
  if (std::abs(range.gm) < 1e-9 * righting.scale()) range.gm = 0.0;
  range.rest = restOf(range, righting, sense);
  if (!range.rest) return range;
  const Side side{righting, sense};
  const double from = sense * *range.rest, end = std::min(std::abs(last), kKeelUp);
  if (!(from < end)) return range;
  range.vanishing = crossing(side, from, end, false);
  range.greatest = greatest(side, from, range.vanishing.value_or(end));
  if (range.vanishing) *range.vanishing *= sense;
  return range;
}

}  // namespace cutwater
