#pragma once
#include <memory>

#include "hydro/database/HullLiftFactors.h"
#include "hydro/forces/ForceGenerator.h"
#include "hydro/forces/PredictedMotion.h"

namespace cutwater {

/// What keeps a hull that makes way from sliding sideways and from spinning: the lift of hull, skeg
/// and rudder amidships, which potential flow lacks. Without it Munk's moment turns every hull
/// under way broadside within a few ship lengths.
///     Y = −e|U|(v − v_w),   N = −d|U|(r − r_w)
/// U the slow speed, v and r the ship's own leeway and turn, v_w and r_w the waves' orbital
/// velocity (HullLiftFactors.h): lift answers the velocity through the water. It is linear in what
/// has wave frequency, so that waves alone do not push by it. Y acts across the slow heading. Takes
/// energy of a ship in calm water, never gives any.
class HullLift final : public ForceGenerator {
 public:
  /// @param predicted  of the same ship.
  explicit HullLift(std::shared_ptr<const PredictedMotion> predicted)
      : predicted_(std::move(predicted)) {}
  std::string_view name() const noexcept override { return "hull_lift"; }
  Wrench evaluate(const TickInput& now) noexcept override;

 private:
  std::shared_ptr<const PredictedMotion> predicted_;
};

}  // namespace cutwater
