#pragma once
#include "hydro/database/Coefficients.h"
#include "hydro/forces/ForceGenerator.h"

namespace cutwater {

/// What keeps a hull that makes way from sliding sideways and from spinning: the lift of hull, skeg
/// and rudder amidships, which potential flow lacks. Without it Munk's moment turns every hull
/// under way broadside within a few ship lengths.
///     Y = −e|u| v,   N = −d|u| r,   e = 2(m + a₂₂)/L,   d = 2 m a₂₂/e,   a = A(0)
/// in own axes. With this e leeway dies within half a ship length. d is twice what keeps a straight
/// run stable, e d > m a₂₂; for a frigate of 124 m it is 1.0·10⁸ N·m·s/rad per m/s, as regression
/// of model tests has it [Clarke, Gedling & Hine 1983]. Takes energy, never gives any.
class HullLift final : public ForceGenerator {
 public:
  /// @param length L [m] > 0.
  HullLift(const Coefficients& coefficients, double length);
  std::string_view name() const noexcept override { return "hull_lift"; }
  Wrench evaluate(const TickInput& now) noexcept override;

 private:
  double side_, turn_;  // e [kg/m], d [kg·m]
};

}  // namespace cutwater
