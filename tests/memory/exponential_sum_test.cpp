#include <gtest/gtest.h>

#include <cmath>

#include "hydro/memory/ExponentialSum.h"
#include "hydro/memory/RetardationMatrix.h"
#include "tests/memory/CausalShip.h"

// The sum of damped oscillations itself; the memory made of it is in exponential_memory_test.cpp.
namespace cutwater {
namespace {

const RetardationMatrix& kernelsToFit() {
  static const RetardationMatrix kernels(test::CausalShip().coefficients(0.1, 20.0),
                                         ForwardSpeedForm::Report);
  return kernels;
}

ExponentialSum sumOf(std::size_t poles) {
  return ExponentialSum(kernelsToFit(), test::CausalShip().addedMassInf, poles);
}

// K⁰ of the causal ship is known in closed form. What is fitted is its transform, to error() of B
// or ωA, the lesser of which is far below |K̂|; in time 1e-3 of the largest K is left.
TEST(ExponentialSumClosedForm, IsTheKnownMemoryInTime) {
  const ExponentialSum sum = sumOf(20);
  const test::CausalShip ship;
  const auto exact = [&ship](double tau) {
    return ship.rest([tau](const test::CausalKernel& k) { return k.K(tau); });
  };
  const double size = exact(0.0).cwiseAbs().maxCoeff();
  for (double tau = 0.05; tau < 15.0; tau += 0.1)
    EXPECT_LT((sum.at(tau, 0.0) - exact(tau)).cwiseAbs().maxCoeff(), 1e-3 * size) << tau;
}

// Simpson's rule on K(τ) e^{−iωτ} up to 60 s, in steps of 0.01 s. The fastest pole within reach of
// the data, some 20 rad/s, leaves (0.2)⁴/180; poles beyond carry 1e-3 of K.
TEST(ExponentialSumIdentity, TransformIsTheIntegralOfTheFunctions) {
  const ExponentialSum sum = sumOf(12);
  constexpr double h = 0.01;
  constexpr int kSteps = 6000;
  for (const double U : {0.0, 2.0}) {
    std::vector<Mat6> K;
    for (int i = 0; i <= kSteps; ++i) K.push_back(sum.at(h * i, U));
    for (const double omega : {0.3, 1.0, 2.5}) {
      CMat6 integral = CMat6::Zero();
      for (int i = 0; i <= kSteps; ++i) {
        const double weight = i == 0 || i == kSteps ? 1.0 : i % 2 == 1 ? 4.0 : 2.0;
        integral += (h / 3.0 * weight) * std::polar(1.0, -omega * h * i) *
                    K[static_cast<std::size_t>(i)].cast<Complex>();
      }
      const CMat6 found = sum.transform(omega, U);
      EXPECT_LT((integral - found).norm(), 1e-4 * found.norm()) << omega << ' ' << U;
    }
  }
}

// L⁰ = ∫K⁰ has the transform K̂/iω, of either sign of ω. Round-off of the fit's ∫K⁰ = 0 over ω.
TEST(ExponentialSumIdentity, MomentumIsTheIntegralOfTheForce) {
  const ExponentialSum sum = sumOf(20);
  for (const double omega : {0.05, 0.7, 2.5, 10.0}) {
    const CMat6 expected = sum.transform(omega, 0.0) / Complex(0.0, omega);
    const CMat6 found = sum.momentumTransform(omega);
    EXPECT_LT((found - expected).norm(), 1e-10 * expected.norm()) << omega;
    EXPECT_LT((sum.momentumTransform(-omega) - found.conjugate()).norm(), 1e-15 * found.norm());
  }
}

// A steady velocity has the momentum of A(0) − A(∞), exactly, with however few poles: a ship that
// is pushed for long moves with M + A(0).
TEST(ExponentialSumIdentity, MomentumAtZeroFrequencyIsThatOfAddedMassAtRest) {
  const Mat6 total = kernelsToFit().momentumIntegral(0.0, HUGE_VAL);
  for (const std::size_t poles : {6u, 20u}) {
    const CMat6 found = sumOf(poles).momentumTransform(0.0);
    // Two conditions beside each other on poles some 1e2 apart.
    EXPECT_LT((found - total.cast<Complex>()).norm(), 1e-10 * total.norm()) << poles;
  }
}

// In time: the memory's momentum is Re Σ (R/s) e^{sτ}, the integral of K⁰, and of opposite signs in
// its runs, so that both are multiplied alike.
TEST(ExponentialSumIdentity, MomentumRunsHoldTheIntegratedResidues) {
  const ExponentialSum sum = sumOf(5);
  const std::vector<double>& runs = sum.momentumRuns();
  ASSERT_EQ(runs.size(), sum.pairs().size() * 2 * sum.width());
  for (std::size_t p = 0; p < sum.pairs().size(); ++p)
    for (std::size_t m = 0; m < sum.width(); ++m) {
      const bool isPole = m < sum.size();
      const Complex R = isPole ? sum.pairs()[p].atRest[m] / sum.poles()[m] : Complex(0.0);
      EXPECT_EQ(runs[2 * p * sum.width() + m], R.real());
      EXPECT_EQ(runs[(2 * p + 1) * sum.width() + m], -R.imag());
    }
}

// More oscillations follow the functions better: the kernels have two poles of fourth order, which
// 6 distinct ones only begin to resemble.
TEST(ExponentialSumConvergence, MorePolesLeaveLess) {
  const double six = sumOf(6).error(), twelve = sumOf(12).error(), twenty = sumOf(20).error();
  EXPECT_LT(twelve, 0.3 * six);
  EXPECT_LT(twenty, twelve);
  EXPECT_LT(twenty, 2e-3);
}

// The runs are what the memory multiplies: −Re R, +Im R, each run padded with zeros to a multiple
// of four.
TEST(ExponentialSumIdentity, RunsHoldTheResiduesPaddedWithZeros) {
  for (const std::size_t poles : {5u, 8u}) {
    const ExponentialSum sum = sumOf(poles);
    EXPECT_EQ(sum.width() % 4, 0u);
    ASSERT_GE(sum.width(), sum.size());
    EXPECT_LT(sum.width() - sum.size(), 4u);
    for (std::size_t part = 0; part < 3; ++part) {
      const std::vector<double>& runs = sum.runs(part);
      ASSERT_EQ(runs.size(), sum.pairs().size() * 2 * sum.width());
      for (std::size_t p = 0; p < sum.pairs().size(); ++p)
        for (std::size_t m = 0; m < sum.width(); ++m) {
          const bool isPole = m < sum.size();
          const Complex R = isPole ? sum.pairs()[p][part][m] : Complex(0.0);
          EXPECT_EQ(runs[2 * p * sum.width() + m], -R.real());
          EXPECT_EQ(runs[(2 * p + 1) * sum.width() + m], R.imag());
        }
    }
  }
}

/// The causal ship, coupled only where modes are both even or both odd.
Coefficients symmetricShip() {
  Coefficients c = test::CausalShip().coefficients(0.1, 20.0);
  for (auto* matrices : {&c.damping, &c.dampingX, &c.addedMass, &c.addedMassX})
    matrices->forEach([](Mat6& m) {
      for (int j = 0; j < 6; ++j)
        for (int k = 0; k < 6; ++k)
          if ((j + k) % 2 == 1) m(j, k) = 0.0;
    });
  return c;
}

// A hull with a centre plane has 18 pairs; no work is done for the others.
TEST(ExponentialSumIdentity, PairsThatVanishBySymmetryAreLeftOut) {
  const Coefficients c = symmetricShip();
  const ExponentialSum sum(RetardationMatrix(c, ForwardSpeedForm::Report), c.addedMass.atInfinity,
                           8);
  EXPECT_EQ(sum.pairs().size(), 18u);
  int before = -1;
  for (const auto& pair : sum.pairs()) {
    EXPECT_EQ((pair.j + pair.k) % 2, 0);
    EXPECT_GT(6 * pair.j + pair.k, before);  // by rows
    before = 6 * pair.j + pair.k;
  }
  for (const double tau : {0.0, 1.0}) EXPECT_EQ(sum.at(tau, 4.0)(0, 1), 0.0);
  EXPECT_EQ(sum.transform(1.0, 4.0)(5, 2), Complex(0.0));
}

TEST(ExponentialSum, OfAShipThatMakesNoWavesIsEmpty) {
  Coefficients still = test::CausalShip().coefficients(0.5, 10.0);
  for (auto* matrices : {&still.damping, &still.dampingX})
    matrices->forEach([](Mat6& m) { m.setZero(); });
  const ExponentialSum sum(RetardationMatrix(still, ForwardSpeedForm::Report),
                           still.addedMass.atInfinity);
  EXPECT_EQ(sum.size(), 0u);
  EXPECT_EQ(sum.error(), 0.0);
  EXPECT_EQ(sum.at(1.0, 2.0), Mat6::Zero().eval());
  ExponentialMemory memory(sum, 0.1);
  EXPECT_EQ(memory.advance(Vec6::Ones(), 2.0), Vec6::Zero().eval());
}

}  // namespace
}  // namespace cutwater
