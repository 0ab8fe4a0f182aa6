#pragma once
#include <array>
#include <span>
#include <vector>

#include "hydro/waves/SeaState.h"

namespace cutwater {

/// How the water of a sea moves at many places at once, beside small bodies there.
///     u = r Σ ωa e^{kz} (cos β cos θ, −sin β cos θ, −sin θ)                    linear, deep water
/// and its gradient ∂u_i/∂x_j, which is symmetric and has no trace. z is taken as the sea's profile
/// has it: not above the surface (Extrapolated), from the surface (Wheeler), not above calm water
/// (Constant). One object for each thread. Allocates in its constructor only.
class FloatWater {
 public:
  explicit FloatWater(const SeaState& sea);

  struct Place {
    Vec3 at = Vec3::Zero();  ///< in E [m]
    /// R [m]: of a wave that is short beside it, kR > 1, the gradient is taken 1/(kR) times, so
    /// that at R it never says more than the wave's own velocity.
    double reach = 0.0;
  };
  struct Motion {
    Vec3 velocity = Vec3::Zero();  ///< in E [m/s]
    Mat3 gradient = Mat3::Zero();  ///< in E [1/s]
    /// (v·∇)v in E [m/s²], which the pressure of linear waves lacks; 0 of a steep wave, whose
    /// pressure has it.
    Vec3 convective = Vec3::Zero();
  };
  /// @pre Both have one length.  O(places × components).
  void motion(double time, std::span<const Place> places, std::span<Motion> water) noexcept;

 private:
  struct Wave {
    double k = 0.0, kx = 0.0, ky = 0.0, amplitude = 0.0, speed = 0.0, phase = 0.0;
    double alongX = 0.0, alongY = 0.0;
  };
  struct alignas(32) Four {
    double sine[4], cosine[4];
  };
  /// Of four places.
  struct alignas(32) Block {
    double x[4], y[4], z[4], reach[4];
    double sums[8][4];  // u, v, w, u_x, u_y, v_y, u_z, v_z
  };
  void motionOfSteep(double time, std::span<const Place> places,
                     std::span<Motion> water) const noexcept;
  static void sum(std::span<const Wave> waves, WaveProfile profile, Four* phasors,
                  Block& block) noexcept;

  SeaState sea_;
  std::vector<Wave> waves_;
  std::vector<Four> phasors_;
};

}  // namespace cutwater
