#include "hydro/waves/Spreading.h"

#include <cmath>

#include "hydro/Conventions.h"

namespace cutwater {

namespace {

// Γ(x + 1/2)/Γ(x) for x > 0: by its series in 1/x from 20 on, to 1e-15, and down from there.
double ratioOfGammas(double x) {
  if (x < 20.0) return ratioOfGammas(x + 1.0) * x / (x + 0.5);
  const double u = 1.0 / x;
  const double series =
      1.0 + u * (-1.0 / 8.0 +
                 u * (1.0 / 128.0 +
                      u * (5.0 / 1024.0 +
                           u * (-21.0 / 32768.0 +
                                u * (-399.0 / 262144.0 +
                                     u * (869.0 / 4194304.0 + u * (39325.0 / 33554432.0)))))));
  return std::sqrt(x) * series;
}

}  // namespace

// Γ²(s+1) 2^{2s}/Γ(2s+1) = √π Γ(s+1)/Γ(s+1/2), by the duplication formula.
double spreadingDensity(SpreadingLaw law, double exponent, double theta) {
  if (law == SpreadingLaw::Cos2s) {
    const double peak = ratioOfGammas(exponent + 0.5) / (2.0 * std::sqrt(kPi));
    return peak * std::pow(std::abs(std::cos(0.5 * theta)), 2.0 * exponent);
  }
  if (!(std::abs(theta) < 0.5 * kPi)) return 0.0;
  const double peak = ratioOfGammas(0.5 * exponent + 0.5) / std::sqrt(kPi);
  return peak * std::pow(std::cos(theta), exponent);
}

double spreadingWidth(SpreadingLaw law, double exponent) {
  if (law == SpreadingLaw::Cos2s) return std::sqrt(2.0 / (exponent + 1.0));
  const double half = 0.5 * exponent;
  return std::sqrt(2.0 * (1.0 - ratioOfGammas(half + 0.5) / ratioOfGammas(half + 1.0)));
}

}  // namespace cutwater
