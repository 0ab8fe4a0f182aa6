#pragma once
#include <memory>

#include "hydro/forces/ForceGenerator.h"
#include "hydro/memory/RadiationModel.h"

namespace cutwater {

/// What answers a ship's own motion, but for −A^∞η̈, which acts through the engine's solver:
///   F(t) = −∫₀^∞ K(U, τ) η̇(t − τ) dτ − b(U) η̇ − c(U) η                    [M03] (30), (33), (41)-(45)
/// The memory takes ShipMotion::etaDot, the mean over the tick just ended; b takes etaDotNow.
///
/// About a course that turns or changes its speed (a free ship), the terms with U would create energy:
/// Munk's moment turns a hull that makes leeway ever faster, and linear theory, which holds her speed, does
/// not ask where the work comes from. Here it comes out of her way. With F = F⁰ + u f, f what the terms of
/// speed are over u, and w = η̇ + r̄ e₆, r̄ = dψ̄/dt, a surge force
///   F₁ −= f·w
/// is added, of second order, so that they do no work in all. For it to be so at every instant b, c and
/// K are taken at u = U + η̇₁, the speed she has, not the mean that lags behind. The report's form damps
/// leeway by the lift of the stern, −U∂A₂₂, which turns into the opposite going astern: it is for going
/// ahead, and a free ship going astern has the memory of one at rest. Tuck's form takes either way.
class RadiationForce final : public ForceGenerator {
 public:
  /// @param step  the engine's fixed tick [s] > 0.  @param free  the course follows the ship.
  /// @throws HydroError as RadiationModel::makeMemory.
  RadiationForce(std::shared_ptr<const RadiationModel> model, double step, bool free = false);

  Vec6 at(const ShipMotion& motion) noexcept override;
  /// The state: save, restore, reset.
  RadiationMemory& memory() noexcept { return *memory_; }
  const RadiationMemory& memory() const noexcept { return *memory_; }

 private:
  Vec6 onFixedCourse(const ShipMotion& motion) noexcept;
  Vec6 onFreeCourse(const ShipMotion& motion) noexcept;

  std::shared_ptr<const RadiationModel> model_;
  std::unique_ptr<RadiationMemory> memory_;
  bool free_, aheadOnly_;
};

}  // namespace cutwater
