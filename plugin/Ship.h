#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "hydro/forces/MeanCourse.h"
#include "hydro/forces/linear/Autopilots.h"
#include "hydro/forces/linear/Excitation.h"
#include "hydro/forces/linear/HullLift.h"
#include "hydro/forces/linear/Radiation.h"
#include "hydro/forces/linear/Restoring.h"
#include "hydro/forces/linear/Supplementary.h"
#include "plugin/AddedMassConstraint.h"
#include "plugin/CourseRestraint.h"
#include "plugin/ShipModel.h"
#include "plugin/WorldFrame.h"

CUTWATER_PLUGIN_BEGIN

/// The mean course about which a ship's motions are linear (frame H).
enum class Mean {
  Fixed,  ///< a straight line at constant speed, whatever she does: as in a towing tank, and in [M03]
  Filtered  ///< follows the ship slowly (MeanCourse.h): a free ship, to be driven, turned and collided with
};

/// Where a ship starts and what it may do. SI units and E (z up) whatever the world's are.
struct ShipSettings {
  double x = 0.0, y = 0.0;  ///< mean position of G in E [m]
  double heading = 0.0;     ///< mean heading [rad]: angle of the bow from E's x axis, about +z
  double speed = 0.0;       ///< U [m/s] along the mean heading
  Mean mean = Mean::Fixed;
  double followTime = 15.0;      ///< 1/ν of MeanCourse [s], Mean::Filtered
  Vec6 offset = Vec6::Zero();    ///< start, about the mean course, in H [m]; roll, pitch, yaw [rad]
  Vec6 velocity = Vec6::Zero();  ///< start, beside U: u, v, w [m/s], p, q, r [rad/s] in B
  bool hullLift = true;          ///< HullLift.h, Mean::Filtered only
  std::array<bool, 6> restrained{};  ///< modes held on the mean course, each by a row of the solver
  MemoryModel memory = MemoryModel::Exponential;
  std::optional<SpeedKeeper> keepSpeed{};    ///< an engine
  std::optional<CourseKeeper> keepCourse{};  ///< a helmsman
  /// Collision shape, kept by the user, in the world's units; without it the convex hull of the ship's
  /// own mesh. Bullet's contacts work on it; hydrodynamics does not look at it.
  btCollisionShape* shape = nullptr;
  /// The shape is in the axes of the hull file (origin where that has it), not about G.
  bool shapeInHullAxes = false;
};

/// Loads on a ship over one tick, by part: force [N] in H; moment [N·m] about G in upright axes
/// with her own heading, to first order H. What contacts, joints and the user add is not here.
/// gravity + restoring = −C η.
struct ForceParts {
  Vec6 gravity = Vec6::Zero();       ///< Bullet's, on this body
  Vec6 restoring = Vec6::Zero();     ///< calm water: what balances gravity at rest, − C η
  Vec6 froudeKrylov = Vec6::Zero();  ///< of the undisturbed waves
  Vec6 diffraction = Vec6::Zero();
  Vec6 radiation = Vec6::Zero();  ///< memory of the waves radiated, −∫K η̇ dτ, and −b(U)η̇ − c(U)η
  Vec6 addedMass = Vec6::Zero();      ///< −d(A∞ v)/dt, as the solver applied it
  Vec6 supplementary = Vec6::Zero();  ///< given damping and stiffness, hull lift, keepers
};

/// State at the start t_n of the last tick and the loads that were evaluated from it.
/// Bullet's velocity after a solve is the mean over the tick just ended; here it is extrapolated to
/// t_n, second order in the tick (at a start, what was set).
struct TickRecord {
  double time = 0.0;             ///< t_n [s]
  Vec3 position = Vec3::Zero();  ///< G in E [m]
  Vec3 attitude = Vec3::Zero();  ///< roll, pitch, yaw [rad] of R_EB = R_z R_y R_x
  Vec6 velocity = Vec6::Zero();  ///< u, v, w [m/s], p, q, r [rad/s] in B
  ForceParts forces;
};

/// Motion of a point of the ship, in E.
struct PointMotion {
  Vec3 position, velocity, acceleration;  ///< [m], [m/s], [m/s²]
};

/// roll, pitch, yaw [rad] of R = R_z(yaw) R_y(pitch) R_x(roll); finite for every rotation.
Vec3 eulerAngles(const Mat3& rotation) noexcept;

/// One ship: a btRigidBody and the hydrodynamic loads on it. Made by Seaway::addShip.
/// Forces act in H; moments, and A∞, in upright axes with her own heading (R_z of her yaw), and
/// velocities are taken alike, so that power is force times velocity. To first order that is H
/// throughout. Moments in H would set a ship's small roll inertia against her large yaw inertia: at
/// 3° of yaw their product exceeds roll's own; in body axes a heeled ship's pitch moment would turn
/// her. Rotations of more than some 20 degrees are outside the linear theory; loads stay finite.
///
/// Not in this theory: calm-water resistance, mean drift in waves, steady sinkage and trim, waves from one
/// ship to another.
class Ship {
 public:
  /// Use Seaway::addShip. World, model and `own` (null: a body is made) must outlive it.
  Ship(btDiscreteDynamicsWorld& world, const WorldFrame& frame, std::shared_ptr<ShipModel> model,
       const ShipSettings& settings, btRigidBody* own);
  ~Ship();
  Ship(const Ship&) = delete;
  Ship& operator=(const Ship&) = delete;

  /// Bullet's body: apply forces and impulses, add joints, read contacts as with any other.
  btRigidBody& body() noexcept { return *body_; }
  const btRigidBody& body() const noexcept { return *body_; }
  const AddedMassConstraint& addedMass() const noexcept { return *addedMass_; }
  const Coefficients& coefficients() const noexcept { return coefficients_; }
  double length() const noexcept { return length_; }  ///< of the hull [m]

  Vec3 position() const noexcept;  ///< G in E [m], now
  Vec3 attitude() const noexcept;  ///< roll, pitch, yaw [rad], now
  Vec6 velocity() const noexcept;  ///< Bullet's, in B [m/s, rad/s], now
  Vec6 motion() const noexcept;    ///< η in H [m, rad], now
  const MeanCourse& course() const noexcept { return course_; }  ///< H, now
  /// State and loads of the last tick.
  const TickRecord& lastTick() const noexcept { return record_; }

  /// A point that moves with the ship. @param point in the hull file's axes turned to ours [m].
  /// Acceleration is the mean over the last tick.
  PointMotion pointMotion(const Vec3& point) const noexcept;
  /// Water above the keel [m], waves included, at a distance x [m] before the hull file's origin; negative
  /// where the keel is out of the water.
  double draught(double time, double x = 0.0) const noexcept;
  /// Pose of the hull file's axes (x forward, y port, z up) in the world, in Bullet's axes and units, between
  /// ticks interpolated by Bullet: to draw a model in.
  btTransform hullTransform() const noexcept;

  // Engine and helmsman. Orders may change at any time between ticks.
  void keepSpeed(const SpeedKeeper& order) { keepers_.hold(order); }
  void keepCourse(const CourseKeeper& order) { keepers_.hold(order); }
  void stopKeepingSpeed() noexcept { keepers_.releaseSpeed(); }
  void stopKeepingCourse() noexcept { keepers_.releaseCourse(); }
  const Keepers& keepers() const noexcept { return keepers_; }

  /// Sets the velocity [m/s, rad/s] in E. body().setLinearVelocity() would be taken for a blow,
  /// which M + A∞ resists; this is not. The memory of radiated waves stays; a filtered course takes the
  /// new velocity at once.
  void resetVelocity(const Vec3& linear, const Vec3& angular) noexcept;
  /// Puts the ship elsewhere, mean course and all, in calm water: `offset` as in ShipSettings.
  void placeAt(double x, double y, double heading, const Vec6& offset = Vec6::Zero(),
               double speed = 0.0);

  /// Exact state. What Bullet itself remembers is not in it: contact caches (Seaway::forgetContacts),
  /// forces not yet applied, the part of a frame that is less than a tick.
  struct Snapshot {
    btTransform transform, interpolated;
    std::array<btVector3, 4> velocities;  // linear, angular; interpolated
    std::array<btVector3, 2> past;        // v⁻
    btMatrix3x3 pastAxes;                 // of A∞ at v⁻
    Vec6 before;
    double headingAtSolve = 0.0;
    TickRecord record;
    std::array<double, MeanCourse::kStateSize> course;
    Keepers::State keepers;
    std::vector<double> memory, excitation;
  };
  Snapshot save() const;
  /// The same into one that exists: allocates nothing if it is of this ship.
  void save(Snapshot& snapshot) const;
  /// @throws HydroError BadArgument if it is of another ship or tick length.
  void restore(const Snapshot& snapshot);

  /// Builds the memory for ticks of `step` [s]: before the first tick, or that tick will.
  void prepare(double step);
  /// One evaluation of all loads at t_n and their impulses; StepFault bits. Touches nothing but this
  /// ship and her body. Seaway calls these.
  std::uint32_t beginTick(double time, btScalar step) noexcept;
  void endTick(btScalar step) noexcept;

 private:
  void createBody(const ShipSettings& settings);
  void adoptBody(btRigidBody& own, const ShipSettings& settings);
  void makeExcitation(double heading, double speed);
  btTransform poseAt(const Vec6& offset) const noexcept;
  Mat3 bodyAxes() const noexcept;
  Mat3 toCourse() const noexcept;
  Mat3 headingAxes() const noexcept;
  Vec6 velocityInEarth(const btVector3& linear, const btVector3& angular) const noexcept;
  void courseBeginsHere() noexcept;
  ShipMotion motionAt(double time, const Mat3& heading) const noexcept;
  void evaluate(const ShipMotion& motion) noexcept;
  bool apply(btScalar step, const Mat3& heading) noexcept;
  std::uint32_t matchTick(double step) noexcept;
  bool recovered() noexcept;
  void startAgain() noexcept;
  void turnAddedMass(const Mat3& heading) noexcept;
  void aimRestraint(const ShipMotion& motion, const Mat3& heading, double step) noexcept;

  btDiscreteDynamicsWorld& world_;
  WorldFrame frame_;
  std::shared_ptr<ShipModel> model_;
  const Coefficients& coefficients_;
  MemoryModel memoryModel_;
  double length_, keel_;
  std::unique_ptr<btCollisionShape> hullShape_, compound_;
  std::unique_ptr<btRigidBody> ownBody_;
  btRigidBody* body_ = nullptr;
  std::unique_ptr<AddedMassConstraint> addedMass_;
  std::unique_ptr<CourseRestraint> restraint_;
  MeanCourse course_;
  double headingAtSolve_ = 0.0;  // ψ̄ of the last solve

  RestoringForce restoring_;
  std::optional<ExcitationForce> excitation_;
  SupplementaryForces supplementary_;
  std::optional<HullLift> lift_;
  Keepers keepers_;
  std::optional<RadiationForce> radiation_;

  Vec6 velocityBefore_ = Vec6::Zero();  // v after the tick before the last one, in E
  double lastStep_ = 0.0;               // of the last tick
  TickRecord record_;
};

CUTWATER_PLUGIN_END
