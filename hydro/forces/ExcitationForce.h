#pragma once
#include <vector>

#include "hydro/forces/ForceGenerator.h"
#include "hydro/forces/WaveExcitation.h"
#include "hydro/waves/SeaState.h"

namespace cutwater {

/// Linear wave excitation in a sea state, one phasor per component:
///   F(t) = r(t) Re Σ_i a_i F̂_i e^{i(ω_i t − k_i(x̄ cos β_i − ȳ sin β_i) + ε_i)}
/// x̄, ȳ: mean position of G in E, so that the force stays linear in the waves; F̂_i in H at the mean
/// heading and speed; r(t) the sea's ramp. On a ship under way x̄, ȳ move with her, which makes the
/// signed encounter frequency of each phase by itself. Cost: one sine and cosine a component and 12 multiply-adds.
class ExcitationForce final : public ForceGenerator {
 public:
  /// @param meanHeading  ψ̄ [rad]: angle of the mean course from E's x axis, positive to port (about
  /// +z).
  /// @param meanSpeed    U [m/s] along it.
  /// @throws HydroError as WaveExcitation::at, naming the component.
  ExcitationForce(const Coefficients& coefficients, const SeaState& sea, double meanHeading,
                  double meanSpeed = 0.0);

  /// Froude-Krylov and diffraction together.
  Vec6 at(const ShipMotion& motion) noexcept override;
  /// The two parts of the last call.
  const Vec6& froudeKrylov() const noexcept { return froudeKrylov_; }
  const Vec6& diffraction() const noexcept { return diffraction_; }

 private:
  struct Phasor {
    double omega, phase, kx, ky;      // argument ω t + phase − kx x̄ − ky ȳ
    Vec6 fkRe, fkIm, diffRe, diffIm;  // a F̂
  };
  std::vector<Phasor> phasors_;
  SeaState sea_;
  Vec6 froudeKrylov_ = Vec6::Zero();
  Vec6 diffraction_ = Vec6::Zero();
};

}  // namespace cutwater
