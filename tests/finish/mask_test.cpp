#include "hydro/finish/Mask.h"

#include <gtest/gtest.h>

#include <cmath>

#include "hydro/Errors.h"
#include "tests/database/SampleShip.h"

namespace cutwater {
namespace {

// Smooth coefficients over which a resonance of width 0.02 at ω = 2 can be laid, as an irregular
// frequency does; its condition number rises with it.
double smooth(double w) { return w * w * std::exp(-w); }
double resonance(double w) { return 0.0004 / ((w - 2.0) * (w - 2.0) + 0.0004); }

Coefficients withResonance(double height) {
  Coefficients c = test::sampleShip();
  c.omega.clear();
  for (auto* matrices : {&c.addedMass, &c.damping, &c.addedMassX, &c.dampingX}) *matrices = {};
  for (auto* list : {&c.conditionEven, &c.conditionOdd}) list->clear();
  c.adjoint = {};
  c.masked.clear();
  c.conditionLimitOdd.clear();
  c.adjointX = {};
  for (int i = 1; i <= 60; ++i) {
    const double w = 0.05 * i, f = smooth(w) + height * resonance(w);
    c.omega.push_back(w);
    c.addedMass.values.push_back(Mat6::Constant(1.0 + f));
    c.damping.values.push_back(Mat6::Constant(f));
    c.addedMassX.values.push_back(Mat6::Constant(2.0 * f));
    c.dampingX.values.push_back(Mat6::Constant(3.0 * f));
    c.conditionEven.push_back(10.0 + 1000.0 * resonance(w));
    c.conditionOdd.push_back(10.0);
    c.adjoint.values.push_back(Coefficients::AdjointVectors::Constant(6, 2, Complex(f, 1.0)));
  }
  c.adjointX = c.adjoint;
  c.addedMass.atZero = c.addedMass.atInfinity = Mat6::Constant(1.0);
  c.addedMassX.atZero = c.addedMassX.atInfinity = Mat6::Zero();
  for (auto* table : {&c.froudeKrylov, &c.diffraction}) {
    for (auto& heading : *table) {
      heading.clear();
      for (const double w : c.omega)
        heading.push_back(CVec6::Constant(smooth(w) + height * resonance(w)));
    }
  }
  c.conditionLimitEven = {{0.0, 20.0}, {4.0, 60.0}};  // 40 at the resonance
  return c;
}

double worst(const std::vector<Mat6>& found, const std::vector<Mat6>& expected) {
  double worst = 0.0;
  for (std::size_t i = 0; i < found.size(); ++i)
    worst = std::max(worst, (found[i] - expected[i]).cwiseAbs().maxCoeff());
  return worst;
}

Coefficients maskOf(Coefficients c) {
  applyMask(c);
  return c;
}

TEST(MaskIdentity, MaskedResonanceLeavesTheSmoothCurve) {
  const Coefficients clean = withResonance(0.0), masked = maskOf(withResonance(5.0));
  int count = 0;
  for (std::size_t i = 0; i < masked.omega.size(); ++i) {
    const double w = masked.omega[i];
    // 10 + 1000 r > 40 where |ω − 2| < 0.114
    EXPECT_EQ(masked.masked[i], std::abs(w - 2.0) < 0.114 ? 1 : 0) << w;
    count += masked.masked[i];
  }
  EXPECT_EQ(count, 5);
  // What is left of the resonance is its flank, 5·0.0004/0.15² = 0.09 beside the mask, 5 before.
  EXPECT_GT(worst(withResonance(5.0).damping.values, clean.damping.values), 4.9);
  EXPECT_LT(worst(masked.addedMass.values, clean.addedMass.values), 0.15);
  EXPECT_LT(worst(masked.damping.values, clean.damping.values), 0.15);
  EXPECT_LT(worst(masked.addedMassX.values, clean.addedMassX.values), 0.3);
  EXPECT_LT(worst(masked.dampingX.values, clean.dampingX.values), 0.45);
  for (std::size_t i = 0; i < masked.omega.size(); ++i) {
    EXPECT_LT((masked.adjoint[i] - clean.adjoint[i]).cwiseAbs().maxCoeff(), 0.15);
    EXPECT_LT((masked.adjointX[i] - clean.adjointX[i]).cwiseAbs().maxCoeff(), 0.15);
  }
}

TEST(MaskIdentity, WhereTheCurveIsSmoothTheMaskHardlyShows) {
  // A gap of 0.3 rad/s under a cubic: error ≤ 3/128 h⁴ f'''' with h = 0.3 in all, f'''' < 3: 6e-4.
  Coefficients c = withResonance(0.0);
  const Coefficients clean = c;
  c = maskOf(c);
  EXPECT_LT(worst(c.damping.values, clean.damping.values), 6e-4);
  EXPECT_GT(worst(c.damping.values, clean.damping.values), 0.0);
  const Coefficients again = maskOf(c);
  EXPECT_EQ(worst(again.damping.values, c.damping.values), 0.0);
  EXPECT_EQ(again.masked, c.masked);
}

TEST(Mask, WithoutVectorsTheForcesAreInterpolatedThemselves) {
  Coefficients c = withResonance(5.0);
  c.adjoint = {};
  c.adjointX = {};
  const Coefficients masked = maskOf(c), clean = withResonance(0.0);
  for (std::size_t i = 0; i < c.omega.size(); ++i)
    EXPECT_LT((masked.diffraction[1][i] - clean.diffraction[1][i]).cwiseAbs().maxCoeff(), 0.15);
  EXPECT_EQ(masked.froudeKrylov, c.froudeKrylov);
}

TEST(Mask, MaskAtTheEndsUsesTheLimits) {
  Coefficients c = withResonance(0.0);
  c.conditionEven.front() = c.conditionOdd.back() = 1e6;
  c.conditionLimitOdd = {{1.0, 100.0}};
  const Coefficients masked = maskOf(c);
  EXPECT_EQ(masked.masked.front(), 1);
  EXPECT_EQ(masked.masked.back(), 1);
  // Through B(0) = 0: exact to the cubic's error 0.1⁴ f''''/24·… < 1e-4. Above: (2.95/3)³ of the
  // last.
  EXPECT_NEAR(masked.damping.values.front()(0, 0), c.damping.values.front()(0, 0), 1e-4);
  EXPECT_NEAR(masked.damping.values.back()(0, 0), std::pow(2.95 / 3.0, 3) * smooth(2.95), 1e-12);
  EXPECT_EQ(masked.adjoint.values.back(),
            c.adjoint[c.adjoint.size() - 2]);  // no vectors of ω = ∞: held
}

TEST(Mask, RefusesAMaskThatLeavesNothingAndBadEnvelopes) {
  Coefficients c = withResonance(0.0);
  c.conditionLimitEven = {{0.0, 1.0}};
  try {
    maskOf(c);
    FAIL();
  } catch (const HydroError& error) {
    EXPECT_EQ(error.fault(), Fault::DatabaseIncomplete);
    EXPECT_NE(std::string(error.what()).find("0 of 60"), std::string::npos) << error.what();
  }
  c.conditionLimitEven = {{1.0, 5.0}, {1.0, 6.0}};
  EXPECT_THROW(maskOf(c), HydroError);
  c.conditionLimitEven = {{1.0, -5.0}};
  EXPECT_THROW(maskOf(c), HydroError);
  c.conditionLimitEven.clear();
  EXPECT_TRUE(maskOf(c).masked.empty());
}

}  // namespace
}  // namespace cutwater
