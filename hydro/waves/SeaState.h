#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "hydro/Conventions.h"
#include "hydro/waves/StokesWave.h"

namespace cutwater {

/// Waves in deep water: one regular wave, or a sum of them.
///     const SeaState sea({{.omega = 0.6, .amplitude = 1.5, .heading = kPi}}, kStandardGravity);
///     const double height = sea.elevation(10.0, 0.0, 0.0);  // [m] at t = 10 s in the origin
///     Seaway seaway(world, sea);                             // plugin/Seaway.h
/// Irregular seas are made by makeSeaState (Spectrum.h), a steep regular wave by SeaState::steep.
/// What there is at many points, in one call: WaterMotion.h.

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

/// Components of one sea that are components of another.
struct SharedWaves {
  std::size_t first = 0, count = 0;  ///< in the sea that was
  std::size_t to = 0;                ///< the first of them in the sea that comes
};

/// Motion of the water at a point, in E.
struct OrbitalMotion {
  Vec3 velocity = Vec3::Zero();      ///< [m/s]
  Vec3 acceleration = Vec3::Zero();  ///< ∂v/∂t [m/s²], at a place that stays
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
  /// One steep regular wave, of second or fifth order in its steepness (StokesWave.h): a higher
  /// crest, a flatter trough, and longer than the wave of first order with the same ω. Its pressure
  /// is Bernoulli's, up to its surface; it has no profile. Linear wave loads are those of its first
  /// harmonic at height a.
  /// @param order  1, 2 or 5.
  /// @throws HydroError ValueOutOfRange as above, or naming the order, or a wave that would break.
  static SeaState steep(const WaveComponent& wave, double gravity, int order, double ramp = 0.0);

  std::span<const WaveComponent> components() const noexcept { return components_; }
  double gravity() const noexcept { return gravity_; }
  /// Wave number of component i [1/m].
  double waveNumber(std::size_t i) const noexcept { return waveNumber_[i]; }
  WaveProfile profile() const noexcept { return profile_; }
  /// 1, or that of a steep wave.
  int order() const noexcept { return order_; }
  /// A steep wave's series; absent: a sum of waves of first order.
  const std::optional<StokesWave>& stokes() const noexcept { return stokes_; }
  /// Hash of all that it is: another number for another sea, the same in every process.
  std::uint64_t key() const noexcept;
  double rampTime() const noexcept { return ramp_; }  ///< [s]; 0 of a sea that goes over

  /// This sea until `from` [s], `next` from `from` + `seconds` on; between the two both, with
  /// amplitudes times cos ½πq and sin ½πq, q = 10s³ − 15s⁴ + 6s⁵, s = 0..1. So seas that know
  /// nothing of one another keep their energy. Components: this one's, then those of `next`.
  /// @param seconds  > 0.
  /// @throws HydroError BadArgument: gravities or profiles differ, or one of the two is steep and
  ///         the other no calm water, or more than kMostLayers seas would be there at once;
  ///         ValueOutOfRange: from, seconds.
  SeaState goingOver(const SeaState& next, double from, double seconds) const;
  /// Internal: sets `from` of the last goingOver() anew, for all copies. Seaway calls it once,
  /// before any other thread sees the sea.
  void goesOverFrom(double from) const noexcept;
  static constexpr std::size_t kMostLayers = 8;
  /// Growth of component i at time t [s], 0..1: its amplitude there is that times a.
  double growth(std::size_t i, double t) const noexcept;
  /// Growth of each of the seas that this one is made of, and amplitude a of component i with it:
  /// for who needs all components at one time.
  using Growths = std::array<double, kMostLayers>;
  Growths growths(double t) const noexcept;
  double amplitude(std::size_t i, const Growths& growths) const noexcept {
    return growths[layerOf_[i]] * components_[i].amplitude;
  }
  /// Growth of all at once, where that is one factor, 0..1; 1 of a sea that goes over, whose
  /// phasors have their growth in them.
  double ramp(double t) const noexcept;

  /// ζ [m] at time t [s] and earth position x, y [m]. No allocation; O(components).
  double elevation(double t, double x, double y) const noexcept;
  /// How many Phasors4 hold all components; those of the last that are no component are e^{0}.
  std::size_t phasorBlocks() const noexcept { return blocks_.size(); }
  /// Phasors of all components at time t and x, y, in their order; the loads that they make are to
  /// be multiplied by ramp(t). No allocation; O(components).
  /// @pre out.size() == phasorBlocks().
  void phasors(double t, double x, double y, std::span<Phasors4> out) const noexcept;
  /// ζ [m] at time t of such phasors.
  double elevation(std::span<const Phasors4> phasors, double t) const noexcept;
  /// The water's motion at x, y, z in E, z above calm water: linear theory, above calm water that
  /// at z = 0; of a steep wave its own, up to its surface. No allocation; O(components).
  OrbitalMotion motion(double t, const Vec3& place) const noexcept;
  Vec3 velocity(double t, const Vec3& place) const noexcept { return motion(t, place).velocity; }

 private:
  struct Block {  // of four components; 0 where there is none
    double omega[4]{}, phase[4]{}, kx[4]{}, ky[4]{}, amplitude[4]{}, k[4]{};
    std::uint8_t layer[4]{};
  };
  struct Change {
    double from = 0.0, seconds = 1.0;  // [s]
    double angle(double t) const noexcept;
  };
  /// One of the seas of which this one is made: how it grows, comes and goes.
  struct Layer {
    double ramp = 0.0;
    std::shared_ptr<const Change> comes, goes;  // null: it always was, it stays
    double growth(double t) const noexcept;
  };
  void fillBlocks();
  double phaseOfSteep(double t, double x, double y) const noexcept;
  static double sumOfWaves(std::span<const Block> blocks, const Growths& growths, double t,
                           double x, double y) noexcept;
  static void phasorsOf(std::span<const Block> blocks, double t, double x, double y,
                        Phasors4* out) noexcept;
  static OrbitalMotion motionOf(std::span<const Block> blocks, const Growths& growths, double t,
                                const Vec3& place) noexcept;

  std::vector<WaveComponent> components_;
  std::vector<double> waveNumber_;
  std::vector<std::uint8_t> layerOf_;  // of each component
  std::vector<Block> blocks_;
  std::vector<Layer> layers_;       // none: one sea, that grows by `ramp_`
  std::shared_ptr<Change> change_;  // the last one
  double gravity_ = kStandardGravity;
  double ramp_ = 0.0;
  WaveProfile profile_ = WaveProfile::Extrapolated;
  int order_ = 1;
  std::optional<StokesWave> stokes_;
};

}  // namespace cutwater
