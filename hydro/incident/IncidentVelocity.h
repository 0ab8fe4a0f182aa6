#pragma once
#include "hydro/waves/Encounter.h"

namespace cutwater {

/// v = −∂φ_I/∂n, its mean over each panel [m/s per m], the normal velocity of the diffracted wave,
/// crest over G. Of a symmetric mesh the even and the odd part at its port panels,
/// v_port = even + odd, v_starboard = even − odd ([M03] (69)-(79), with the factor e^{kz} missing
/// in (76)); else `even` is v, `odd` empty.
/// THEORY.md, chapter 3.
struct IncidentVelocity {
  Eigen::VectorXcd even, odd;
};

/// v as the equations at ω_e need it: conjugated where the ship overtakes the wave.
inline IncidentVelocity atEncounter(const IncidentVelocity& v, const Encounter& met) {
  return {met.conjugatedIfOvertaking(v.even), met.conjugatedIfOvertaking(v.odd)};
}

}  // namespace cutwater
