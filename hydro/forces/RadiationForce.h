#pragma once
#include <memory>

#include "hydro/forces/ForceGenerator.h"
#include "hydro/memory/RadiationModel.h"

namespace cutwater {

/// What answers a ship's own motion, but for −A^∞η̈, which acts through the engine's solver:
///   F(t) = −∫₀^∞ K(U, τ) η̇(t − τ) dτ − b(U) η̇ − c(U) η                    [M03] (30), (33), (41)-(45)
/// The memory takes ShipMotion::etaDot, the mean over the tick just ended; b takes etaDotNow.
///
/// About a course that turns or changes its speed (a free ship), b and c would create energy: Munk's moment
/// turns a hull that makes leeway ever faster, and linear theory, which holds her speed, does not ask where
/// the work comes from. Here it comes out of her way:
///   F₁ += U (c/U² η)·w + [(b/U) η̇]₆ r̄,   w = η̇ + r̄ e₆,  r̄ = dψ̄/dt
/// is what those loads do, over U; of second order, without mean in waves on a steady course.
class RadiationForce final : public ForceGenerator {
 public:
  /// @param step  the engine's fixed tick [s] > 0.  @param free  the course follows the ship.
  /// @throws HydroError as RadiationModel::makeMemory.
  RadiationForce(std::shared_ptr<const RadiationModel> model, double step, bool free = false);

  Vec6 at(const ShipMotion& motion) noexcept override;
  /// The part −b η̇ − c η (and F₁) of the last call.
  const Vec6& speedTerms() const noexcept { return speedTerms_; }

  /// The state: save, restore, reset.
  RadiationMemory& memory() noexcept { return *memory_; }
  const RadiationMemory& memory() const noexcept { return *memory_; }

 private:
  std::shared_ptr<const RadiationModel> model_;
  std::unique_ptr<RadiationMemory> memory_;
  bool free_;
  Vec6 speedTerms_ = Vec6::Zero();
};

}  // namespace cutwater
