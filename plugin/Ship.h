#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "hydro/forces/ForceGenerator.h"
#include "hydro/forces/MeanCourse.h"
#include "hydro/forces/ShipSettings.h"
#include "plugin/WorldFrame.h"

namespace cutwater {
class Autopilots;
class CarriedLoad;
class Compartment;
class FreeRadiation;
class Hydrodynamics;
class PredictedMotion;
class PressureHull;
class Resistance;
class SeaTables;
struct Coefficients;
struct CompartmentBox;
struct CourseForces;
struct Helm;
class WaveForce;
struct Weight;
class WettedHull;
}  // namespace cutwater

CUTWATER_PLUGIN_BEGIN

class AddedMassConstraint;
struct Rig;       // what of a ship stands in the world
struct ShipPart;  // of the load, with what the ship knows about it
struct ShipSea;   // what of a ship belongs to its sea
struct ShipSeaOrder;

/// What Bullet's contacts work on; hydrodynamics does not look at it.
///     seaway.addShip(boat, {.collision = {.deck = 1.4}});  // crates and people stay on board
///
/// The default shape is the convex hull of the ship's whole mesh, with a margin of 1 % of the half
/// beam, at most Bullet's own. Whatever stands on the deck in that mesh (masts, wheelhouse, rails)
/// is in it, and so is all air between its top and bow, stern and sides: things that you put on the
/// deck are inside the shape then, and are thrown off. With `deck` the shape ends at that height.
/// What is not convex needs a shape of your own: decks with holds or bulwarks, catamarans.
struct CollisionShape {
  /// Kept by the user, in the world's units; null: the convex hull of the ship's own mesh.
  btCollisionShape* shape = nullptr;
  /// The shape is in the hull file's axes turned to ours (Ship::hullTransform), not about G.
  bool inHullAxes = false;
  /// Height of the deck above calm water [m] with the ship at rest: z in hull axes, as the point of
  /// Ship::pointMotion. Only for the default shape, which is then the convex hull of the mesh below
  /// that height, flat on top. Above calm water, and not above the mesh.
  std::optional<double> deck{};
};

/// A new ship: where it starts, which theory acts on it, and what it collides with.
struct ShipSettings {
  ShipStart start{};
  ShipModel model{};
  CollisionShape collision{};
};

/// State at the start t_n of the last tick and the loads that were evaluated from it.
/// Bullet's velocity after a solve is the mean over the tick just ended; here it is extrapolated to
/// t_n, second order in the tick (at a start, what was set).
struct TickRecord {
  double time = 0.0;             ///< t_n [s]
  Vec3 position = Vec3::Zero();  ///< G in E [m]
  Vec3 attitude = Vec3::Zero();  ///< roll, pitch, yaw [rad] of R_EB = R_z R_y R_x
  Vec6 velocity = Vec6::Zero();  ///< u, v, w [m/s], p, q, r [rad/s] in B
  /// Of each part in the order of Ship::parts(): force [N] in H, moment [N·m] about G by its parts
  /// about the own x axis, the level y and the vertical. What contacts, joints and Bullet forces of
  /// the user add is not here.
  std::vector<Vec6> loads;
};

/// Motion of a point of the ship, in E.
struct PointMotion {
  Vec3 position, velocity, acceleration;  ///< [m], [m/s], [m/s²]
};

/// What of a hull the water covers (Ship::wetted).
struct Wetted {
  double area = 0.0;           ///< wetted [m²]
  double volume = 0.0;         ///< submerged [m³]
  Vec3 centre = Vec3::Zero();  ///< of that volume, the centre of buoyancy, in E [m]
  double immersion = 1.0;      ///< s, 0 out of the water .. 1 (TickInput::immersion)
};

/// A ship with all that it carries (Ship::loading).
struct LoadedShip {
  double mass = 0.0;            ///< [kg]
  Vec3 cog = Vec3::Zero();      ///< its centre of gravity in hull axes (Ship::pointMotion) [m]
  Mat3 inertia = Mat3::Zero();  ///< about that centre, in B [kg·m²]
};

/// roll, pitch, yaw [rad] of R = R_z(yaw) R_y(pitch) R_x(roll); finite for every rotation.
Vec3 eulerAngles(const Mat3& rotation) noexcept;

/// The same as long as the ship is upright to 30 degrees. Beyond 45 degrees R = R_z(yaw) S, where S
/// turns by |s| about s = (roll, pitch, 0), |s| ≤ π: its heading does not jump when the bow or the
/// stern points up, as Euler's does. Between the two it goes over smoothly.
Vec3 motionAngles(const Mat3& rotation) noexcept;

/// The same, but as long as the bow is within 30 degrees of level, whatever the roll; beyond 45 the
/// heading is that of motionAngles. It does not jump where a ship turns over: its heading is where
/// its bow points. Own axes of nonlinear mode.
Vec3 bowAngles(const Mat3& rotation) noexcept;

/// One ship: a btRigidBody and the hydrodynamic loads on it. Made by Seaway::addShip.
///     cutwater::Ship& ship = seaway.addShip(frigate, {.start = {.speed = 8.0}});
///     ship.keepCourse({.heading = 0.5});                     // autopilots
///     ship.addForce(std::make_unique<Wind>(20.0));       // a load of your own (ForceGenerator.h)
///
/// The load is a list of parts:
///     gravity         the weight: the world's gravity, which the ship takes over from Bullet
///     wetted_pressure  nonlinear mode: the undisturbed waves' pressure on the hull in them; it
///                     replaces the next two
///     restoring       calm water: what balances gravity at rest, − C η
///     froude_krylov   the undisturbed waves
///     diffraction     the waves that the hull throws back
///     radiation       memory of the waves radiated, −∫K η̇ dτ, and −b(U)η̇ − c(U)η
///     added_mass      −d(A∞ v)/dt, as Bullet's solver applied it; of a free ship also −V × A∞ v
///     supplementary   damping and stiffness given with the ship
///     autopilots      SpeedKeeper and CourseKeeper
///     hull_lift       Mean::Free only
///     resistance      of the hull in calm water, Mean::Free only
///     engine, rudder  of a free ship that has them (setThrottle, setRudder)
///     loading         weight of what it carries beside (setWeights, addCompartment)
/// and then those of addForce(). gravity + restoring = −C η.
///
/// First-order forces act in H. Moments, and A∞, act in axes along the ship's own heading and
/// pitch, which do not roll; velocities are taken alike, so that power is force times velocity. To
/// first order that is H throughout. Moments in H would set a ship's small roll inertia against its
/// large yaw inertia: at 3° of yaw their product exceeds roll's own; in body axes a heeled ship's
/// pitch moment would turn it. Tilted beyond kLargestTilt a ship is outside the linear theory; its
/// loads stay bounded, and a fault bit says so.
///
/// What Bullet offers for its bodies holds for a ship: linear and angular factors, sleep, damping,
/// setMassProps(0) to hold it still. A factor of 0 about the vertical holds the heading (or its
/// rate), where Bullet's own would let roll and pitch turn it bit by bit. Bullet's weight is off
/// the body (getGravity() is 0 and BT_DISABLE_WORLD_GRAVITY is set), as the water carries it; the
/// ship reads the world's gravity each tick. Bullet's gyroscopic term is off, too: the ship applies
/// its own, as Bullet's vanishes for small inertias in single precision.
///
/// Not in this theory: the waves that speed makes, mean drift in waves, steady sinkage and trim,
/// waves from one ship to another.
class Ship {
 public:
  /// Tilt from upright [rad] beyond which kAttitudeOutsideTheory is raised.
  static constexpr double kLargestTilt = kPi / 6.0;

  /// Internal: use Seaway::addShip. `own` (null: a body is made) must outlive the ship.
  Ship(btDiscreteDynamicsWorld& world, const WorldFrame& frame,
       std::shared_ptr<const SeaTables> tables, const ShipSettings& settings, btRigidBody* own);
  ~Ship();
  Ship(const Ship&) = delete;
  Ship& operator=(const Ship&) = delete;

  /// Bullet's body: apply forces and impulses, add joints, read contacts as with any other. If it
  /// was deleted by somebody else, one that is in no world.
  btRigidBody& body() noexcept { return *body_; }
  const btRigidBody& body() const noexcept { return *body_; }
  const AddedMassConstraint& addedMass() const noexcept;
  const Hydrodynamics& hydrodynamics() const noexcept;
  const Coefficients& coefficients() const noexcept;
  double length() const noexcept;  ///< of the hull [m]

  // Where the ship is, now.
  Vec3 position() const noexcept;                                ///< G in E [m]
  Vec3 attitude() const noexcept;                                ///< roll, pitch, yaw [rad]
  Vec6 velocity() const noexcept;                                ///< Bullet's, in B [m/s, rad/s]
  Vec6 motion() const noexcept;                                  ///< η in H [m, rad]
  const MeanCourse& course() const noexcept { return course_; }  ///< H
  /// (M + A∞)v in E: momentum [N·s] and moment of momentum about G [N·m·s] of ship and water.
  Vec6 momentum() const noexcept;
  /// ½vᵀ(M + A∞)v + ½ηᵀCη [J] in the middle of the last tick: Bullet's velocity is the mean over
  /// it. In nonlinear mode the potential is m g z_G − ρg∫z dV of the water displaced, less that of
  /// the ship at rest, at the start of the last tick, and the velocity the mean of those before and
  /// after it.
  double energy() const noexcept;
  /// A point that moves with the ship. @param point in the hull file's axes turned to ours [m].
  /// Acceleration is the mean over the last tick.
  PointMotion pointMotion(const Vec3& point) const noexcept;
  /// Water above the keel [m], waves included, at a distance x [m] before the hull file's origin;
  /// negative where the keel is out of the water.
  double draught(double time, double x = 0.0) const noexcept;
  /// What of the hull was wet at the start of the last tick. Absent in linear mode, whose hull is
  /// always that at rest.
  std::optional<Wetted> wetted() const noexcept;
  /// The waterline then, in pieces and in no order: pairs of ends in E [m]. Empty in linear mode.
  std::vector<std::pair<Vec3, Vec3>> waterline() const;
  /// The hull that the pressure is integrated on, with what is said of it; null in linear mode.
  const PressureHull* pressureHull() const noexcept { return pressureHull_.get(); }
  /// Distance [m] between G and its mean place, where the waves are taken.
  double offCourse() const noexcept;
  /// Pose of the hull file's axes (x forward, y port, z up) in the world, in Bullet's axes and
  /// units: for drawing. It is what Bullet gives to motion states, interpolated to the moment that
  /// stepSimulation() was asked for, up to a tick behind position(). The body has a motion state,
  /// its own or yours; without one it is the pose of the last tick.
  btTransform hullTransform() const noexcept;
  /// Places the file that the hull was read from, as it was drawn (its own axes, unit and origin),
  /// in the world: draw your model at it. The pose is that of hullTransform(). The scale from the
  /// file's unit to the world's is in the basis, so that getOpenGLMatrix is right for drawing;
  /// getRotation is not where the scale is not 1: engines that take a rotation and a scale apart
  /// divide the basis by modelScale(). Databases that do not know the file
  /// (ShipParticulars::file) give the hull's axes turned to ours, in metres.
  btTransform modelTransform() const noexcept;
  /// Units of the world in one unit of that file.
  double modelScale() const noexcept;

  // The load and its parts.
  /// State and loads of the last tick.
  const TickRecord& lastTick() const noexcept { return record_; }
  /// Names of all parts, in order.
  std::vector<std::string_view> parts() const;
  /// Hash of these names: another number when a part has come or gone.
  std::uint64_t partsKey() const noexcept { return partsKey_; }
  /// Index of the part that holds the ship up against its weight; parts().size() if none is on.
  std::size_t weightCarrier() const noexcept;
  /// Load of one part in the last tick (TickRecord::loads).
  /// @throws HydroError BadArgument, naming the parts there are.
  const Vec6& load(std::string_view part) const;
  /// Takes a part of the user's, from the next tick on; it comes last in the list. At any time
  /// between ticks. @throws HydroError BadArgument: null, a name that is taken or is no name.
  void addForce(std::unique_ptr<ForceGenerator> force);
  /// Gives back a part that addForce() took. @throws HydroError BadArgument: there is none.
  std::unique_ptr<ForceGenerator> removeForce(std::string_view part);
  /// Switches a part off (its load is 0) and on again; switched on, it has forgotten its past.
  /// @throws HydroError BadArgument: no such part, or gravity, which is Bullet's.
  void setEnabled(std::string_view part, bool on);
  bool enabled(std::string_view part) const;  ///< @throws as load().
  /// Name of the first part whose load was not finite since the last call; "" if none was.
  std::string brokenPart();
  /// Starts or stops timing the parts; a start forgets what was timed.
  void measureCosts(bool on) noexcept;
  /// Mean time of one evaluation [ns], in the order of parts(); 0 where nothing was timed.
  std::vector<double> costs() const;

  /// One line on waves of this sea that are shorter than the database has forces for, whose linear
  /// loads are left out, with their number and share of the sea's energy; empty if there are none.
  std::string seaWarning() const;
  // What it carries beside the mass of its database (hydro/forces/nonlinear/CarriedLoad.h and
  // hydro/forces/Compartment.h), fixed to the body off its centre: it settles, heels and trims by
  // it, and has its inertia. Bullet's body stays as it is, with its origin in the database's G, and
  // so do position(), the coefficients and the motions predicted in waves. From the first call on
  // the load has a part "loading"; snapshots from before do not fit any more.
  /// All weights from now on, instead of those before; at any time between ticks.
  ///     ship.setWeights({{.name = "deck cargo", .mass = 40e3, .place = {-12, 3, 7}}});
  /// @throws HydroError ValueOutOfRange, BadArgument, naming weight, field and value; the weights
  ///         before stay then.
  void setWeights(std::vector<Weight> weights);
  const std::vector<Weight>& weights() const noexcept;
  /// A room for water. The reference is good as long as the ship.
  /// @throws HydroError ValueOutOfRange, naming compartment, field and value.
  Compartment& addCompartment(const CompartmentBox& box);
  const std::vector<std::unique_ptr<Compartment>>& compartments() const noexcept;
  /// The ship with all of it, now.
  LoadedShip loading() const noexcept;
  /// Wholly under water with a weight beyond the buoyancy of the whole hull: it goes down.
  /// Nonlinear mode only; as at the start of the last tick.
  bool foundered() const noexcept;

  // Autopilots. Orders may change at any time between ticks.
  // @throws HydroError ValueOutOfRange, naming field, value and bounds; the order before stays.
  void keepSpeed(const SpeedKeeper& order);
  void keepCourse(const CourseKeeper& order);
  void stopKeepingSpeed() noexcept;
  void stopKeepingCourse() noexcept;

  // Engine and rudder: of a free ship whose ship.toml has [engine] and [rudder], or that was given
  // ShipModel::engine and rudder. Autopilots steer by them then; an order of yours ends theirs.
  // @throws HydroError BadArgument: the ship has none; ValueOutOfRange: a value that is not finite.
  /// Thrust as a share of the engine's full one, −1 full astern .. 1 full ahead; beyond is full.
  void setThrottle(double order);
  /// Angle [rad] to which the rudder turns at its rate, held to its limit. Positive turns the bow
  /// to port under way ahead.
  void setRudder(double angle);

  /// Sets the velocity [m/s, rad/s] in E. body().setLinearVelocity() would be taken for a blow,
  /// which M + A∞ resists; this is not. The memory of radiated waves stays; a free ship has
  /// always had its new way.
  void resetVelocity(const Vec3& linear, const Vec3& angular) noexcept;
  /// Begins anew, in microseconds; a free ship in waves takes some more of them for each component
  /// in its next tick. From here on the ship has the same bits as a new one with this start in the
  /// sea of this moment. Orders to autopilots, parts, what it carries and what is switched off
  /// stay.
  /// Contacts are Bullet's (Seaway::forgetContacts). Allocates nothing but for a fixed course on a
  /// heading or at a speed that no ship has had in this sea.
  /// @throws HydroError as SeaTables::exact, or ValueOutOfRange; nothing has changed then.
  void reset(const ShipStart& start);
  /// reset() with some of its fields.
  void placeAt(double x, double y, double heading, const Vec6& offset = Vec6::Zero(),
               double speed = 0.0);

  /// Exact state. What Bullet itself remembers is not in it: contact caches
  /// (Seaway::forgetContacts), forces not yet applied, the part of a frame that is less than a
  /// tick.
  struct Snapshot {
    btTransform transform, interpolated;
    std::array<btVector3, 4> velocities;  // linear, angular; interpolated
    std::array<btVector3, 2> past;        // v⁻
    std::array<Mat3, 2> pastAxes;         // of A∞ at v⁻
    Mat3 pastBody = Mat3::Identity();     // axes of the body at v⁻
    bool carries = false;                 // AddedMassConstraint::carries
    Vec6 before;
    double lastStep = 0.0, stepBefore = 0.0;
    bool courseBegins = false, anew = false;
    int activation = 0;  // Bullet's activation state of the body
    int now = 0;         // ticking, paused, asleep
    std::array<double, 3> lockedYaw{};
    btTransform known;  // pose after the last tick
    TickRecord record;
    std::array<double, MeanCourse::kStateSize> course, line;
    std::vector<double> predicted;       // of a free ship
    std::vector<double> immersed;        // in nonlinear mode
    std::uint64_t hydrodynamicsKey = 0;  // Hydrodynamics::key
    std::uint64_t partsKey = 0;          // of the names of the parts
    std::vector<std::size_t> sizes;      // numbers of each part's state
    std::vector<double> states;          // of the parts, one after the other
    std::vector<char> enabled;           // of the parts
  };
  Snapshot save() const;
  /// The same into one that exists: allocates nothing if it is of this ship.
  void save(Snapshot& snapshot) const;
  /// @throws HydroError BadArgument if it is of a ship of other parts, or of another length of
  ///         tick.
  void restore(const Snapshot& snapshot);

  /// Makes what depends on the tick's length [s]: before the first tick, or that tick will.
  /// @throws HydroError ValueOutOfRange.
  void prepare(double step);
  /// Sees to it that our constraints stand in the world's list; StepFault bits. Seaway calls these
  /// three, the first for one ship after the other.
  std::uint32_t keepConstraints() noexcept;
  /// One evaluation of all loads at t_n and their impulses; StepFault bits. Touches nothing but
  /// this ship and its body.
  std::uint32_t beginTick(double time, btScalar step) noexcept;
  std::uint32_t endTick(btScalar step) noexcept;
  /// Of the sea that it is in. Seaway asks.
  const SeaTables& tables() const noexcept { return *tables_; }
  /// What the ship's part of another sea is made from, and that part's entry between two ticks,
  /// which allocates nothing. Seaway calls them.
  ShipSeaOrder seaOrder() const;
  void enterSea(ShipSea& sea, const SharedWaves& shared) noexcept;
  /// Of somebody else's constraint that holds our own body; null: none. Seaway asks it.
  btTypedConstraint* foreignConstraint() const noexcept;
  /// Calm water is here from now on: its height [units of the world], and its speed upwards [m/s].
  void setWater(double seaLevel, double rate) noexcept;
  /// Whether the body is known to stand in its world, which therefore lives.
  bool inWorld() const noexcept;
  /// Before its end: the world is known to live.
  void worldLives() noexcept { worldLives_ = true; }

 private:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  /// The body as Bullet left it, or as this ship set it: where it is put back to, and by what is
  /// seen that somebody else has moved it.
  struct Known {
    btTransform pose;
    btVector3 linear, angular;
  };

  void createBody(const CollisionShape& collision);
  void adoptBody(btRigidBody& own);
  void requireCourse(Mean mean, double speed) const;
  void takeOver();
  void makeParts(const ShipSettings& settings);
  void makeWetted(const ShipModel& model);
  void makeDrive(const ShipModel& model);
  Helm& helmFor(const char* order, const char* part, double value) const;
  void addPart(ShipPart part);
  void switchOff(const std::vector<std::string>& parts);
  void saveParts(Snapshot& snapshot) const;
  void checkParts(const Snapshot& snapshot) const;
  void restoreParts(const Snapshot& snapshot);
  void restoreWetted(const Snapshot& snapshot);
  void partsChanged();
  std::size_t indexOf(std::string_view part) const;
  void findLimits();

  btTransform poseAt(const Vec6& offset) const noexcept;
  Mat3 bodyAxes() const noexcept;
  Mat3 toCourse() const noexcept;
  double heading() const noexcept;
  Vec3 ownAngles(const Mat3& attitude) const noexcept;
  Mat3 ownAxesNow() const noexcept;
  Vec6 velocityInEarth(const btVector3& linear, const btVector3& angular) const noexcept;
  Vec6 velocityNow() const noexcept;
  Vec6 waterMomentum() const noexcept;
  void beginFixed(double x, double y, double heading, double speed) noexcept;
  void courseBeginsHere() noexcept;
  void findMotion(TickInput& input) const noexcept;
  void findInput(double time, double step) noexcept;
  void findOwnMotion() noexcept;
  void findSlowMotion() noexcept;
  Vec3 findSlowPlace() noexcept;
  std::uint32_t evaluate() noexcept;
  Wrench evaluatePart(ShipPart& part) noexcept;
  Vec6 inCourseAxes(const Wrench& wrench) const noexcept;
  Vec6 sumOfLoads() const noexcept;
  Vec3 turningOfAddedMass() const noexcept;
  bool apply(double step) noexcept;
  void turnByInertia(double step) noexcept;
  void holdLockedYaw(double step) noexcept;
  std::uint32_t tick(double time, btScalar step) noexcept;
  void readyToWake(btScalar step) noexcept;
  std::uint32_t matchTick(double step) noexcept;
  void place(const ShipStart& start) noexcept;
  void forget() noexcept;
  void startAgain() noexcept;
  void turnAddedMass(const Mat3& own) const noexcept;
  void immerseAddedMass() const noexcept;
  CarriedLoad& carriedLoad();
  bool carries() const noexcept;
  double carriedMass() const noexcept;
  Mat6 carriedMatrix() const noexcept;
  double carriedEnergy() const noexcept;
  void carryInertia() const noexcept;
  Vec3 turningOfCarried() const noexcept;
  std::uint32_t outsideLoading() const noexcept;
  Vec3 meanInEarth() const noexcept;
  Vec6 metMomentum() const noexcept;
  Mat6 addedMassNow() const noexcept;
  double mass() const noexcept;
  void findWetted() noexcept;
  void lookAgain() noexcept;
  double energyAtTick() const noexcept;
  void aimRestraint(double step) noexcept;
  bool free() const noexcept { return predicted_ != nullptr; }
  bool nonlinear() const noexcept { return wetted_ != nullptr; }

  // What others did to the body (ShipGuard.cpp).
  void leaveWorld();
  friend struct Rig;
  bool bodyDeleted(btRigidBody& dying);
  void adoptStandIn();
  void constraintDeleted(btTypedConstraint& dying) noexcept;
  AddedMassConstraint& added() const;
  void takeOutOfWorld();
  void takeJointsOut() noexcept;
  void giveBack() noexcept;
  std::uint32_t mendState() noexcept;
  std::uint32_t lookForChanges() noexcept;
  std::uint32_t lookForMoves() noexcept;
  bool outOfWater() const noexcept;
  std::uint32_t outsideTheory() const noexcept;
  void remember() noexcept;
  void set(const Known& state) noexcept;
  bool restrains() const noexcept;

  btDiscreteDynamicsWorld& world_;
  WorldFrame frame_;
  std::shared_ptr<const SeaTables> tables_;
  std::shared_ptr<const CourseForces> onCourse_;  // keeps them made while the course is fixed
  std::unique_ptr<btCollisionShape> hullShape_, compound_;
  std::unique_ptr<Rig> rig_;
  btRigidBody* body_ = nullptr;
  bool ownBody_ = true;  // made by us
  bool worldLives_ = false;
  int flagsFound_ = 0, activationFound_ = 0;  // of the user's body
  btVector3 gravityFound_;
  std::shared_ptr<const PressureHull> pressureHull_;  // nonlinear mode
  std::shared_ptr<WettedHull> wetted_;                // nonlinear mode
  std::array<bool, 6> restrained_{};
  double fastest_ = 0.0;  // up to which its motions were looked at [m/s]
  MeanCourse course_;
  MeanCourse line_;  // on which modes are held: the fixed course, or a free ship's from its start
  std::shared_ptr<PredictedMotion> predicted_;  // of a free ship
  std::array<WaveForce*, 2> waves_{};           // of a fixed course: two of the parts
  const FreeRadiation* radiation_ = nullptr;    // of a free ship: one of the parts

  std::vector<ShipPart> parts_;
  std::size_t gravityPart_ = kNone, addedMassPart_ = kNone;  // Bullet's own: their places in parts_
  Autopilots* autopilots_ = nullptr;                         // one of the parts
  const Resistance* resistance_ = nullptr;                   // one of the parts, or null
  CarriedLoad* carried_ = nullptr;                           // one of the parts, or null
  std::shared_ptr<Helm> helm_;                               // null: neither engine nor rudder
  double preparedFor_ = 0.0;  // length of tick the parts were made for; 0: none
  std::uint64_t partsKey_ = 0;
  bool measuring_ = false;
  double growsAhead_ = 0.0, growsAstern_ = 0.0;  // speeds at which its motions grow, or beyond
                                                 // those looked at [m/s]
  double longestTick_ = 0.0;    // [s] for which loads are right, from the fastest own motion
  std::size_t broken_ = kNone;  // index of the first part whose load was not finite

  /// A yaw that the body's angular factor locks: heading [rad] and its rate [rad/s] as they were.
  struct LockedYaw {
    bool on = false;
    double heading = 0.0, rate = 0.0;
  };
  LockedYaw lockedYaw_;
  enum class Now { Ticks, Paused, Asleep };
  Now now_ = Now::Ticks;
  bool begun_ = false;  // this tick, by beginTick()
  Known known_;
  btScalar inverseMass_ = 0;  // as the database has it
  btVector3 inverseInertia_, worldGravity_;

  TickInput input_;  // of the tick under way
  std::vector<Phasors4> phasors_;
  bool anew_ = true;                          // of a free ship: nothing is kept of what it was
  Vec3 turning_ = Vec3::Zero();               // −V × R A∞ν of this tick, in E [N·m]
  double waterRate_ = 0.0;                    // of the calm water, upwards [m/s]
  double elevation_ = 0.0;                    // of the sea at the mean place [m]
  Vec6 velocityAfter_ = Vec6::Zero();         // v⁻ of the last solve, in E
  Vec6 velocityBefore_ = Vec6::Zero();        // the same a tick before
  double lastStep_ = 0.0, stepBefore_ = 0.0;  // of the last tick, and of the one before
  TickRecord record_;
};

CUTWATER_PLUGIN_END
