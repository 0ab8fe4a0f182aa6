#include "hydro/database/ForwardSpeed.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "hydro/Errors.h"
#include "hydro/database/Interpolation.h"

namespace cutwater {

namespace {

/// What one frequency has at rest.
struct AtRest {
  Mat6 addedMass, damping, addedMassX, dampingX;
};

AtRest atRest(const CoefficientTables& c, double omega, double speed, ForwardSpeedForm form) {
  if (!std::isfinite(speed)) {
    throw HydroError(Fault::ValueOutOfRange, fmt::format("atSpeed: speed = {} m/s", speed));
  }
  AtRest rest{addedMassAt(c, omega), dampingAt(c, omega), Mat6::Zero(), Mat6::Zero()};
  if (form == ForwardSpeedForm::Tuck) {
    rest.addedMassX = tuckMatrix() * rest.addedMass;
    rest.dampingX = tuckMatrix() * rest.damping;
  } else if (speed != 0.0) {
    if (c.addedMassX.empty() || c.dampingX.empty()) {
      throw HydroError(
          Fault::DatabaseIncomplete,
          fmt::format("atSpeed: speed = {} m/s, form report: needs added_mass_x and damping_x, "
                      "which the database does not hold (form tuck needs neither)",
                      speed));
    }
    rest.addedMassX = addedMassXAt(c, omega);
    rest.dampingX = dampingXAt(c, omega);
  }
  return rest;
}

SpeedCoefficients combined(const AtRest& rest, double omega, double speed) {
  const Complex iu(0.0, speed / omega), i(0.0, omega);
  const CMat6 Z = rest.damping.cast<Complex>() + i * rest.addedMass.cast<Complex>();
  const CMat6 ZX = rest.dampingX.cast<Complex>() + i * rest.addedMassX.cast<Complex>();
  const CMat6 moving = Z + iu * ZX;
  const CMat6 ZU = moving - iu * (moving * tuckMatrix().transpose().cast<Complex>());
  return {ZU.imag() / omega, ZU.real()};
}

/// ω = 0 or ∞: B, ∂B and their shares are 0; (U/ω)²∂A Tᵀ is infinite or 0.
SpeedCoefficients limit(const AtRest& rest, double speed, bool infinite) {
  const Mat6 Tt = tuckMatrix().transpose(), growing = rest.addedMassX * Tt;
  SpeedCoefficients result{rest.addedMass, speed * (rest.addedMass * Tt - rest.addedMassX)};
  for (int n = 0; n < 36 && !infinite && speed != 0.0; ++n) {
    if (growing(n) != 0.0) result.addedMass(n) = std::numeric_limits<double>::quiet_NaN();
  }
  return result;
}

}  // namespace

ForwardSpeedForm usableForm(const CoefficientTables& c) {
  const bool derivatives =
      !c.addedMassX.empty() && !c.dampingX.empty() && (c.adjoint.empty() || !c.adjointX.empty());
  return derivatives ? c.forwardSpeed : ForwardSpeedForm::Tuck;
}

Mat6 tuckMatrix() {
  Mat6 T = Mat6::Zero();
  T(Pitch, Heave) = 1.0;
  T(Yaw, Sway) = -1.0;
  return T;
}

CVec6 tuckSpeedForce(const CVec6& omegaForce) {
  return Complex(0.0, 1.0) * (tuckMatrix().cast<Complex>() * omegaForce);
}

SpeedCoefficients atSpeed(const Mat6& addedMass, const Mat6& damping, const Mat6& addedMassX,
                          const Mat6& dampingX, double omega, double speed, ForwardSpeedForm form) {
  if (form == ForwardSpeedForm::Report) {
    return combined({addedMass, damping, addedMassX, dampingX}, omega, speed);
  }
  const Mat6 T = tuckMatrix();
  return combined({addedMass, damping, T * addedMass, T * damping}, omega, speed);
}

SpeedCoefficients atSpeed(const CoefficientTables& c, double omega, double speed,
                          ForwardSpeedForm form) {
  const AtRest rest = atRest(c, omega, speed, form);
  if (speed == 0.0) return {rest.addedMass, rest.damping};
  if (omega > 0.0 && std::isfinite(omega)) return combined(rest, omega, speed);
  return limit(rest, speed, omega > 0.0);
}

CMat6 radiationImpedance(const CoefficientTables& c, double omega, double speed,
                         ForwardSpeedForm form) {
  if (!std::isfinite(omega)) {
    throw HydroError(Fault::ValueOutOfRange,
                     fmt::format("radiationImpedance: omega = {} rad/s", omega));
  }
  const AtRest rest = atRest(c, omega, speed, form);
  const Complex i(0.0, 1.0);
  // iωZ(U) with every division by ω carried out: (iωZ − U∂Z)(I − i(U/ω)Tᵀ), and ∂B/ω → 0.
  const CMat6 Z = rest.damping.cast<Complex>() + i * omega * rest.addedMass.cast<Complex>();
  const CMat6 ZX = rest.dampingX.cast<Complex>() + i * omega * rest.addedMassX.cast<Complex>();
  const Mat6 slope = omega > 0.0 ? Mat6(rest.dampingX / omega) : Mat6(Mat6::Zero());
  const CMat6 ZXoverOmega = slope.cast<Complex>() + i * rest.addedMassX.cast<Complex>();
  const CMat6 Tt = tuckMatrix().transpose().cast<Complex>();
  return i * omega * Z - speed * ZX + speed * (Z * Tt) + i * speed * speed * (ZXoverOmega * Tt);
}

}  // namespace cutwater
