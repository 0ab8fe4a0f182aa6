#include "hydro/response/FrequencyResponse.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <vector>

#include "hydro/Errors.h"
#include "hydro/database/ForwardSpeed.h"
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

CVec6 FrequencyResponse::at(double omegaI, double heading, double speed) const {
  const ShipParticulars& ship = coefficients_.ship;
  const Encounter met(omegaI, speed, heading, ship.gravity);
  const double omega = met.frequency();
  const CVec6 force = met.conjugatedIfOvertaking(excitation_->at(omegaI, heading, speed).total());
  Mat6 stiffness = ship.restoring;
  stiffness.diagonal() += ship.supplementary.stiffness;
  CMat6 system = radiationImpedance(coefficients_, omega, speed, form_) +
                 (stiffness - omega * omega * ship.massMatrix()).cast<Complex>();
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
