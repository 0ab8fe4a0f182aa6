#pragma once
#include <array>
#include <memory>
#include <optional>

#include "hydro/database/Coefficients.h"

namespace cutwater {

class WaveExcitation;
struct HullLiftFactors;

/// Below this ω_e [rad/s] surge, sway and yaw, which have no stiffness, grow without bound and are
/// not theory.
inline constexpr double kLeastEncounterFrequency = 0.1;

/// Motions in regular waves by the frequency domain, at forward speed U.
///     const Coefficients frigate = readCoefficients("frigate.h5");  // must outlive the response
///     const FrequencyResponse response(frigate);
///     const double heave = std::abs(response.at(0.6, kPi, 8.0)[Heave]);  // [m/m], head waves
///
///   {−ω_e²(M + A(U)) + iω_e(B(U) + B_s) + (C + C_s)} η̂ = F_I + F_D                [M03] (5)
/// with A, B the solver's own values, interpolated in ω_e and continued above the resolved
/// frequency, and B_s, C_s the linear supplementary terms; a quadratic roll damping is not linear
/// and is left out. η(t) = Re{η̂ e^{iω′t}} with the signed ω′ = ω_I − kU cos β: for ω′ < 0 the
/// equation is solved at ω_e = |ω′| for conj(F) and the answer conjugated. Answers below
/// kLeastEncounterFrequency are of no use in surge, sway and yaw.
///
/// That is a ship on a fixed course. A free ship (Mean::Free of ShipSettings.h), linearised about
/// its steady way, obeys
///   {−ω′²M + iω′B_s + C + C_s + Q(U) + lift} η̂ = F_I + F_D + lift of the orbital velocity
/// with Q of database/FreeMotion.h, Tuck's form and what A₁₁ adds to it, Tuck's form of F_D, no
/// stiffness given for surge, sway and yaw, and the lift of the hull (HullLiftFactors.h).
/// THEORY.md, chapter 1.
class FrequencyResponse {
 public:
  /// Of a free ship.
  struct Free {
    bool hullLift = true;
  };
  /// @param coefficients must outlive this object.
  /// @param restrained   modes held: their η̂ is 0 and their equations are dropped.
  /// @param form         of the forward-speed terms; absent: the database's own.
  /// @throws HydroError DatabaseIncomplete: a rotation is free and its radius of gyration is 0, not
  ///         known (a plain BEMIO file has none).
  explicit FrequencyResponse(const CoefficientTables& coefficients,
                             std::array<bool, 6> restrained = {},
                             std::optional<ForwardSpeedForm> form = {});
  /// Of a free ship.  @throws as the other.
  FrequencyResponse(const CoefficientTables& coefficients, const Free& free,
                    std::array<bool, 6> restrained = {});

  /// η̂ [m/m, rad/m] about G per metre of wave amplitude, crest over G's mean position at t = 0.
  /// @param omegaI ω_I [rad/s].  @param heading β [rad].  @param speed U [m/s].
  /// @throws HydroError ValueOutOfRange: ω_I beyond the database's last frequency, or ω_e where the
  ///         database has no vectors for ω = ∞; a speed, heading or frequency that its tables lack.
  ///         DatabaseIncomplete: no excitation, or none at a speed. MatrixSingular, naming the
  ///         modes: a free mode has no stiffness, inertia or damping at all, as surge and sway at
  ///         ω′ = 0.
  CVec6 at(double omegaI, double heading, double speed = 0.0) const;
  /// The same, but nan in all modes where MatrixSingular would be thrown.
  CVec6 atOrNan(double omegaI, double heading, double speed = 0.0) const;
  /// The answer to another force than the waves' own, F(t) = Re{F e^{iω′t}} [N/m, N·m/m], at their
  /// frequency of encounter; arguments, answer and errors as of at().
  CVec6 to(const CVec6& force, double omegaI, double heading, double speed = 0.0) const;

 private:
  CMat6 systemOnCourse(double omega, double speed) const;
  CMat6 systemOfFree(double omega, double speed) const;

  const CoefficientTables& coefficients_;
  ForwardSpeedForm form_;
  std::shared_ptr<const WaveExcitation> excitation_;
  std::array<bool, 6> restrained_;
  bool free_ = false;
  std::shared_ptr<const HullLiftFactors> lift_;  // of a free ship that has it
};

}  // namespace cutwater
