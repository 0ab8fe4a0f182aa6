#pragma once
#include <span>
#include <string_view>

#include "hydro/Conventions.h"
#include "hydro/waves/SeaState.h"

/// A load of your own on a ship, in three steps: derive from ForceGenerator, give it a name, return
/// a Wrench from evaluate(); then
///     ship.addForce(std::make_unique<Wind>(20.0));
/// and it is part of every tick, of snapshots, of the CSV (columns wind_F1 … wind_F6), and can be
/// switched off by that name.
namespace cutwater {

/// The axes in which the six numbers of a load are given. The point is always G.
enum class Axes {
  /// Force in H. Moment as generalised forces of roll, pitch and yaw: its parts about the own
  /// x axis, about the level y axis of the heading, and about the vertical (first-order theory).
  Course,
  Earth,  ///< E
  Own     ///< B, fixed to the hull
};

/// Force [N] and moment about G [N·m], and their axes.
struct Wrench {
  Vec6 load = Vec6::Zero();
  Axes axes = Axes::Course;
};

/// What a part of the load may know at the start of a tick. SI units and radians. Velocities with
/// "Now" are those at t_n, extrapolated to second order in the tick.
struct TickInput {
  double time = 0.0;  ///< t_n [s]
  double step = 0.0;  ///< length of the tick [s]
  /// Length of the tick that ended at t_n [s]; before the first one as `step`. Ticks may vary.
  double lastStep = 0.0;

  // The ship as it is.
  Vec3 position = Vec3::Zero();      ///< G in E [m]
  Mat3 attitude = Mat3::Identity();  ///< R_EB: v_E = R_EB v_B
  Vec6 velocityNow = Vec6::Zero();   ///< u, v, w [m/s], p, q, r [rad/s] in B
  Vec3 weight = Vec3::Zero();        ///< Bullet's gravity on the body, in H [N]
  Vec3 gravity = Vec3::Zero();       ///< the world's, in H [m/s²]

  // The same in axes along the ship's heading and pitch, but not its roll (OwnAxes.h).
  Mat3 ownAxes = Mat3::Identity();        ///< v_E = R v, as they will be at t_n + h/2
  Mat3 ownAxesBefore = Mat3::Identity();  ///< those of the tick that ended at t_n
  Vec6 ownVelocity = Vec6::Zero();        ///< mean over that tick, in those
  Vec6 ownVelocityNow = Vec6::Zero();     ///< at t_n, in the axes of t_n
  double turningShare = 1.0;  ///< of the turning of momentum, 1 within the theory (TurningLimits)

  // Frame H. On a fixed course it moves along it. A free ship's is its slow motion: the actual one
  // less the motion with which linear theory has the ship answer the waves; no filter. In calm
  // water that is the ship's own place, heading and velocity at t_n.
  double meanX = 0.0, meanY = 0.0;  ///< place of G in E [m]: here the waves are taken
  double meanHeading = 0.0;         ///< ψ̄ [rad]: x axis of H from that of E, about +z
  double speed = 0.0;               ///< U [m/s] along that axis
  double leeway = 0.0;              ///< V [m/s] across it, to port; 0 on a fixed course
  double turnRate = 0.0;            ///< dψ̄/dt [rad/s]; η̇₆ is the turning beyond it
  bool courseBegins = false;  ///< the course was set anew since the last tick: it did not come here

  // The motion about H, in H; rotations are those of R_z(ψ̄ + η₆) R_y(η₅) R_x(η₄).
  Vec6 eta = Vec6::Zero();     ///< surge, sway, heave of G [m]; roll, pitch, yaw [rad]
  Vec6 etaDot = Vec6::Zero();  ///< η̇ [m/s]; rates about own x, level y, own z [rad/s]: means over
                               ///< the tick that ended at t_n
  Vec6 etaDotNow = Vec6::Zero();  ///< the same at t_n

  // How far the linear theory of an upright, immersed hull holds for what it says of waves: 1 with
  // linear hydrostatics, which know no other hull (Ship.h).
  double immersion = 1.0;       ///< s, 0 out of the water .. 1 as deep as at rest or deeper
  double deckUnderWater = 0.0;  ///< more of the hull's wet surface that faces up than at rest [m²]
  double upright = 1.0;         ///< 1 to a tilt of 45°, 0 from 90° on; less under water

  // The water.
  const SeaState* sea = nullptr;      ///< waves; null: calm water
  double ramp = 1.0;                  ///< growth factor of the waves at t_n, 0..1
  std::span<const Phasors4> phasors;  ///< SeaState::phasors at t_n and the mean place
};

/// One part of the load on a ship: radiation, a rudder, wind. Parts do not know each other.
/// Acceleration is no input, so added mass cannot be a part: plugin/AddedMassConstraint.h carries
/// it.
class ForceGenerator {
 public:
  virtual ~ForceGenerator() = default;
  /// "radiation": key of queries, prefix of CSV columns. The same for the part's whole life;
  /// letters, digits and _ only.
  virtual std::string_view name() const noexcept = 0;
  /// The load at t_n. Called once a tick, in order of time; may advance the part's own state.
  /// Allocates nothing. A load that is not finite is left out of that tick and reported.
  virtual Wrench evaluate(const TickInput& now) noexcept = 0;

  /// Makes what depends on the length of the tick [s]: before the first tick, and when it changes
  /// for a part that needs fixed ticks. May allocate.  @throws HydroError.
  virtual void prepare(double /*step*/) {}
  /// True: the part must be prepared anew for ticks of another length, and its past is lost; the
  /// tick then raises kTickLengthChanged. False: it takes TickInput::step as it comes.
  virtual bool needsFixedTicks() const noexcept { return false; }
  /// Forgets the past: as if on the mean course, at rest about it, for ever.
  virtual void reset() noexcept {}

  /// Exact state as numbers: restore(what save() gave) has the same bits ever after. A part without
  /// state needs none of these.
  virtual std::size_t stateSize() const noexcept { return 0; }
  /// @pre state.size() == stateSize().
  virtual void save(std::span<double> /*state*/) const noexcept {}
  /// Whether these numbers are a state of this part, as it is now.
  virtual bool fits(std::span<const double> state) const noexcept {
    return state.size() == stateSize();
  }
  /// @pre fits(state).
  virtual void restore(std::span<const double> /*state*/) noexcept {}

  /// Names of the parts that this one stands for: they are not evaluated while it is on.
  virtual std::span<const std::string_view> replaces() const noexcept { return {}; }
  /// True: this part holds the ship up against its weight. If its load is not finite, the weight is
  /// left out of that tick as well.
  virtual bool carriesWeight() const noexcept { return false; }
};

}  // namespace cutwater
