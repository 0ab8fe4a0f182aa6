#pragma once
#include "hydro/database/Coefficients.h"
#include "hydro/forces/ForceGenerator.h"

namespace cutwater {

/// Linear hydrostatic stiffness about the equilibrium: F = −C η              [M03] (5), (30)
/// C holds buoyancy and weight about G. The equilibrium part, ρgV up = m g up, is left to the
/// caller, who cancels the engine's own gravity with it exactly. Valid for small η; replaced by the
/// pressure on the wetted hull in nonlinear mode.
class RestoringForce final : public ForceGenerator {
 public:
  explicit RestoringForce(const Coefficients& coefficients)
      : stiffness_(coefficients.ship.restoring) {}
  Vec6 at(const ShipMotion& motion) noexcept override { return -(stiffness_ * motion.eta); }

 private:
  Mat6 stiffness_;
};

}  // namespace cutwater
