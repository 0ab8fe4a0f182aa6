#pragma once
#include <array>

#include "plugin/BulletTypes.h"

CUTWATER_PLUGIN_BEGIN

/// Added mass A∞, a full 6×6 as large as the ship's own, inside Bullet's stock solver, which knows
/// a scalar mass and three inertias only. Every impulse of the tick (gravity, loads, the user's
/// forces, contacts, joints) then moves M + A∞ instead of M.
///     (M + A∞)(v⁺ − v⁻) = P      as      M(v⁺ − v⁻) = P + Σ_r J_rᵀλ_r,  λ_r = −l_r J_r(v⁺ − v⁻)
///     A∞ x_r = l_r M x_r,  x_rᵀ M x_r = 1,  J_r = M x_r  in body axes, turned with the body.
/// Then J_r M⁻¹ J_sᵀ = δ_rs: without contacts one Gauss-Seidel pass is exact. With contacts or
/// joints the sweeps converge as (l/(1+l))ⁿ against a much heavier partner; see iterationsFor().
///
/// v⁻ is the velocity after the last tick's solve, not that before this one, so that an impulse
/// that a user applies between two ticks moves M + A∞ too. Call beginTick() before and endTick()
/// after each internal tick (Seaway does). Bullet's linear and angular factors are not respected:
/// hold a mode by a constraint. btMLCPSolver mishandles constraints with one body and must not be
/// used.
class AddedMassConstraint final : public btTypedConstraint {
 public:
  /// @param body      a dynamic body; keeps its own mass and inertia; must outlive this object.
  /// @param addedMass A∞ [kg, kg·m, kg·m²] about the centre of mass in body axes B, any 6×6: its
  ///                  antisymmetric part (discretisation error) is dropped, negative l are clipped.
  /// @throws HydroError ValueOutOfRange: A∞ not finite, or the body is static.
  AddedMassConstraint(btRigidBody& body, const Mat6& addedMass);

  /// States the tick's length h [s]; call in the internal pre-tick, after all impulses.
  void beginTick(btScalar step) noexcept { step_ = step; }
  /// Takes the velocity that the solver has just left, whatever actions did to the body since.
  void endTick() noexcept;
  /// Makes v⁻ the body's velocity as it is: what happened before is not felt by A∞.
  void forgetPast() noexcept;

  /// v⁻ [m/s], [rad/s] in E.
  const btVector3& linearVelocity() const noexcept { return linear_; }
  const btVector3& angularVelocity() const noexcept { return angular_; }
  void setPast(const btVector3& linear, const btVector3& angular) noexcept;

  /// Force [N] and moment [N·m] about G in E that it applied, mean over the last tick: −A∞ dv/dt.
  Vec3 force() const noexcept;
  Vec3 moment() const noexcept;

  /// Largest l: A∞ over M in the direction where it is greatest.
  double largestRatio() const noexcept;
  /// btContactSolverInfo::m_numIterations that brings a contact or joint with a much heavier
  /// partner within `tolerance` (0..1) of M + A∞: ln(tolerance)/ln(l/(1 + l)).
  int iterationsFor(double tolerance) const noexcept;

  void buildJacobian() override {}
  void getInfo1(btConstraintInfo1* info) override;
  void getInfo2(btConstraintInfo2* info) override;
  void setParam(int, btScalar, int) override {}
  btScalar getParam(int, int) const override { return 0; }

 private:
  struct Row {
    Vec3 linear, angular;  // J in B
    double ratio;          // l
  };
  void pendingChange(Vec3& linear, Vec3& angular) const noexcept;

  std::array<Row, 6> rows_;
  int count_ = 0;
  btScalar step_ = 0;
  btVector3 linear_, angular_;  // v⁻ in E
  btJointFeedback feedback_;
};

CUTWATER_PLUGIN_END
