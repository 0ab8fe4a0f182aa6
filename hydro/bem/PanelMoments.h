#pragma once
#include "hydro/geometry/PanelMesh.h"

namespace cutwater {

/// Mean values of powers of the distance s from a panel's centroid, in its plane.
struct PanelMoments {
  Vec3 u, v;                     ///< axes in the plane
  std::array<double, 3> second;  ///< cumulants by falling power of u, with their binomials
  std::array<double, 4> third;
  std::array<double, 5> fourth;

  explicit PanelMoments(const Panel& panel);
  /// ln S for the complex wave vector k: ½⟨(k·s)²⟩ + …
  Complex logarithm(const Eigen::Vector3cd& k) const;
};

}  // namespace cutwater
