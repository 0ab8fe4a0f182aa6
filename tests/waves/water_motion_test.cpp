#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "hydro/waves/Spectrum.h"
#include "hydro/waves/WaterMotion.h"
#include "hydro/waves/WaterPressure.h"

namespace cutwater {
namespace {

constexpr double kG = 9.81;

struct Places {
  std::vector<double> x, y, z;
};

Places placesAbout(std::size_t count, unsigned seed) {
  Places places;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> level(-80.0, 80.0), up(-12.0, 4.0);
  for (std::size_t i = 0; i < count; ++i) {
    places.x.push_back(level(random));
    places.y.push_back(level(random));
    places.z.push_back(up(random));
  }
  return places;
}

struct Fields {
  explicit Fields(std::size_t n)
      : elevation(n), slopeX(n), slopeY(n), vx(n), vy(n), vz(n), head(n) {}
  WaterMotion::Water all() { return {elevation, slopeX, slopeY, vx, vy, vz, head}; }
  std::vector<double> elevation, slopeX, slopeY, vx, vy, vz, head;
};

SeaState shortCrested(WaveProfile profile, int components) {
  SeaStateSettings settings{.heading = 1.0, .spreading = 5.0, .components = components, .seed = 4};
  settings.ramp = 30.0;
  settings.profile = profile;
  return makeSeaState({.hs = 4.0, .tp = 9.0, .gravity = kG}, settings);
}

// The header's bound of 2e-6, of sums of amplitudes, with waves at most e^{kz} = 1.4 higher above
// calm water.
constexpr double kError = 3e-6;

// Slopes and pressures against differences of the sea's own elevation and against WaterPressure,
// velocities against SeaState below calm water, where all profiles but Wheeler's agree with it.
TEST(WaterMotionIdentity, IsTheSeaThatShipsSailIn) {
  for (const WaveProfile profile : {WaveProfile::Extrapolated, WaveProfile::Constant}) {
    for (const int components : {1, 3, 17, 120}) {
      const SeaState sea = shortCrested(profile, components);
      double heights = 0.0, slopes = 0.0, speeds = 0.0;
      for (std::size_t i = 0; i < sea.components().size(); ++i) {
        const WaveComponent& c = sea.components()[i];
        heights += c.amplitude;
        slopes += sea.waveNumber(i) * c.amplitude;
        speeds += c.omega * c.amplitude;
      }
      const double t = 1234.5, x0 = 300.0, y0 = -200.0;
      for (const bool wide : {false, true}) {
        const Places at = placesAbout(48, 7);
        Fields f(48), pressed(48);
        WaterMotion(sea, wide).at(t, x0, y0, {at.x, at.y, at.z}, f.all());
        WaterPressure(sea, wide).at(t, x0, y0, {at.x, at.y, at.z}, 100.0,
                                    {pressed.elevation, pressed.head, pressed.slopeX});
        for (std::size_t i = 0; i < 48; ++i) {
          const double X = x0 + at.x[i], Y = y0 + at.y[i], h = 1e-4;
          const double zeta = sea.elevation(t, X, Y);
          EXPECT_NEAR(f.elevation[i], zeta, kError * heights);
          EXPECT_NEAR(f.slopeX[i],
                      (sea.elevation(t, X + h, Y) - sea.elevation(t, X - h, Y)) / (2.0 * h),
                      kError * slopes);
          EXPECT_NEAR(f.slopeY[i],
                      (sea.elevation(t, X, Y + h) - sea.elevation(t, X, Y - h)) / (2.0 * h),
                      kError * slopes);
          const double p = at.z[i] < f.elevation[i] ? pressed.head[i] - at.z[i] : 0.0;
          EXPECT_NEAR(f.head[i], p, kError * heights);
          if (at.z[i] > 0.0 || at.z[i] > zeta) continue;
          const Vec3 v = sea.velocity(t, {X, Y, at.z[i]});
          EXPECT_NEAR(f.vx[i], v.x(), kError * speeds);
          EXPECT_NEAR(f.vy[i], v.y(), kError * speeds);
          EXPECT_NEAR(f.vz[i], v.z(), kError * speeds);
        }
      }
    }
  }
}

// Wheeler's: the velocity at the surface is that of linear theory at calm water.
TEST(WaterMotionIdentity, WheelersSurfaceHasTheVelocityOfCalmWater) {
  const SeaState sea = shortCrested(WaveProfile::Wheeler, 60);
  double speeds = 0.0;
  for (const WaveComponent& c : sea.components()) speeds += c.omega * c.amplitude;
  const Places at = placesAbout(32, 3);
  Fields f(32);
  WaterMotion(sea).at(500.0, 0.0, 0.0, {.x = at.x, .y = at.y}, f.all());
  for (std::size_t i = 0; i < 32; ++i) {
    const Vec3 v = sea.velocity(500.0, {at.x[i], at.y[i], 0.0});
    EXPECT_NEAR(f.vx[i], v.x(), kError * speeds);
    EXPECT_NEAR(f.vz[i], v.z(), kError * speeds);
    EXPECT_EQ(f.head[i], 0.0);
  }
}

// What is asked for does not change what is answered, nor does the number of points; but for the
// rounding of sums, 50 waves of at most 1 m in single precision.
TEST(WaterMotionIdentity, EachAnswerIsTheSameAloneOrWithOthers) {
  const SeaState sea = shortCrested(WaveProfile::Wheeler, 50);
  const Places at = placesAbout(37, 9);
  Fields f(37);
  WaterMotion water(sea);
  water.at(77.0, 1.0, 2.0, {at.x, at.y, at.z}, f.all());
  for (std::size_t i = 0; i < 37; ++i) {
    const std::span x(&at.x[i], 1), y(&at.y[i], 1), z(&at.z[i], 1);
    double elevation = 0.0, slope = 0.0, speed = 0.0, head = 0.0;
    water.at(77.0, 1.0, 2.0, {x, y, z}, {.elevation = {&elevation, 1}});
    water.at(77.0, 1.0, 2.0, {x, y, z}, {.slopeY = {&slope, 1}});
    water.at(77.0, 1.0, 2.0, {x, y, z}, {.velocityZ = {&speed, 1}});
    water.at(77.0, 1.0, 2.0, {x, y, z}, {.pressureHead = {&head, 1}});
    EXPECT_NEAR(elevation, f.elevation[i], 1e-6);
    EXPECT_NEAR(slope, f.slopeY[i], 1e-6);
    EXPECT_NEAR(speed, f.vz[i], 1e-6);
    EXPECT_NEAR(head, f.head[i], 1e-6);
  }
}

TEST(WaterMotion, CalmWaterIsCalm) {
  const Places at = placesAbout(5, 2);
  Fields f(5);
  WaterMotion(SeaState()).at(3.0, 0.0, 0.0, {at.x, at.y, at.z}, f.all());
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(f.elevation[i], 0.0);
    EXPECT_EQ(f.vx[i], 0.0);
    EXPECT_EQ(f.head[i], std::max(0.0, -at.z[i]));
  }
}

}  // namespace
}  // namespace cutwater
