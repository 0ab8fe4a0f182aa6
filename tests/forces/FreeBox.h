#pragma once
#include "tests/excitation/TableBox.h"
#include "tests/memory/CausalShip.h"

namespace cutwater::test {

/// The box of tables, whose A and B belong to one memory that is known in closed form; coupled as a
/// hull with a centre plane is.
inline Coefficients freeBox() {
  Coefficients c = tableBox();
  const Coefficients causal = CausalShip().coefficients(0.1, 4.0);
  const double mass = 0.5 * c.ship.mass, arm = 4.0;
  const auto scaled = [&](const Mat6& m) {
    Mat6 result;
    for (int j = 0; j < 6; ++j)
      for (int k = 0; k < 6; ++k)
        result(j, k) =
            (j + k) % 2 == 1 ? 0.0 : mass * (j > 2 ? arm : 1.0) * (k > 2 ? arm : 1.0) * m(j, k);
    return result;
  };
  c.omega = causal.omega;
  for (std::size_t i = 0; i < c.omega.size(); ++i) {
    c.addedMass[i] = scaled(causal.addedMass[i]);
    c.damping[i] = scaled(causal.damping[i]);
  }
  c.addedMass.atZero = scaled(causal.addedMass.atZero);
  c.addedMass.atInfinity = scaled(causal.addedMass.atInfinity);
  c.ship.supplementary.damping << 0.0, 0.0, 0.0, 2e5, 0.0, 0.0;
  c.ship.supplementary.stiffness << 1e6, 1e6, 2e4, 1e5, 3e4, 1e7;
  return c;
}

}  // namespace cutwater::test
