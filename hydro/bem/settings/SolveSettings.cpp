#include "hydro/bem/settings/SolveSettings.h"

#include <cmath>

namespace cutwater {
namespace {

/// first, …, last times `step` √(g/L).
std::vector<double> multiples(const ShipParticulars& ship, double step, int first, int last) {
  const double unit = step * std::sqrt(ship.gravity / ship.length());
  std::vector<double> omega;
  for (int i = first; i <= last; ++i) omega.push_back(unit * i);
  return omega;
}

}  // namespace

std::vector<double> usualOmega(const ShipParticulars& ship) { return multiples(ship, 0.36, 1, 60); }

std::vector<double> usualWaveOmega(const ShipParticulars& ship) {
  return multiples(ship, 0.18, 4, 40);
}

}  // namespace cutwater
