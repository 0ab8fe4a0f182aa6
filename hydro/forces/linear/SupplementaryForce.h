#pragma once
#include "hydro/database/Coefficients.h"
#include "hydro/database/FreeMotion.h"
#include "hydro/forces/ForceGenerator.h"

namespace cutwater {

/// Damping and stiffness given as numbers, for what potential flow lacks: viscous roll damping, the
/// stiffness of a helmsman.
///     F_j = −b_j η̇_j − s_j η_j,   roll also −q |η̇₄| η̇₄                        [M03] section 9
/// Velocities are those at t_n, so that the term is second order in the tick. Damping sees the
/// motion about frame H, whose steady way it does not slow. That of roll is the water's on the
/// hull: it fades as the hull leaves the water or lies on its side. A free ship has no stiffness of
/// surge, sway and yaw: nothing in the sea holds its place. A CourseKeeper holds its heading.
class SupplementaryForce final : public ForceGenerator {
 public:
  /// @param free  Mean::Free.
  explicit SupplementaryForce(const Supplementary& terms, bool free = false) : terms_(terms) {
    if (free) terms_.stiffness = freeStiffness(terms_.stiffness);
  }
  std::string_view name() const noexcept override { return "supplementary"; }
  Wrench evaluate(const TickInput& now) noexcept override {
    Vec6 force = -terms_.damping.cwiseProduct(now.etaDotNow);
    const double roll = now.etaDotNow[Roll];
    force[Roll] -= terms_.rollDampingQuadratic * (roll < 0.0 ? -roll : roll) * roll;
    force[Roll] *= now.immersion * now.upright;
    return {force - terms_.stiffness.cwiseProduct(now.eta)};
  }

 private:
  Supplementary terms_;
};

}  // namespace cutwater
