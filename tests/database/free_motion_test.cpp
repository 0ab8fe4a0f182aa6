#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "hydro/database/ForwardSpeed.h"
#include "hydro/database/FreeMotion.h"
#include "tests/memory/CausalShip.h"

namespace cutwater {
namespace {

constexpr double kRound = 1e-13;  // round-off of sums of some dozen products

/// A(0) of a ship without symmetry: no two entries alike.
Mat6 anyAtRest() {
  const test::CausalShip ship;
  return ship.addedMassInf + ship.rest([](const test::CausalKernel& k) { return k.E(0.0); });
}

/// A + B/iω.
CMat6 anyWater(double omega) {
  const test::CausalShip ship;
  const auto over = [omega](const test::CausalKernel& k) {
    return Complex(k.transform(omega) / Complex(0.0, omega));
  };
  CMat6 water = ship.addedMassInf.cast<Complex>();
  water += ship.slow.cast<Complex>() * over(test::CausalShip::kSlow);
  water += ship.fast.cast<Complex>() * over(test::CausalShip::kFast);
  return water;
}

// u = sξ₁ + Vξ₆, v = sξ₂ − Uξ₆, w = sξ₃ + Uξ₅: bow to port the way goes to starboard of the ship,
// bow down it goes up.
TEST(FreeMotionClosedForm, HeadingAndPitchTurnTheSteadyWay) {
  const Complex s(0.1, 0.7);
  const CMat6 N = ownVelocities(s, {5.0, 0.5});
  CVec6 xi;
  for (int j = 0; j < 6; ++j) xi[j] = Complex(1.0 + j, 0.3 * j);
  CVec6 expected = s * xi;
  expected[Surge] += 0.5 * xi[Yaw];
  expected[Sway] -= 5.0 * xi[Yaw];
  expected[Heave] += 5.0 * xi[Pitch];
  EXPECT_LT((N * xi - expected).norm(), kRound * expected.norm());
}

// A ship without A₁₁ and A₁₃ at rest has Tuck's form: Q = iω′ S Z⁰ Sᴴ, at any signed ω′, which is
// iω(B(U) + iωA(U)).
TEST(FreeMotionIdentity, WithoutA11AndA13ItIsTucksForm) {
  Mat6 atRest = anyAtRest();
  atRest.row(Surge).setZero();
  atRest.col(Surge).setZero();
  for (const double omega : {0.4, 1.3, -0.8}) {
    for (const double U : {0.0, 6.0, -3.0}) {
      const CMat6 water = anyWater(omega);
      const Complex iw(0.0, omega);
      const CMat6 S = CMat6::Identity() + (iw * U / (omega * omega) * tuckMatrix().cast<Complex>());
      const CMat6 expected = iw * (S * (iw * water) * S.adjoint());
      const CMat6 found = waterLoad(iw, {U, 0.0}, water, atRest);
      EXPECT_LT((found - expected).norm(), kRound * expected.norm()) << omega << ' ' << U;
      if (omega < 0.0) continue;
      const SpeedCoefficients c = test::CausalShip().atSpeed(omega, U, ForwardSpeedForm::Tuck);
      const CMat6 listed =
          (-omega * omega * c.addedMass).cast<Complex>() + iw * c.damping.cast<Complex>();
      EXPECT_LT((found - listed).norm(), kRound * listed.norm()) << omega << ' ' << U;
    }
  }
}

// Over a period the load −Qξ takes π Im(ξᴴQξ). What the steady momentum adds to Q is Hermitian: it
// takes nothing, whatever the ship's shape.
TEST(FreeMotionIdentity, WhatTheSteadyMomentumAddsDoesNoWork) {
  const Mat6 atRest = anyAtRest();
  for (const double U : {6.0, -3.0}) {
    const Complex iw(0.0, 0.7);
    const CMat6 water = anyWater(0.7);
    const CMat6 more =
        waterLoad(iw, {U, 0.0}, water, atRest) - waterLoad(iw, {U, 0.0}, water, Mat6::Zero());
    EXPECT_GT(more.norm(), 0.1);
    EXPECT_LT((more - more.adjoint()).norm(), kRound * more.norm()) << U;
  }
}

// The terms by name, of a hull with A₁₁ alone: B₂₆ += Ua, B₆₂ −= Ua, C₆₆ += U²a, B₃₅ −= Ua,
// B₅₃ += Ua, C₅₅ += U²a. Q = −ω²A + iωB + C.
TEST(FreeMotionClosedForm, TermsOfA11) {
  Mat6 atRest = Mat6::Zero();
  atRest(Surge, Surge) = 2.0;
  const double U = 5.0, a = 2.0, omega = 0.7;
  const Complex iw(0.0, omega);
  CMat6 expected = CMat6::Zero();
  expected(Sway, Yaw) = iw * U * a;
  expected(Yaw, Sway) = -iw * U * a;
  expected(Yaw, Yaw) = U * U * a;
  expected(Heave, Pitch) = -iw * U * a;
  expected(Pitch, Heave) = iw * U * a;
  expected(Pitch, Pitch) = U * U * a;
  const CMat6 found = waterLoad(iw, {U, 0.0}, CMat6::Zero(), atRest);
  EXPECT_LT((found - expected).norm(), kRound * expected.norm()) << found;
}

/// A ship that moves by ξ about a steady way, water of constant A: what the momentum law says,
/// without linearising.
struct Momentum {
  Mat6 A;
  SteadyWay way;

  /// Own axes, own x part held, of angles at time t; ξ real and growing by e^{st}, s real.
  static Mat3 axes(const Vec6& xi) {
    return (Eigen::AngleAxisd(xi[Yaw], Vec3::UnitZ()) * Eigen::AngleAxisd(xi[Pitch], Vec3::UnitY()))
        .toRotationMatrix();
  }
  Vec3 velocity(const Vec6& xi, double s) const {
    return Vec3(way.ahead, way.leeway, 0.0) + s * xi.head<3>();
  }
  Vec6 own(const Vec6& xi, double s) const {
    Vec6 nu;
    const double c = std::cos(xi[Pitch]), sine = std::sin(xi[Pitch]);
    nu << axes(xi).transpose() * velocity(xi, s), s * xi[Roll] - s * xi[Yaw] * sine, s * xi[Pitch],
        s * xi[Yaw] * c;
    return nu;
  }
  /// Forces in axes of the steady way, moments by their parts about own x, level y, vertical.
  Vec6 load(const Vec6& xi, double s) const {
    constexpr double h = 1e-4;
    const Vec6 before = std::exp(-s * h) * xi, after = std::exp(s * h) * xi;
    const Vec6 p0 = A * own(before, s), p1 = A * own(after, s), p = A * own(xi, s);
    const Mat3 R = axes(xi);
    const Vec3 force = -(axes(after) * p1.head<3>() - axes(before) * p0.head<3>()) / (2.0 * h);
    const Vec3 moment = -(axes(after) * p1.tail<3>() - axes(before) * p0.tail<3>()) / (2.0 * h) -
                        velocity(xi, s).cross(R * p.head<3>());
    Vec6 load;
    load << force, -(p1[Roll] - p0[Roll]) / (2.0 * h), R.col(1).dot(moment), moment.z();
    return load;
  }
};

// −Q is the derivative of the momentum law by ξ: central differences of 1e-4, in ξ and in time.
TEST(FreeMotionIdentity, IsTheMomentumLawLinearised) {
  const Mat6 A = anyAtRest();
  for (const SteadyWay way : {SteadyWay{6.0, 0.0}, SteadyWay{-4.0, 1.5}}) {
    const Momentum law{A, way};
    const double s = 0.6, step = 1e-4;
    const Mat6 Q = waterLoad(s, way, A.cast<Complex>(), A).real();
    for (int k = 0; k < 6; ++k) {
      const Vec6 xi = step * Vec6::Unit(k);
      const Vec6 slope = (law.load(xi, s) - law.load(-xi, s)) / (2.0 * step);
      EXPECT_LT((slope + Q.col(k)).norm(), 1e-6 * Q.norm()) << k << '\n'
                                                            << (slope + Q.col(k)).transpose();
    }
  }
}

}  // namespace
}  // namespace cutwater
