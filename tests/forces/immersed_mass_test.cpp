#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "hydro/base/SymmetricEigen.h"
#include "hydro/forces/ImmersedMass.h"
#include "tests/support/Matrices.h"

namespace cutwater {
namespace {

const std::vector<double> kArms{-45.0, -30.0, -15.0, 0.0, 15.0, 30.0, 45.0};
const std::vector<double> kWeights{120.0, 190.0, 200.0, 200.0, 180.0, 110.0, 20.0};

// A ship's: symmetric, all modes of each parity coupled.
Mat6 addedMass() {
  Mat6 a = Mat6::Zero();
  a.diagonal() << 1.4e5, 2.0e6, 5.5e6, 2.4e7, 3.6e9, 1.5e9;
  const auto set = [&](int j, int k, double value) { a(j, k) = a(k, j) = value; };
  set(Surge, Heave, -6e4);
  set(Surge, Pitch, 5e5);
  set(Heave, Pitch, 1.2e7);
  set(Sway, Roll, -2e6);
  set(Sway, Yaw, 4e6);
  set(Roll, Yaw, 1e7);
  return a;
}

double smallest(const Mat6& m, const Mat6& unit) {
  const Vec6 root = unit.diagonal().cwiseSqrt().cwiseInverse();
  const Mat6 scaled = root.asDiagonal() * m * root.asDiagonal();
  return symmetricEigenvalues(scaled)[0];
}

double difference(const Mat6& a, const Mat6& b) {
  const Vec6 root = addedMass().diagonal().cwiseSqrt().cwiseInverse();
  return (root.asDiagonal() * (a - b) * root.asDiagonal()).cwiseAbs().maxCoeff();
}

class ImmersedMassIdentity : public testing::Test {
 protected:
  std::vector<double> someShares() {
    std::vector<double> shares;
    for (std::size_t i = 0; i < kArms.size(); ++i) shares.push_back(uniform_(random_));
    return shares;
  }
  const ImmersedMass mass_{addedMass(), kWeights, kArms};
  const std::vector<double> whole_ = std::vector<double>(kArms.size(), 1.0);
  const std::vector<double> none_ = std::vector<double>(kArms.size(), 0.0);

 private:
  std::mt19937 random_{7};
  std::uniform_real_distribution<double> uniform_{0.0, 1.0};
};

TEST_F(ImmersedMassIdentity, WholeIsAInfinityAndNoneIsNothing) {
  EXPECT_LT(difference(mass_.at(whole_), addedMass()), 1e-12);
  EXPECT_LT(difference(mass_.at(none_), Mat6::Zero()), 1e-12);
  EXPECT_DOUBLE_EQ(mass_.mean(whole_), 1.0);
  EXPECT_DOUBLE_EQ(mass_.mean(none_), 0.0);
}

TEST_F(ImmersedMassIdentity, MoreWaterIsMoreMassInEveryDirection) {
  for (int i = 0; i < 100; ++i) {
    const auto less = someShares();
    auto more = someShares();
    for (std::size_t k = 0; k < more.size(); ++k) more[k] = std::max(more[k], less[k]);
    EXPECT_GT(smallest(mass_.at(less), addedMass()), -1e-12);
    EXPECT_GT(smallest(mass_.at(more) - mass_.at(less), addedMass()), -1e-12);
  }
}

TEST_F(ImmersedMassIdentity, AllStripsAlikeAreAShareOfHeaveAndPitch) {
  const std::vector<double> third(kArms.size(), 1.0 / 3.0);
  const Mat6 part = mass_.at(third);
  for (const int j : {Heave, Pitch}) {
    for (int k = 0; k < 6; ++k)
      EXPECT_NEAR(part(j, k), addedMass()(j, k) / 3.0, 1e-12 * std::abs(addedMass()(j, k)));
  }
  // What is coupled to neither goes with the mean, a third of eight tenths.
  EXPECT_NEAR(part(Sway, Sway), addedMass()(Sway, Sway) / 3.0 / 0.8, 1e-6);
}

TEST_F(ImmersedMassIdentity, WhatChangesIsWhatCameLessWhatLeft) {
  const std::vector<double> still(kArms.size(), 0.0);
  for (int i = 0; i < 100; ++i) {
    const auto before = someShares(), now = someShares();
    const auto change = mass_.change(before, now, still);
    EXPECT_LT(difference(change.now, mass_.at(now)), 1e-12);
    EXPECT_GT(smallest(change.left, addedMass()), -1e-12);
    const Mat6 came = change.now - mass_.at(before) + change.left;
    EXPECT_GT(smallest(came, addedMass()), -1e-12);
    EXPECT_EQ(change.met, Vec6(Vec6::Zero()));
  }
}

// A fall: no velocity gives energy to the ship with its water, whatever comes and goes.
TEST_F(ImmersedMassIdentity, EnergyNeverGrows) {
  const std::vector<double> still(kArms.size(), 0.0);
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  Vec6 inertia;
  inertia << 4.6e6, 4.6e6, 4.6e6, 1.5e8, 3.8e9, 3.8e9;
  const Mat6 M = inertia.asDiagonal();
  for (int i = 0; i < 100; ++i) {
    const auto before = someShares(), now = someShares();
    const auto change = mass_.change(before, now, still);
    Vec6 v;
    for (double& x : v) x = normal(random);
    v.tail<3>() /= 40.0;
    const Mat6 then = mass_.at(before);
    const Vec6 momentum = (M + then - change.left) * v;
    const Vec6 after = test::inverse(M + change.now) * momentum;
    const double energy = 0.5 * v.dot((M + then) * v);
    EXPECT_LE(0.5 * after.dot((M + change.now) * after), energy * (1.0 + 1e-12));
  }
}

// The water that rises with the hull's own speed against a strip is no blow.
TEST_F(ImmersedMassIdentity, WaterThatRisesAlikeIsNoBlow) {
  auto before = whole_, now = whole_;
  before[5] = 0.2;
  std::vector<double> rise(kArms.size(), 0.0);
  rise[5] = 1.7;
  const auto change = mass_.change(before, now, rise);
  Vec6 heaving = Vec6::Zero();
  heaving[Heave] = 1.7;
  const Vec6 came = (change.now - mass_.at(before)) * heaving;
  // But for what goes with the mean: surge, sway, roll and yaw beside heave and pitch, without
  // heave.
  EXPECT_NEAR(change.met[Heave], came[Heave], 1e-9 * std::abs(came[Heave]));
  EXPECT_NEAR(change.met[Pitch], came[Pitch], 1e-9 * std::abs(came[Pitch]));
}

TEST_F(ImmersedMassIdentity, ABowThatComesInIsMetAtTheBow) {
  auto before = whole_;
  before.back() = 0.0;
  const auto change = mass_.change(before, whole_, none_);
  const Mat6 came = change.now - mass_.at(before);
  // Force and moment of a blow on heave: pitch / heave = −x of the place where it acts.
  EXPECT_NEAR(-came(Pitch, Heave) / came(Heave, Heave), kArms.back(), 12.0);
}

TEST(ImmersedMass, OneStripIsAShareOfAll) {
  const ImmersedMass mass(addedMass(), std::vector<double>{3.0}, std::vector<double>{1.0});
  EXPECT_LT(difference(mass.at(std::vector<double>{0.25}), 0.25 / 0.8 * addedMass()), 1e-12);
}

TEST(ImmersedMass, NegativeDirectionsAreDropped) {
  Mat6 a = addedMass();
  a(Surge, Surge) = -1e3;
  a(Surge, Heave) = a(Heave, Surge) = a(Surge, Pitch) = a(Pitch, Surge) = 0.0;
  const ImmersedMass mass(a, kWeights, kArms);
  const Mat6 whole = mass.at(std::vector<double>(kArms.size(), 1.0));
  EXPECT_NEAR(whole(Surge, Surge), 0.0, 1e-6);
  EXPECT_NEAR(whole(Heave, Heave), a(Heave, Heave), 1e-6 * a(Heave, Heave));
}

}  // namespace
}  // namespace cutwater
