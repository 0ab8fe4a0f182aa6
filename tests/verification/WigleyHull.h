#pragma once
#include <map>
#include <string>
#include <vector>

#include "hydro/bem/BuildCoefficients.h"

namespace cutwater::test {

/// Wigley hull III of Journée's experiments: V, G and gyradius as he gives them.
inline constexpr double kWigleyLength = 3.0, kWigleyVolume = 0.0780;  // [m], [m³]

/// A head wave of length λ met at a Froude number.
struct HeadWave {
  double froude;  ///< U/√(gL)
  double lambda;  ///< λ/L

  double speed() const;       ///< U [m/s]
  double waveNumber() const;  ///< k [1/m]
  double omegaI() const;      ///< [rad/s]
  double omegaE() const;      ///< [rad/s]
};

/// ω_e √(L/g) and back.
double reducedFrequency(double omega);
double omegaOf(double reduced);

/// Coefficients of the hull at exactly these frequencies [rad/s], in any order: nothing below is
/// interpolated.
SolverOutput solveWigley(const SurfaceMesh& wet, std::vector<double> omega,
                         SolveSettings settings = {});

/// a33 = A33/ρV, b33 = B33/ρV·√(L/g), a35 = A35/ρVL, a55 = A55/ρVL², … at speed, by name.
std::map<std::string, double> reducedCoefficients(const SolverOutput& solved, double omegaE,
                                                  double speed, ForwardSpeedForm form);

/// Those, X3 = |F3|/C33, X5 = |F5|/(k C55), and of the hull free in heave and pitch alone
/// heave = |η3| and pitch = |η5|/k per metre of wave amplitude.
std::map<std::string, double> response(const SolverOutput& solved, const HeadWave& wave,
                                       ForwardSpeedForm form);

/// heave and pitch with A, B in one form and F_I + F_D in another.
std::map<std::string, double> mixedMotions(const SolverOutput& solved, const HeadWave& wave,
                                           ForwardSpeedForm radiation, ForwardSpeedForm excitation);

}  // namespace cutwater::test
