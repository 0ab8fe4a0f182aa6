#include "hydro/forces/FreeResponse.h"

#include <Eigen/LU>
#include <cmath>

#include "hydro/memory/RadiationModel.h"

namespace cutwater {

FreeResponse::FreeResponse(const Coefficients& coefficients, const RadiationModel& model)
    : model_(model),
      lift_(coefficients, coefficients.ship.lengthOverall()),
      mass_(coefficients.ship.massMatrix()),
      stiffness_(freeRestoring(coefficients.ship.restoring)),
      damping_(coefficients.ship.supplementary.damping),
      addedStiffness_(freeStiffness(coefficients.ship.supplementary.stiffness)),
      slow_(slowFrequency(coefficients.ship)) {
  model.sum();
  atRest_ = model.waterMass(0.0).real();
}

double FreeResponse::slowFrequency(const ShipParticulars& ship) {
  return 0.53 * std::sqrt(ship.gravity / ship.lengthOverall());
}

double FreeResponse::share(double omega, double slow) noexcept {
  const double ratio = omega / slow, fourth = ratio * ratio * ratio * ratio;
  return fourth / (1.0 + fourth);
}

FreeResponse::Answer FreeResponse::at(double omega, const SteadyWay& way, const CVec6& force,
                                      const ActiveParts& parts) const noexcept {
  const Complex s(0.0, omega);
  const CMat6 water = model_.waterMass(omega), velocities = ownVelocities(s, way);
  CMat6 system = waterLoad(s, way, water, atRest_);
  system += (stiffness_ - omega * omega * mass_).cast<Complex>();
  if (parts.supplementary)
    system.diagonal() += (addedStiffness_.cast<Complex>() + s * damping_.cast<Complex>());
  if (parts.hullLift) lift_.resist(way.ahead, velocities, system);
  CVec6 right = force;
  for (int j = 0; j < 6; ++j) {
    if (!parts.restrained[static_cast<std::size_t>(j)]) continue;
    system.row(j).setZero();
    system(j, j) = 1.0;
    right[j] = 0.0;
  }
  Answer answer;
  answer.motion = system.partialPivLu().solve(right);
  answer.momentum = water * (velocities * answer.motion);
  return answer;
}

}  // namespace cutwater
