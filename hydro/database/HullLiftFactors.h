#pragma once
#include "hydro/database/Coefficients.h"

namespace cutwater {

/// Lift of a hull that makes way, linear in leeway v and rate of turn r, in own axes:
///     Y = −e|u| v,   N = −d|u| r,   e = 2(m + a₂₂)/L,   d = 2 m a₂₂/e,   a = A(0)
/// With this e leeway dies within half a ship length. d is twice what keeps a straight run stable,
/// e d > m a₂₂; for a frigate of 124 m it is 1.0·10⁸ N·m·s/rad per m/s, as regression of model
/// tests has it [Clarke, Gedling & Hine 1983].
struct HullLiftFactors {
  double side = 0.0;  ///< e [kg/m]
  double turn = 0.0;  ///< d [kg·m]

  /// @param length L [m] > 0.
  HullLiftFactors(const CoefficientTables& coefficients, double length);
};

}  // namespace cutwater
