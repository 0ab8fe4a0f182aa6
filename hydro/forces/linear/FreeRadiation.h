#pragma once
#include <memory>

#include "hydro/forces/ForceGenerator.h"
#include "hydro/forces/OwnAxes.h"
#include "hydro/forces/PredictedMotion.h"
#include "hydro/forces/ShipSettings.h"

namespace cutwater {

class RadiationMemory;
class RadiationModel;

/// Load of the water that a free ship sets in motion, as the rate of that water's momentum in the
/// ship's own axes R (OwnAxes.h), with its full velocities ν there:
///     p = A^∞ν + q,   q = ∫₀^∞ L⁰(τ) ν(t − τ) dτ,   L⁰(τ) = ∫₀^τ K⁰
///     force = −d(R p_F)/dt,   moment = −d(R p_M)/dt − V × R p_F
/// where the own x part of both cross terms is left out, as R does not roll. Nothing here is slow
/// or filtered, so that the cross terms do no work and the force has no mean. This part has the
/// terms of q; those of A^∞ν, one of them by the engine's solver, are the part added_mass. The mean
/// yaw moment of V × R p_F in waves, of second order, is taken off as the ship's predicted motion
/// has it, and so is the steady trim of its way.               THEORY.md, chapter 8
/// A hull that is immersed by a share s drives the memory by sν and feels s times its force: in
/// both places, so that the waves it has radiated never push it more than it has pushed them.
///
/// Loads are differences of momenta half a tick apart from t_n: over any run they add up to what is
/// left in the water, exactly.
class FreeRadiation final : public ForceGenerator {
 public:
  /// @param predicted  of the same ship.
  /// @param limits  of its cross terms; those of the ship's A^∞ are the same.
  FreeRadiation(std::shared_ptr<const RadiationModel> model,
                std::shared_ptr<const PredictedMotion> predicted,
                MemoryModel memory = MemoryModel::Exponential);
  ~FreeRadiation() override;

  std::string_view name() const noexcept override { return "radiation"; }
  /// @throws HydroError as RadiationModel::makeMemory.
  void prepare(double step) override;
  bool needsFixedTicks() const noexcept override {
    return memoryModel_ == MemoryModel::Convolution;
  }
  Wrench evaluate(const TickInput& now) noexcept override;
  void reset() noexcept override;
  std::size_t stateSize() const noexcept override;
  void save(std::span<double> state) const noexcept override;
  bool fits(std::span<const double> state) const noexcept override;
  void restore(std::span<const double> state) noexcept override;

  /// q, in the axes of the last tick's solve.
  const Vec6& momentum() const noexcept { return momentum_; }
  /// The same as the next tick will find it if the ship was given this way since the last one.
  /// @param steady  u, v [m/s], r [rad/s] in own axes.
  Vec6 momentumOf(const Vec3& steady) const noexcept;

 private:
  static constexpr std::size_t kOwnState = 6 + 3 + 1;
  void begin(const TickInput& now) noexcept;
  double steadyTrim(const TickInput& now) const noexcept;
  double meanYaw(const TickInput& now) const noexcept;

  std::shared_ptr<const RadiationModel> model_;
  std::shared_ptr<const PredictedMotion> predicted_;
  std::unique_ptr<RadiationMemory> memory_;  // null before prepare()
  MemoryModel memoryModel_;
  Vec6 momentum_ = Vec6::Zero();  // q
  Vec3 steady_ = Vec3::Zero();    // s times slow u, v, r of the last tick
  double immersion_ = 1.0;        // s then; found anew by each tick
  bool begun_ = false;            // has a past
};

}  // namespace cutwater
