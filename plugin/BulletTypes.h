#pragma once
#include <btBulletDynamicsCommon.h>

#include "hydro/Conventions.h"

/// Conversions between Bullet's types and ours, and the namespace of a precision. Everything that
/// sees Bullet is compiled twice, for Bullet in single and in double precision, and lives in an
/// inline namespace of its own: users write cutwater::Seaway and link one of
/// cutwater::plugin and cutwater::plugin_float64. A mix of the two does not link.
#ifdef BT_USE_DOUBLE_PRECISION
#define CUTWATER_PLUGIN_BEGIN \
  namespace cutwater {        \
  inline namespace bullet_float64 {
#else
#define CUTWATER_PLUGIN_BEGIN \
  namespace cutwater {        \
  inline namespace bullet_float32 {
#endif
#define CUTWATER_PLUGIN_END \
  }                         \
  }

CUTWATER_PLUGIN_BEGIN

/// The only conversions between Bullet's types and ours. Bullet's world axes are E (z up, metres,
/// z = 0 at calm water); a ship's body axes are B, origin in G, which is Bullet's centre of mass.
inline Vec3 fromBullet(const btVector3& v) {
  return {static_cast<double>(v.x()), static_cast<double>(v.y()), static_cast<double>(v.z())};
}

inline btVector3 toBullet(const Vec3& v) {
  return {static_cast<btScalar>(v.x()), static_cast<btScalar>(v.y()), static_cast<btScalar>(v.z())};
}

/// R_EB of a Bullet basis: v_E = R_EB v_B.
inline Mat3 fromBullet(const btMatrix3x3& basis) {
  Mat3 r;
  for (int i = 0; i < 3; ++i) r.row(i) = fromBullet(basis[i]).transpose();
  return r;
}

inline btMatrix3x3 toBulletBasis(const Mat3& r) {
  btMatrix3x3 basis;
  for (int i = 0; i < 3; ++i) basis[i] = toBullet(r.row(i).transpose());
  return basis;
}

CUTWATER_PLUGIN_END
