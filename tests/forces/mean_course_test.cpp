#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>

#include "hydro/Errors.h"
#include "hydro/forces/MeanCourse.h"

namespace cutwater {
namespace {

/// A ship that makes speed 1 m/s from t = 0, seen by a mean at rest: largest distance of the mean's
/// speed from the closed form over 12/ν.
double stepError(double followTime, double step) {
  MeanCourse mean(followTime);
  mean.reset(0.0, 0.0, 0.0, 0.0);
  double error = 0.0;
  for (int n = 1; n * step < 12.0 * followTime; ++n) {
    mean.advance(step, {n * step, 0.0, 0.0, 1.0, 0.0, 0.0});
    const double tau = n * step / followTime;
    error =
        std::max(error, std::abs(mean.speed() - 1.0 + std::exp(-tau) * (1.0 + tau - tau * tau)));
  }
  return error;
}

// x̄/x = (3s + 1)/(s + 1)³ in units of 1/ν: a step of velocity gives 1 − e^{−τ}(1 + τ − τ²).
TEST(MeanCourseConvergence, StepOfSpeedIsFollowedAsTheThirdOrderFilterDoes) {
  const double coarse = stepError(15.0, 0.2), fine = stepError(15.0, 0.1);
  EXPECT_NEAR(std::log2(coarse / fine), 1.0, 0.05);  // semi-implicit: first order in the tick
  EXPECT_LT(fine, 3.0 * 0.1 / 15.0);  // the steepest slope is 3ν: a tick late at most
}

// On a straight line at any heading and in a steady turn there is no lag; round-off of 10⁵ ticks.
TEST(MeanCourseIdentity, SteadyMotionIsFollowedWithoutLag) {
  const double heading = 2.3, speed = 7.0, step = 0.02;
  MeanCourse mean(15.0);
  mean.reset(3.0, -4.0, heading, speed);
  const double u = speed * std::cos(heading), v = speed * std::sin(heading);
  for (int n = 1; n <= 100000; ++n)
    mean.advance(step, {3.0 + u * (n * step), -4.0 + v * (n * step), heading, u, v, 0.0});
  EXPECT_NEAR(mean.x(), 3.0 + u * 2000.0, 1e-6);
  EXPECT_NEAR(mean.y(), -4.0 + v * 2000.0, 1e-6);
  EXPECT_NEAR(mean.speed(), speed, 1e-9);
  mean.reset(0.0, 0.0, 0.0, 0.0, 0.02);
  for (int n = 1; n <= 100000; ++n) {
    const double psi = std::remainder(0.02 * (n * step), 2.0 * kPi);  // as an engine gives it
    mean.advance(step, {0.0, 0.0, psi, 0.0, 0.0, 0.02});
  }
  EXPECT_NEAR(mean.heading(), 40.0, 1e-6);  // not wrapped
  EXPECT_NEAR(mean.turnRate(), 0.02, 1e-9);
}

// |(3ν²iω + ν³)/(iω + ν)³| is 3(ν/ω)² for ω ≫ ν: at ω = 0.6 rad/s and ν = 1/15 s 3.6 %, of which
// higher powers of ν/ω are √(1 + 1/729)/(1 + 1/81)^{3/2}, 2 %.
TEST(MeanCourseClosedForm, LetsThreeTimesTheSquareOfTheRatioOfFrequenciesThrough) {
  const double omega = 0.6, nu = 1.0 / 15.0, step = 0.01;
  MeanCourse mean(15.0);
  mean.reset(0.0, 0.0, 0.0, 0.0);
  double largest = 0.0;
  for (int n = 1; n < 60000; ++n) {
    const double t = n * step;
    mean.advance(step, {std::sin(omega * t), 0.0, 0.0, omega * std::cos(omega * t), 0.0, 0.0});
    if (t > 500.0) largest = std::max(largest, std::abs(mean.x()));
  }
  EXPECT_NEAR(largest / (3.0 * nu * nu / (omega * omega)), 1.0, 0.025);
}

// The header's promise. (3νẍ by the old acceleration would be unstable from ν h = 0.5 on.)
TEST(MeanCourse, IsStableUpToATickOfTheFollowTime) {
  for (const double share : {0.1, 0.5, 0.99}) {
    MeanCourse mean(1.0);
    mean.reset(5.0, 0.0, 0.0, 0.0);
    for (int n = 0; n < 2000; ++n) mean.advance(share, {0.0, 0.0, 0.0, 0.0, 0.0, 0.0});
    EXPECT_LT(std::abs(mean.x()), 1e-6) << share;
  }
}

TEST(MeanCourse, AFixedOneIsAStraightLineWhateverTheShipDoes) {
  MeanCourse mean;
  EXPECT_FALSE(mean.follows());
  mean.reset(1.0, 2.0, kPi / 2, 5.0, 0.3);
  for (int n = 0; n < 100; ++n) mean.advance(0.1, {9.0, 9.0, 9.0, 9.0, 9.0, 9.0});
  EXPECT_NEAR(mean.x(), 1.0, 1e-12);
  EXPECT_NEAR(mean.y(), 52.0, 1e-12);
  EXPECT_EQ(mean.heading(), kPi / 2);
  EXPECT_EQ(mean.speed(), 5.0);
  EXPECT_EQ(mean.turnRate(), 0.0);
}

TEST(MeanCourse, LeewayIsNotSpeed) {
  MeanCourse mean(10.0);
  mean.reset(0.0, 0.0, 0.0, 4.0);
  for (int n = 1; n <= 20000; ++n)
    mean.advance(0.02, {4.0 * (0.02 * n), 0.5 * (0.02 * n), 0.0, 4.0, 0.5, 0.0});
  EXPECT_NEAR(mean.speed(), 4.0, 1e-9);
  EXPECT_NEAR(mean.y(), 0.5 * 400.0, 1e-6);
}

TEST(MeanCourse, LooksAwayFromWhatIsNotFinite) {
  MeanCourse mean(10.0);
  mean.reset(0.0, 0.0, 0.4, 4.0);
  const double nan = std::nan("");
  mean.advance(0.1, {nan, HUGE_VAL, nan, 1.0, 1.0, 0.0});
  EXPECT_NEAR(mean.x(), 0.4 * std::cos(0.4), 1e-12);
  EXPECT_NEAR(mean.speed(), 4.0, 1e-12);
  EXPECT_EQ(mean.heading(), 0.4);
}

TEST(MeanCourse, RestoredStateGivesTheSameBits) {
  const auto drive = [](MeanCourse& mean, int from, int to) {
    for (int n = from; n < to; ++n)
      mean.advance(0.03, {std::sin(0.1 * n), 0.2 * n, 0.01 * n, 0.5, 6.0, 0.3 * std::cos(0.2 * n)});
  };
  MeanCourse one(12.0), other(12.0);
  one.reset(1.0, 2.0, 0.3, 6.0);
  drive(one, 0, 500);
  std::array<double, MeanCourse::kStateSize> middle{}, end{}, again{};
  one.save(middle);
  other.restore(middle);
  drive(one, 500, 900);
  drive(other, 500, 900);
  one.save(end);
  other.save(again);
  EXPECT_EQ(std::memcmp(end.data(), again.data(), sizeof end), 0);
}

TEST(MeanCourse, RefusesNonsense) {
  for (const double time : {-1.0, std::nan(""), 1e-320})
    EXPECT_THROW(MeanCourse{time}, HydroError) << time;
}

}  // namespace
}  // namespace cutwater
