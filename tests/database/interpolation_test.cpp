#include "hydro/database/Interpolation.h"

#include <gtest/gtest.h>

#include <cmath>

#include "hydro/Errors.h"
#include "tests/database/SampleShip.h"

namespace cutwater {
namespace {

Coefficients sampled(double step, double (*law)(double)) {
  Coefficients c;
  for (int i = 1; i <= std::lround(3.0 / step); ++i) {
    const double w = i * step;
    c.omega.push_back(w);
    c.addedMass.values.push_back(Mat6::Constant(law(w)));
    c.damping.values.push_back(Mat6::Constant(w * law(w)));
    c.adjoint.values.push_back(
        Eigen::Matrix<Complex, 6, Eigen::Dynamic>::Constant(6, 3, {law(w), w}));
  }
  c.addedMass.atZero = Mat6::Constant(law(0.0));
  c.addedMass.atInfinity = Mat6::Constant(0.25);
  return c;
}

TEST(InterpolationClosedForm, CubicIsMetExactly) {
  const auto cubic = [](double w) { return 1.0 + w * (2.0 - w * (0.5 + 0.3 * w)); };
  const Coefficients c = sampled(0.25, cubic);
  for (double w = 0.0; w <= 3.0; w += 0.07) {
    EXPECT_NEAR(addedMassAt(c, w)(3, 1), cubic(w), 1e-13);
    if (w >= 0.25) {
      EXPECT_NEAR(std::abs(adjointAt(c, w)(5, 2) - Complex(cubic(w), w)), 0.0, 1e-13);
    }
  }
}

TEST(InterpolationConvergence, FourthOrderInFrequencyStep) {
  const auto law = [](double w) { return w * std::exp(-w) * std::cos(w); };
  const auto error = [&](double step) {
    const Coefficients c = sampled(step, law);
    double worst = 0.0;
    for (double w = 0.0; w <= 3.0; w += 0.01) {
      worst = std::max(worst, std::abs(dampingAt(c, w)(0, 0) - w * law(w)));
    }
    return worst;
  };
  EXPECT_NEAR(std::log2(error(0.1) / error(0.05)), 4.0, 0.3);
}

TEST(Interpolation, GoesThroughTheDataAndToTheLimits) {
  const Coefficients c = test::sampleShip();
  for (std::size_t i = 0; i < c.omega.size(); ++i) {
    EXPECT_EQ(addedMassAt(c, c.omega[i]), c.addedMass[i]);
    EXPECT_EQ(dampingAt(c, c.omega[i]), c.damping[i]);
    EXPECT_EQ(adjointAt(c, c.omega[i]), c.adjoint[i]);
  }
  EXPECT_EQ(addedMassAt(c, 0.0), c.addedMass.atZero);
  EXPECT_EQ(addedMassAt(c, HUGE_VAL), c.addedMass.atInfinity);
  EXPECT_EQ(dampingAt(c, 0.0), Mat6::Zero().eval());
  EXPECT_EQ(dampingAt(c, HUGE_VAL), Mat6::Zero().eval());
}

TEST(Interpolation, DoesNotGuessBeyondTheData) {
  Coefficients c = test::sampleShip();
  c.adjoint.atInfinity.resize(6, 0);
  EXPECT_THROW(adjointAt(c, 1.5), HydroError);
  EXPECT_THROW(addedMassAt(c, -0.1), HydroError);
  EXPECT_THROW(dampingAt(c, std::nan("")), HydroError);
  EXPECT_THROW(adjointAt(Coefficients{}, 1.0), HydroError);
}

TEST(InterpolationClosedForm, AdjointVectorsGoThroughTheirLimits) {
  using Vectors = Coefficients::AdjointVectors;
  const auto law = [](double w) { return 1.0 + w * (2.0 - w * (0.5 + 0.3 * w)); };
  Coefficients c = sampled(0.25, law);
  EXPECT_EQ(adjointAt(c, 0.0), c.adjoint.values.front());  // without the limit: held
  c.adjoint.atZero = Vectors::Constant(6, 3, Complex(law(0.0), 0.0));
  for (double w = 0.0; w <= 0.75; w += 0.05)
    EXPECT_NEAR(std::abs(adjointAt(c, w)(5, 2) - Complex(law(w), w)), 0.0, 1e-13);
  c.adjointX.values = c.adjoint.values;
  c.adjointX.atInfinity = Vectors::Constant(6, 3, Complex(7.0, 1.0));
  EXPECT_EQ(adjointXAt(c, 0.0), c.adjoint.values.front());
  const Complex last = c.adjoint.values.back()(0, 0), inf(7.0, 1.0);
  EXPECT_NEAR(std::abs(adjointXAt(c, 6.0)(0, 0) - (inf + 0.25 * (last - inf))), 0.0, 1e-12);
  EXPECT_EQ(adjointXAt(c, HUGE_VAL)(1, 1), inf);
  // What the panels do not resolve is not used once there is a limit to go to.
  c.resolvedOmega = 2.6;
  const Complex resolved = c.adjoint[9](0, 0);  // ω = 2.5
  EXPECT_NEAR(std::abs(adjointXAt(c, 5.0)(0, 0) - (inf + 0.25 * (resolved - inf))), 0.0, 1e-12);
}

}  // namespace
}  // namespace cutwater
