#pragma once
#include <memory>

#include "hydro/forces/ForceGenerator.h"
#include "hydro/forces/ShipSettings.h"

namespace cutwater {

class RadiationMemory;
class RadiationModel;

/// Force of the waves that a ship on a fixed course radiates; −A^∞η̈ is left to the engine's solver:
///     F(t) = −∫₀^∞ K(U, τ) η̇(t − τ) dτ − b(U) η̇ − c(U) η            [M03] (30), (33), (41)-(45)
/// The memory takes TickInput::etaDot, the mean over the tick just ended, and the length of that; b
/// takes etaDotNow.
class Radiation final : public ForceGenerator {
 public:
  explicit Radiation(std::shared_ptr<const RadiationModel> model,
                     MemoryModel memory = MemoryModel::Exponential);
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
  std::shared_ptr<const RadiationModel> model_;
  std::unique_ptr<RadiationMemory> memory_;  // null before prepare()
  MemoryModel memoryModel_;
};

}  // namespace cutwater
