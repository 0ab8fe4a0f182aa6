#pragma once
#include <memory>

#include "hydro/forces/ForceGenerator.h"
#include "hydro/forces/PredictedMotion.h"

namespace cutwater {

/// One part of the linear load of a sea on a free ship, at its slow place and for its slow heading,
/// speed and leeway: PredictedMotion.h.
class FreeWaveForce final : public ForceGenerator {
 public:
  /// @param predicted  of the same ship.
  FreeWaveForce(std::shared_ptr<const PredictedMotion> predicted, WaveLoad load)
      : predicted_(std::move(predicted)), load_(load) {}
  std::string_view name() const noexcept override {
    return kWaveLoadNames[static_cast<int>(load_)];
  }
  Wrench evaluate(const TickInput& now) noexcept override {
    const PredictedMotion::Sums& sums = predicted_->now();
    if (load_ == WaveLoad::FroudeKrylov) return {sums.froudeKrylov};
    return {now.immersion * now.upright * sums.diffraction};
  }

 private:
  std::shared_ptr<const PredictedMotion> predicted_;
  WaveLoad load_;
};

}  // namespace cutwater
