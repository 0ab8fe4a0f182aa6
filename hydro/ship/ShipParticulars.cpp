#include "hydro/ship/ShipParticulars.h"

#include <cmath>

namespace cutwater {

Mat6 ShipParticulars::massMatrix() const {
  Vec6 diagonal;
  diagonal << Vec3::Constant(mass), mass * gyradii.cwiseAbs2();
  return diagonal.asDiagonal();
}

double ShipParticulars::length() const {
  if (wetSurface.vertices.empty()) return std::cbrt(volume);
  const Bounds wet = bounds(wetSurface);
  return wet.high.x() - wet.low.x();
}

double ShipParticulars::beam() const {
  if (wetSurface.vertices.empty()) return 0.1 * length();
  const Bounds wet = bounds(wetSurface);
  return symmetric ? 2.0 * wet.high.y() : wet.high.y() - wet.low.y();
}

}  // namespace cutwater
