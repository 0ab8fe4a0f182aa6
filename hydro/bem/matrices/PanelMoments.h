#pragma once
#include "hydro/base/Simd.h"
#include "hydro/geometry/panels/PanelMesh.h"

namespace cutwater {

/// Mean values of powers of the distance s from a panel's centroid, in its plane.
/// THEORY.md, chapter 5.
struct PanelMoments {
  Vec3 u, v;                     ///< axes in the plane
  std::array<double, 3> second;  ///< cumulants by falling power of u, with their binomials
  std::array<double, 4> third;
  std::array<double, 5> fourth;

  explicit PanelMoments(const Panel& panel);
  /// ln S for the complex wave vector k: ½⟨(k·s)²⟩ + … to the fourth power.
  /// @param a, b  k·u and k·v, complex numbers or several.
  template <typename Number>
  CUTWATER_INLINE Number logarithm(const Number& a, const Number& b) const {
    const Number aa = a * a, ab = a * b, bb = b * b;
    return 0.5 * (second[0] * aa + second[1] * ab + second[2] * bb) +
           1.0 / 6.0 * (a * (third[0] * aa + third[1] * ab + third[2] * bb) + third[3] * (b * bb)) +
           1.0 / 24.0 *
               (aa * (fourth[0] * aa + fourth[1] * ab + fourth[2] * bb) +
                bb * (fourth[3] * ab + fourth[4] * bb));
  }
};

}  // namespace cutwater
