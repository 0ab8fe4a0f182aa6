#pragma once
#include <cstddef>

namespace cutwater {

/// A quantity as atRest + U linear + U² squared: K, its transform, its force.   [M03] (33), (36)
template <class T>
struct SpeedParts {
  T atRest, linear, squared;

  T at(double speed) const { return atRest + speed * (linear + speed * squared); }
  /// By the power of U, 0 to 2.
  const T& operator[](std::size_t power) const {
    return power == 0 ? atRest : power == 1 ? linear : squared;
  }
  T& operator[](std::size_t power) { return power == 0 ? atRest : power == 1 ? linear : squared; }
};

}  // namespace cutwater
