#pragma once
#include <Eigen/Geometry>

#include "plugin/BulletTypes.h"

CUTWATER_PLUGIN_BEGIN

/// R_z: from axes turned by `angle` [rad] about +z.
inline Mat3 rotationZ(double angle) {
  return Eigen::AngleAxisd(angle, Vec3::UnitZ()).toRotationMatrix();
}

/// The two halves of a velocity or a force, each by its own rotation.
inline Vec6 rotated(const Mat3& linear, const Mat3& angular, const Vec6& v) {
  Vec6 result;
  result << linear * v.head<3>(), angular * v.tail<3>();
  return result;
}

CUTWATER_PLUGIN_END
