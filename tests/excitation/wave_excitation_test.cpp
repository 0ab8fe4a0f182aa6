#include <gtest/gtest.h>

#include <cmath>

#include "hydro/Errors.h"
#include "hydro/excitation/WaveExcitation.h"
#include "tests/excitation/BoxShip.h"

namespace cutwater {
namespace {

using test::boxShip, test::kBoxDensity, test::kBoxGravity;

TEST(WaveExcitationClosedForm, LongWavesPressLikeTheSlowlyMovingSurface) {
  // As ω → 0 heave excitation is C33 and the roll moment of a beam wave C44's buoyant part;
  // k = 1e-4/m, so that terms of order kL are 2e-3.
  const Coefficients ship = boxShip();
  const double omega = std::sqrt(1e-4 * kBoxGravity);
  const CVec6 force = WaveExcitation(ship).at(omega, kPi / 2).froudeKrylov;
  EXPECT_NEAR(std::abs(force[Heave]) / ship.ship.restoring(Heave, Heave), 1.0, 2e-3);
}

TEST(WaveExcitationClosedForm, BoxInBeamAndHeadWavesHasTheIntegralOfThePressure) {
  // Heave of a box by Froude-Krylov: ρg L B e^{−kT} sinc(kL/2) in head waves, phase
  // e^{ik(x_c − x_G)}.
  const Coefficients ship = boxShip();
  const double omega = 1.5, k = omega * omega / kBoxGravity;
  const Complex heave = WaveExcitation(ship).at(omega, kPi).froudeKrylov[Heave];
  const double amplitude =
      kBoxDensity * kBoxGravity * 20.0 * 6.0 * std::exp(-2.0 * k) * std::sin(10.0 * k) / (10.0 * k);
  const Complex expected =
      std::polar(amplitude, -0.5 * k);  // centre half a metre aft of G, head waves
  EXPECT_LT(std::abs(heave - expected), 1e-6 * amplitude);  // the integral's stated accuracy
}

TEST(WaveExcitationIdentity, HeadingPlusMinusIsTheMirrorImage) {
  const Coefficients ship = boxShip();
  const WaveExcitation waves(ship);
  const CVec6 port = waves.at(1.0, 0.7).total(), starboard = waves.at(1.0, -0.7).total();
  for (int j = 0; j < 6; ++j) {
    const double sign = j % 2 == 0 ? 1.0 : -1.0;
    EXPECT_LT(std::abs(port[j] - sign * starboard[j]), 1e-9 * (1.0 + std::abs(port[j])));
  }
}

TEST(WaveExcitation, RefusesFrequenciesOutsideTheDatabase) {
  const Coefficients ship = boxShip();
  EXPECT_THROW(WaveExcitation(ship).at(4.5, 0.0), HydroError);
  EXPECT_THROW(WaveExcitation(ship).at(0.0, 0.0), HydroError);
  EXPECT_NO_THROW(WaveExcitation(ship).at(0.01, 0.0));
}

TEST(WaveExcitationIdentity, TableOfAPlainFileGivesItsOwnNodes) {
  Coefficients ship = boxShip();
  const WaveExcitation exact(ship);
  std::vector<std::vector<CVec6>> fk(3), diffraction(3);
  for (std::size_t h = 0; h < 3; ++h) {
    ship.headings.push_back(kPi / 2 * static_cast<double>(h));
    for (const double omega : ship.omega) {
      fk[h].push_back(exact.at(omega, ship.headings[h]).froudeKrylov);
      diffraction[h].push_back(exact.at(omega, ship.headings[h]).diffraction);
    }
  }
  const CVec6 expected = exact.at(1.3, -kPi / 2).total();
  Coefficients plain = ship;
  plain.adjoint = {};
  plain.froudeKrylov = fk;
  plain.diffraction = diffraction;
  const CVec6 force = WaveExcitation(plain).at(1.3, -kPi / 2).total();  // the mirror image of +90°
  EXPECT_LT((force - expected).norm(), 1e-9 * expected.norm());
}

}  // namespace
}  // namespace cutwater
