#pragma once
#include <array>
#include <memory>

#include "hydro/forces/ForceGenerator.h"
#include "hydro/forces/WettedHull.h"

namespace cutwater {

/// Pressure of the undisturbed waves on the hull as it lies in them: buoyancy and Froude-Krylov
/// force in one, for any attitude, up to the actual surface. It takes the place of the linear
/// restoring force and of F_I; the weight is the part `gravity`. So the ship floats where its
/// weight and its hull say, turns over where it has no stability, and falls where it is out of the
/// water.                                                                     [M03] section 10
class WettedPressure final : public ForceGenerator {
 public:
  /// @param hull  of the same ship, which looks at it before this part is asked.
  explicit WettedPressure(std::shared_ptr<const WettedHull> hull) : hull_(std::move(hull)) {}
  std::string_view name() const noexcept override { return "wetted_pressure"; }
  bool carriesWeight() const noexcept override { return true; }
  std::span<const std::string_view> replaces() const noexcept override { return kReplaces; }
  Wrench evaluate(const TickInput& /*now*/) noexcept override {
    return {hull_->load(), Axes::Earth};
  }

 private:
  static constexpr std::array<std::string_view, 2> kReplaces{"restoring", "froude_krylov"};
  std::shared_ptr<const WettedHull> hull_;
};

}  // namespace cutwater
