#pragma once
#include <limits>
#include <memory>

#include "hydro/forces/ForceGenerator.h"
#include "hydro/forces/ShipSettings.h"

namespace cutwater {

class RadiationMemory;
class RadiationModel;

/// Where the terms of speed end. Nothing is bounded unless it is given.
struct SpeedTermBounds {
  double fastest = std::numeric_limits<double>::infinity();  ///< [m/s]
  double halfLength = 0.0;                                   ///< [m]
};

/// Force of the waves that the ship radiates; −A^∞η̈ is left to the engine's solver:
///     F(t) = −∫₀^∞ K(U, τ) η̇(t − τ) dτ − b(U) η̇ − c(U) η            [M03] (30), (33), (41)-(45)
/// The memory takes TickInput::etaDot, the mean over the tick just ended, and the length of that; b
/// takes etaDotNow.
///
/// On a course that follows the ship the terms with U would create energy: Munk's moment turns a
/// hull that makes leeway ever faster, and linear theory, which holds the speed, does not ask where
/// the work comes from. Here it comes out of the ship's way. With F = F⁰ + u f, f what the terms of
/// speed are over u, and w = η̇ + r̄ e₆, r̄ = dψ̄/dt, a surge force of second order
///     F₁ −= f·w
/// is added, so that these terms do no work in all. b, c and K are taken at u = U + η̇₁, the present
/// speed, not at the mean that lags behind. The report's form damps leeway by the lift of the
/// stern, −U∂A₂₂, which drives it going astern: there a free ship has the memory of one at rest.
/// Tuck's form holds ahead and astern.
///
/// These terms grow with the square of the motion. Where the ends of the hull move faster than
/// `fastest`, far outside the theory, they are taken smaller by the square of the ratio, so that a
/// ship that is thrown stays bounded.
class Radiation final : public ForceGenerator {
 public:
  /// @param follows  the mean course follows the ship.
  explicit Radiation(std::shared_ptr<const RadiationModel> model, bool follows = false,
                     MemoryModel memory = MemoryModel::Exponential,
                     const SpeedTermBounds& bounds = {});
  Radiation(Radiation&&) noexcept;
  ~Radiation() override;

  std::string_view name() const noexcept override { return "radiation"; }
  /// No load until a tick length is known. The sum of exponentials keeps its past.
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

 private:
  Vec6 onFixedCourse(const TickInput& now) noexcept;
  Vec6 onFollowingCourse(const TickInput& now) noexcept;

  std::shared_ptr<const RadiationModel> model_;
  std::unique_ptr<RadiationMemory> memory_;  // null before prepare()
  MemoryModel memoryModel_;
  bool follows_, aheadOnly_;
  SpeedTermBounds bounds_;
};

}  // namespace cutwater
