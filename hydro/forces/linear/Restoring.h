#pragma once
#include <algorithm>
#include <cmath>

#include "hydro/database/Coefficients.h"
#include "hydro/forces/ForceGenerator.h"

namespace cutwater {

/// Calm water: what carries the ship's weight at rest, and the linear hydrostatic stiffness about
/// that equilibrium.
///     F = −W − C η,   W the weight on the body                               [M03] (5), (30)
/// C holds buoyancy and weight about G. Valid for small η. Beyond a tilt of 60 degrees, far outside
/// the theory, roll and pitch in η are taken smaller by one factor, so that moments are bounded and
/// vanish upside down: about any fixed axis they have a potential, and no turn gains energy.
class Restoring final : public ForceGenerator {
 public:
  explicit Restoring(const ShipParticulars& ship) : stiffness_(ship.restoring) {}
  std::string_view name() const noexcept override { return "restoring"; }
  bool carriesWeight() const noexcept override { return true; }
  Wrench evaluate(const TickInput& now) noexcept override {
    Vec6 weight = Vec6::Zero();
    weight.head<3>() = now.weight;
    Vec6 eta = now.eta;
    eta.segment<2>(Roll) *= shareOfTilt(std::hypot(eta[Roll], eta[Pitch]));
    return {-(stiffness_ * eta) - weight};
  }

 private:
  // t h with h the cubic of value a and slope 1 at a = 60°, of value and slope 0 at 180°.
  static double shareOfTilt(double tilt) noexcept {
    constexpr double kLinearTo = kPi / 3.0;
    if (!(tilt > kLinearTo)) return 1.0;
    const double s = std::min(1.0, (tilt - kLinearTo) / (kPi - kLinearTo)), rest = 1.0 - s;
    return rest * rest * (kLinearTo * (1.0 + 2.0 * s) + (kPi - kLinearTo) * s) / tilt;
  }

  Mat6 stiffness_;
};

}  // namespace cutwater
