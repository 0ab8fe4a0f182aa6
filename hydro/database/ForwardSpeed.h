#pragma once
#include "hydro/database/Coefficients.h"

namespace cutwater {

/// A and B of a ship under way:
///     const SpeedCoefficients at8 = atSpeed(coefficients, omegaE, 8.0, usableForm(coefficients));
/// With Z = B + iωA, ∂Z = ∂B + iω∂A at rest, u = U/ω, T_53 = 1, T_62 = −1 (all else 0) and
/// S = I + iuT both forms of the forward-speed terms are
///     Z(U) = (Z⁰ + iu ∂Z) Sᴴ
/// Report: ∂Z as integrated, which is                                       [M03] (24)-(29)
///     A_jk(U) = A_jk + (U/ω²)∂B_jk,    B_jk(U) = B_jk − U∂A_jk,    k = 1..4
///     A_j5(U) = A_j5 − (U/ω²)B_j3 + (U/ω²)∂B_j5 + (U/ω)²∂A_j3
///     B_j5(U) = B_j5 + U A_j3 − U∂A_j5 + (U/ω)²∂B_j3
///     A_j6(U) = A_j6 + (U/ω²)B_j2 + (U/ω²)∂B_j6 − (U/ω)²∂A_j2
///     B_j6(U) = B_j6 − U A_j2 − U∂A_j6 − (U/ω)²∂B_j2
/// Tuck: ∂Z = TZ⁰, hence Z(U) = S Z⁰ Sᴴ: for instance A_53 += (U/ω²)B_33, A_35 −= (U/ω²)B_33,
/// B_53 −= U A_33, B_35 += U A_33, A_55 += (U/ω)²A_33. Passive for every U, and
/// Z_jk(U) = Z_kj(−U) [TimmanNewman62]; the report's form is neither.
/// THEORY.md, chapter 6.
struct SpeedCoefficients {
  Mat6 addedMass, damping;
};

/// At one frequency. Tuck's form does not use ∂A and ∂B.
/// @param omega ω_e [rad/s], finite, > 0.  @param speed U [m/s], any sign.
SpeedCoefficients atSpeed(const Mat6& addedMass, const Mat6& damping, const Mat6& addedMassX,
                          const Mat6& dampingX, double omega, double speed, ForwardSpeedForm form);

/// At any ω_e ≥ 0, ∞ included, interpolated between the database's frequencies. At ω = 0 the
/// entries of A_j5, A_j6 that grow as (U/ω)² are NaN; B(U) = U(A Tᵀ − ∂A), ∞ alike.
/// @throws HydroError ValueOutOfRange (ω < 0, NaN; U not finite), DatabaseIncomplete: the report's
///         form at U ≠ 0 needs ∂A and ∂B.
SpeedCoefficients atSpeed(const CoefficientTables& coefficients, double omega, double speed,
                          ForwardSpeedForm form);

/// −ω²A(U) + iωB(U) [N/m, …], the water's part of the equations of motion (5). Unlike A(U) it is
/// finite at ω = 0, where it is the stiffness −U²∂A(0)Tᵀ.                        [M03] (43), (45)
/// @param omega ω_e, 0 ≤ ω_e < ∞.  @throws as atSpeed.
CMat6 radiationImpedance(const CoefficientTables& coefficients, double omega, double speed,
                         ForwardSpeedForm form);

/// Tuck's F^U from F^ω: F^U_5 = iF^ω_3, F^U_6 = −iF^ω_2, others 0 (F_D = ω′F^ω + U F^U).
CVec6 tuckSpeedForce(const CVec6& omegaForce);

/// The database's own form; Tuck's if it lacks the x-derivatives that the report's needs.
ForwardSpeedForm usableForm(const CoefficientTables& coefficients);

/// T: T_53 = 1, T_62 = −1.
Mat6 tuckMatrix();

}  // namespace cutwater
