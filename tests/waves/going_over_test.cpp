// Seas that go over into others: SeaState::goingOver.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "hydro/Errors.h"
#include "hydro/waves/SeaState.h"
#include "hydro/waves/SeaStatistics.h"
#include "hydro/waves/Spectrum.h"
#include "hydro/waves/WaterPressure.h"

namespace cutwater {
namespace {

constexpr double kG = 9.81;

SeaState seaOf(double hs, std::uint64_t seed, double ramp = 0.0) {
  SeaStateSettings settings{.heading = 0.5, .spreading = 4.0, .components = 50, .seed = seed};
  settings.ramp = ramp;
  return makeSeaState({.hs = hs, .tp = 8.0, .gravity = kG}, settings);
}

// All sums in double precision: 50 waves of some 0.2 m.
constexpr double kRounding = 1e-12;

TEST(GoingOverIdentity, BeforeItIsTheOneAndAfterTheOther) {
  const SeaState swell = seaOf(2.0, 1, 40.0), storm = seaOf(8.0, 2);
  const SeaState both = swell.goingOver(storm, 100.0, 60.0);
  for (const double t : {10.0, 60.0, 100.0})
    EXPECT_NEAR(both.elevation(t, 30.0, 20.0), swell.elevation(t, 30.0, 20.0), kRounding);
  for (const double t : {160.0, 500.0}) {
    EXPECT_NEAR(both.elevation(t, 30.0, 20.0), storm.elevation(t, 30.0, 20.0), kRounding);
    EXPECT_NEAR(both.velocity(t, {3.0, 2.0, -4.0}).z(), storm.velocity(t, {3.0, 2.0, -4.0}).z(),
                kRounding);
  }
}

// Halfway both have √½ of their amplitudes.
TEST(GoingOverClosedForm, EnergyGoesFromTheOneToTheOther) {
  const SeaState swell = seaOf(2.0, 1), storm = seaOf(8.0, 2);
  const SeaState both = swell.goingOver(storm, 100.0, 60.0);
  const double root = std::sqrt(0.5);
  EXPECT_NEAR(both.growth(0, 130.0), root, 1e-15);
  EXPECT_NEAR(both.growth(99, 130.0), root, 1e-15);
  EXPECT_NEAR(both.elevation(130.0, 5.0, 6.0),
              root * (swell.elevation(130.0, 5.0, 6.0) + storm.elevation(130.0, 5.0, 6.0)),
              kRounding);
  for (const double t : {105.0, 117.0, 149.0})
    EXPECT_NEAR(std::pow(both.growth(0, t), 2) + std::pow(both.growth(50, t), 2), 1.0, 1e-14);
}

// Phasors, whose loads are a sum, and the pressure on hulls grow alike.
TEST(GoingOverIdentity, PhasorsAndPressuresGrowAsTheSurfaceDoes) {
  const SeaState both = seaOf(2.0, 1, 10.0).goingOver(seaOf(4.0, 2, 5.0), 30.0, 20.0);
  std::vector<Phasors4> phasors(both.phasorBlocks());
  WaterPressure water(both);
  std::vector<double> x(16, 3.0), y(16, -2.0), z(16, -1.0), zeta(16), head(16), surface(16);
  for (const double t : {4.0, 35.0, 41.0, 70.0}) {
    both.phasors(t, 3.0, -2.0, phasors);
    const double exact = both.elevation(t, 3.0, -2.0);
    EXPECT_NEAR(both.elevation(phasors, t), exact, kRounding);
    water.at(t, 0.0, 0.0, {x, y, z}, 10.0, {zeta, head, surface});
    EXPECT_NEAR(zeta[0], exact, 2e-6 * 20.0);  // WaterPressure's bound, of Σ a below 20 m
  }
}

// Variances of seas that know nothing of one another add.
TEST(GoingOverClosedForm, HeightsGoOverByTheirSquares) {
  const SeaState both = seaOf(2.0, 1).goingOver(seaOf(8.0, 2), 100.0, 60.0);
  EXPECT_NEAR(momentsOf(both, 100.0).significantHeight(), 2.0, kRounding);
  EXPECT_NEAR(momentsOf(both, 130.0).significantHeight(), std::sqrt(0.5 * (4.0 + 64.0)), kRounding);
  EXPECT_NEAR(momentsOf(both, 160.0).significantHeight(), 8.0, kRounding);
}

TEST(GoingOverIdentity, AThirdSeaComesWhileTheSecondDoes) {
  const SeaState a = seaOf(2.0, 1), b = seaOf(4.0, 2), c = seaOf(6.0, 3);
  const SeaState all = a.goingOver(b, 10.0, 60.0).goingOver(c, 30.0, 20.0);
  EXPECT_EQ(all.components().size(), 150U);
  EXPECT_NEAR(all.elevation(90.0, 1.0, 2.0), c.elevation(90.0, 1.0, 2.0), kRounding);
  EXPECT_NEAR(all.elevation(30.0, 1.0, 2.0), a.goingOver(b, 10.0, 60.0).elevation(30.0, 1.0, 2.0),
              kRounding);
}

TEST(GoingOver, SeasThatDoNotFitAreRefused) {
  const SeaState sea = seaOf(2.0, 1);
  const SeaState steep = SeaState::steep({.omega = 0.8, .amplitude = 2.0}, kG, 2);
  EXPECT_THROW((void)sea.goingOver(steep, 0.0, 10.0), HydroError);
  EXPECT_NO_THROW((void)SeaState().goingOver(steep, 0.0, 10.0));
  EXPECT_THROW((void)sea.goingOver(SeaState({{1.0, 1.0}}, 1.62), 0.0, 10.0), HydroError);
  EXPECT_THROW((void)sea.goingOver(SeaState({{1.0, 1.0}}, kG), 0.0, 10.0), HydroError);  // profile
  EXPECT_THROW((void)sea.goingOver(sea, 0.0, 0.0), HydroError);
}

}  // namespace
}  // namespace cutwater
