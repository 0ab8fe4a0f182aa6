#pragma once
#include "hydro/Conventions.h"

namespace cutwater {

/// Steady way of a ship through the water, along its own heading [m/s].
struct SteadyWay {
  double ahead = 0.0;   ///< U
  double leeway = 0.0;  ///< V, to port
  bool operator==(const SteadyWay&) const = default;
};

/// The free ship, linearised about a steady way (THEORY.md, chapter 8). Motion ξ e^{st} about
/// it in axes of the steady heading; the water's momentum p = A ν in axes that follow the ship's
/// own heading and pitch; s = iω′ for waves.
///
/// ν = N ξ: velocity of G and rates in those axes, of which heading and pitch turn the steady way:
///     u = sξ₁ + Vξ₆,   v = sξ₂ − Uξ₆,   w = sξ₃ + Uξ₅,   p, q, r = sξ₄, sξ₅, sξ₆
CMat6 ownVelocities(Complex s, const SteadyWay& way);

/// The water's load, as a matrix Q of generalised force = −Q ξ (roll about the own x axis, pitch
/// about the level y, yaw about the vertical):
///     force = −d(R p_F)/dt,  moment = −d(R p_M)/dt − V × R p_F, without the own x part of both
/// cross terms. With A₁₁ = A₁₃ = 0 it is Tuck's form S Z⁰ Sᴴ (ForwardSpeed.h) times −iω; what A₁₁
/// adds does no work.
/// @param water   A(ω) + B(ω)/iω of the ship at rest, symmetric.
/// @param atRest  A(0).
CMat6 waterLoad(Complex s, const SteadyWay& way, const CMat6& water, const Mat6& atRest);

/// C of a free ship: a force and a moment for each of heave, roll and pitch, none for a place or a
/// heading. The moment of a weight that is not above the buoyancy stays about the level y of the
/// ship's own heading, so that C₄₆ = W(x_G − x_B) is of fixed axes alone.
Mat6 freeRestoring(const Mat6& restoring);
/// Of stiffness that is given beside C, what a free ship has: none of surge, sway and yaw.
Vec6 freeStiffness(const Vec6& given);

}  // namespace cutwater
