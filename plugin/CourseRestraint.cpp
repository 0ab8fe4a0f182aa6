#include "plugin/CourseRestraint.h"

#include <algorithm>

CUTWATER_PLUGIN_BEGIN

CourseRestraint::CourseRestraint(btRigidBody& body, const std::array<bool, 6>& modes)
    : btTypedConstraint(MAX_CONSTRAINT_TYPE, body), held_(modes) {
  course_.setIdentity();
  heading_.setIdentity();
}

void CourseRestraint::aim(const btMatrix3x3& course, const btMatrix3x3& heading,
                          const std::array<btScalar, 6>& velocity) noexcept {
  course_ = course;
  heading_ = heading;
  velocity_ = velocity;
}

void CourseRestraint::getInfo1(btConstraintInfo1* info) {
  info->m_numConstraintRows = static_cast<int>(std::count(held_.begin(), held_.end(), true));
  info->nub = 6 - info->m_numConstraintRows;
}

// Rows are scaled by √m or √I, so that J M⁻¹ Jᵀ = 1: Bullet in single precision gives up a row
// where it is below 1e-7.
void CourseRestraint::getInfo2(btConstraintInfo2* info) {
  int row = 0;
  for (std::size_t j = 0; j < 6; ++j) {
    if (!held_[j]) continue;
    const bool angular = j >= 3;
    const btVector3 axis = (angular ? heading_ : course_).getColumn(static_cast<int>(j) % 3);
    const btScalar response =
        angular ? axis.dot(m_rbA.getInvInertiaTensorWorld() * axis) : m_rbA.getInvMass();
    const btScalar scale = response > 0 ? btScalar(1) / btSqrt(response) : btScalar(1);
    const btVector3 scaled = scale * axis;
    btScalar* at = (angular ? info->m_J1angularAxis : info->m_J1linearAxis) + row * info->rowskip;
    std::copy_n(scaled.m_floats, 3, at);
    info->m_constraintError[row * info->rowskip] = scale * velocity_[j];
    ++row;
  }
}

CUTWATER_PLUGIN_END
