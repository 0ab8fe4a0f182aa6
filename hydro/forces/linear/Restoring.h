#pragma once
#include "hydro/database/Coefficients.h"
#include "hydro/forces/ForceGenerator.h"

namespace cutwater {

/// Calm water: what carries the ship's weight at rest, and the linear hydrostatic stiffness about
/// that equilibrium.
///     F = −W − C η,   W the engine's own gravity on the body                 [M03] (5), (30)
/// C holds buoyancy and weight about G. Valid for small η.
class Restoring final : public ForceGenerator {
 public:
  explicit Restoring(const ShipParticulars& ship) : stiffness_(ship.restoring) {}
  std::string_view name() const noexcept override { return "restoring"; }
  bool carriesWeight() const noexcept override { return true; }
  Wrench evaluate(const TickInput& now) noexcept override {
    Vec6 weight = Vec6::Zero();
    weight.head<3>() = now.weight;
    return {-(stiffness_ * now.eta) - weight};
  }

 private:
  Mat6 stiffness_;
};

}  // namespace cutwater
