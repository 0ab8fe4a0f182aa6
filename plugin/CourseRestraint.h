#pragma once
#include <array>

#include "plugin/BulletTypes.h"

CUTWATER_PLUGIN_BEGIN

/// Holds some of a ship's modes on a mean course that moves and turns. One row a mode asks for the
/// velocity that brings the ship onto the course by the end of the tick, whatever acts on it. (A
/// stock six degree of freedom joint to the world would trail behind a moving course.)
class CourseRestraint : public btTypedConstraint {
 public:
  /// @param body  must outlive this object.  @param modes  held, surge to yaw.
  CourseRestraint(btRigidBody& body, const std::array<bool, 6>& modes);

  /// For the next tick, in the world's axes and units.
  /// @param course   axes of surge, sway, heave, as columns.
  /// @param heading  axes of roll, pitch, yaw, as columns.
  /// @param velocity wanted along each [units/s, rad/s].
  void aim(const btMatrix3x3& course, const btMatrix3x3& heading,
           const std::array<btScalar, 6>& velocity) noexcept;

  void buildJacobian() override {}
  void getInfo1(btConstraintInfo1* info) override;
  void getInfo2(btConstraintInfo2* info) override;
  void setParam(int, btScalar, int) override {}
  btScalar getParam(int, int) const override { return 0; }

 private:
  std::array<bool, 6> held_;
  btMatrix3x3 course_, heading_;
  std::array<btScalar, 6> velocity_{};
};

CUTWATER_PLUGIN_END
