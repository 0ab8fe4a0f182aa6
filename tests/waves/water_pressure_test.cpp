#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "hydro/waves/Spectrum.h"
#include "hydro/waves/WaterPressure.h"

namespace cutwater {
namespace {

constexpr double kG = 9.81;
constexpr std::array kProfiles{WaveProfile::Extrapolated, WaveProfile::Wheeler,
                               WaveProfile::Constant};

/// Places and the water there.
struct Cloud {
  explicit Cloud(std::size_t count)
      : x(count), y(count), z(count), elevation(count), head(count), surfaceHead(count) {}
  /// About a ship of 120 m, from its keel to above its deck.
  static Cloud ofShip(unsigned seed, std::size_t count = 96) {
    Cloud cloud(count);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> along(-60.0, 60.0), across(-8.0, 8.0), up(-6.0, 5.0);
    for (std::size_t i = 0; i < count; ++i) {
      cloud.x[i] = along(random);
      cloud.y[i] = across(random);
      cloud.z[i] = up(random);
    }
    return cloud;
  }
  void fill(WaterPressure& water, double t, double x0, double y0, double near = 1e3) {
    water.at(t, x0, y0, {x, y, z}, near, {elevation, head, surfaceHead});
  }
  std::vector<double> x, y, z, elevation, head, surfaceHead;
};

/// ζ and H of the header's formulas, in double precision, and what their errors are relative to.
class Exact {
 public:
  Exact(const SeaState& sea, double t, double x, double y) : sea_(sea) {
    for (const WaveComponent& c : sea.components()) {
      const double k = c.omega * c.omega / kG;
      const double along = x * std::cos(c.heading) - y * std::sin(c.heading);
      k_.push_back(k);
      amplitude_.push_back(sea.ramp(t) * c.amplitude);
      height_.push_back(amplitude_.back() * std::cos(c.omega * t - k * along + c.phase));
      elevation += height_.back();
      sum += amplitude_.back();
    }
  }
  /// At z, or at the surface if z is above it. scale = r Σ a max(1, (1 + kz) e^{kz}).
  double head(double z, double& scale) const {
    double level = std::min(z, elevation);
    if (sea_.profile() == WaveProfile::Wheeler) level -= elevation;
    if (sea_.profile() == WaveProfile::Constant) level = std::min(level, 0.0);
    double head = scale = 0.0;
    for (std::size_t i = 0; i < k_.size(); ++i) {
      const double kz = k_[i] * level;
      head += height_[i] * std::exp(kz);
      scale += amplitude_[i] * std::max(1.0, (1.0 + kz) * std::exp(kz));
    }
    return head;
  }
  double elevation = 0.0, sum = 0.0;

 private:
  const SeaState& sea_;
  std::vector<double> k_, amplitude_, height_;
};

/// The header's bound: cosine, exponential and two products 6e-7, a sum of sixteen in single
/// precision at most 15 · 6e-8.
constexpr double kError = 2e-6;

void expectExact(const SeaState& sea, double t, double x0, double y0, unsigned seed) {
  for (const bool wide : {false, true}) {
    WaterPressure water(sea, wide);
    Cloud cloud = Cloud::ofShip(seed);
    cloud.fill(water, t, x0, y0);
    for (std::size_t i = 0; i < cloud.x.size(); ++i) {
      const Exact exact(sea, t, x0 + cloud.x[i], y0 + cloud.y[i]);
      double scale = 0.0;
      EXPECT_NEAR(cloud.elevation[i], exact.elevation, kError * exact.sum);
      const double head = exact.head(cloud.z[i], scale);
      EXPECT_NEAR(cloud.head[i], head, kError * scale);
      const double surface = exact.head(exact.elevation, scale);
      EXPECT_NEAR(cloud.surfaceHead[i], surface, kError * scale);
    }
  }
}

SeaState roughSea(int components, WaveProfile profile, std::uint64_t seed, double spreading) {
  SeaStateSettings settings{.heading = 2.0, .spreading = spreading, .components = components};
  settings.seed = seed;
  settings.ramp = 20.0;
  settings.profile = profile;
  return makeSeaState({.hs = 3.0, .tp = 9.0, .gravity = kG}, settings);
}

TEST(WaterPressureClosedForm, IsThatOfTheFormulasOfEachProfile) {
  for (const WaveProfile profile : kProfiles) {
    unsigned seed = 1;
    for (const int components : {1, 2, 15, 16, 17, 60, 200}) {
      const SeaState sea = roughSea(components, profile, seed, components % 2 == 0 ? 4.0 : 0.0);
      for (const double t : {7.0, 33.3, 5000.0})  // within the ramp, and long after it
        expectExact(sea, t, 31.0, -17.0, ++seed);
    }
  }
}

// Of waves between a wave length of 3 m and one of 1 km, on a ship of 120 m: 250 rad and 0.8 rad.
TEST(WaterPressureClosedForm, IsThatOfOneWave) {
  for (const WaveProfile profile : kProfiles) {
    for (const double omega : {0.25, 0.7, 1.5, 4.5}) {
      const double amplitude = 0.05 * 2.0 * kPi * kG / (omega * omega);  // H/λ = 1/10
      expectExact(SeaState({{omega, amplitude, 0.3, 1.0}}, kG, 0.0, profile), 100.0, 2.0, 3.0, 5);
      expectExact(SeaState({{omega, 1e-3, 0.3, 1.0}}, kG, 0.0, profile), 100.0, 2.0, 3.0, 6);
    }
  }
}

// Double precision has 1e-10 rad at phases of 1e6.
TEST(WaterPressureClosedForm, IsAsExactFarFromTheOriginAndLate) {
  for (const WaveProfile profile : kProfiles) {
    expectExact(roughSea(60, profile, 4, 4.0), 1e5, 1e5, -1e5, 9);
    expectExact(SeaState({{3.0, 0.2, 1.0, -2.0}}, kG, 0.0, profile), 1e5, -1e5, 1e5, 10);
  }
}

// The same sea seen from another origin: the same water at the same places.
TEST(WaterPressureIdentity, DoesNotDependOnTheOrigin) {
  const SeaState sea = roughSea(50, WaveProfile::Extrapolated, 2, 4.0);
  WaterPressure water(sea);
  Cloud here = Cloud::ofShip(3), there = here;
  for (double& x : there.x) x -= 40.0;
  for (double& y : there.y) y += 25.0;
  here.fill(water, 50.0, 100.0, 200.0);
  there.fill(water, 50.0, 140.0, 175.0);
  const Exact exact(sea, 50.0, 0.0, 0.0);
  for (std::size_t i = 0; i < here.x.size(); ++i)
    EXPECT_NEAR(here.elevation[i], there.elevation[i], 2.0 * kError * exact.sum);
}

TEST(WaterPressureIdentity, WheelersHeadAtTheSurfaceIsTheElevation) {
  for (const bool wide : {false, true}) {
    WaterPressure water(roughSea(200, WaveProfile::Wheeler, 7, 4.0), wide);
    Cloud cloud = Cloud::ofShip(8);
    cloud.fill(water, 40.0, 3.0, 4.0);
    EXPECT_EQ(cloud.surfaceHead, cloud.elevation);
    cloud.z = cloud.elevation;
    cloud.fill(water, 40.0, 3.0, 4.0);
    EXPECT_EQ(cloud.head, cloud.elevation);
  }
}

TEST(WaterPressureIdentity, PointsAboveTheWaterHaveTheHeadOfTheSurface) {
  for (const WaveProfile profile : kProfiles) {
    WaterPressure water(roughSea(40, profile, 7, 0.0));
    Cloud cloud = Cloud::ofShip(9);
    cloud.fill(water, 40.0, 3.0, 4.0);
    int above = 0;
    for (std::size_t i = 0; i < cloud.x.size(); ++i) {
      if (cloud.z[i] < cloud.elevation[i]) continue;
      ++above;
      EXPECT_EQ(cloud.head[i], cloud.surfaceHead[i]);
    }
    EXPECT_GT(above, 10);
  }
}

TEST(WaterPressure, NearSaysWhereTheHeadOfTheSurfaceIsMade) {
  for (const WaveProfile profile : kProfiles) {
    const SeaState sea = roughSea(40, profile, 7, 0.0);
    WaterPressure water(sea);
    Cloud all = Cloud::ofShip(9);
    std::sort(all.z.begin(), all.z.end());
    Cloud some = all;
    all.fill(water, 40.0, 3.0, 4.0);
    some.fill(water, 40.0, 3.0, 4.0, 1.0);
    EXPECT_EQ(all.head, some.head);
    EXPECT_EQ(all.elevation, some.elevation);
    for (std::size_t i = 0; i < all.x.size(); ++i) {
      EXPECT_TRUE(std::isfinite(some.surfaceHead[i]));
      if (all.z[i] > -1.0) {
        EXPECT_EQ(all.surfaceHead[i], some.surfaceHead[i]);
      }
    }
  }
}

TEST(WaterPressure, CalmWaterHasNoDynamicPressure) {
  Cloud cloud = Cloud::ofShip(1);
  const std::vector<double> none(cloud.x.size(), 0.0);
  for (const SeaState& sea : {SeaState(), SeaState({{0.7, 2.0, 0.3, 1.0}}, kG, 10.0)}) {
    WaterPressure water(sea);
    cloud.fill(water, 0.0, 10.0, 20.0);  // t = 0: before the ramp
    EXPECT_EQ(cloud.elevation, none);
    EXPECT_EQ(cloud.head, none);
    EXPECT_EQ(cloud.surfaceHead, none);
  }
}

// Ripples on a wave of 20 m: e^{kζ} would be 1e87. It is bounded, and nothing is infinite.
TEST(WaterPressure, IsFiniteFarOutsideItsTheory) {
  for (const WaveProfile profile : kProfiles) {
    WaterPressure water(
        SeaState({{0.4, 20.0, 0.0, 0.0}, {10.0, 0.01, 0.0, 0.0}}, kG, 0.0, profile));
    Cloud cloud = Cloud::ofShip(1);
    for (double& z : cloud.z) z *= 1e4;
    cloud.fill(water, 0.0, 0.0, 0.0);
    for (std::size_t i = 0; i < cloud.x.size(); ++i) {
      EXPECT_TRUE(std::isfinite(cloud.head[i]));
      EXPECT_TRUE(std::isfinite(cloud.surfaceHead[i]));
    }
  }
}

}  // namespace
}  // namespace cutwater
