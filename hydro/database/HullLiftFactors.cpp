#include "hydro/database/HullLiftFactors.h"

#include <algorithm>
#include <cmath>

namespace cutwater {

HullLiftFactors::HullLiftFactors(const CoefficientTables& coefficients, double length)
    : length_(coefficients.ship.length()), middle_(0.0) {
  const ShipParticulars& ship = coefficients.ship;
  const Mat6& A = coefficients.addedMass.atZero.isZero(0.0) ? coefficients.addedMass.atInfinity
                                                            : coefficients.addedMass.atZero;
  const double mass = ship.mass, added = std::max(A(Sway, Sway), 0.0);
  side = 2.0 * (mass + added) / length;
  turn = side > 0.0 ? 2.0 * mass * added / side : 0.0;
  depth_ = std::max(0.0, -ship.centreOfBuoyancy.z());  // of a hull that is known by numbers alone
  if (ship.wetSurface.vertices.empty()) return;
  const Bounds wet = bounds(ship.wetSurface);
  middle_ = 0.5 * (wet.low.x() + wet.high.x()) - ship.cog.x();
  depth_ = -0.5 * std::min(0.0, wet.low.z());
}

// e^{−ikx cos β} averaged over the length, and its slope by least squares, 12/L³ ∫ x · dx.
HullLiftFactors::Orbital HullLiftFactors::orbital(double omega, double waveNumber,
                                                  double heading) const {
  const double along = waveNumber * std::cos(heading), x = 0.5 * along * length_;
  const bool longWave = std::abs(x) < 1e-2;  // series, to 1e-9
  const double mean = longWave ? 1.0 - x * x / 6.0 : std::sin(x) / x;
  const double slope =
      longWave ? x / 3.0 - x * x * x / 30.0 : (std::sin(x) - x * std::cos(x)) / (x * x);
  const Complex across = -std::sin(heading) * omega * std::exp(-waveNumber * depth_) *
                         std::polar(1.0, -along * middle_);
  return {across * mean, across * Complex(0.0, -6.0 * slope / length_)};
}

void HullLiftFactors::resist(double speed, const CMat6& velocities, CMat6& system) const {
  system.row(Sway) += std::abs(speed) * side * velocities.row(Sway);
  system.row(Yaw) += std::abs(speed) * turn * velocities.row(Yaw);
}

void HullLiftFactors::push(double speed, const Orbital& water, CVec6& force) const {
  force[Sway] += std::abs(speed) * side * water.side;
  force[Yaw] += std::abs(speed) * turn * water.turn;
}

}  // namespace cutwater
