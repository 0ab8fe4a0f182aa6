#pragma once
#include <array>
#include <span>
#include <vector>

#include "hydro/Conventions.h"

namespace cutwater {

/// Waves: one regular wave, or a sum of them.
///     const SeaState sea({{.omega = 0.6, .amplitude = 1.5, .heading = kPi}}, kStandardGravity);
///     const double height = sea.elevation(10.0, 0.0, 0.0);  // [m] at t = 10 s in the origin
///     Seaway seaway(world, sea);                             // plugin/Seaway.h
/// Irregular seas are made by makeSeaState (Spectrum.h).

/// One regular wave of small amplitude in deep water:
///   ζ = a cos(ωt − k(x cos β − y sin β) + ε), k = ω²/g, x, y in earth axes E.
struct WaveComponent {
  double omega = 0.0;      ///< ω_I [rad/s] > 0
  double amplitude = 0.0;  ///< a [m]
  double phase = 0.0;      ///< ε [rad]
  double heading = 0.0;    ///< β [rad], −2π..2π: travels towards (cos β, −sin β) in E
};

/// Dynamic pressure of a sea at height z above calm water, over ρg and the ramp, for ζ = Σ a cos θ:
///   Extrapolated  Σ a e^{kz} cos θ, above calm water as well: linear theory as it is written
///   Wheeler       Σ a e^{k(z − ζ)} cos θ: ζ itself at the surface, so that p = 0 there
///   Constant      Σ a e^{k min(z, 0)} cos θ
enum class WaveProfile { Extrapolated, Wheeler, Constant };
inline constexpr std::array kWaveProfileNames{"extrapolated", "wheeler", "constant"};

/// e^{iθ} of four waves, θ = ωt − k(x cos β − y sin β) + ε: what every linear wave load is a sum
/// over.
struct alignas(32) Phasors4 {
  double re[4], im[4];
};

/// A sum of regular waves, grown smoothly from rest over `ramp` seconds. Immutable.
class SeaState {
 public:
  /// Calm water.
  SeaState() = default;
  /// @param gravity [m/s²] > 0.  @param ramp [s] ≥ 0: factor ½(1 − cos πt/ramp) until then, 1
  /// after.
  /// @param profile  of the pressure on a wetted hull; linear wave loads have none.
  /// @throws HydroError ValueOutOfRange naming the component and value.
  SeaState(std::vector<WaveComponent> components, double gravity, double ramp = 0.0,
           WaveProfile profile = WaveProfile::Extrapolated);

  std::span<const WaveComponent> components() const noexcept { return components_; }
  double gravity() const noexcept { return gravity_; }
  /// Wave number of component i [1/m].
  double waveNumber(std::size_t i) const noexcept { return waveNumber_[i]; }
  WaveProfile profile() const noexcept { return profile_; }
  double rampTime() const noexcept { return ramp_; }  ///< [s]
  /// Growth factor at time t [s], 0..1.
  double ramp(double t) const noexcept;
  /// ζ [m] at time t [s] and earth position x, y [m]. No allocation; O(components).
  double elevation(double t, double x, double y) const noexcept;
  /// How many Phasors4 hold all components; those of the last that are no component are e^{0}.
  std::size_t phasorBlocks() const noexcept { return blocks_.size(); }
  /// Phasors of all components at time t and x, y, in their order. No allocation; O(components).
  /// @pre out.size() == phasorBlocks().
  void phasors(double t, double x, double y, std::span<Phasors4> out) const noexcept;
  /// ζ [m] of such phasors, but for the ramp.
  double elevation(std::span<const Phasors4> phasors) const noexcept;
  /// Velocity of the water [m/s] in E at x, y and z ≤ 0 (above calm water: that at z = 0); the
  /// linear theory of deep water. No allocation; O(components).
  Vec3 velocity(double t, const Vec3& place) const noexcept;

 private:
  struct Block {  // of four components; 0 where there is none
    double omega[4]{}, phase[4]{}, kx[4]{}, ky[4]{}, amplitude[4]{};
  };
  static double sumOfWaves(std::span<const Block> blocks, double t, double x, double y) noexcept;
  static void phasorsOf(std::span<const Block> blocks, double t, double x, double y,
                        Phasors4* out) noexcept;

  std::vector<WaveComponent> components_;
  std::vector<double> waveNumber_;
  std::vector<Block> blocks_;
  double gravity_ = kStandardGravity;
  double ramp_ = 0.0;
  WaveProfile profile_ = WaveProfile::Extrapolated;
};

}  // namespace cutwater
