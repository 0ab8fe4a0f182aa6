#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "hydro/Errors.h"
#include "hydro/database/ForwardSpeed.h"
#include "hydro/database/Interpolation.h"

namespace cutwater {
namespace {

// Random numbers of order 1; sums of some ten products of them: round-off 1e-14.
constexpr double kRoundOff = 1e-13;

class Random {
 public:
  Mat6 matrix() {
    return Mat6::NullaryExpr([this] { return uniform_(engine_); });
  }
  Mat6 symmetric() {
    const Mat6 m = matrix();
    return 0.5 * (m + m.transpose());
  }
  Mat6 positive() {
    const Mat6 m = matrix();
    return m * m.transpose();
  }

 private:
  std::mt19937 engine_{7};
  std::uniform_real_distribution<double> uniform_{-1.0, 1.0};
};

SpeedCoefficients tuck(const Mat6& A, const Mat6& B, double omega, double speed) {
  return atSpeed(A, B, Mat6::Zero(), Mat6::Zero(), omega, speed, ForwardSpeedForm::Tuck);
}

double distance(const SpeedCoefficients& a, const SpeedCoefficients& b) {
  return (a.addedMass - b.addedMass).cwiseAbs().maxCoeff() +
         (a.damping - b.damping).cwiseAbs().maxCoeff();
}

TEST(ForwardSpeedIdentity, TucksFormKeepsTimmanAndNewmansReversedFlow) {
  Random random;
  const Mat6 A = random.symmetric(), B = random.symmetric();
  const SpeedCoefficients ahead = tuck(A, B, 0.8, 1.7), astern = tuck(A, B, 0.8, -1.7);
  EXPECT_LT((ahead.addedMass - astern.addedMass.transpose()).cwiseAbs().maxCoeff(), kRoundOff);
  EXPECT_LT((ahead.damping - astern.damping.transpose()).cwiseAbs().maxCoeff(), kRoundOff);
}

/// Has a Hermitian matrix no eigenvalue below 0? Cholesky's pivots say so.
bool isPositive(CMat6 m) {
  for (int k = 0; k < 6; ++k) {
    if (!(m(k, k).real() > 0.0)) return false;
    for (int i = k + 1; i < 6; ++i)
      for (int j = k + 1; j < 6; ++j) m(i, j) -= m(i, k) * m(k, j) / m(k, k).real();
  }
  return true;
}

TEST(ForwardSpeedIdentity, TucksFormTakesNoEnergyFromCalmWaterAtAnySpeed) {
  // Work per period of η̂ is ∝ η̂ᴴ Herm(Z) η̂, Z = B + iωA: Herm(Z(U)) must have no negative
  // eigenvalue.
  Random random;
  const Mat6 A = random.symmetric(), B = random.positive();
  for (const double speed : {0.0, 0.5, 3.0, -8.0}) {
    const SpeedCoefficients c = tuck(A, B, 0.8, speed);
    const CMat6 Z = c.damping.cast<Complex>() + Complex(0.0, 0.8) * c.addedMass.cast<Complex>();
    const CMat6 work = 0.5 * (Z + Z.adjoint());
    EXPECT_TRUE(isPositive(work + kRoundOff * work.norm() * CMat6::Identity())) << "U = " << speed;
    EXPECT_FALSE(isPositive(work - 2.0 * work.norm() * CMat6::Identity()));
  }
}

TEST(ForwardSpeedClosedForm, TucksFormAddsTheTermsOfStripTheory) {
  Random random;
  const Mat6 A = random.symmetric(), B = random.symmetric();
  const double w = 0.7, U = 2.3, u = U / w, u2 = U / (w * w);
  const SpeedCoefficients c = tuck(A, B, w, U);
  const Mat6 dA = c.addedMass - A, dB = c.damping - B;
  const auto expect = [](double found, double value) { EXPECT_NEAR(found, value, kRoundOff); };
  expect(dA(Pitch, Heave), u2 * B(Heave, Heave));
  expect(dA(Heave, Pitch), -u2 * B(Heave, Heave));
  expect(dB(Pitch, Heave), -U * A(Heave, Heave));
  expect(dB(Heave, Pitch), U * A(Heave, Heave));
  expect(dA(Pitch, Pitch), u * u * A(Heave, Heave));
  expect(dB(Pitch, Pitch), u * u * B(Heave, Heave));
  expect(dA(Yaw, Sway), -u2 * B(Sway, Sway));
  expect(dA(Sway, Yaw), u2 * B(Sway, Sway));
  expect(dB(Yaw, Sway), U * A(Sway, Sway));
  expect(dB(Sway, Yaw), -U * A(Sway, Sway));
  expect(dA(Yaw, Yaw), u * u * A(Sway, Sway));
  expect(dB(Yaw, Yaw), u * u * B(Sway, Sway));
  expect(dA(Surge, Pitch), -u2 * B(Surge, Heave));
  expect(dB(Roll, Yaw), -U * A(Roll, Sway));
  EXPECT_LT((dA.topLeftCorner<4, 4>().cwiseAbs().maxCoeff()), kRoundOff);
  EXPECT_LT((dB.topLeftCorner<4, 4>().cwiseAbs().maxCoeff()), kRoundOff);
}

/// (24)-(29) as the report prints them, one entry at a time.
SpeedCoefficients asPrinted(const Mat6& A, const Mat6& B, const Mat6& dA, const Mat6& dB, double w,
                            double U) {
  SpeedCoefficients c{A + U / (w * w) * dB, B - U * dA};
  const double u2 = U / (w * w), uu = U * U / (w * w);
  c.addedMass.col(Pitch) += -u2 * B.col(Heave) + uu * dA.col(Heave);
  c.damping.col(Pitch) += U * A.col(Heave) + uu * dB.col(Heave);
  c.addedMass.col(Yaw) += u2 * B.col(Sway) - uu * dA.col(Sway);
  c.damping.col(Yaw) += -U * A.col(Sway) - uu * dB.col(Sway);
  return c;
}

TEST(ForwardSpeedClosedForm, ReportsFormIsEquations24To29) {
  Random random;
  const Mat6 A = random.matrix(), B = random.matrix(), dA = random.matrix(), dB = random.matrix();
  const auto found = atSpeed(A, B, dA, dB, 0.7, 2.3, ForwardSpeedForm::Report);
  EXPECT_LT(distance(found, asPrinted(A, B, dA, dB, 0.7, 2.3)), kRoundOff);
}

TEST(ForwardSpeedIdentity, ReportsFormWithTucksDerivativesIsTucksForm) {
  Random random;
  const Mat6 A = random.matrix(), B = random.matrix(), T = tuckMatrix();
  const auto report = atSpeed(A, B, T * A, T * B, 1.1, 4.0, ForwardSpeedForm::Report);
  EXPECT_LT(distance(report, tuck(A, B, 1.1, 4.0)), kRoundOff);
}

/// Smooth made-up coefficients with A − A(∞) ~ ω⁻², B ~ ω³ at 0 and ω⁻³ at ∞.
Coefficients smooth() {
  Random random;
  Coefficients c;
  const Mat6 A = random.symmetric(), B = random.positive(), dA = random.matrix(),
             dB = random.matrix();
  const auto fall = [](double w) { return 1.0 / (1.0 + w * w); };
  for (int i = 1; i <= 60; ++i) {
    const double w = 0.1 * i, f = fall(w);
    c.omega.push_back(w);
    c.addedMass.values.push_back((1.0 + f) * A);
    c.damping.values.push_back(w * w * w * f * f * f * B);
    c.addedMassX.values.push_back((1.0 + f) * dA);
    c.dampingX.values.push_back(w * w * w * f * f * f * dB);
  }
  c.addedMass.atZero = 2.0 * A;
  c.addedMass.atInfinity = A;
  c.addedMassX.atZero = 2.0 * dA;
  c.addedMassX.atInfinity = dA;
  return c;
}

TEST(ForwardSpeedIdentity, LimitsAreThoseOfTheFrequenciesBesideThem) {
  const Coefficients c = smooth();
  for (const auto form : {ForwardSpeedForm::Report, ForwardSpeedForm::Tuck}) {
    const SpeedCoefficients rest = atSpeed(c, 0.0, 3.0, form), slow = atSpeed(c, 1e-4, 3.0, form);
    for (int n = 0; n < 36; ++n) {
      if (std::isnan(rest.addedMass(n))) {
        EXPECT_GT(std::abs(slow.addedMass(n)), 1e4);  // (U/ω)² = 1e9 times what is not 0
      } else {
        // B of the cubic through 0 is 4e-3 ω at first, (U/ω²) of it is 100, were B not 0 there; the
        // interpolation's own slope at 0 decides, so only B is compared.
        EXPECT_NEAR(rest.damping(n), slow.damping(n),
                    1e-2 + 1e3 * std::abs(rest.damping(n)) * 1e-5);
      }
    }
    const SpeedCoefficients inf = atSpeed(c, HUGE_VAL, 3.0, form),
                            fast = atSpeed(c, 1e4, 3.0, form);
    EXPECT_LT(distance(inf, fast), 1e-6);  // (Ω/ω)² = 4e-7
    EXPECT_EQ(inf.addedMass, c.addedMass.atInfinity);
  }
  EXPECT_TRUE(std::isnan(atSpeed(c, 0.0, 3.0, ForwardSpeedForm::Tuck).addedMass(Pitch, Pitch)));
  EXPECT_EQ(atSpeed(c, 0.0, 3.0, ForwardSpeedForm::Tuck).addedMass(Heave, Heave),
            c.addedMass.atZero(Heave, Heave));
}

TEST(ForwardSpeedIdentity, ImpedanceIsThatOfAAndBAndTendsToTheStiffnessAtRest) {
  const Coefficients c = smooth();
  for (const auto form : {ForwardSpeedForm::Report, ForwardSpeedForm::Tuck}) {
    const double w = 0.63, U = 5.0;
    const SpeedCoefficients moving = atSpeed(c, w, U, form);
    const CMat6 expected = (-w * w * moving.addedMass).cast<Complex>() +
                           Complex(0.0, w) * moving.damping.cast<Complex>();
    const CMat6 found = radiationImpedance(c, w, U, form);
    EXPECT_LT((found - expected).cwiseAbs().maxCoeff(), 10.0 * kRoundOff * U * U);
    // (43), (45): c_j5 = −U²∂A_j3(0), c_j6 = +U²∂A_j2(0).
    const Mat6 dA = form == ForwardSpeedForm::Tuck ? Mat6(tuckMatrix() * c.addedMass.atZero)
                                                   : c.addedMassX.atZero;
    const CMat6 still = radiationImpedance(c, 0.0, U, form);
    EXPECT_LT((still.col(Pitch) - (-U * U * dA.col(Heave)).cast<Complex>()).norm(), kRoundOff * 25);
    EXPECT_LT((still.col(Yaw) - (U * U * dA.col(Sway)).cast<Complex>()).norm(), kRoundOff * 25);
    EXPECT_LT(still.leftCols<4>().norm(), kRoundOff);
    EXPECT_LT((radiationImpedance(c, 1e-7, U, form) - still).cwiseAbs().maxCoeff(), 1e-4);
  }
}

TEST(ForwardSpeed, ReportsFormNeedsTheDerivativesAndTucksDoesNot) {
  Coefficients c = smooth();
  c.addedMassX = {};
  try {
    atSpeed(c, 0.5, 2.0, ForwardSpeedForm::Report);
    FAIL();
  } catch (const HydroError& error) {
    EXPECT_EQ(error.fault(), Fault::DatabaseIncomplete);
    EXPECT_NE(std::string(error.what()).find("added_mass_x"), std::string::npos) << error.what();
  }
  EXPECT_NO_THROW(atSpeed(c, 0.5, 2.0, ForwardSpeedForm::Tuck));
  EXPECT_EQ(atSpeed(c, 0.5, 0.0, ForwardSpeedForm::Report).addedMass, c.addedMass[4]);
  EXPECT_THROW(atSpeed(c, -0.5, 2.0, ForwardSpeedForm::Tuck), HydroError);
  EXPECT_THROW(atSpeed(c, 0.5, std::nan(""), ForwardSpeedForm::Tuck), HydroError);
}

TEST(ForwardSpeed, DerivativesBeyondWhatThePanelsResolveFollowTheirLimit) {
  Coefficients c = smooth();
  c.resolvedOmega = 4.05;
  c.addedMassX.values.back().setConstant(1e9);  // rings
  c.dampingX.values.back().setConstant(1e9);
  // 1 + 1/(1 + ω²) continued by ω⁻² from ω = 4: off by 1/16 of itself at most, 0.3 % of the value.
  EXPECT_LT((addedMassXAt(c, 6.0) - (1.0 + 1.0 / 37.0) * c.addedMassX.atInfinity).norm(),
            0.003 * c.addedMassX.atInfinity.norm());
  EXPECT_LT(dampingXAt(c, 6.0).cwiseAbs().maxCoeff(), 1.0);
  EXPECT_EQ(addedMassXAt(c, 0.0), c.addedMassX.atZero);
  EXPECT_EQ(dampingXAt(c, 0.0), Mat6(Mat6::Zero()));
}

}  // namespace
}  // namespace cutwater
