#include "tests/verification/WigleyHull.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "hydro/database/ForwardSpeed.h"
#include "hydro/excitation/WaveExcitation.h"
#include "hydro/response/FrequencyResponse.h"
#include "hydro/ship/Afloat.h"
#include "hydro/waves/Wave.h"

namespace cutwater::test {
namespace {

constexpr double kGravity = 9.81, kDensity = 1000.0;

ShipParticulars particulars(const SurfaceMesh& wet) {
  const Loading loading{.mass = kDensity * kWigleyVolume,
                        .cog = Vec3(0.0, 0.0, 0.17 - 0.1875),  // 0.17 m above the keel
                        .gyradii = Vec3(0.105, 0.75, 0.75)};   // of roll: held here
  return afloat({{}, wet, true}, loading, {kDensity, kGravity}).ship;
}

}  // namespace

double HeadWave::speed() const { return froude * std::sqrt(kGravity * kWigleyLength); }
double HeadWave::waveNumber() const { return 2.0 * kPi / (lambda * kWigleyLength); }
double HeadWave::omegaI() const { return std::sqrt(kGravity * waveNumber()); }
double HeadWave::omegaE() const { return encounterFrequency(omegaI(), speed(), kPi, kGravity); }

double reducedFrequency(double omega) { return omega * std::sqrt(kWigleyLength / kGravity); }
double omegaOf(double reduced) { return reduced * std::sqrt(kGravity / kWigleyLength); }

SolverOutput solveWigley(const SurfaceMesh& wet, std::vector<double> omega,
                         SolveSettings settings) {
  settings.forwardSpeed = ForwardSpeedForm::Report;
  std::sort(omega.begin(), omega.end());
  const auto same = [](double a, double b) { return b - a < 1e-9 * b; };
  omega.erase(std::unique(omega.begin(), omega.end(), same), omega.end());
  settings.omega = std::move(omega);
  return buildCoefficients(particulars(wet), settings);
}

std::map<std::string, double> reducedCoefficients(const SolverOutput& solved, double omegaE,
                                                  double speed, ForwardSpeedForm form) {
  const SpeedCoefficients at = atSpeed(solved, omegaE, speed, form);
  const double unit = kDensity * kWigleyVolume, time = std::sqrt(kWigleyLength / kGravity);
  std::map<std::string, double> values;
  for (const int j : {Heave, Pitch})
    for (const int k : {Heave, Pitch}) {
      const std::string pair = std::to_string(j + 1) + std::to_string(k + 1);
      const double arm = std::pow(kWigleyLength, (j == Pitch) + (k == Pitch));
      values["a" + pair] = at.addedMass(j, k) / (unit * arm);
      values["b" + pair] = at.damping(j, k) / (unit * arm) * time;
    }
  return values;
}

std::map<std::string, double> response(const SolverOutput& solved, const HeadWave& wave,
                                       ForwardSpeedForm form) {
  auto values = reducedCoefficients(solved, wave.omegaE(), wave.speed(), form);
  const Mat6& restoring = solved.ship.restoring;
  const CVec6 force = WaveExcitation(solved, form).at(wave.omegaI(), kPi, wave.speed()).total();
  values["X3"] = std::abs(force[Heave]) / restoring(Heave, Heave);
  values["X5"] = std::abs(force[Pitch]) / (wave.waveNumber() * restoring(Pitch, Pitch));
  const CVec6 motion = FrequencyResponse(solved, {true, true, false, true, false, true}, form)
                           .at(wave.omegaI(), kPi, wave.speed());
  values["heave"] = std::abs(motion[Heave]);
  values["pitch"] = std::abs(motion[Pitch]) / wave.waveNumber();
  return values;
}

std::map<std::string, double> mixedMotions(const SolverOutput& solved, const HeadWave& wave,
                                           ForwardSpeedForm radiation,
                                           ForwardSpeedForm excitation) {
  const double omega = wave.omegaE();
  const CMat6 all = radiationImpedance(solved, omega, wave.speed(), radiation) -
                    omega * omega * solved.ship.massMatrix() + solved.ship.restoring;
  const CVec6 force =
      WaveExcitation(solved, excitation).at(wave.omegaI(), kPi, wave.speed()).total();
  const std::array<int, 2> free{Heave, Pitch};
  const Eigen::Matrix2cd system = all(free, free);
  const Eigen::Vector2cd motion = system.inverse() * force(free);
  return {{"heave", std::abs(motion[0])}, {"pitch", std::abs(motion[1]) / wave.waveNumber()}};
}

}  // namespace cutwater::test
