#pragma once
#include <limits>
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
/// THEORY.md, chapter 8.
class HullLift final : public ForceGenerator {
 public:
  /// @param predicted  of the same ship.
  /// @param fastest  |U| [m/s] beyond which lift grows no more: a ship that is thrown is far
  ///        outside the theory, and a tick must be able to bear it.
  explicit HullLift(std::shared_ptr<const PredictedMotion> predicted,
                    double fastest = std::numeric_limits<double>::infinity())
      : predicted_(std::move(predicted)), fastest_(fastest) {}
  std::string_view name() const noexcept override { return "hull_lift"; }
  Wrench evaluate(const TickInput& now) noexcept override;

 private:
  std::shared_ptr<const PredictedMotion> predicted_;
  double fastest_;
};

}  // namespace cutwater
