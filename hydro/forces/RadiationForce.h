#pragma once
#include "hydro/database/Coefficients.h"
#include "hydro/forces/ForceGenerator.h"
#include "hydro/memory/Convolution.h"

namespace cutwater {

/// Force of the waves the ship has radiated: F(t) = −∫₀^∞ K(τ) η̇(t − τ) dτ     [M03] (30)
/// The instantaneous part −A^∞ η̈ is not here: it acts through the engine's solver.
/// Takes ShipMotion::etaDot, the mean over the tick just ended, once per tick.
class RadiationForce final : public ForceGenerator {
 public:
  /// @param step  the engine's fixed tick [s] > 0.
  /// @throws HydroError as RetardationMatrix and Convolution.
  RadiationForce(const Coefficients& coefficients, double step);
  Vec6 at(const ShipMotion& motion) noexcept override { return memory_.advance(motion.etaDot); }

  /// The state: save, restore, reset.
  Convolution& memory() noexcept { return memory_; }
  const Convolution& memory() const noexcept { return memory_; }

 private:
  Convolution memory_;
};

}  // namespace cutwater
