#include "hydro/forces/WaveExcitation.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "hydro/Errors.h"
#include "hydro/database/Interpolation.h"
#include "hydro/waves/IncidentWaveForce.h"

namespace cutwater {

namespace {

// The two columns of a table of headings that stand on either side of β, and the weight of the second.
// Headings are angles: in any order, modulo 2π.
struct Bracket {
  std::size_t low, high;
  double weight;
};

bool bracket(const std::vector<double>& headings, double beta, Bracket& found) {
  constexpr double kSame = 1e-9, kWidest = 0.5 * kPi + kSame;
  double below = -1e9, above = 1e9;
  for (std::size_t i = 0; i < headings.size(); ++i) {
    const double distance = std::remainder(headings[i] - beta, 2.0 * kPi);
    if (distance <= kSame && distance > below) {
      below = distance;
      found.low = i;
    }
    if (distance >= -kSame && distance < above) {
      above = distance;
      found.high = i;
    }
  }
  found.weight = above - below > kSame ? -below / (above - below) : 0.0;
  return above - below < kWidest;
}

CVec6 reversedOddModes(const CVec6& force) {
  CVec6 mirrored = force;
  for (const int j : {Sway, Roll, Yaw}) mirrored[j] = -mirrored[j];
  return mirrored;
}

}  // namespace

WaveExcitation::WaveExcitation(const Coefficients& coefficients) : coefficients_(coefficients) {
  if (!coefficients.ship.wetSurface.faces.empty()) {
    const ShipParticulars& ship = coefficients.ship;
    panels_ = makePanels(ship.wetSurface, ship.symmetric);
    faces_ = makePanels(triangulated(ship.wetSurface), ship.symmetric);
  }
}

WaveExcitation::Force WaveExcitation::at(double omega, double heading) const {
  const auto& grid = coefficients_.omega;
  if (grid.empty() || !(omega > 0.0) || omega > grid.back() * (1.0 + 1e-9)) {
    throw HydroError(Fault::ValueOutOfRange,
                     "WaveExcitation: omega = " + std::to_string(omega) + " rad/s is outside 0.." +
                         std::to_string(grid.empty() ? 0.0 : grid.back()) + " of the database");
  }
  if (coefficients_.adjoint.empty() || panels_.panels.empty()) return fromTable(omega, heading);
  const ShipParticulars& ship = coefficients_.ship;
  const AiryWave wave{omega, heading, ship.gravity};
  const double solved = std::clamp(omega, grid.front(), grid.back());
  Force force;
  force.froudeKrylov = froudeKrylovForce(faces_, wave, ship.cog, ship.density);
  force.diffraction =
      omega * diffractionForce(adjointAt(coefficients_, solved), panels_, wave, ship.cog);
  return force;
}

WaveExcitation::Force WaveExcitation::fromTable(double omega, double heading) const {
  const Coefficients& c = coefficients_;
  if (c.headings.empty() || c.froudeKrylov.empty()) {
    throw HydroError(Fault::DatabaseIncomplete,
                     "WaveExcitation: the database has no wave excitation");
  }
  // What a table of one side of a symmetric hull lacks is its mirror image.
  Bracket b{};
  bool mirrored = false;
  if (!bracket(c.headings, heading, b)) {
    mirrored = c.ship.symmetric && bracket(c.headings, -heading, b);
    if (!mirrored) {
      throw HydroError(Fault::ValueOutOfRange,
                       "WaveExcitation: heading " + std::to_string(heading * 180.0 / kPi) +
                           " deg is outside the database's table, which has no adjoint vectors");
    }
  }
  const double solved = std::clamp(omega, c.omega.front(), c.omega.back());
  const LocalCubic cubic = localCubic(c.omega, solved);
  Force force;
  for (std::size_t i = 0; i < cubic.count; ++i) {
    const auto mix = [&](const std::vector<std::vector<CVec6>>& table) -> CVec6 {
      const std::size_t row = cubic.first + i;
      return cubic.weight[i] *
             ((1.0 - b.weight) * table[b.low][row] + b.weight * table[b.high][row]);
    };
    force.froudeKrylov += mix(c.froudeKrylov);
    force.diffraction += mix(c.diffraction);
  }
  if (mirrored) return {reversedOddModes(force.froudeKrylov), reversedOddModes(force.diffraction)};
  return force;
}

}  // namespace cutwater
