#include "hydro/database/HullLiftFactors.h"

#include <algorithm>

namespace cutwater {

HullLiftFactors::HullLiftFactors(const CoefficientTables& coefficients, double length) {
  const Mat6& A = coefficients.addedMass.atZero.isZero(0.0) ? coefficients.addedMass.atInfinity
                                                            : coefficients.addedMass.atZero;
  const double mass = coefficients.ship.mass, added = std::max(A(Sway, Sway), 0.0);
  side = 2.0 * (mass + added) / length;
  turn = side > 0.0 ? 2.0 * mass * added / side : 0.0;
}

}  // namespace cutwater
