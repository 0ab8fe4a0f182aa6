#pragma once
#include <cmath>
#include <sstream>
#include <string>

#include "hydro/Conventions.h"
#include "hydro/Errors.h"

namespace cutwater {

inline constexpr double kDegree = kPi / 180.0;  ///< [rad]

/// Largest angles that a program may give: a turn for headings, half a turn for attitudes. Of what
/// is larger nearly all is degrees. The margin is for 360 times π/180.
inline constexpr double kTurn = 2.0 * kPi * (1.0 + 1e-12), kHalfTurn = kPi * (1.0 + 1e-12);

/// Refuses an angle beyond ±`largest` [rad].
/// @param field  begins the message: function and field.
/// @throws HydroError ValueOutOfRange, naming field, value and bounds.
inline void requireRadians(const std::string& field, double value, double largest) {
  if (std::abs(value) <= largest) return;
  std::ostringstream line;
  line << field << " = " << value << ": must be finite and in " << -largest << ".." << largest
       << " radians";
  if (std::isfinite(value)) line << "; did you mean degrees?";
  throw HydroError(Fault::ValueOutOfRange, line.str());
}

}  // namespace cutwater
