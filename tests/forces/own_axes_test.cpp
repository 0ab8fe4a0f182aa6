#include <gtest/gtest.h>

#include <random>

#include "hydro/forces/OwnAxes.h"

namespace cutwater {
namespace {

constexpr double kRound = 1e-14;  // round-off of numbers of order 1

Vec3 anyVector(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return Vec3::NullaryExpr([&] { return normal(random); });
}

Vec6 anyMomentum(std::mt19937& random) {
  Vec6 p;
  p << anyVector(random), anyVector(random);
  return p;
}

// R = R_z R_y: y stays level, positive pitch is bow down.
TEST(OwnAxesClosedForm, FollowHeadingAndPitch) {
  const double psi = 2.1, theta = 0.3;
  const Mat3 own = ownAxes(psi, theta);
  EXPECT_LT((own.col(0) - Vec3(std::cos(theta) * std::cos(psi), std::cos(theta) * std::sin(psi),
                               -std::sin(theta)))
                .norm(),
            kRound);
  EXPECT_LT((own.col(1) - Vec3(-std::sin(psi), std::cos(psi), 0.0)).norm(), kRound);
  EXPECT_LT((own * own.transpose() - Mat3::Identity()).norm(), kRound);
}

// R pitches whole with the ship to 30°, beyond that ever less, without a jump of angle or slope,
// and never beyond 75°.
TEST(OwnAxes, NeverStandOnEnd) {
  const auto pitchOf = [](double theta) { return std::asin(-ownAxes(0.4, theta)(2, 0)); };
  constexpr double kStep = 1e-3;
  double slope = 1.0;
  for (double theta = kStep; theta < 100.0; theta += theta < kPi ? kStep : 1.0) {
    const double pitch = pitchOf(theta);
    EXPECT_NEAR(pitchOf(-theta), -pitch, kRound);
    EXPECT_LT(pitch, kPi * 75.0 / 180.0);
    if (theta <= kPi / 6.0) {
      EXPECT_NEAR(pitch, theta, 10.0 * kRound);
    }
    const double next = (pitch - pitchOf(theta - kStep)) / kStep;
    EXPECT_LT(next, slope + 1e-9);  // round-off of a difference over the step
    if (theta < kPi) {
      EXPECT_GT(next, slope - 0.02) << theta;
    }
    slope = next;
  }
}

// N = ((F₄ + F₆ sin θ)/cos θ, F₅, F₆) in axes of the heading alone: power F₄p + F₅θ̇ + F₆ψ̇ is that
// of N on the rates.
TEST(OwnAxesClosedForm, AMomentOfGivenPartsInAxesOfTheHeading) {
  const double psi = -1.3, theta = 0.4;
  const Vec3 parts(2.0, -3.0, 5.0);
  const Mat3 own = ownAxes(psi, theta), heading = ownAxes(psi, 0.0);
  const Vec3 found = heading.transpose() * momentOf(own, parts);
  const Vec3 expected((parts[0] + parts[2] * std::sin(theta)) / std::cos(theta), parts[1],
                      parts[2]);
  EXPECT_LT((found - expected).norm(), 10.0 * kRound);
  const double roll = 0.7, pitch = 0.2, yaw = -0.4;  // φ̇, θ̇, ψ̇
  const Vec3 spin = roll * own.col(0) + pitch * own.col(1) + yaw * Vec3::UnitZ();
  EXPECT_NEAR(momentOf(own, parts).dot(spin), parts.dot(Vec3(roll, pitch, yaw)), 10.0 * kRound);
}

TEST(OwnAxesIdentity, PartsOfAMomentAndTheMomentOfItsParts) {
  std::mt19937 random(4);
  for (const double theta : {-3.0, -0.9, 0.0, 0.2, 1.5}) {
    const Mat3 own = ownAxes(1.7, theta);
    const Vec3 moment = anyVector(random);
    // 1/cos²(75°) = 15 magnifies round-off.
    EXPECT_LT((momentOf(own, generalisedMoment(own, moment)) - moment).norm(), 100.0 * kRound);
    EXPECT_LT((generalisedMoment(own, momentOf(own, moment)) - moment).norm(), 100.0 * kRound);
  }
}

// What the ship's axes turned, and pitched: the force part stands still, and so do the moment's
// parts about the new level axis and the vertical; its part about x went with the ship.
TEST(OwnAxesIdentity, CarriedMomentumStandsStillButForItsPartAboutX) {
  std::mt19937 random(5);
  for (int n = 0; n < 20; ++n) {
    const Vec3 turn = anyVector(random);
    const Mat3 then = ownAxes(turn[0], 0.3 * turn[1]), now = ownAxes(turn[0] + 0.1 * turn[2], 0.2);
    const Mat3 level = ownAxes(turn[0], 0.0), levelNow = ownAxes(turn[0] + 0.1 * turn[2], 0.0);
    const Vec6 p = anyMomentum(random), q = carried(p, level, then, levelNow, now);
    EXPECT_LT((levelNow * q.head<3>() - level * p.head<3>()).norm(), 10.0 * kRound);
    EXPECT_EQ(q[Roll], p[Roll]);
    const Vec3 before = then * p.tail<3>(), after = now * q.tail<3>();
    EXPECT_NEAR(now.col(1).dot(after), now.col(1).dot(before), 10.0 * kRound);
    EXPECT_NEAR(after.z(), before.z(), 10.0 * kRound);
  }
}

// A ship that only rolls, or stands still, carries all of it; no bit of it changes.
TEST(OwnAxesIdentity, AxesThatDidNotTurnCarryTheSame) {
  std::mt19937 random(6);
  const Mat3 own = ownAxes(0.8, -0.2);
  const Vec6 p = anyMomentum(random);
  EXPECT_LT((carried(p, own, own, own, own) - p).norm(), 10.0 * kRound);
  EXPECT_EQ(carried(Vec6::Zero(), own, own, own, own), Vec6::Zero().eval());
}

// Within the theory all of the cross terms, beyond it (v*/v)², and from 30° to 45° of tilt down to
// none without a jump.
TEST(TurningLimitsClosedForm, ShareFallsOutsideTheTheory) {
  const TurningLimits limits{20.0, 60.0};
  Vec6 own = Vec6::Zero();
  own[Surge] = 16.0;
  own[Yaw] = 0.2;  // the ends: hypot(16, 12)
  EXPECT_EQ(limits.share(own, 1.0), 1.0);
  EXPECT_EQ(limits.share(own, std::cos(0.5)), 1.0);
  EXPECT_NEAR(limits.share(3.0 * own, 1.0), 1.0 / 9.0, kRound);
  EXPECT_EQ(limits.share(own, std::cos(kPi / 4)), 0.0);
  EXPECT_EQ(limits.share(own, -1.0), 0.0);
  double before = 1.0;
  for (double tilt = 0.5; tilt < 0.8; tilt += 1e-3) {
    const double now = limits.share(own, std::cos(tilt));
    EXPECT_LE(now, before);
    EXPECT_GT(now, before - 0.01) << tilt;  // 1.5 in 15° at the steepest
    before = now;
  }
}

}  // namespace
}  // namespace cutwater
