#include "hydro/ship/ShipParticulars.h"

#include <algorithm>
#include <cmath>

namespace cutwater {

Mat6 ShipParticulars::massMatrix() const {
  Vec6 diagonal;
  diagonal << Vec3::Constant(mass), mass * gyradii.cwiseAbs2();
  return diagonal.asDiagonal();
}

namespace {

double lengthOf(const SurfaceMesh& mesh) {
  const Bounds box = bounds(mesh);
  return box.high.x() - box.low.x();
}

}  // namespace

double ShipParticulars::length() const {
  return wetSurface.vertices.empty() ? 5.0 * std::cbrt(std::max(volume, 1e-9))
                                     : lengthOf(wetSurface);
}

double ShipParticulars::lengthOverall() const {
  return hull.vertices.empty() ? length() : lengthOf(hull);
}

double ShipParticulars::beam() const {
  if (wetSurface.vertices.empty()) return length() / 7.0;
  const Bounds wet = bounds(wetSurface);
  return symmetric ? 2.0 * wet.high.y() : wet.high.y() - wet.low.y();
}

}  // namespace cutwater
