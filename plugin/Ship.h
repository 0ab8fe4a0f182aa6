#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <optional>

#include "hydro/forces/ExcitationForce.h"
#include "hydro/forces/RadiationForce.h"
#include "hydro/forces/RestoringForce.h"
#include "hydro/forces/SupplementaryForces.h"
#include "plugin/AddedMassConstraint.h"

CUTWATER_PLUGIN_BEGIN

/// Where a ship starts and what it may do. Motions are about the mean course (frame H): here a
/// fixed place and heading at speed 0, as linear theory has it.
struct ShipSettings {
  double x = 0.0, y = 0.0;       ///< mean position of G in E [m]
  double heading = 0.0;          ///< mean heading [rad]: angle of the bow from E's x axis, about +z
  Vec6 offset = Vec6::Zero();    ///< start, about the mean course, in H [m]; roll, pitch, yaw [rad]
  Vec6 velocity = Vec6::Zero();  ///< start, u, v, w [m/s], p, q, r [rad/s] in B
  std::array<bool, 6> restrained{};  ///< modes held at 0 by a Bullet constraint
  /// Collision shape in B (origin in G), kept by the user; without it the convex hull of the ship's
  /// own mesh. Bullet's contacts work on it; hydrodynamics does not look at it.
  btCollisionShape* shape = nullptr;
};

/// Loads on a ship over one tick, by part: force [N] in H; moment [N·m] about G in upright axes
/// with her own heading, to first order H. What contacts, joints and the user add is not here.
/// gravity + restoring = −C η.
struct ForceParts {
  Vec6 gravity = Vec6::Zero();       ///< Bullet's, on this body
  Vec6 restoring = Vec6::Zero();     ///< calm water: what balances gravity at rest, − C η
  Vec6 froudeKrylov = Vec6::Zero();  ///< of the undisturbed waves
  Vec6 diffraction = Vec6::Zero();
  Vec6 radiation = Vec6::Zero();  ///< memory of the waves radiated, −∫K η̇ dτ
  Vec6 addedMass = Vec6::Zero();  ///< −d(A∞ v)/dt, as the solver applied it
  Vec6 supplementary = Vec6::Zero();
};

/// State at the start t_n of the last tick and the loads that were evaluated from it.
/// Bullet's velocity after a solve is the mean over the tick just ended; here it is extrapolated to
/// t_n, second order in the tick (at a start, what was set).
struct TickRecord {
  double time = 0.0;             ///< t_n [s]
  Vec3 position = Vec3::Zero();  ///< G in E [m]
  Vec3 attitude = Vec3::Zero();  ///< roll, pitch, yaw [rad] of R_EB = R_z R_y R_x
  Vec6 velocity = Vec6::Zero();  ///< u, v, w [m/s], p, q, r [rad/s] in B
  double wave = 0.0;             ///< ζ [m] at G's x, y
  ForceParts forces;
};

/// roll, pitch, yaw [rad] of R = R_z(yaw) R_y(pitch) R_x(roll); finite for every rotation.
Vec3 eulerAngles(const Mat3& rotation) noexcept;

/// One ship: a btRigidBody and the hydrodynamic loads on it. Made by Seaway::addShip.
/// Forces act in H; moments, and A∞, in upright axes with her own heading (R_z of her yaw), and
/// velocities are taken alike, so that power is force times velocity. To first order that is H
/// throughout. Moments in H would set a ship's small roll inertia against her large yaw inertia: at
/// 3° of yaw their product exceeds roll's own; in body axes a heeled ship's pitch moment would turn
/// her. Rotations of more than some 20 degrees are outside the linear theory; loads stay finite.
class Ship {
 public:
  /// Use Seaway::addShip. Coefficients, sea, world and `own` (null: a body is made) must outlive
  /// it.
  Ship(btDiscreteDynamicsWorld& world, const Coefficients& coefficients, const SeaState& sea,
       const ShipSettings& settings, btRigidBody* own);
  ~Ship();
  Ship(const Ship&) = delete;
  Ship& operator=(const Ship&) = delete;

  /// Bullet's body: apply forces and impulses, add joints, read contacts as with any other.
  btRigidBody& body() noexcept { return *body_; }
  const btRigidBody& body() const noexcept { return *body_; }
  const AddedMassConstraint& addedMass() const noexcept { return *addedMass_; }

  Vec3 position() const noexcept;  ///< G in E [m], now
  Vec3 attitude() const noexcept;  ///< roll, pitch, yaw [rad], now
  Vec6 velocity() const noexcept;  ///< Bullet's, in B [m/s, rad/s], now
  Vec6 motion() const noexcept;    ///< η in H [m, rad], now
  /// State and loads of the last tick.
  const TickRecord& lastTick() const noexcept { return record_; }

  /// Sets the velocity [m/s, rad/s] in E. body().setLinearVelocity() would be taken for a blow,
  /// which M + A∞ resists; this is not. The memory of radiated waves stays.
  void resetVelocity(const Vec3& linear, const Vec3& angular) noexcept;
  /// Puts the ship elsewhere, mean course and all, at rest in calm water: `offset` as in
  /// ShipSettings.
  void placeAt(double x, double y, double heading, const Vec6& offset = Vec6::Zero());

  /// Exact state. What Bullet itself remembers is not in it: contact caches, forces not yet applied,
  /// the part of a frame that is less than a tick.
  struct Snapshot {
    btTransform transform, interpolated;
    std::array<btVector3, 4> velocities;  // linear, angular; interpolated
    std::array<btVector3, 2> past;        // v⁻
    btMatrix3x3 pastAxes;                 // of A∞ at v⁻
    Vec6 before;
    TickRecord record;
    std::array<double, 3> course;
    std::optional<Convolution::Snapshot> memory;
  };
  Snapshot save() const;
  /// @throws HydroError BadArgument if it is of another ship or tick length.
  void restore(const Snapshot& snapshot);

  /// Builds the memory for ticks of `step` [s]: before the first tick, or that tick will.
  void prepare(double step);
  /// One evaluation of all loads at t_n and their impulses; StepFault bits. Seaway calls these.
  std::uint32_t beginTick(double time, btScalar step) noexcept;
  void endTick() noexcept;

 private:
  void createBody(const ShipSettings& settings);
  void adoptBody(btRigidBody& own);
  btTransform poseAt(const Vec6& offset) const noexcept;
  void restrain();
  Mat3 toCourse() const noexcept;
  ShipMotion motionAt(double time, const Mat3& heading) const noexcept;
  void evaluate(const ShipMotion& motion) noexcept;
  bool apply(btScalar step, const Mat3& heading) noexcept;
  std::uint32_t matchTick(double step) noexcept;
  void turnAddedMass(const Mat3& heading) noexcept;

  btDiscreteDynamicsWorld& world_;
  const Coefficients& coefficients_;
  const SeaState& sea_;
  std::unique_ptr<btCollisionShape> hullShape_;
  std::unique_ptr<btRigidBody> ownBody_;
  btRigidBody* body_ = nullptr;
  std::unique_ptr<AddedMassConstraint> addedMass_;
  std::unique_ptr<btTypedConstraint> restraint_;
  double courseX_, courseY_, courseHeading_;
  std::array<bool, 6> restrained_;

  RestoringForce restoring_;
  ExcitationForce excitation_;
  SupplementaryForces supplementary_;
  std::optional<RadiationForce> radiation_;

  Vec6 velocityBefore_ = Vec6::Zero();  // v after the tick before the last one, in E
  TickRecord record_;
};

CUTWATER_PLUGIN_END
