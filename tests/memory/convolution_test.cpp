#include "hydro/memory/Convolution.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "hydro/Errors.h"
#include "hydro/memory/RetardationMatrix.h"

namespace cutwater {
namespace {

Coefficients coupledShip() {
  Coefficients c;
  c.ship.volume = 1.0;
  for (int i = 1; i <= 60; ++i) {
    const double w = 0.1 * i, b = std::pow(w, 3) * std::exp(-3.0 * w);
    Mat6 matrix = Mat6::Zero();
    matrix.diagonal() << b, 2.0 * b, 3.0 * b, 0.5 * b, 4.0 * b, b;
    matrix(2, 4) = matrix(4, 2) = 0.3 * b;
    c.omega.push_back(w);
    c.damping.values.push_back(matrix);
  }
  return c;
}

Vec6 anyVelocity(int n) {
  Vec6 v;
  for (int m = 0; m < 6; ++m) v(m) = std::sin(0.37 * n * (m + 1)) + 0.1 * m;
  return v;
}

/// Largest distance between the force of a heave oscillation cos ωt, once the memory is full, and
/// −(B cos ωt + S sin ωt), S = ∫K sin ωτ dτ = ω(A∞ − A), over one period.
double harmonicError(const RetardationMatrix& matrix, double omega, double step) {
  Convolution convolution(matrix, step);
  double error = 0.0, damping = 0.0;
  const double sine = matrix.sineTransform(omega)(4, 2);
  damping = 0.3 * std::pow(omega, 3) * std::exp(-3.0 * omega);
  const auto full = static_cast<int>(convolution.length());
  const int last = full + static_cast<int>(2.0 * kPi / omega / step);
  for (int n = 0; n <= last; ++n) {
    const double t = n * step, before = t - step;
    Vec6 mean = Vec6::Zero();
    mean(Heave) = (std::sin(omega * t) - std::sin(omega * before)) / (omega * step);
    const double force = convolution.advance(mean)(Pitch);
    if (n < full) continue;
    const double exact = -(damping * std::cos(omega * t) + sine * std::sin(omega * t));
    error = std::max(error, std::abs(force - exact));
  }
  return error;
}

TEST(ConvolutionConvergence, OscillationFeelsDampingAndAddedMassAtSecondOrder) {
  const RetardationMatrix matrix(coupledShip());
  const double coarse = harmonicError(matrix, 1.0, 0.4), fine = harmonicError(matrix, 1.0, 0.2);
  EXPECT_NEAR(std::log2(coarse / fine), 2.0, 0.1);
  // B(1) = 0.0149; at a tick of 0.02 s what is left is memory beyond its duration, 0.1 % of ∫|K|.
  EXPECT_LT(harmonicError(matrix, 1.0, 0.02), 3e-5);
}

TEST(ConvolutionIdentity, SteadyVelocityFeelsNothing) {
  const RetardationMatrix matrix(coupledShip());
  for (double duration : {0.0, 6.0}) {  // its own, and one that cuts into K
    Convolution convolution(matrix, 0.05, duration);
    Vec6 force, most = Vec6::Zero();
    for (std::size_t n = 0; n < convolution.length(); ++n) {
      force = convolution.advance(Vec6::Ones());
      most = most.cwiseMax(force.cwiseAbs());
    }
    EXPECT_LT(force.cwiseAbs().maxCoeff(), 1e-14 * most.maxCoeff() * 1e2);  // round-off of the sum
  }
}

TEST(Convolution, IsTheSumOfCellIntegralsTimesPastVelocities) {
  const RetardationMatrix matrix(coupledShip());
  Convolution convolution(matrix, 0.1, 100.0);  // nothing is missing beyond 100 s but 1e-6
  Vec6 force;
  for (int n = 0; n < 300; ++n) force = convolution.advance(anyVelocity(n));
  Vec6 sum = Vec6::Zero();
  for (int i = 0; i < 300; ++i) {
    sum -= (matrix.integral(0.1 * (i + 1)) - matrix.integral(0.1 * i)) * anyVelocity(299 - i);
  }
  EXPECT_LT((force - sum).norm(), 1e-13);
}

TEST(Convolution, RestoredStateGivesTheSameBits) {
  const RetardationMatrix matrix(coupledShip());
  Convolution one(matrix, 0.03), other(matrix, 0.03);
  for (int n = 0; n < 777; ++n) one.advance(anyVelocity(n));
  std::vector<double> snapshot(one.stateSize());
  one.save(snapshot);
  std::vector<Vec6> first;
  for (int n = 0; n < 999; ++n) first.push_back(one.advance(anyVelocity(3 * n)));
  one.restore(snapshot);
  other.restore(snapshot);
  for (int n = 0; n < 999; ++n) {
    const Vec6 again = one.advance(anyVelocity(3 * n)),
               elsewhere = other.advance(anyVelocity(3 * n));
    const Vec6& then = first[static_cast<std::size_t>(n)];
    ASSERT_EQ(std::memcmp(again.data(), then.data(), sizeof then), 0) << n;
    ASSERT_EQ(std::memcmp(elsewhere.data(), then.data(), sizeof then), 0) << n;
  }
}

TEST(Convolution, ForgetsOnReset) {
  Convolution convolution(RetardationMatrix(coupledShip()), 0.05);
  for (int n = 0; n < 50; ++n) convolution.advance(anyVelocity(n));
  convolution.reset();
  EXPECT_EQ(convolution.advance(Vec6::Zero()), Vec6::Zero().eval());
}

TEST(Convolution, RefusesImpossibleTicks) {
  const RetardationMatrix matrix(coupledShip());
  for (double step : {0.0, -0.1, std::nan(""), HUGE_VAL, 1e-9}) {
    EXPECT_THROW(Convolution(matrix, step), HydroError) << step;
  }
  EXPECT_THROW(Convolution(matrix, 0.1, -1.0), HydroError);
  EXPECT_THROW(Convolution(matrix, 0.1, std::nan("")), HydroError);
  Convolution one(matrix, 0.1), other(matrix, 0.05);
  std::vector<double> state(other.stateSize());
  other.save(state);
  EXPECT_THROW(one.restore(state), HydroError);
}

}  // namespace
}  // namespace cutwater
