#pragma once
#include <span>

#include "hydro/Conventions.h"

namespace cutwater {

/// Integrals of 1/r over one flat panel, r = |x − ξ|, ξ on the panel.
struct RankineIntegrals {
  double potential = 0.0;        ///< ∫ 1/r dS [m]
  Vec3 gradient = Vec3::Zero();  ///< ∇_x ∫ 1/r dS [–]; on the panel itself the normal part is 0 (principal value)
  double doubleLayer = 0.0;      ///< ∫ ∂/∂n_ξ (1/r) dS = −n·gradient [–]: the signed solid angle
};

/// Exact for a flat polygon of 3 or 4 corners, counter-clockwise about n; multipole forms far away.
RankineIntegrals rankineIntegrals(const Vec3& x, std::span<const Vec3> corner);

}  // namespace cutwater
