#pragma once
#include <algorithm>
#include <cmath>

#include "hydro/database/Coefficients.h"
#include "hydro/database/FreeMotion.h"
#include "hydro/forces/ForceGenerator.h"

namespace cutwater {

/// Calm water: what carries the ship's weight at rest, and the linear hydrostatic stiffness about
/// that equilibrium.
///     F = −W − C η,   W the weight on the body                               [M03] (5), (30)
/// C holds buoyancy and weight about G. Valid for small η. Beyond a tilt of 60 degrees, far outside
/// the theory, roll and pitch in η are taken smaller by one factor, so that moments are bounded and
/// vanish upside down: about any fixed axis they have a potential, and no turn gains energy. Waves
/// and added mass of an upright hull still can feed a hull that tumbles. So beyond 45 degrees its
/// turning is braked with the square of its rate,
///     M −= c s I|ω|ω,   c = 0.3, s from 0 at 45° to 1 at 60°, I of the hull alone
/// which belongs to no theory, and keeps the spin within some radians a second.
class Restoring final : public ForceGenerator {
 public:
  /// @param free  Mean::Free: freeRestoring (FreeMotion.h).
  explicit Restoring(const ShipParticulars& ship, bool free = false)
      : stiffness_(free ? freeRestoring(ship.restoring) : ship.restoring),
        inertia_(ship.massMatrix().diagonal().tail<3>()) {}
  std::string_view name() const noexcept override { return "restoring"; }
  bool carriesWeight() const noexcept override { return true; }
  Wrench evaluate(const TickInput& now) noexcept override {
    Vec6 weight = Vec6::Zero();
    weight.head<3>() = now.weight;
    Vec6 eta = now.eta;
    const double tilt = std::hypot(eta[Roll], eta[Pitch]);
    eta.segment<2>(Roll) *= shareOfTilt(tilt);
    Vec6 load = -(stiffness_ * eta) - weight;
    if (tilt > kUprightTo) load.tail<3>() -= brake(now, tilt);
    return {load};
  }

 private:
  static constexpr double kUprightTo = kPi / 4.0, kBrakedFrom = kPi / 3.0, kBrake = 0.3;

  Vec3 brake(const TickInput& now, double tilt) const noexcept {
    Vec3 spin = now.etaDotNow.tail<3>();
    spin.z() += now.turnRate;
    const double share = std::min(1.0, (tilt - kUprightTo) / (kBrakedFrom - kUprightTo));
    // A tick never takes more than half of the spin.
    const double rate = std::min(kBrake * spin.norm(), 0.5 / now.step);
    return share * rate * inertia_.cwiseProduct(spin);
  }
  // t h with h the cubic of value a and slope 1 at a = 60°, of value and slope 0 at 180°.
  static double shareOfTilt(double tilt) noexcept {
    constexpr double kLinearTo = kPi / 3.0;
    if (!(tilt > kLinearTo)) return 1.0;
    const double s = std::min(1.0, (tilt - kLinearTo) / (kPi - kLinearTo)), rest = 1.0 - s;
    return rest * rest * (kLinearTo * (1.0 + 2.0 * s) + (kPi - kLinearTo) * s) / tilt;
  }

  Mat6 stiffness_;
  Vec3 inertia_;
};

}  // namespace cutwater
