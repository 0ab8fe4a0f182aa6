#pragma once
#include <cmath>

#include "hydro/database/Coefficients.h"
#include "hydro/geometry/shapes/Shapes.h"
#include "hydro/ship/Afloat.h"

namespace cutwater::test {

inline constexpr double kBoxGravity = 9.81, kBoxDensity = 1000.0;

// A box 20 × 6 × 2 m with given A and B: no solver is needed to test what forces do with them.
inline Coefficients boxShip(const Vec3& cog = Vec3(0.5, 0.0, 0.3)) {
  Coefficients c;
  c.forwardSpeed = ForwardSpeedForm::Report;
  c.ship = afloat({{}, wetBox({20.0, 6.0, 2.0, 1.0}, 16, 4, 3), true},
                  {.cog = cog, .gyradii = Vec3(2.0, 5.0, 5.0)}, {kBoxDensity, kBoxGravity})
               .ship;
  for (int i = 1; i <= 40; ++i) {
    const double omega = 0.1 * i;
    c.omega.push_back(omega);
    c.addedMass.values.push_back(c.ship.mass * (0.8 + 0.3 / (1.0 + omega * omega)) *
                                 Mat6::Identity());
    c.damping.values.push_back(c.ship.mass * omega * omega * std::exp(-omega) * Mat6::Identity());
    // b_j ∝ ω of the panel's area: a diffraction force that is known in closed form below.
    c.adjoint.values.push_back(Eigen::Matrix<Complex, 6, Eigen::Dynamic>::Constant(
        6, static_cast<Eigen::Index>(c.ship.wetSurface.faces.size()),
        Complex(0.0, kBoxDensity * omega)));
  }
  c.addedMass.atZero = 1.1 * c.ship.mass * Mat6::Identity();
  c.addedMass.atInfinity = 0.8 * c.ship.mass * Mat6::Identity();
  return c;
}

}  // namespace cutwater::test
