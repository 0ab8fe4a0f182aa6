#include <gtest/gtest.h>

#include <cmath>

#include "hydro/Errors.h"
#include "hydro/database/ForwardSpeed.h"
#include "hydro/excitation/WaveExcitation.h"
#include "hydro/geometry/panels/WetSurface.h"
#include "hydro/response/FrequencyResponse.h"
#include "tests/excitation/BoxShip.h"
#include "tests/forces/WaveLoads.h"

namespace cutwater {
namespace {

using test::boxShip, test::kBoxDensity, test::kBoxGravity;

// b and b^x as polynomials that interpolation meets exactly. A real system answers at −ω with the
// conjugate; b holds a factor i besides, so b(−ω) = −conj b(ω), b^x(−ω) = conj b^x(ω), and a signed
// ω′ can be put into the formula itself.
Complex omegaVector(double w) { return kBoxDensity * Complex(0.2 * w, 0.5 + 0.1 * w * w); }
Complex speedVector(double w) { return kBoxDensity * Complex(0.3 - 0.1 * w * w, 0.2 * w); }

// The box with all that forward speed needs; ∂A, ∂B such that no two entries are alike.
Coefficients movingBox() {
  Coefficients c = test::boxShip();
  const auto panels = static_cast<Eigen::Index>(c.ship.wetSurface.faces.size());
  const auto vectors = [&](Complex value) {
    Coefficients::AdjointVectors b = Coefficients::AdjointVectors::Constant(6, panels, value);
    for (int j = 0; j < 6; ++j) b.row(j) *= 1.0 + 0.1 * j;
    return b;
  };
  const Mat6 shape = Mat6::NullaryExpr([](Eigen::Index j, Eigen::Index k) {
    return std::cos(1.0 + 2.0 * static_cast<double>(j + 6 * k));
  });
  for (std::size_t i = 0; i < c.omega.size(); ++i) {
    const double w = c.omega[i];
    c.adjoint[i] = vectors(omegaVector(w));
    c.adjointX.values.push_back(vectors(speedVector(w)));
    c.addedMassX.values.push_back(0.1 * c.ship.mass / (1.0 + w * w) * shape);
    c.dampingX.values.push_back(0.1 * c.ship.mass * w * w * w * std::exp(-w) * shape);
  }
  c.adjoint.atZero = vectors(omegaVector(0.0));
  c.adjointX.atZero = vectors(speedVector(0.0));
  c.addedMassX.atZero = 0.1 * c.ship.mass * shape;
  return c;
}

// F_D by its formula with the signed ω′.
CVec6 expectedDiffraction(const Coefficients& c, double omegaI, double heading, double speed) {
  const double w = encounterFrequency(omegaI, speed, heading, kBoxGravity);
  const PanelMesh mesh = c.wet().panels();
  const Complex factor = (w * omegaVector(w) + speed * speedVector(w)) / speedVector(0.0);
  return factor *
         diffractionForce(c.adjointX.atZero, mesh, {omegaI, heading, kBoxGravity}, c.ship.cog);
}

TEST(EncounterFrequencyClosedForm, HeadSeasMeetOftenerFollowingSeasAreOvertaken) {
  EXPECT_DOUBLE_EQ(encounterFrequency(1.0, 5.0, kPi, kBoxGravity), 1.0 + 5.0 / kBoxGravity);
  EXPECT_DOUBLE_EQ(encounterFrequency(1.0, 5.0, 0.0, kBoxGravity), 1.0 - 5.0 / kBoxGravity);
  EXPECT_LT(encounterFrequency(2.5, 5.0, 0.0, kBoxGravity), 0.0);
  EXPECT_NEAR(encounterFrequency(1.0, 5.0, kPi / 2, kBoxGravity), 1.0, 1e-15);
  EXPECT_EQ(encounterFrequency(1.0, 0.0, 0.3, kBoxGravity), 1.0);
}

TEST(WaveExcitationIdentity, OvertakenWavesAreTheFormulaAtNegativeFrequency) {
  const Coefficients ship = movingBox();
  const WaveExcitation waves(ship);
  int overtaken = 0;
  for (const double omegaI : {0.6, 1.2, 1.9, 2.4}) {
    for (const double heading : {0.0, 0.5, 2.0, kPi}) {
      if (encounterFrequency(omegaI, 6.0, heading, kBoxGravity) > 4.0)
        continue;  // the last of the grid
      const CVec6 found = waves.at(omegaI, heading, 6.0).diffraction;
      const CVec6 expected = expectedDiffraction(ship, omegaI, heading, 6.0);
      EXPECT_LT((found - expected).norm(), 1e-12 * expected.norm()) << omegaI << ' ' << heading;
      overtaken += encounterFrequency(omegaI, 6.0, heading, kBoxGravity) < 0.0 ? 1 : 0;
    }
  }
  EXPECT_GE(overtaken, 3);
}

TEST(WaveExcitationIdentity, SpeedDoesNotChangeTheIncidentWavesForce) {
  const Coefficients ship = movingBox();
  const WaveExcitation waves(ship);
  EXPECT_EQ(waves.at(1.3, 0.4, 7.0).froudeKrylov, waves.at(1.3, 0.4).froudeKrylov);
}

TEST(WaveExcitationIdentity, DiffractionIsContinuousThroughZeroEncounterFrequency) {
  // U(1 ± ε) about ω′ = 0; F_D changes by order ε of itself.
  const Coefficients ship = movingBox();
  for (const auto form : {ForwardSpeedForm::Report, ForwardSpeedForm::Tuck}) {
    const WaveExcitation waves(ship, form);
    const double omegaI = 1.2, speed = kBoxGravity / omegaI, epsilon = 1e-7;
    ASSERT_LT(encounterFrequency(omegaI, speed * (1.0 + epsilon), 0.0, kBoxGravity), 0.0);
    const CVec6 at = waves.at(omegaI, 0.0, speed).diffraction;
    for (const double side : {-1.0, 1.0}) {
      const CVec6 beside = waves.at(omegaI, 0.0, speed * (1.0 + side * epsilon)).diffraction;
      EXPECT_LT((beside - at).norm(), 10.0 * epsilon * at.norm() + 1e-6 * kBoxDensity);
    }
  }
}

TEST(WaveExcitationIdentity, TucksSpeedForceComesFromHeaveAndSwayAlone) {
  Coefficients ship = movingBox();
  ship.adjointX = {};  // not needed
  const double omegaI = 1.1, heading = 2.2, speed = 4.0;
  const double w = encounterFrequency(omegaI, speed, heading, kBoxGravity);
  const CVec6 force =
      WaveExcitation(ship, ForwardSpeedForm::Tuck).at(omegaI, heading, speed).diffraction;
  const CVec6 perOmega = expectedDiffraction(movingBox(), omegaI, heading, 0.0) /
                         omegaVector(omegaI) *
                         (omegaVector(w) / omegaI);  // F^ω at ω_e: modes share one polynomial
  CVec6 expected = w * perOmega;
  expected[Pitch] += speed * Complex(0.0, 1.0) * perOmega[Heave];
  expected[Yaw] -= speed * Complex(0.0, 1.0) * perOmega[Sway];
  EXPECT_LT((force - expected).norm(), 1e-12 * expected.norm());
}

TEST(WaveExcitation, SaysWhatADatabaseLacksAtSpeed) {
  Coefficients ship = movingBox();
  ship.adjointX = {};
  EXPECT_NO_THROW(WaveExcitation(ship).at(1.0, 0.0));
  try {
    WaveExcitation(ship).at(1.0, 0.0, 3.0);
    FAIL();
  } catch (const HydroError& error) {
    EXPECT_EQ(error.fault(), Fault::DatabaseIncomplete);
    EXPECT_NE(std::string(error.what()).find("speed = 3"), std::string::npos) << error.what();
  }
  // Head seas at 4 rad/s and 3 m/s are met at 8.9 rad/s: beyond 4 rad/s only with vectors of ω = ∞.
  Coefficients all = movingBox();
  EXPECT_THROW(WaveExcitation(all).at(4.0, kPi, 3.0), HydroError);
  all.adjoint.atInfinity = all.adjoint.values.back();
  all.adjointX.atInfinity = all.adjointX.values.back();
  EXPECT_NO_THROW(WaveExcitation(all).at(4.0, kPi, 3.0));
}

Coefficients withTable(const Coefficients& ship) {
  const WaveExcitation exact(ship);
  Coefficients table = ship;
  table.adjoint = {};
  table.adjointX = {};
  table.diffractionTable = {{0.0, 5.0}, {kPi / 2, kPi * 5 / 6, kPi}, {}, {}};
  DiffractionTable& t = table.diffractionTable;
  for (int i = 0; i < 21; ++i) t.waveOmega.push_back(0.5 + 0.05 * i);
  for (const double speed : t.speeds) {
    for (const double heading : t.headings) {
      for (const double omega : t.waveOmega)
        t.values.push_back(exact.at(omega, heading, speed).diffraction);
    }
  }
  return table;
}

TEST(WaveExcitationIdentity, TableAtItsOwnSpeedsGivesItsOwnForces) {
  const Coefficients ship = movingBox(), table = withTable(ship);
  const WaveExcitation exact(ship), read(table);
  for (const double heading : {kPi, -kPi / 2}) {
    for (const double omega : {0.5, 1.0, 1.234, 1.5}) {
      const CVec6 expected = exact.at(omega, heading, 5.0).total();
      const CVec6 found = read.at(omega, heading, 5.0).total();
      // between nodes 3/128 h⁴ of the fourth derivative, (kL)⁴ at most some ten: 1e-5
      EXPECT_LT((found - expected).norm(), 1e-5 * expected.norm()) << omega;
    }
  }
  const CVec6 between = read.at(1.0, kPi * 11 / 12, 5.0).diffraction;
  const CVec6 mean =
      0.5 * (exact.at(1.0, kPi * 5 / 6, 5.0).diffraction + exact.at(1.0, kPi, 5.0).diffraction);
  EXPECT_LT((between - mean).norm(), 1e-9 * mean.norm());
  EXPECT_NO_THROW(read.at(1.0, kPi));
}

// Columns at 90°, 150° and 180°: a gap of 60° between the first two, of 270° behind them.
TEST(WaveExcitation, TableIsNotInterpolatedOverWideGaps) {
  const Coefficients table = withTable(movingBox());
  const WaveExcitation read(table);
  const auto refusal = [&](double heading) -> std::string {
    try {
      read.at(1.0, heading, 5.0);
    } catch (const HydroError& error) {
      EXPECT_EQ(error.fault(), Fault::ValueOutOfRange);
      return error.what();
    }
    return "";
  };
  EXPECT_NE(refusal(kPi * 2 / 3).find("heading 120 deg lies in a gap of 60 deg"),
            std::string::npos);
  EXPECT_NE(refusal(0.0).find("heading 0 deg lies in a gap of 270 deg"), std::string::npos);
  EXPECT_EQ(refusal(-kPi * 11 / 12), "");  // the mirror image of 165°
  EXPECT_EQ(refusal(kPi / 2), "");
}

TEST(WaveExcitation, TableRefusesOtherSpeedsAndTheOtherForm) {
  const Coefficients table = withTable(movingBox());
  const auto faultOf = [&](double omega, double speed, ForwardSpeedForm form) {
    try {
      WaveExcitation(table, form).at(omega, kPi, speed);
    } catch (const HydroError& error) {
      return error.fault();
    }
    return Fault::FileMalformed;
  };
  EXPECT_EQ(faultOf(1.0, 4.0, ForwardSpeedForm::Report), Fault::ValueOutOfRange);
  EXPECT_EQ(faultOf(1.6, 5.0, ForwardSpeedForm::Report), Fault::ValueOutOfRange);
  EXPECT_EQ(faultOf(1.0, 5.0, ForwardSpeedForm::Tuck), Fault::BadArgument);
  EXPECT_EQ(faultOf(1.0, 0.0, ForwardSpeedForm::Tuck), Fault::FileMalformed);  // none
  // At rest the table of the frequency grid serves where this one has no such speed.
  Coefficients grid = table;
  grid.diffractionTable = {{5.0}, {kPi}, {1.0}, {CVec6::Zero()}};
  EXPECT_THROW(WaveExcitation(grid).at(1.0, kPi), HydroError);  // it has none either
  grid.headings = {kPi};
  grid.froudeKrylov.assign(1, std::vector<CVec6>(grid.omega.size(), CVec6::Zero()));
  grid.diffraction.assign(1, std::vector<CVec6>(grid.omega.size(), CVec6::Constant(7.0)));
  EXPECT_LT((WaveExcitation(grid).at(1.0, kPi).diffraction - CVec6::Constant(7.0)).norm(), 1e-12);
  EXPECT_GT(WaveExcitation(grid).at(1.0, kPi).froudeKrylov.norm(), 1.0);  // integrated
  Coefficients nothing = table;
  nothing.diffractionTable = {};
  EXPECT_THROW(WaveExcitation(nothing).at(1.0, kPi, 5.0), HydroError);
}

TEST(WaveForceIdentity, AShipUnderWayMeetsThePhasesAtTheEncounterFrequency) {
  const Coefficients ship = movingBox();
  const double omega = 1.9, beta = 0.3, speed = 7.0, t = 5.3;
  const double omegaE = encounterFrequency(omega, speed, beta, kBoxGravity);
  ASSERT_LT(omegaE, 0.0);
  test::WaveLoads loads(ship, SeaState({{omega, 0.5, 0.2, beta}}, kBoxGravity), {0.0, speed});
  TickInput now;
  now.time = t;
  now.meanX = speed * t;
  const CVec6 amplitude = WaveExcitation(ship).at(omega, beta, speed).total();
  const Vec6 expected = (std::polar(0.5, omegaE * t + 0.2) * amplitude).real();
  EXPECT_LT((loads.evaluate(now) - expected).norm(), 1e-12 * amplitude.norm());
}

TEST(FrequencyResponseIdentity, SolvesTheEquationOfMotionAtSpeedAlsoWhenOvertaking) {
  const Coefficients ship = movingBox();
  const double speed = 6.0;
  for (const auto form : {ForwardSpeedForm::Report, ForwardSpeedForm::Tuck}) {
    for (const double omegaI : {0.9, 2.2}) {
      const double w = encounterFrequency(omegaI, speed, 0.3, kBoxGravity);
      const CVec6 eta = FrequencyResponse(ship, {}, form).at(omegaI, 0.3, speed);
      const SpeedCoefficients c = atSpeed(ship, std::abs(w), speed, form);
      // A(U) and B(U) are even in ω′: (5) holds with the signed one.
      const CMat6 system =
          (-w * w * (ship.ship.massMatrix() + c.addedMass) + ship.ship.restoring).cast<Complex>() +
          Complex(0.0, w) * c.damping.cast<Complex>();
      const CVec6 force = WaveExcitation(ship, form).at(omegaI, 0.3, speed).total();
      EXPECT_LT((system * eta - force).norm(), 1e-9 * force.norm()) << "omega' = " << w;
    }
  }
}

TEST(FrequencyResponseIdentity, HeaveRollAndPitchAreContinuousWhereTheWavesStandStill) {
  const Coefficients ship = movingBox();
  const double omegaI = 1.2, speed = kBoxGravity / (omegaI * std::cos(0.3)), epsilon = 1e-6;
  for (const auto form : {ForwardSpeedForm::Report, ForwardSpeedForm::Tuck}) {
    const FrequencyResponse response(ship, {true, true, false, false, false, true}, form);
    const CVec6 at = response.at(omegaI, 0.3, speed);
    for (const double side : {-1.0, 1.0}) {
      const CVec6 beside = response.at(omegaI, 0.3, speed * (1.0 + side * epsilon));
      EXPECT_LT((beside - at).norm(), 30.0 * epsilon * at.norm());
    }
  }
}

TEST(FrequencyResponse, NamesTheModesThatNothingHoldsWhereTheWavesStandStill) {
  // ω_I = 1.25 is exact in binary, so that ω′ is 0 to the last bit.
  const Coefficients ship = movingBox();
  const double omegaI = 1.25, speed = kBoxGravity / omegaI;
  ASSERT_EQ(encounterFrequency(omegaI, speed, 0.0, kBoxGravity), 0.0);
  try {
    FrequencyResponse(ship, {}, ForwardSpeedForm::Tuck).at(omegaI, 0.0, speed);
    FAIL();
  } catch (const HydroError& error) {
    EXPECT_EQ(error.fault(), Fault::MatrixSingular);
    EXPECT_NE(std::string(error.what()).find("surge sway"), std::string::npos) << error.what();
    EXPECT_EQ(std::string(error.what()).find("heave"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace cutwater
