#include <gtest/gtest.h>

#include <cmath>

#include "hydro/Errors.h"
#include "hydro/forces/linear/Excitation.h"
#include "hydro/forces/linear/Restoring.h"
#include "hydro/forces/linear/Supplementary.h"
#include "hydro/incident/IncidentWaveForce.h"
#include "hydro/response/FrequencyResponse.h"
#include "tests/forces/BoxShip.h"

namespace cutwater {
namespace {

using test::boxShip, test::kBoxDensity, test::kBoxGravity;

TEST(WaveExcitationClosedForm, LongWavesPressLikeTheSlowlyMovingSurface) {
  // As ω → 0 heave excitation is C33 and the roll moment of a beam wave C44's buoyant part; k =
  // 1e-4/m, so that terms of order kL are 2e-3.
  const Coefficients ship = boxShip();
  const double omega = std::sqrt(1e-4 * kBoxGravity);
  const CVec6 force = WaveExcitation(ship).at(omega, kPi / 2).froudeKrylov;
  EXPECT_NEAR(std::abs(force[Heave]) / ship.ship.restoring(Heave, Heave), 1.0, 2e-3);
}

TEST(WaveExcitationClosedForm, BoxInBeamAndHeadWavesHasTheIntegralOfThePressure) {
  // Heave of a box by Froude-Krylov: ρg L B e^{−kT} sinc(kL/2) in head waves, phase e^{ik(x_c −
  // x_G)}.
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
  plain.adjoint.clear();
  plain.froudeKrylov = fk;
  plain.diffraction = diffraction;
  const CVec6 force = WaveExcitation(plain).at(1.3, -kPi / 2).total();  // the mirror image of +90°
  EXPECT_LT((force - expected).norm(), 1e-9 * expected.norm());
}

TEST(ExcitationForceIdentity, AgreesWithTheComplexAmplitudeAnywhereAndAtAnyTime) {
  const Coefficients ship = boxShip();
  const double omega = 1.1, beta = 0.4, course = 0.9, a = 0.7, epsilon = 0.3, x = 30.0, y = -12.0,
               t = 4.4;
  ExcitationForce force(ship, SeaState({{omega, a, epsilon, beta}}, kBoxGravity), course);
  ShipMotion motion;
  motion.time = t;
  motion.meanX = x;
  motion.meanY = y;
  const Vec6 now = force.at(motion);
  const double k = omega * omega / kBoxGravity;
  const Complex phasor =
      std::polar(a, omega * t - k * (x * std::cos(beta) - y * std::sin(beta)) + epsilon);
  const CVec6 amplitude = WaveExcitation(ship).at(omega, beta + course).total();
  EXPECT_LT((now - (phasor * amplitude).real()).norm(), 1e-9 * amplitude.norm());
  EXPECT_LT((now - force.froudeKrylov() - force.diffraction()).norm(), 1e-12 * amplitude.norm());
}

TEST(ExcitationForceIdentity, AWaveFromTheBowIsAHeadSeaWhateverTheCourse) {
  // Course 120° to port; the wave travels against it. In H the ship must see β = 180°.
  const Coefficients ship = boxShip();
  const double course = 2.0 * kPi / 3.0;
  // Direction of travel (cos β, −sin β) = −(cos ψ, sin ψ): β = π − ψ.
  ExcitationForce force(ship, SeaState({{1.0, 1.0, 0.0, kPi - course}}, kBoxGravity), course);
  const Vec6 now = force.at({});
  const CVec6 head = WaveExcitation(ship).at(1.0, kPi).total();
  EXPECT_LT((now - head.real()).norm(), 1e-9 * head.norm());
}

TEST(RestoringForce, OpposesHeaveByTheWaterplane) {
  const Coefficients ship = boxShip();
  ShipMotion motion;
  motion.eta[Heave] = 0.1;
  // Moment about G half a metre forward of the waterplane's centre: C53 = −ρg∫x dA = +ρgA·0.5.
  const Vec6 force = RestoringForce(ship).at(motion);
  EXPECT_NEAR(force[Heave], -kBoxDensity * kBoxGravity * 120.0 * 0.1, 1e-6);
  EXPECT_NEAR(force[Pitch], -kBoxDensity * kBoxGravity * 120.0 * 0.5 * 0.1, 1e-6);
}

TEST(SupplementaryForces, QuadraticRollDampingAlwaysTakesEnergy) {
  Supplementary terms;
  terms.rollDampingQuadratic = 3.0;
  terms.damping[Sway] = 2.0;
  terms.stiffness[Yaw] = 5.0;
  ShipMotion motion;
  for (const double rate : {-2.0, 2.0}) {
    motion.etaDotNow << 0, 1, 0, rate, 0, 0;
    motion.eta[Yaw] = 0.1;
    const Vec6 force = SupplementaryForces(terms).at(motion);
    EXPECT_DOUBLE_EQ(force[Roll], -3.0 * std::abs(rate) * rate);
    EXPECT_DOUBLE_EQ(force[Sway], -2.0);
    EXPECT_DOUBLE_EQ(force[Yaw], -0.5);
  }
}

TEST(FrequencyResponseClosedForm, LongWavesCarryTheShipLikeARaft) {
  // ω → 0: heave 1, pitch = wave slope: head wave ζ = cos(ωt + kx), bow-down pitch −∂ζ/∂x = k sin:
  // phase −90°... with η5 = −∂ζ/∂x = k sin(ωt) = Re{−ik e^{iωt}}. Restoring and wave pressure
  // balance to order kL.
  // The made-up diffraction has no moment arm and does not vanish beside pitch's: left out. G amidships:
  // the 1e-3 by which heave's inertia lifts her is 6 % of this slope at half a metre of lever.
  Coefficients ship = boxShip(Vec3(0.0, 0.0, 0.3));
  for (auto& vectors : ship.adjoint) vectors.setZero();
  const double k = 2e-4, omega = std::sqrt(k * kBoxGravity);
  const CVec6 eta = FrequencyResponse(ship).at(omega, kPi);
  EXPECT_NEAR(std::abs(eta[Heave] - 1.0), 0.0, 0.01);
  EXPECT_NEAR(std::abs(eta[Pitch] - Complex(0.0, -k)) / k, 0.0, 0.02);
}

TEST(FrequencyResponseIdentity, SolvesTheEquationOfMotion) {
  Coefficients ship = boxShip();
  ship.ship.supplementary.damping[Roll] = 1e5;
  ship.ship.supplementary.stiffness[Yaw] = 2e6;
  const double omega = 1.2;  // a node of the grid: A and B are the data themselves
  const CVec6 eta = FrequencyResponse(ship).at(omega, 0.8);
  Mat6 inertia = ship.ship.massMatrix() + ship.addedMass[11], damping = ship.damping[11];
  Mat6 stiffness = ship.ship.restoring;
  damping(Roll, Roll) += 1e5;
  stiffness(Yaw, Yaw) += 2e6;
  const CVec6 left = (-omega * omega * inertia + stiffness).cast<Complex>() * eta +
                     Complex(0, omega) * (damping.cast<Complex>() * eta);
  const CVec6 force = WaveExcitation(ship).at(omega, 0.8).total();
  EXPECT_LT((left - force).norm(), 1e-9 * force.norm());
}

TEST(FrequencyResponse, RestrainedModesDoNotMove) {
  const Coefficients ship = boxShip();
  const CVec6 eta = FrequencyResponse(ship, {true, false, false, false, false, true}).at(1.0, 0.5);
  EXPECT_EQ(eta[Surge], Complex(0.0));
  EXPECT_EQ(eta[Yaw], Complex(0.0));
  EXPECT_GT(std::abs(eta[Heave]), 0.0);
}

TEST(FrequencyResponse, RefusesAFreeRotationWithoutRadiusOfGyration) {
  Coefficients ship = boxShip();
  ship.ship.gyradii = Vec3::Zero();
  EXPECT_ANY_THROW(FrequencyResponse{ship});
  EXPECT_NO_THROW(FrequencyResponse(ship, {false, false, false, true, true, true}));
}

}  // namespace
}  // namespace cutwater
