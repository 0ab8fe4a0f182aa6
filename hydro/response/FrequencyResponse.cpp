#include "hydro/response/FrequencyResponse.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <limits>
#include <vector>

#include "hydro/Errors.h"
#include "hydro/database/ForwardSpeed.h"
#include "hydro/database/FreeMotion.h"
#include "hydro/database/HullLiftFactors.h"
#include "hydro/excitation/WaveExcitation.h"
#include "hydro/waves/Encounter.h"

namespace cutwater {

namespace {

[[noreturn]] void refuse(double omegaE, const std::string& modes) {
  throw HydroError(
      Fault::MatrixSingular,
      fmt::format("FrequencyResponse: no bounded motion at omega_e = {} rad/s: {}", omegaE,
                  modes.empty() ? "singular matrix" : "nothing holds" + modes));
}

Eigen::VectorXcd solved(const CMat6& system, const std::vector<int>& free, const CVec6& force,
                        double omegaE) {
  std::string loose;
  for (const int j : free) {
    if (system.col(j)(free).isZero(0.0)) loose += std::string(" ") + kModeNames[j];
  }
  if (!loose.empty()) refuse(omegaE, loose);
  Eigen::VectorXcd solution = system(free, free).eval().partialPivLu().solve(force(free));
  if (!solution.allFinite()) refuse(omegaE, "");
  return solution;
}

}  // namespace

FrequencyResponse::FrequencyResponse(const CoefficientTables& coefficients,
                                     std::array<bool, 6> restrained,
                                     std::optional<ForwardSpeedForm> form)
    : coefficients_(coefficients),
      form_(form.value_or(coefficients.forwardSpeed)),
      excitation_(std::make_shared<const WaveExcitation>(coefficients, form_)),
      restrained_(restrained) {
  for (int j = Roll; j <= Yaw; ++j) {
    if (restrained[static_cast<std::size_t>(j)] || coefficients.ship.gyradii[j - Roll] > 0.0)
      continue;
    throw HydroError(Fault::DatabaseIncomplete,
                     "FrequencyResponse: the radii of gyration are not in the database; give them "
                     "(--gyradii)");
  }
}

FrequencyResponse::FrequencyResponse(const CoefficientTables& coefficients, const Free& free,
                                     std::array<bool, 6> restrained)
    : FrequencyResponse(coefficients, restrained, ForwardSpeedForm::Tuck) {
  free_ = true;
  if (free.hullLift)
    lift_ =
        std::make_shared<const HullLiftFactors>(coefficients, coefficients.ship.lengthOverall());
}

CMat6 FrequencyResponse::systemOnCourse(double omega, double speed) const {
  const Supplementary& given = coefficients_.ship.supplementary;
  CMat6 system = radiationImpedance(coefficients_, omega, speed, form_);
  system.diagonal() += given.stiffness.cast<Complex>();
  return system;
}

CMat6 FrequencyResponse::systemOfFree(double omega, double speed) const {
  const SteadyWay way{speed, 0.0};
  const Complex s(0.0, omega);
  const SpeedCoefficients rest = atSpeed(coefficients_, omega, 0.0, form_);
  CMat6 water = rest.addedMass.cast<Complex>();
  if (omega > 0.0) water += rest.damping.cast<Complex>() / s;
  const CMat6 symmetric = 0.5 * (water + water.transpose());
  const Mat6& atZero = coefficients_.addedMass.atZero;
  CMat6 system = waterLoad(s, way, symmetric, 0.5 * (atZero + atZero.transpose()));
  system.diagonal() += freeStiffness(coefficients_.ship.supplementary.stiffness).cast<Complex>();
  if (lift_) lift_->resist(speed, ownVelocities(s, way), system);
  return system;
}

CVec6 FrequencyResponse::at(double omegaI, double heading, double speed) const {
  CVec6 wave = excitation_->at(omegaI, heading, speed).total();
  const double waveNumber = omegaI * omegaI / coefficients_.ship.gravity;
  if (lift_) lift_->push(speed, lift_->orbital(omegaI, waveNumber, heading), wave);
  return to(wave, omegaI, heading, speed);
}

CVec6 FrequencyResponse::atOrNan(double omegaI, double heading, double speed) const {
  try {
    return at(omegaI, heading, speed);
  } catch (const HydroError& error) {
    if (error.fault() != Fault::MatrixSingular) throw;
    return CVec6::Constant(std::numeric_limits<double>::quiet_NaN());
  }
}

CVec6 FrequencyResponse::to(const CVec6& wave, double omegaI, double heading, double speed) const {
  const ShipParticulars& ship = coefficients_.ship;
  const Encounter met(omegaI, speed, heading, ship.gravity);
  const double omega = met.frequency();
  const CVec6 force = met.conjugatedIfOvertaking(wave);
  CMat6 system = free_ ? systemOfFree(omega, speed) : systemOnCourse(omega, speed);
  const Mat6 restoring = free_ ? freeRestoring(ship.restoring) : ship.restoring;
  system += (restoring - omega * omega * ship.massMatrix()).cast<Complex>();
  system.diagonal() += Complex(0.0, omega) * ship.supplementary.damping.cast<Complex>();

  std::vector<int> free;
  for (int j = 0; j < 6; ++j) {
    if (!restrained_[static_cast<std::size_t>(j)]) free.push_back(j);
  }
  CVec6 eta = CVec6::Zero();
  if (free.empty()) return eta;
  eta(free) = solved(system, free, force, met.signedFrequency());
  return met.conjugatedIfOvertaking(eta);
}

}  // namespace cutwater
