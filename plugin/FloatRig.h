#pragma once
#include "plugin/AddedMassConstraint.h"
#include "plugin/Lent.h"

CUTWATER_PLUGIN_BEGIN

/// What stands in a world's list in place of a constraint whose body may be gone: it does nothing,
/// between Bullet's own fixed body and itself.
class RetiredConstraint final : public btTypedConstraint {
 public:
  RetiredConstraint() : btTypedConstraint(MAX_CONSTRAINT_TYPE, getFixedBody(), getFixedBody()) {
    setEnabled(false);
  }
  void getInfo1(btConstraintInfo1* info) override { info->m_numConstraintRows = info->nub = 0; }
  void getInfo2(btConstraintInfo2*) override {}
  void setParam(int, btScalar, int) override {}
  btScalar getParam(int, int) const override { return 0; }
};

/// Takes a constraint out of a living world's list without a look at its bodies.
void strike(btDiscreteDynamicsWorld& world, const btTypedConstraint& constraint) noexcept;

struct FloatRig {
  Lent<AddedMassConstraint> added;
  int place = 0;  // in the world's list of constraints
};

CUTWATER_PLUGIN_END
