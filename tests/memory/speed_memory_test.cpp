#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "hydro/memory/RetardationMatrix.h"
#include "tests/memory/CausalShip.h"

namespace cutwater {
namespace {

using test::CausalKernel, test::CausalShip;

constexpr ForwardSpeedForm kForms[] = {ForwardSpeedForm::Report, ForwardSpeedForm::Tuck};

/// A(U) and B(U) as iωA^∞ + b + K̂ + c/iω: what the memory holds.
CMat6 ofMemory(const RetardationMatrix& K, const Mat6& addedMassInf, const CMat6& transform,
               double omega, double U) {
  const Complex iw(0.0, omega);
  return iw * addedMassInf.cast<Complex>() + U * K.speedDamping().cast<Complex>() + transform +
         U * U * K.speedStiffness().cast<Complex>() / iw;
}

/// Largest distance from −ω²A(U) + iωB(U) in closed form, of the largest of it, both over ω; ω from
/// 0.05 to 5 rad/s, anywhere between the frequencies.
double impedanceError(double step, ForwardSpeedForm form) {
  const CausalShip ship;
  const Coefficients c = ship.coefficients(step, 48.0);
  const RetardationMatrix K(c, form);
  double error = 0.0, size = 0.0;
  for (double omega = 0.05; omega < 5.0; omega += 0.037) {
    const auto transforms = K.transforms(omega);
    for (double U : {0.0, 0.7, -3.0}) {
      const SpeedCoefficients z = ship.atSpeed(omega, U, form);
      const CMat6 exact =
          z.damping.cast<Complex>() + Complex(0.0, omega) * z.addedMass.cast<Complex>();
      const CMat6 found = ofMemory(K, c.addedMass.atInfinity, transforms.at(U), omega, U);
      error = std::max(error, (found - exact).cwiseAbs().maxCoeff());
      size = std::max(size, exact.cwiseAbs().maxCoeff());
    }
  }
  return error / size;
}

// The set (30), (33)-(45) is exact; what is left is the cubic spline's, of fourth order in Δω. Its
// error at the end ω = 0 is Δω⁴/46 of the fourth derivative of B/ω, some 10 of the largest B/ω over
// the square of 1.5 rad/s twice, and in K^UU it is divided by ω²: less than
// (0.1/1.5)⁴ · 10/46 · (1.5/0.1)².
TEST(SpeedMemoryConvergence, MemoryAndSpeedTermsGiveBackAddedMassAndDampingUnderWay) {
  for (const auto form : kForms) {
    const double coarse = impedanceError(0.2, form), fine = impedanceError(0.1, form);
    EXPECT_NEAR(std::log2(coarse / fine), 4.0, 0.5) << coarse << ' ' << fine;
    EXPECT_LT(fine, 1e-3);
  }
}

/// K⁰, K^U, K^UU in closed form.
SpeedKernels closedForm(const CausalShip& ship, double tau, ForwardSpeedForm form) {
  const Mat6 T = tuckMatrix();
  const auto K = [&](const CausalKernel& k) { return k.K(tau); };
  const auto I = [&](const CausalKernel& k) { return k.I(tau); };
  const auto E = [&](const CausalKernel& k) { return k.E(tau); };
  const bool tuck = form == ForwardSpeedForm::Tuck;
  const Mat6 D = tuck ? Mat6(T * ship.rest(I)) : ship.x(I);
  const Mat6 restOfD = tuck ? Mat6(T * ship.rest(E)) : ship.x(E);
  return {ship.rest(K), ship.rest(I) * T.transpose() - D, restOfD * T.transpose()};
}

double distance(const SpeedKernels& a, const SpeedKernels& b) {
  return std::max({(a.atRest - b.atRest).cwiseAbs().maxCoeff(),
                   (a.linear - b.linear).cwiseAbs().maxCoeff(),
                   (a.squared - b.squared).cwiseAbs().maxCoeff()});
}

// As above; the entries of K are of order 1.
TEST(SpeedMemoryClosedForm, KernelsUnderWay) {
  const CausalShip ship;
  const Coefficients c = ship.coefficients(0.1, 48.0);
  for (const auto form : kForms) {
    const RetardationMatrix K(c, form);
    for (double tau : {0.0, 0.2, 1.0, 3.0, 9.0})
      EXPECT_LT(distance(K.kernels(tau), closedForm(ship, tau, form)), 3e-5) << tau;
  }
}

// The mean of a cell is its middle's value and h²/24 of the second derivative, of order 1 per s²
// here, h = 0.05.
TEST(SpeedMemoryIdentity, IntegralsOverACellAreThoseOfTheKernels) {
  const CausalShip ship;
  const Coefficients c = ship.coefficients(0.1, 48.0);
  for (const auto form : kForms) {
    const RetardationMatrix K(c, form);
    for (double a : {0.0, 0.6, 4.0}) {
      SpeedKernels sum{Mat6::Zero(), Mat6::Zero(), Mat6::Zero()}, whole = K.integrals(a, a + 1.0);
      constexpr int kCells = 20;
      constexpr double h = 1.0 / kCells;
      for (int i = 0; i < kCells; ++i) {
        const SpeedKernels middle = K.kernels(a + (i + 0.5) * h);
        sum.atRest += h * middle.atRest;
        sum.linear += h * middle.linear;
        sum.squared += h * middle.squared;
      }
      EXPECT_LT(distance(sum, whole), h * h / 24.0 * 10.0) << a;
    }
  }
}

TEST(SpeedMemoryIdentity, TotalOfTheLinearPartIsItsTransformAtZero) {
  const CausalShip ship;
  const Coefficients c = ship.coefficients(0.1, 48.0);
  for (const auto form : kForms) {
    const RetardationMatrix K(c, form);
    // K̂(ω) − K̂(0) = −iω∫τK^U: 1e-3 of something of order 10.
    const CMat6 nearZero = K.transforms(1e-3).linear;
    EXPECT_LT((nearZero.real() - K.linearTotal()).cwiseAbs().maxCoeff(), 1e-3);
    EXPECT_LT(nearZero.imag().cwiseAbs().maxCoeff(), 2e-2);
  }
}

// c = −U²∂A(0)Tᵀ, b = U(A^∞Tᵀ − ∂A^∞). ∂A^∞ is found again from ∂A(ω) and ∂B(ω).
TEST(SpeedMemoryClosedForm, DampingAndStiffnessOfSpeed) {
  const CausalShip ship;
  const Coefficients c = ship.coefficients(0.1, 48.0);
  const RetardationMatrix K(c);
  const Mat6 Tt = tuckMatrix().transpose();
  EXPECT_LT((K.addedMassXInf() - c.addedMassX.atInfinity).cwiseAbs().maxCoeff(), 3e-5);
  EXPECT_LT((K.speedDamping() - (c.addedMass.atInfinity * Tt - c.addedMassX.atInfinity))
                .cwiseAbs()
                .maxCoeff(),
            3e-5);
  EXPECT_LT((K.speedStiffness() + c.addedMassX.atZero * Tt).cwiseAbs().maxCoeff(), 3e-5);
}

// Z(U) = S Z⁰ Sᴴ: nothing but round-off.
TEST(SpeedMemoryIdentity, TucksFormIsGyroscopicInItsOddPartAndSymmetricInItsEven) {
  const Coefficients c = CausalShip().coefficients(0.2, 20.0);
  const RetardationMatrix K(c, ForwardSpeedForm::Tuck);
  const auto symmetric = [](const Mat6& m) {
    return (m - m.transpose()).norm() <= 1e-14 * m.norm();
  };
  const auto antisymmetric = [](const Mat6& m) {
    return (m + m.transpose()).norm() <= 1e-14 * m.norm();
  };
  EXPECT_TRUE(antisymmetric(K.speedDamping()));
  EXPECT_TRUE(symmetric(K.speedStiffness()));
  EXPECT_TRUE(antisymmetric(K.linearTotal()));
  for (double tau : {0.0, 0.7, 3.0}) {
    EXPECT_TRUE(symmetric(K.kernels(tau).atRest));
    EXPECT_TRUE(antisymmetric(K.kernels(tau).linear));
    EXPECT_TRUE(symmetric(K.kernels(tau).squared));
  }
  EXPECT_LT(K.speedStiffness()(Pitch, Pitch), 0.0);  // −A_33(0), Munk's moment
  EXPECT_LT(K.speedStiffness()(Yaw, Yaw), 0.0);
}

TEST(SpeedMemoryIdentity, TheReportsFormWithTucksDerivativesIsTucks) {
  const Mat6 T = tuckMatrix();
  Coefficients c = CausalShip().coefficients(0.2, 20.0);
  for (std::size_t i = 0; i < c.omega.size(); ++i) {
    c.addedMassX[i] = T * c.addedMass[i];
    c.dampingX[i] = T * c.damping[i];
  }
  c.addedMassX.atInfinity = T * c.addedMass.atInfinity;
  c.addedMassX.atZero = T * c.addedMass.atZero;
  const RetardationMatrix report(c, ForwardSpeedForm::Report), tuck(c, ForwardSpeedForm::Tuck);
  for (double tau : {0.0, 0.7, 3.0})
    EXPECT_LT(distance(report.kernels(tau), tuck.kernels(tau)), 1e-13);  // round-off
  // Of b and c Tuck's uses A^∞ itself, the report's what A and B give back: the spline's error,
  // h = 0.2, sixteen times that above.
  EXPECT_LT((report.speedDamping() - tuck.speedDamping()).cwiseAbs().maxCoeff(), 16 * 3e-5);
  EXPECT_LT((report.speedStiffness() - tuck.speedStiffness()).cwiseAbs().maxCoeff(), 16 * 3e-5);
}

TEST(SpeedMemory, WithoutXDerivativesTheReportsFormHasNoSpeedTermsAndTucksHas) {
  Coefficients c = CausalShip().coefficients(0.2, 20.0);
  c.addedMassX = {};
  c.dampingX = {};
  const RetardationMatrix report(c, ForwardSpeedForm::Report), tuck(c, ForwardSpeedForm::Tuck);
  EXPECT_FALSE(report.hasSpeedTerms());
  EXPECT_TRUE(report.speedDamping().isZero(0.0));
  EXPECT_TRUE(report.speedStiffness().isZero(0.0));
  EXPECT_TRUE(report.kernels(1.0).linear.isZero(0.0));
  EXPECT_TRUE(report.integrals(1.0, 2.0).squared.isZero(0.0));
  EXPECT_TRUE(report.transforms(1.0).linear.isZero(0.0));
  EXPECT_TRUE(tuck.hasSpeedTerms());
}

TEST(SpeedMemory, NoDampingAtAllIsNoMemory) {
  Coefficients c = CausalShip().coefficients(0.2, 20.0);
  for (auto* matrices : {&c.damping, &c.dampingX})
    for (Mat6& m : *matrices) m.setZero();
  for (const auto form : kForms) {
    const RetardationMatrix K(c, form);
    EXPECT_EQ(K.lastOmega(), 0.0);
    EXPECT_EQ(K.duration(), 0.0);
    EXPECT_TRUE(K.kernels(0.3).at(5.0).isZero(0.0));
    EXPECT_TRUE(K.transforms(0.3).at(5.0).isZero(0.0));
  }
}

}  // namespace
}  // namespace cutwater
