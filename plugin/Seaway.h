#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "hydro/Errors.h"
#include "plugin/Float.h"
#include "plugin/Ship.h"

CUTWATER_PLUGIN_BEGIN

class FloatFleet;
class SeaChange;
struct ComingSea;
class SeaView;
class SeaWatch;
class Seaway;
class ThreadPool;
class WorldHook;

/// When a StepFault bit was raised: time t_n [s] of the first tick, and in how many ticks.
struct FaultCount {
  double first = 0.0;
  std::uint64_t ticks = 0;
};

/// Sees every internal tick of a Seaway, when it is over.
class TickObserver {
 public:
  virtual ~TickObserver() = default;
  virtual void tickDone(const Seaway& seaway) noexcept = 0;
};

/// Waves and ships in a stock Bullet world: discrete, multi-body, soft-rigid or Mt (whose solver
/// runs serially on Debian, where Bullet has no threads; our own share of a tick may: setThreads).
///
///     btDiscreteDynamicsWorld world(...);
///     world.setGravity({0, 0, -9.81});   // z up, metres; other worlds: WorldFrame
///     const auto frigate = cutwater::readHydrodynamics("frigate.h5");
///     cutwater::Seaway seaway(world, cutwater::SeaState(components, 9.81));
///     auto& ship = seaway.addShip(frigate, {.start = {.heading = 0.5, .speed = 8.0},
///                                           .model = {.mean = cutwater::Mean::Free}});
///     ship.keepSpeed({.speed = 8.0});
///     while (running) world.stepSimulation(frame, 4, 1.0 / 60);   // ship.body() moves
///
/// All loads come from one evaluation per internal tick, so results do not depend on how ticks are
/// grouped into stepSimulation calls, nor on threads. Ticks may vary (but for
/// MemoryModel::Convolution); a fixed one is the more accurate. Contacts, joints, forces, callbacks
/// of the user work as without us; set velocities by Ship::resetVelocity. One thread at a time, as
/// the world itself; worlds on different threads may share one Hydrodynamics. Contacts and joints
/// need btContactSolverInfo::m_numIterations of AddedMassConstraint::iterationsFor.
class Seaway final {
 public:
  /// @param world should outlive the Seaway. If it does not, or if somebody clears it with all
  ///        that is in it, nothing of it is touched any more; what it could still read is kept.
  /// @throws HydroError SolverNotSupported: btMLCPSolver treats a constraint whose two bodies are
  ///         one as two bodies and ignores its softness, so that M + A∞ would be wrong in contacts;
  ///         BadArgument: the world has a Seaway; ValueOutOfRange: frame.
  explicit Seaway(btDiscreteDynamicsWorld& world, SeaState sea = {}, const WorldFrame& frame = {});
  /// Takes its ships out, and joints of others with the bodies that we made for them, and leaves
  /// the world's callback as it was found. (A Seaway without ships cannot know that its world still
  /// lives: then the callback goes through a few instructions of ours, that do nothing, for ever.)
  ~Seaway();
  Seaway(const Seaway&) = delete;
  Seaway& operator=(const Seaway&) = delete;

  /// A new ship at its mean course. Ships that are given the same Hydrodynamics share it; another
  /// mass distribution on the same waterline is withLoading(coefficients, …) of
  /// database/ChangeOfLoading.h.
  /// @throws HydroError ValueOutOfRange: a setting that is not finite or far outside what ships do
  ///         (named, with its bounds), gravity of the world (or zero) or of the sea that is not the
  ///         database's, mass or gyradii not positive, a wave outside the database;
  ///         DatabaseIncomplete: no hull in it and no shape given;
  ///         BadArgument: a null pointer, an unknown part in `without`, a body that is a ship here
  ///         already. Nothing has changed then.
  Ship& addShip(std::shared_ptr<const Hydrodynamics> hydrodynamics,
                const ShipSettings& settings = {});
  /// The user's own body, already in the world, origin in G, axes B; the database's mass within
  /// 0.1 %. It must outlive the ship. It keeps its shape, pose and velocity, and its pose becomes
  /// the mean course (x, y, heading). Of `settings`
  ///     model      is used, all of it, as for a body of ours
  ///     start      speed only, and only with Mean::Fixed: the speed of the mean course. The body
  ///                is not set in motion: setLinearVelocity before. With Mean::Free the course
  ///                begins at the body's own velocity.
  ///     collision  is not used
  Ship& addShip(std::shared_ptr<const Hydrodynamics> hydrodynamics, btRigidBody& body,
                const ShipSettings& settings = {});
  /// The same for one ship that shares with no other: Hydrodynamics of its own are made of
  /// `coefficients` (a copy: temporaries may be passed), some tenths of a second for each call.
  Ship& addShip(Coefficients coefficients, const ShipSettings& settings = {});
  Ship& addShip(Coefficients coefficients, btRigidBody& body, const ShipSettings& settings = {});
  /// Ends the hydrodynamics of a ship; a body we made leaves the world.
  /// @throws HydroError BadArgument: it is no ship of this sea, or a joint of yours still holds the
  ///         body that we made; remove that first. Nothing has changed then.
  void removeShip(Ship& ship);
  /// The ship of a body, for example of one in a contact; null: it is none of this sea.
  Ship* shipOf(const btCollisionObject& body) const noexcept;
  /// Makes what depends on the tick's length [s], for the ships there are and those to come: before
  /// the first tick, which then takes no longer than others.  @throws HydroError ValueOutOfRange.
  void prepare(double step);
  const std::vector<std::unique_ptr<Ship>>& ships() const noexcept { return ships_; }

  /// A body of the user's, in the world, that floats by its shape: crates, buoys, swimmers, ice
  /// (Float.h). 500 of them beside a ship run at 60 Hz on one core. Ships and other floats do not
  /// change the water that it meets.
  /// @throws HydroError BadArgument: a body that floats here already, is in no world, or whose
  ///         shape encloses nothing that is known; HullNotClosed, HullInverted: a mesh that is not
  ///         closed, or inside out; ValueOutOfRange: a setting, or gravity of the world that does
  ///         not point down or is not the sea's. Nothing has changed then.
  Float& addFloat(btRigidBody& body, const FloatSettings& settings = {});
  /// The body goes on without water. Do so before it is deleted; one that was deleted after it was
  /// taken out of the world is found in the next tick, and not touched any more.
  /// @throws HydroError BadArgument: it is no float of this sea.
  void removeFloat(Float& floating);
  /// The float of a body, for example of one in a contact; null: it is none of this sea.
  Float* floatOf(const btCollisionObject& body) const noexcept;
  const std::vector<std::unique_ptr<Float>>& floats() const noexcept;

  /// How many threads evaluate the ships' loads; 1 unless set. The same bits for any number.
  void setThreads(unsigned threads);

  /// Another sea, into which the present one goes over while ships sail: a storm that builds up,
  /// or waves that die down (`SeaState()`).
  ///     seaway.setSea(makeSeaState({.hs = 8.0, .tp = 12.0}, {.seed = 2}), 120.0);
  /// Its tables are made on a thread of ours, in some tenths of a second for each kind of ship;
  /// with the first tick that finds them ready the change begins. From then on amplitudes of the
  /// old sea fall and those of the new one rise over `fadeSeconds`, as SeaState::goingOver has it;
  /// surface and loads do not jump, and no tick waits. Which tick that is depends on the machine;
  /// who needs the same bits in each run calls waitForSea(). A change during a change is allowed.
  /// Ships keep the triangles that they press on the water with, made for their first sea:
  /// PressureHull::pressureErrorIn says what that means in another one.
  /// @throws HydroError as SeaState::goingOver; ValueOutOfRange: the sea's gravity is not that of a
  ///         ship's database.
  void setSea(SeaState next, double fadeSeconds);
  /// setSea() was called, and its change is not yet over.
  bool seaIsChanging() const noexcept;
  /// Waits until the tables of the coming sea are made: its change begins with the next tick.
  /// @throws HydroError  what was thrown in making them; the old sea stays.
  void waitForSea();
  /// What another thread may look at the sea through: SeaView.h. Call it on the world's thread.
  SeaView view() const;

  /// Sum of all ticks [s] since the Seaway joined the world.
  double time() const noexcept { return time_; }
  const SeaState& sea() const noexcept { return *sea_; }
  const WorldFrame& frame() const noexcept { return frame_; }
  /// Moves calm water to a height [m] over the one at which this Seaway began
  /// (WorldFrame::seaLevel), up or down at `rate` [m/s]: a lock, a tide, a dock that is drained.
  /// From the next tick on; infinity: at once, as if it had always been there.
  ///
  /// E goes with it: z = 0 is calm water always, and so position(), waterAt(), waves, draught and
  /// drawing keep their meaning. Velocities in E are those against the water; nothing jumps when it
  /// begins to move: the ship follows by its own buoyancy and damping.
  /// @throws HydroError ValueOutOfRange: a height that is not finite or beyond 1e5 m, a rate that
  ///         is not positive.
  void setCalmLevel(double height, double rate);
  /// Height of calm water now [m], over the one at the beginning.
  double calmLevel() const noexcept { return calm_.level; }
  /// ζ [m] at x, y in E, now.
  double waveHeight(double x, double y) const noexcept { return sea_->elevation(time_, x, y); }
  /// The water's surface above or below a point of the world, in the world's units and axes.
  btVector3 waterAt(const btVector3& place) const noexcept;

  /// StepFault bits of all ticks since clearFaults(), of all ships. Ship::brokenPart names a part.
  std::uint32_t faults() const noexcept { return faults_; }
  /// Of one bit, since clearFaults().
  FaultCount faultCount(StepFault bit) const noexcept;
  void clearFaults() noexcept;

  /// Exact state of time, ships and floats, in their order: going on from it gives the same bits,
  /// if contacts are forgotten both when it is taken and when it is restored (or there are none).
  /// It belongs to the sea of its moment: within a change of seas it may be restored until that is
  /// over. Allocates nothing when saved into one of the same ships and floats.
  /// @throws HydroError BadArgument: other ships, another number of floats, another sea.
  struct Snapshot {
    double time = 0.0;
    std::uint64_t seaKey = 0;                             ///< SeaState::key
    std::array<double, 4> calmLevel{0.0, 0.0, 1.0, 0.0};  // level, wanted, rate, rate now
    std::vector<Ship::Snapshot> ships;
    std::vector<Float::Snapshot> floats;

    /// For a file or another process with the same precision of Bullet, which goes on with the same
    /// bits. Little-endian, with a version and a checksum.
    std::vector<std::byte> toBytes() const;
    /// @throws HydroError FileMalformed: cut off, damaged or no snapshot; VersionNotSupported: of
    ///         the other precision of Bullet, or of a Cutwater whose ships hold other numbers.
    static Snapshot fromBytes(std::span<const std::byte> bytes);
  };
  Snapshot save() const;
  void save(Snapshot& snapshot) const;
  void restore(const Snapshot& snapshot);
  /// Makes Bullet forget its contact points, their impulses and its solver's random state, of all
  /// bodies of the world: what would be left of the future after a rollback.
  void forgetContacts();

  /// Draws waterlines, the parts of the load (1 m for 1 % of the ship's weight) and a grid of waves
  /// around each ship; waterlines of floats. btCollisionWorld::debugDrawWorld calls it.
  void debugDraw(btIDebugDraw& drawer) const;

  /// Observers must outlive the Seaway or be removed.
  void addObserver(TickObserver& observer);
  void removeObserver(TickObserver& observer) noexcept;

 private:
  class Listener;  // to the world's ticks

  Ship& add(std::shared_ptr<const Hydrodynamics> hydrodynamics, const ShipSettings& settings,
            btRigidBody* own);
  void raise(std::uint32_t faults) noexcept;
  void beginCalmLevel(double step) noexcept;
  void endCalmLevel(double step) noexcept;
  void placeWater() noexcept;
  void saveCalmLevel(Snapshot& snapshot) const noexcept;
  void restoreCalmLevel(const Snapshot& snapshot) noexcept;
  bool worldLives() const noexcept;
  void followSea() noexcept;
  void settleSea() noexcept;
  void enterComing();
  void enterNext() noexcept;
  void setShared(const std::shared_ptr<const SeaState>& sea) noexcept;
  void beforeTick(btScalar step) noexcept;
  void afterTick(btScalar step) noexcept;

  btDiscreteDynamicsWorld& world_;
  std::shared_ptr<const SeaState> sea_;
  WorldFrame frame_;
  std::uint64_t seaKey_ = 0;
  /// Of calm water over its height at the beginning [m], and its speed [m/s].
  struct CalmLevel {
    double level = 0.0, wanted = 0.0, rate = 1.0, now = 0.0;
  };
  CalmLevel calm_;
  double firstLevel_ = 0.0;  // WorldFrame::seaLevel at the beginning
  double time_ = 0.0;
  btScalar step_ = 0;                                      // of this tick
  double preparedFor_ = 0.0;                               // length of tick; 0: none
  std::uint32_t faults_ = kStepOk, tickFaults_ = kStepOk;  // since they were cleared; of this tick
  std::array<FaultCount, 32> faultCounts_{};               // of each bit
  std::vector<std::shared_ptr<const SeaTables>> tables_;
  std::vector<std::unique_ptr<Ship>> ships_;
  std::unique_ptr<SeaChange> change_;      // makes tables; null until it is needed
  std::unique_ptr<ComingSea> coming_;      // the change that goes on; null: none
  std::vector<std::uint32_t> shipFaults_;  // of this tick
  std::vector<TickObserver*> observers_;
  std::unique_ptr<FloatFleet> floats_;
  std::unique_ptr<ThreadPool> pool_;
  std::shared_ptr<SeaWatch> watch_;  // sea and time as views see them
  std::unique_ptr<Listener> listener_;
  std::unique_ptr<WorldHook> hook_;  // last: no tick reaches us before all else is there
};

CUTWATER_PLUGIN_END
