#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "hydro/geometry/SurfaceMesh.h"
#include "plugin/WorldFrame.h"

namespace cutwater {
class FloatBody;
class FloatHull;
}  // namespace cutwater

CUTWATER_PLUGIN_BEGIN

class AddedMassConstraint;
class FloatFleet;
struct FloatRig;  // what of a float stands in the world

/// What the water is to a body that floats by its shape.
struct FloatSettings {
  /// What displaces water, instead of the collision shape: closed, normals out, in the body's own
  /// axes and the world's units, about the body's centre of mass. For bodies whose collision shape
  /// is a triangle mesh, is simpler than they are, or has holes that fill.
  std::optional<SurfaceMesh> mesh{};
  double waterDensity = 1025.0;  ///< [kg/m³], 1 .. 20000
  /// C of −½ρ(C/2) v_n|v_n| on each wetted face, 0 .. 10: v_n is the face's velocity through the
  /// water along its normal. A cube along an edge has C_D = C, a ball ½C, a cylinder across ⅔C.
  double normalDrag = 1.05;
  double friction = 0.005;  ///< C_F of the wetted faces, along them, 0 .. 1
  /// Of √(gL), L = V^{1/3}: the speed below which drag across faces falls with v instead of v², so
  /// that small swings end, 0 .. 1. Eddies at edges take more of them than of a steady flow.
  double slowDrag = 0.1;
};

/// One body that floats, sinks and drifts by its collision shape: a crate, barrel, buoy, raft,
/// swimmer, container, a floe. Made by Seaway::addFloat; no database.
///     btRigidBody crate(mass, nullptr, &box, inertia);
///     world.addRigidBody(&crate);
///     cutwater::Float& floating = seaway.addFloat(crate);
///
/// What acts on it besides Bullet's own gravity, forces, contacts and joints:
///     pressure    of water and undisturbed waves on its wet surface, p = ρg(H − z): buoyancy in
///                 any attitude, and the waves' push
///     added mass  of the ellipsoid like it, times the wet share of its volume, in Bullet's solver
///                 (AddedMassConstraint): contacts, ropes and blows move body and water. The
///                 water's own acceleration acts on it, too, so that a body as heavy as water
///                 moves with it
///     entry       what of it comes into the water sets that water going: a blow, never a bounce
///     drag        of its wet faces through the moving water, and what a body that heaves gives to
///                 the waves it makes; both are solved for within the tick and never turn the
///                 velocity round, whatever the tick, however light the body
/// The water's velocity is taken at the middle of what is wet, with its gradient: a float should be
/// short against the waves. Its pressure is taken at every corner of its surface.
///
/// Not in it: wakes and waves of ships and other floats, what a ship's hull shelters, wind.
///
/// The body is yours. It may be moved, pushed, locked by factors, made static or kinematic (no load
/// then), given another mass, put to sleep, taken out of the world and put in again. Its shape as
/// it was in addFloat floats, whatever the body's shape is now. A wet body does not fall asleep in
/// waves, nor before it lies still. setLinearVelocity in the water is taken for a blow, which body
/// and water resist; call velocityWasSet() after it.
class Float {
 public:
  /// Internal: use Seaway::addFloat.
  Float(btDiscreteDynamicsWorld& world, const WorldFrame& frame, btRigidBody& body,
        const FloatSettings& settings);
  ~Float();
  Float(const Float&) = delete;
  Float& operator=(const Float&) = delete;

  /// As given. Not to be used once it was deleted.
  btRigidBody& body() const noexcept { return *body_; }
  /// Whether the body stood in the world at the last tick. One that was deleted does not.
  bool inWorld() const noexcept { return listed_; }

  double volume() const noexcept;  ///< of the whole body [m³]
  /// Of the last tick: wet volume [m³], its share of the whole, wet area [m²].
  double wetVolume() const noexcept;
  double immersion() const noexcept;
  double wetArea() const noexcept;
  /// Load of the pressure at its start, in E [N], about the centre of mass [N·m].
  Vec6 pressure() const noexcept;
  /// Velocity of the water there [m/s] in E; 0 of a body that is dry.
  const Vec3& waterVelocity() const noexcept { return waterVelocity_; }
  /// Pieces of its waterline then, in E [m].
  std::vector<std::pair<Vec3, Vec3>> waterline() const;
  /// Half axes [m] of the ellipsoid that its added mass is taken from.
  const Vec3& semiAxes() const noexcept;
  /// Null while the body is static.
  const AddedMassConstraint* addedMass() const noexcept;

  /// The body was set in motion or moved elsewhere: what happened before is not felt. A move
  /// farther than the body is long is seen without it.
  void velocityWasSet() noexcept;

  /// Exact state, as Ship::Snapshot. Of a body that is in no world only that.
  struct Snapshot {
    bool inWorld = false;
    btTransform transform{btTransform::getIdentity()}, interpolated{btTransform::getIdentity()};
    std::array<btVector3, 4> velocities{};  // linear, angular; interpolated
    std::array<btVector3, 2> past{};        // v⁻
    btMatrix3x3 known{btMatrix3x3::getIdentity()};
    btVector3 knownAt{0, 0, 0};
    int activation = 1;
    int now = 3;
    double stillFor = 0.0, share = 0.0;
    std::array<Mat3, 2> addedMass{Mat3::Zero(), Mat3::Zero()};
    std::array<Vec3, 3> momentum{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};  // arm, of the water
    bool begun = false;
  };
  void save(Snapshot& snapshot) const noexcept;
  void restore(const Snapshot& snapshot) noexcept;

 private:
  friend class FloatFleet;

  enum class Now { Away, Held, Asleep, Ticks };
  // A tick, in this order, by FloatFleet.
  std::uint32_t look() noexcept;
  bool wakesIn(bool waves, btScalar step) noexcept;
  std::uint32_t begin(bool waves, const Vec3& water, const Mat3& gradient, const Vec3& convective,
                      btScalar step) noexcept;
  std::uint32_t end() noexcept;

  bool findBody() noexcept;
  std::uint32_t keepConstraint();
  std::uint32_t mendState() noexcept;
  void heedMass() noexcept;
  void heedMoves() noexcept;
  void keepAwake(bool waves) noexcept;
  void strikeOut() noexcept;
  btTypedConstraint* retire();
  Vec6 massNow() const noexcept;
  void remember() noexcept;

  btDiscreteDynamicsWorld& world_;
  WorldFrame frame_;
  btRigidBody* body_;
  const btCollisionShape* shape_;  // by its address
  std::shared_ptr<const FloatHull> hull_;
  std::unique_ptr<FloatBody> water_;
  std::unique_ptr<FloatRig> rig_;
  int place_ = 0;  // in the world's list
  bool listed_ = true, ticked_ = false, dry_ = false;
  Now now_ = Now::Ticks;
  btScalar inverseMass_ = 0;
  btVector3 inverseInertia_{0, 0, 0};
  struct Known {
    btTransform pose;
    btVector3 linear, angular;
  } known_;
  Vec3 waterVelocity_ = Vec3::Zero();
};

CUTWATER_PLUGIN_END
