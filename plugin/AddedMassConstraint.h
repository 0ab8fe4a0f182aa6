#pragma once
#include <array>

#include "plugin/BulletTypes.h"

CUTWATER_PLUGIN_BEGIN

/// Added mass A∞, a full 6×6 as large as the ship's own, inside Bullet's stock solver, which knows
/// a scalar mass and three inertias only. Every impulse of the tick (gravity, loads, the user's
/// forces, contacts, joints) then moves M + A∞ instead of M. Seaway makes one for each ship; for a
/// body without other hydrodynamics:
///     AddedMassConstraint added(body, addedMass);
///     world.addConstraint(&added);
///     // in the internal pre-tick: added.beginTick(step);   in an action: added.endTick();
///
///     (M + A∞)(v⁺ − v⁻) = P      as      M(v⁺ − v⁻) = P + Σ_r J_rᵀλ_r,   λ_r = −l_r J_r(v⁺ − v⁻)
///     A∞ x_r = l_r M x_r,   x_rᵀ M x_r = 1,   J_r = M x_r
/// in body axes, turned with the body, or in axes that the caller gives (follow): a ship's turn
/// with its heading and pitch but do not heel with it.
/// When the axes R turn, A∞ turns with them, and what acts is the rate of the water's momentum:
///     force = −d(R A∞ Rᵀ v)/dt,   so that A∞ v⁻ above is the momentum p⁻ at the last solve.
/// Over any motion that returns on itself it sums to nothing: a rolling and heaving ship does not
/// drift by it, as it would with R A∞ Rᵀ dv/dt (roll times heave acceleration has a mean). Of axes
/// that do not roll, the part about their x axis stays with the body (hydro/forces/OwnAxes.h). What
/// of p⁻ no row can carry is given to the body as an impulse.
/// A ship on a fixed course has a mean velocity V (setMean) of which its linear theory says all in
/// its terms b(U), c(U), K^U: V's momentum then turns with the axes, without any force.
/// J_r M⁻¹ J_sᵀ = δ_rs (but for a heeled body's inertia in upright axes, where a few passes do):
/// without contacts one Gauss-Seidel pass is exact. With contacts or joints the sweeps converge as
/// (l/(1+l))ⁿ against a much heavier partner; see iterationsFor().
///
/// v⁻ is the velocity after the last tick's solve, not that before this one, so that an impulse
/// that a user applies between two ticks moves M + A∞ too. A body whose linear or angular factor is
/// 0 along an axis of the world is held there by Bullet; it moves with M + A∞ in the others,
/// P A∞ P with P = diag(0 or 1). btMLCPSolver mishandles constraints with one body and must not be
/// used.
/// THEORY.md, chapter 10.
class AddedMassConstraint : public btTypedConstraint {
 public:
  /// @param body      a dynamic body; keeps its own mass and inertia; must outlive this object.
  /// @param addedMass A∞ [kg, kg·m, kg·m²] about the centre of mass in body axes (of the axes
  ///                  followed), any 6×6: its antisymmetric part (discretisation error) is dropped,
  ///                  negative l are clipped.
  /// @throws HydroError ValueOutOfRange: A∞ not finite, or the body is static.
  AddedMassConstraint(btRigidBody& body, const Mat6& addedMass);
  /// The same for a body that is held still just now, by a mass of 0.
  /// @param mass  M of the body when it is not [kg, kg·m²], diagonal in its axes, > 0.
  AddedMassConstraint(btRigidBody& body, const Mat6& addedMass, const Vec6& mass);

  /// States the tick's length h [s]; call in the internal pre-tick, after all impulses.
  void beginTick(btScalar step) noexcept;
  /// Axes of A∞ in the world's: of its first three rows and columns, and of the other three.
  struct TurningAxes {
    Mat3 linear = Mat3::Identity(), angular = Mat3::Identity();
  };
  /// From now on the axes of A∞ are these, not the body's. Call before forgetPast() at the start
  /// and before each tick in which they have changed.
  /// @param frame  of the world: v_W = frame v_E, z of E up.
  /// @param share  of the momentum that stands still when they turn, 1 in the theory; the rest
  ///        turns with them (TurningLimits of hydro/forces/OwnAxes.h).
  void follow(const TurningAxes& axes, const Mat3& frame, double share = 1.0) noexcept {
    followed_ = axes;
    frame_ = frame;
    share_ = share;
    follows_ = true;
  }
  /// What changes of A∞ from one solve to the next, in its axes and the world's units: a hull that
  /// enters or leaves the water.
  struct Change {
    Mat6 now = Mat6::Zero();   ///< A∞ from now on, symmetric
    Mat6 left = Mat6::Zero();  ///< of the one before: goes its own way, and takes its momentum
    Vec6 met = Vec6::Zero();   ///< momentum that came with what is new
  };
  /// Call before beginTick. What is new and came without momentum has to be set going: a blow.
  void change(const Change& change) noexcept;
  /// A∞ is this, and was it at v⁻: nothing has changed.
  void setAddedMass(const Mat6& addedMass) noexcept;
  /// The body's M has changed [kg, kg·m²], diagonal in its axes, > 0.
  void setMass(const Vec6& mass) noexcept;
  /// A rigid mass L that is fixed to the body beside its own and turns with it, off its centre as
  /// it may be: cargo, water in a tank. (M + A∞ + L)(v⁺ − v⁻) = P. Its momentum stands in the
  /// world,
  ///     force = −d(R L Rᵀ v)/dt,   R the body's axes
  /// and −V × p about a centre of mass that moves with V is the caller's, as of A∞. Call before
  /// beginTick.
  /// @param mass  L from now on, symmetric, ≥ 0, about the centre of mass in body axes.
  /// @param kept  that of it whose momentum at v⁻ it has: L as it was, less what has left, with
  ///        what came with the body's velocity. What is new beyond it came at rest, relative to V.
  void carry(const Mat6& mass, const Mat6& kept) noexcept;
  /// L is this, and was it at v⁻ in these body axes.
  /// @param carries  what carries() was then: with an L of 0 rows are summed in another order.
  void setCarried(const Mat6& mass, const Mat3& pastBody, bool carries) noexcept;
  /// L was not 0 at some time.
  bool carries() const noexcept { return carries_; }
  /// Body axes in the world's at v⁻.
  const Mat3& pastBody() const noexcept { return pastBody_; }
  /// What the last tick's L took of the solver's impulse: R L Rᵀ(v⁺ − V) less what it had before,
  /// with what no row could give it [units of momentum], in the world's axes.
  const Vec6& carriedChange() const noexcept { return carriedChange_; }
  /// V [units/s] in the world's axes. Without it V = 0.
  void setMean(const btVector3& velocity) noexcept { mean_ = fromBullet(velocity); }
  /// Off: it applies nothing until it is on again, when what happened before is not felt.
  void setActive(bool on) noexcept;
  /// Takes the velocity that the solver has just left, whatever actions did to the body since.
  void endTick() noexcept;
  /// Makes v⁻ the body's velocity as it is: what happened before is not felt by A∞.
  void forgetPast() noexcept;

  /// v⁻ [m/s], [rad/s] in E.
  const btVector3& linearVelocity() const noexcept { return linear_; }
  const btVector3& angularVelocity() const noexcept { return angular_; }
  /// Axes of A∞ when v⁻ was solved for.
  const TurningAxes& pastAxes() const noexcept { return pastAxes_; }
  void setPast(const btVector3& linear, const btVector3& angular, const TurningAxes& axes) noexcept;
  /// R A∞ Rᵀ v⁻ [units of momentum], in the world's axes.
  Vec6 momentum() const noexcept;

  /// Force [N] and moment [N·m] about G in E that it applied, mean over the last tick:
  /// −d(R A∞ Rᵀ v)/dt.
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
  struct Row {               // of M + A∞ with the body free, or held by its factors
    Vec3 linear, angular;    // J in the axes of A∞
    Vec3 linearX, angularX;  // x = M⁻¹J
    double ratio;            // l
  };
  TurningAxes axes() const noexcept;
  void findRows(const Mat6& addedMass) noexcept;
  void heedFactors() noexcept;
  void pendingChange(Vec3& linear, Vec3& angular) const noexcept;
  bool stands(const TurningAxes& now) const noexcept;
  Vec6 pastMomentum() const noexcept;
  Vec6 carriedInto(const TurningAxes& now) const noexcept;
  Mat6 bodyMassIn(const Mat6& mass, const TurningAxes& axes, const Mat3& body) const noexcept;
  Mat6 total() const noexcept;
  Vec6 relativeVelocity(const TurningAxes& axes) const noexcept;
  Vec6 momentumOfCarried() const noexcept;
  Vec6 momentumInto(const TurningAxes& now) const noexcept;
  Vec6 changeByTurning(const TurningAxes& now) const noexcept;
  void giveWhatNoRowCarries() noexcept;

  Mat6 addedMass_;                      // A∞, symmetric
  Mat6 projection_ = Mat6::Identity();  // of a body that is held, onto what is free
  Mat6 kept_;                           // of that at v⁻, if it has changed since
  Vec6 met_ = Vec6::Zero();
  bool changed_ = false;
  Vec6 root_;  // √M
  std::array<Row, 6> rows_;
  int count_ = 0;
  bool held_ = false;          // by a factor: rows are of P A∞ P
  double largestRatio_ = 0.0;  // of the free body
  btScalar step_ = 0;
  btVector3 linear_, angular_;  // v⁻ in E
  TurningAxes pastAxes_;        // of v⁻
  TurningAxes solved_;          // of the solve under way
  TurningAxes followed_;        // the caller's
  Mat3 frame_ = Mat3::Identity();
  double share_ = 1.0;
  bool follows_ = false, active_ = true;
  Vec3 mean_ = Vec3::Zero();  // V in W
  // L: now, and of it what has its momentum at v⁻; body axes now and then.
  Mat6 carried_ = Mat6::Zero(), carriedKept_ = Mat6::Zero();
  Mat3 body_ = Mat3::Identity(), pastBody_ = Mat3::Identity();
  bool carries_ = false;
  Vec6 carriedBefore_ = Vec6::Zero(), carriedChange_ = Vec6::Zero();  // in W
  Vec6 given_ = Vec6::Zero();  // impulse of the tick under way that no row carries, in W
  btJointFeedback feedback_;
};

CUTWATER_PLUGIN_END
