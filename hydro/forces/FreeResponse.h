#pragma once
#include <array>

#include "hydro/database/Coefficients.h"
#include "hydro/database/FreeMotion.h"
#include "hydro/database/HullLiftFactors.h"

namespace cutwater {

class RadiationModel;

/// Which parts of the load of a free ship act, as far as its answer to waves depends on them.
/// THEORY.md, chapter 8.
struct ActiveParts {
  bool froudeKrylov = true, diffraction = true, hullLift = true, supplementary = true;
  bool water = true;  ///< restoring, radiation and added mass, all of them
  std::array<bool, 6> restrained{};
  bool operator==(const ActiveParts&) const = default;
};

/// How a free ship answers a regular wave, as its ticks would in the long run: the free ship
/// linearised, with the fitted memory.
///     {−ω′²M + iω′B_s + C + C_s + Q + lift} ξ = F,   Q of FreeMotion.h
/// Immutable; any thread may ask. An answer costs some 3 µs.
class FreeResponse {
 public:
  /// Arguments must outlive this object.
  FreeResponse(const Coefficients& coefficients, const RadiationModel& model);

  struct Answer {
    CVec6 motion;    ///< ξ about the steady way, in its axes
    CVec6 momentum;  ///< of the water, p in axes of the ship's heading and pitch
  };
  /// @param omega ω′ [rad/s], signed, not 0.  @param force  F [N/m, N·m/m], lift of the orbital
  ///        velocity included.
  Answer at(double omega, const SteadyWay& way, const CVec6& force,
            const ActiveParts& parts) const noexcept;

  const HullLiftFactors& lift() const noexcept { return lift_; }
  const Mat6& addedMassAtRest() const noexcept { return atRest_; }  ///< A(0), of the fit
  /// Share of an answer that counts as motion about a slow one, 1 where waves are met fast:
  ///     w = ω′⁴/(ω′⁴ + ω₀⁴),   ω₀ = 0.53 √(g/L)
  /// Near ω′ = 0 the ship rides the wave, and its actual motion is its slow one.
  double share(double omega) const noexcept { return share(omega, slow_); }
  static double share(double omega, double slow) noexcept;   ///< w of an ω₀ [rad/s]
  static double slowFrequency(const ShipParticulars& ship);  ///< ω₀ [rad/s]

 private:
  const RadiationModel& model_;
  HullLiftFactors lift_;
  Mat6 mass_, stiffness_, atRest_;
  Vec6 damping_, addedStiffness_;
  double slow_;  // ω₀
};

}  // namespace cutwater
