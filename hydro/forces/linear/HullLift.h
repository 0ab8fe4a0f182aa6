#pragma once
#include "hydro/database/HullLiftFactors.h"
#include "hydro/forces/ForceGenerator.h"

namespace cutwater {

/// What keeps a hull that makes way from sliding sideways and from spinning: the lift of hull, skeg
/// and rudder amidships, which potential flow lacks. Without it Munk's moment turns every hull
/// under way broadside within a few ship lengths.
///     Y = −e|u| v,   N = −d|u| r
/// in own axes (HullLiftFactors.h). Takes energy, never gives any.
class HullLift final : public ForceGenerator {
 public:
  /// @param length L [m] > 0.
  HullLift(const Coefficients& coefficients, double length);
  std::string_view name() const noexcept override { return "hull_lift"; }
  Wrench evaluate(const TickInput& now) noexcept override;

 private:
  HullLiftFactors lift_;
};

}  // namespace cutwater
