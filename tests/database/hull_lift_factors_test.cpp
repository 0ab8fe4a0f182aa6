#include <gtest/gtest.h>

#include <cmath>

#include "hydro/database/HullLiftFactors.h"
#include "tests/excitation/BoxShip.h"

namespace cutwater {
namespace {

using test::boxShip;

/// Mean of f(x) over the box's length, x from its middle, by Gauss-Legendre points in many cells.
template <class Function>
Complex meanOver(double length, Function f) {
  constexpr int kCells = 200;
  const double inner = std::sqrt(0.6), weights[] = {5.0 / 18, 8.0 / 18, 5.0 / 18};
  Complex sum = 0.0;
  for (int i = 0; i < kCells; ++i) {
    for (int n = 0; n < 3; ++n) {
      const double x = length * ((i + 0.5 + 0.5 * (n - 1) * inner) / kCells - 0.5);
      sum += weights[n] / kCells * f(x);
    }
  }
  return sum;
}

// e = 2(m + a₂₂)/L, d = 2 m a₂₂/e: a straight run is stable where e d > m a₂₂.
TEST(HullLiftFactorsClosedForm, AreThoseOfMassAndAddedMass) {
  const Coefficients box = boxShip();
  const double m = box.ship.mass, a = 1.1 * m;
  const HullLiftFactors lift(box, 20.0);
  EXPECT_DOUBLE_EQ(lift.side, 2.0 * (m + a) / 20.0);
  EXPECT_DOUBLE_EQ(lift.side * lift.turn, 2.0 * m * a);
}

// The box reaches 10 m either way of hull axes' origin, G is half a metre before it, half of its
// draught is 1 m. Across the hull the water moves with −aω sin β e^{kz} e^{i(ωt − kx cos β)}, x
// from G; its mean, and the slope of its least-squares line, 12/L² times the mean of x·v. The
// lengths of wave take in both branches of the closed form.
TEST(HullLiftFactorsIdentity, OrbitalVelocityIsTheMeanAndSlopeOfTheWavesOverTheHull) {
  const HullLiftFactors lift(boxShip(), 20.0);
  const double g = test::kBoxGravity, middle = -0.5, depth = 1.0, L = 20.0;
  for (const double omega : {0.05, 0.0989, 0.0991, 0.4, 1.1, 2.7}) {
    const double k = omega * omega / g;
    for (const double beta : {0.0, 0.4, kPi / 2, 2.2, kPi, -1.0}) {
      const auto water = [&](double x) {
        return -omega * std::sin(beta) * std::exp(-k * depth) *
               std::polar(1.0, -k * std::cos(beta) * (middle + x));
      };
      const Complex mean = meanOver(L, water);
      const Complex slope = 12.0 / (L * L) * meanOver(L, [&](double x) { return x * water(x); });
      const auto found = lift.orbital(omega, k, beta);
      EXPECT_LT(std::abs(found.side - mean), 1e-9 * omega) << omega << ' ' << beta;
      EXPECT_LT(std::abs(found.turn - slope), 1e-9 * omega / L) << omega << ' ' << beta;
    }
  }
}

// At k L cos β/2 = 0.01 the series and the closed form meet.
TEST(HullLiftFactorsIdentity, OrbitalVelocityHasNoStepWhereLongWavesBegin) {
  const HullLiftFactors lift(boxShip(), 20.0);
  const double k = 0.001, beta = 0.3, edge = k / std::cos(beta);
  const auto below = lift.orbital(1.0, edge * (1.0 - 1e-12), beta),
             above = lift.orbital(1.0, edge * (1.0 + 1e-12), beta);
  EXPECT_LT(std::abs(above.side - below.side), 1e-9);
  EXPECT_LT(std::abs(above.turn - below.turn), 1e-9 / 20.0);
}

}  // namespace
}  // namespace cutwater
