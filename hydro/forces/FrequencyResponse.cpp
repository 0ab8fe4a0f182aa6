#include "hydro/forces/FrequencyResponse.h"

#include <Eigen/LU>
#include <string>
#include <vector>

#include "hydro/Errors.h"
#include "hydro/database/Interpolation.h"

namespace cutwater {

FrequencyResponse::FrequencyResponse(const Coefficients& coefficients,
                                     std::array<bool, 6> restrained)
    : coefficients_(coefficients), excitation_(coefficients), restrained_(restrained) {}

CVec6 FrequencyResponse::at(double omega, double heading) const {
  const ShipParticulars& ship = coefficients_.ship;
  const CVec6 force = excitation_.at(omega, heading).total();
  const Mat6 inertia = ship.massMatrix() + addedMassAt(coefficients_, omega);
  Mat6 damping = dampingAt(coefficients_, omega);
  Mat6 stiffness = ship.restoring;
  damping.diagonal() += ship.supplementary.damping;
  stiffness.diagonal() += ship.supplementary.stiffness;
  const CMat6 system = (-omega * omega * inertia + stiffness).cast<Complex>() +
                       Complex(0.0, omega) * damping.cast<Complex>();

  std::vector<int> free;
  for (int j = 0; j < 6; ++j) {
    if (!restrained_[static_cast<std::size_t>(j)]) free.push_back(j);
  }
  CVec6 eta = CVec6::Zero();
  if (free.empty()) return eta;
  const Eigen::VectorXcd solution = system(free, free).eval().partialPivLu().solve(force(free));
  if (!solution.allFinite()) {
    throw HydroError(Fault::MatrixSingular, "FrequencyResponse: no motion at omega = " +
                                                std::to_string(omega) + " rad/s: singular matrix");
  }
  eta(free) = solution;
  return eta;
}

}  // namespace cutwater
