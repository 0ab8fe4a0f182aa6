#pragma once
#include "plugin/BulletTypes.h"

CUTWATER_PLUGIN_BEGIN

/// How a Bullet world measures: its up axis, its unit of length and of mass, the height of calm
/// water.
///     Seaway seaway(world, sea, {.up = WorldFrame::Up::Y, .metresPerUnit = 0.01});
///     world.setGravity(btVector3(0, -980.665f, 0));
///     const btVector3 above = seaway.frame().place(ship.position() + Vec3(0, 0, 20));
///
/// Everything that Cutwater gives and takes is SI in E (z up, z = 0 at calm water, with which it
/// moves: Seaway::setCalmLevel);
/// everything of Bullet's own (bodies, worlds, btIDebugDraw) is in the world's axes and units. The
/// world's origin in plan is E's. Gravity is to be given to Bullet in the world's units, as for any
/// scene.
struct WorldFrame {
  enum class Up {
    Z,  ///< world x, y, z = E's: a ship at heading 0 has x forward, y to port, z up
    Y   ///< world x = E's x, y = E's z, z = −E's y: x forward, y up, z to starboard
  };
  Up up = Up::Z;
  double metresPerUnit = 1.0;
  double kilogramsPerUnit = 1.0;
  double seaLevel = 0.0;  ///< height of calm water in the world's units

  /// @throws HydroError ValueOutOfRange: a unit that is not positive, a level that is not finite.
  void check() const;

  /// v_W = axes() v_E.
  Mat3 axes() const noexcept;
  btVector3 upwards() const noexcept {
    return up == Up::Z ? btVector3(0, 0, 1) : btVector3(0, 1, 0);
  }

  // Directions and angular velocities: turned only.
  Vec3 directionToEarth(const btVector3& v) const noexcept {
    const Vec3 w = fromBullet(v);
    return up == Up::Z ? w : Vec3(w.x(), -w.z(), w.y());
  }
  btVector3 direction(const Vec3& v) const noexcept {
    return toBullet(up == Up::Z ? v : Vec3(v.x(), v.z(), -v.y()));
  }
  // Lengths and velocities.
  Vec3 lengthToEarth(const btVector3& v) const noexcept {
    return metresPerUnit * directionToEarth(v);
  }
  btVector3 length(const Vec3& v) const noexcept { return direction(v / metresPerUnit); }
  // Places.
  Vec3 placeToEarth(const btVector3& v) const noexcept {
    Vec3 place = directionToEarth(v);
    place.z() -= seaLevel;
    return metresPerUnit * place;
  }
  btVector3 place(const Vec3& v) const noexcept {
    return direction(v / metresPerUnit + seaLevel * Vec3::UnitZ());
  }
  // Forces and impulses; moments and angular impulses.
  double forceUnit() const noexcept { return kilogramsPerUnit * metresPerUnit; }  ///< N per unit
  double momentUnit() const noexcept { return forceUnit() * metresPerUnit; }      ///< N·m per unit
  btVector3 force(const Vec3& v) const noexcept { return direction(v / forceUnit()); }
  btVector3 moment(const Vec3& v) const noexcept { return direction(v / momentUnit()); }
  Vec3 forceToEarth(const btVector3& v) const noexcept { return forceUnit() * directionToEarth(v); }
  Vec3 momentToEarth(const btVector3& v) const noexcept {
    return momentUnit() * directionToEarth(v);
  }
  // Rotations: R_W = axes() R_E axes()ᵀ, so that a body's own axes are turned like the world's.
  Mat3 rotationToEarth(const btMatrix3x3& r) const noexcept {
    const Mat3 w = fromBullet(r);
    return up == Up::Z ? w : Mat3(axes().transpose() * w * axes());
  }
  btMatrix3x3 rotation(const Mat3& r) const noexcept {
    return toBulletBasis(up == Up::Z ? r : Mat3(axes() * r * axes().transpose()));
  }
  /// A 6×6 mass [kg, kg·m, kg·m²] in the world's axes and units.
  Mat6 mass(const Mat6& m) const noexcept;
  /// Momentum and moment of momentum of a ship in its own axes, likewise.
  Vec6 momentum(const Vec6& p) const noexcept;
  /// Principal moments of inertia [kg·m²] of body axes, likewise.
  btVector3 inertia(const Vec3& principal) const noexcept;
};

CUTWATER_PLUGIN_END
