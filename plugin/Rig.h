#pragma once
#include "plugin/AddedMassConstraint.h"
#include "plugin/CourseRestraint.h"
#include "plugin/Lent.h"

CUTWATER_PLUGIN_BEGIN

/// Keeps the pose that Bullet interpolates for drawing.
class ShipMotionState : public btMotionState {
 public:
  BT_DECLARE_ALIGNED_ALLOCATOR();
  explicit ShipMotionState(const btTransform& pose) : pose_(pose) {}
  void getWorldTransform(btTransform& pose) const override { pose = pose_; }
  void setWorldTransform(const btTransform& pose) override { pose_ = pose; }

 private:
  btTransform pose_;
};

/// A constraint of ours, and where in its world's list it was seen last.
template <class T>
struct RigConstraint {
  Lent<T> lent;
  int place = 0;
};

/// What of a ship stands in the world, where others may take it out or delete it.
struct Rig {
  Rig(void (*bodyDeleted)(void*), void (*motionStateDeleted)(void*), void* ship)
      : motionState(motionStateDeleted, ship), body(bodyDeleted, ship) {}
  Lent<ShipMotionState> motionState;     // of the body we made
  Lent<btRigidBody> body;                // empty: it is the user's, or was deleted
  std::unique_ptr<btRigidBody> standIn;  // for one that was deleted
  RigConstraint<AddedMassConstraint> addedMass;
  RigConstraint<CourseRestraint> restraint;
};

CUTWATER_PLUGIN_END
