#pragma once
#include <algorithm>
#include <cmath>
#include <limits>

namespace cutwater {

/// A function's value at a place.
struct Sample {
  double x, y;
};

/// The place between `a` and `b` where a continuous function is 0, by the method of
/// [Chandrupatla 1997]: inverse quadratic interpolation where that is safe, else bisection. Never
/// leaves the interval and needs no derivative; about 8 calls for a smooth function.
///     const double root = findRoot(f, {0.0, f(0.0)}, {1.0, f(1.0)}, 1e-12);
/// @pre  a.y and b.y have opposite signs, or one of them is 0.
/// @param tolerance  of the place, in the unit of x; round-off of x comes on top.
template <class Function>
double findRoot(Function f, Sample a, Sample b, double tolerance) {
  constexpr double kRoundOff = 2.0 * std::numeric_limits<double>::epsilon();
  if (a.y == 0.0) return a.x;
  if (b.y == 0.0) return b.x;
  Sample before = a;
  for (double share = 0.5;;) {  // of the way from a to b
    const double x = a.x + share * (b.x - a.x);
    const Sample next{x, f(x)};
    before = b;
    if ((next.y > 0.0) == (a.y > 0.0)) {
      before = a;
    } else {
      b = a;
    }
    a = next;
    const Sample& best = std::abs(a.y) < std::abs(b.y) ? a : b;
    const double least = (kRoundOff * std::abs(best.x) + tolerance) / std::abs(b.x - a.x);
    if (best.y == 0.0 || !(least <= 0.5)) return best.x;
    const double xi = (a.x - b.x) / (before.x - b.x), phi = (a.y - b.y) / (before.y - b.y);
    share = 0.5;
    if (phi * phi < xi && (1.0 - phi) * (1.0 - phi) < 1.0 - xi) {
      share = a.y / (b.y - a.y) * before.y / (b.y - before.y) +
              (before.x - a.x) / (b.x - a.x) * a.y / (before.y - a.y) * b.y / (before.y - b.y);
    }
    share = std::clamp(share, least, 1.0 - least);
  }
}

}  // namespace cutwater
