#include "hydro/ship/ShipParticulars.h"

namespace cutwater {

Mat6 ShipParticulars::massMatrix() const {
  Vec6 diagonal;
  diagonal << Vec3::Constant(mass), mass * gyradii.cwiseAbs2();
  return diagonal.asDiagonal();
}

}  // namespace cutwater
