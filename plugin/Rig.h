#pragma once
#include <memory>
#include <vector>

#include "plugin/AddedMassConstraint.h"
#include "plugin/CourseRestraint.h"
#include "plugin/Lent.h"

CUTWATER_PLUGIN_BEGIN

class Ship;

/// Flags of a body that a ship takes over from Bullet.
inline constexpr int kFlagsTaken = BT_DISABLE_WORLD_GRAVITY | BT_ENABLE_GYROSCOPIC_FORCE_EXPLICIT |
                                   BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_WORLD |
                                   BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_BODY;

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
  RigConstraint(typename Lent<T>::Deleted deleted, void* ship) : lent(deleted, ship) {}
  Lent<T> lent;
  int place = 0;
};

/// What of a ship stands in the world, where others may take it out or delete it.
struct Rig {
  explicit Rig(Ship& ship);
  template <class T>
  static bool constraintDeleted(void* ship, T& dying);
  void enable(bool on) noexcept {
    if (addedMass.lent) addedMass.lent->setEnabled(on);
    if (restraint.lent) restraint.lent->setEnabled(on);
  }
  Lent<ShipMotionState> motionState;     // of the body we made
  Lent<btRigidBody> body;                // empty: it is the user's, or was deleted
  std::unique_ptr<btRigidBody> standIn;  // for one that was deleted
  RigConstraint<AddedMassConstraint> addedMass;
  RigConstraint<CourseRestraint> restraint;
  bool takenOut = false;  // the constraints, by us, as the body was out of the world
  // Of a body that was deleted; to be taken out of a world that lives.
  std::vector<btTypedConstraint*> leftOver;
};

CUTWATER_PLUGIN_END
