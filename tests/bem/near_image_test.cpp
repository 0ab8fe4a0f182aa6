#include <gtest/gtest.h>

#include <array>

#include "hydro/bem/matrices/NearWave.h"
#include "hydro/green/WaveTerm.h"

// The parts that near_wave_test.cpp adds up, one by one.
namespace cutwater::test {
namespace {

const Panel kWall = flatPanel({{0, 0.2, 0}, {1, 0, 0}, {1, -0.1, -0.8}, {0, 0.1, -0.8}});

RankinePanel rankineOfAll(const Panel& panel) {
  return RankinePanel(std::span(panel.corner.data(), static_cast<std::size_t>(panel.corners)));
}

NearImage imageSeenFrom(const Vec3& x, const Panel& panel, const Vec3& along) {
  QuarteredPanel quartered(panel);
  return nearImage(x, quartered, rankineOfAll(panel), along);
}

const std::vector<Vec3> kFieldPoints{{0.5, 0.3, -0.2}, {1.2, -0.4, -0.5}, {-0.6, 0.1, 0.0}};

// Outgoing waves for e^{+iωt}: Im g = −2πK e^{−Y}J₀, as the standard library has J₀; the tables
// leave 1e-11.
TEST(NearWaveClosedForm, ImaginaryPartOfTheWaveTermIsBesselsFunction) {
  for (const double K : {0.1, 1.0, 4.0})
    for (const double X : {0.0, 0.3, 2.0, 11.0})
      for (const double Y : {0.1, 1.5}) {
        const WavePoint w(K, X, Y);
        const double E = std::exp(-Y);
        EXPECT_NEAR(w.value.imag(), -2.0 * kPi * K * E * std::cyl_bessel_j(0.0, X), 1e-10 * K);
        EXPECT_NEAR(w.slope.imag(), 2.0 * kPi * K * K * E * std::cyl_bessel_j(1.0, X),
                    1e-10 * K * K);
        EXPECT_NEAR(w.rise.imag(), -K * w.value.imag(), 1e-10 * K * K);
      }
}

// Slope and rise are derivatives of the value by distance and depth, in metres. Fourth order: h⁴/30
// of the fifth derivative, which near the image is 2·5!/R⁶, R ≥ 1 here.
TEST(NearWaveIdentity, SlopeAndRiseAreDerivativesOfTheValue) {
  const double K = 0.7, h = 0.01;
  for (const double distance : {1.0, 4.0})
    for (const double depth : {0.8, 3.0}) {
      const auto at = [K](double d, double z) { return WavePoint(K, K * d, K * z).value; };
      const auto slope = [h](auto f) {
        return (8.0 * (f(h) - f(-h)) - (f(2.0 * h) - f(-2.0 * h))) / (12.0 * h);
      };
      const WavePoint w(K, K * distance, K * depth);
      const Complex byDistance = slope([&](double d) { return at(distance + d, depth); });
      const Complex byDepth = slope([&](double d) { return at(distance, depth + d); });
      EXPECT_LT(std::abs(w.slope - byDistance), 2e-7);
      EXPECT_LT(std::abs(w.rise - byDepth), 2e-7);  // deeper is −ζ
    }
}

// From all of −2/R₁ in short waves to none in long ones; half at R = 4. Of one number and of four
// the same.
TEST(NearWaveClosedForm, ShareOfTheImageIsHalfAtFour) {
  EXPECT_DOUBLE_EQ(inverseShare(0.25), 0.5);
  EXPECT_GT(inverseShare(1e-2), 1.0 - 1e-5);
  EXPECT_LT(inverseShare(10.0), 1e-6);
  const Double4 four = inverseShare(Double4{0.01, 0.2, 0.25, 3.0});
  for (const auto& [i, perR] : {std::pair{0, 0.01}, {1, 0.2}, {2, 0.25}, {3, 3.0}})
    EXPECT_DOUBLE_EQ(four[i], inverseShare(perR));
}

// ∂(ln ρ)/∂z = −1/R₁ and ∂(ln ρ)/∂x_h = −∇_ξ ln ρ: the four integrals of one image hold together.
// Quadrature of the logarithm leaves 1e-5 of the panel's area, near it; differences of 1e-3 m 1e-6.
TEST(NearWaveIdentity, IntegralsOfAnImageAreEachOthersDerivatives) {
  constexpr double h = 1e-3;
  const Vec3 along(0.6, 0.8, 0.0);
  for (const Vec3& x : {Vec3(0.5, 0.3, -0.2), Vec3(1.2, -0.4, -0.5), Vec3(-0.6, 0.1, -0.3)}) {
    const NearImage image = imageSeenFrom(x, kWall, along);
    const auto log = [&](const Vec3& step) { return imageSeenFrom(x + step, kWall, along).log; };
    const Vec3 up = h * Vec3::UnitZ(), ahead = h * along;
    EXPECT_NEAR((log(up) - log(-up)) / (2.0 * h), -image.inverse, 1e-4 * image.inverse);
    EXPECT_NEAR((log(ahead) - log(-ahead)) / (2.0 * h), -image.logAlong, 1e-4);
    const auto inverse = [&](const Vec3& step) {
      return imageSeenFrom(x + step, kWall, along).inverse;
    };
    EXPECT_NEAR((inverse(ahead) - inverse(-ahead)) / (2.0 * h), -image.inverseAlong, 1e-5);
  }
}

// Seen from afar a panel is its area at its centroid, to (size/distance)².
TEST(NearWaveClosedForm, DistantPanelIsItsArea) {
  const Vec3 x(30.0, -40.0, -12.0);
  const NearImage image = imageSeenFrom(x, kWall, Vec3::UnitX());
  const Vec3 d = kWall.centroid - Vec3(x.x(), x.y(), -x.z());
  const double R1 = d.norm(), rho = R1 - d.z();
  EXPECT_DOUBLE_EQ(image.distance, R1);
  EXPECT_NEAR(image.inverse, kWall.area / R1, 1e-3 * kWall.area / R1);
  EXPECT_NEAR(image.inverseAlong, -kWall.area * d.x() / (R1 * R1 * R1),
              1e-3 * kWall.area / (R1 * R1));
  EXPECT_NEAR(image.log, kWall.area * std::log(rho), 1e-3 * kWall.area);
}

// Quartering stops where it is no longer needed: deeper changes nothing from afar, and little near
// by.
TEST(NearWaveConvergence, QuarteringDeeperChangesLittle) {
  const auto logAt = [](const Vec3& x, int depth) {
    QuarteredPanel panel(kWall);
    NearImage sum;
    panel.addLog(x, Vec3::UnitX(), depth, sum);
    return sum.log;
  };
  EXPECT_EQ(logAt({5.0, 0.0, -1.0}, 0), logAt({5.0, 0.0, -1.0}, 5));
  for (const Vec3& x : kFieldPoints) {
    const double deep = logAt(x, 7);
    EXPECT_LE(std::abs(logAt(x, 5) - deep), 1e-5 * kWall.area);  // as the header says
    EXPECT_LE(std::abs(logAt(x, 5) - deep), std::abs(logAt(x, 0) - deep) + 1e-12);
  }
}

// One quartered panel serves many field points, in any order, with the same bits.
TEST(NearWaveIdentity, QuartersMadeForOnePointServeTheNext) {
  QuarteredPanel kept(kWall);
  const RankinePanel rankine = rankineOfAll(kWall);
  for (int round = 0; round < 2; ++round)
    for (const Vec3& x : kFieldPoints) {
      const NearImage fresh = imageSeenFrom(x, kWall, kWall.normal),
                      again = nearImage(x, kept, rankine, kWall.normal);
      EXPECT_EQ(fresh.log, again.log);
      EXPECT_EQ(fresh.logAlong, again.logAlong);
      EXPECT_EQ(fresh.inverse, again.inverse);
    }
}

// The derivative has a horizontal part by way of the logarithm and a vertical one by way of 1/R₁:
// in every direction what 10 × 10 points give of the whole, which leave 1e-5 of a panel as far away
// as it is long; quartering leaves 1e-5 as well.
TEST(NearWaveIdentity, SplitDerivativeIsTheWholeOneInEveryDirection) {
  const Vec3 corner(0.0, 0.0, -0.4), along(1.0, 0.0, 0.1), across(0.1, 1.0, -0.1);
  const Panel bottom =
      flatPanel({corner, corner + along, corner + along + across, corner + across});
  const Vec3 x(0.3, 0.5, -0.5);
  const QuadraturePoint field{x, 1.0};
  const auto points = panelQuadrature(bottom, 10);
  for (const double K : {0.3, 1.0, 4.0, 20.0})  // from the logarithm to the image
    for (const Vec3& e : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(0.48, -0.6, 0.64)}) {
      Complex value = 0.0, slope = 0.0;
      for (const QuadraturePoint& at : points) {
        const double dx = at.x.x() - x.x(), dy = at.x.y() - x.y(), h = std::hypot(dx, dy);
        const WavePoint w(K, K * h, -K * (at.x.z() + x.z()));
        value += at.weight * w.value;
        slope += at.weight * ((e.x() * dx + e.y() * dy) / h * w.slope - e.z() * w.rise);
      }
      const NearSums sums({&field, 1}, false, points, K);
      const WaveIntegral split = nearWave(sums, 1.0, imageSeenFrom(x, bottom, e), e, K);
      EXPECT_LT(std::abs(split.value - value), 5e-5 * (1.0 + K)) << K;
      EXPECT_LT(std::abs(split.along - slope), 5e-5 * (1.0 + K)) << K << ' ' << e.transpose();
    }
}

// The two limits of the whole: no waves at K → 0, minus twice the image at K → ∞
// [InfluenceMatrices.h].
TEST(NearWaveClosedForm, LongAndShortWaves) {
  const Vec3 x(0.5, 0.4, -0.3);
  const QuadraturePoint field{x, 1.0};
  const NearImage image = imageSeenFrom(x, kWall, kWall.normal);
  const auto waveAt = [&](double K) {
    const NearSums sums({&field, 1}, false, panelQuadrature(kWall, 4), K);
    return nearWave(sums, 1.0, image, kWall.normal, K);
  };
  const WaveIntegral longest = waveAt(1e-6), shortest = waveAt(2e3);
  EXPECT_LT(std::abs(longest.value), 1e-4 * kWall.area);  // K ln K
  EXPECT_LT(std::abs(longest.along), 1e-4);
  // Next to −2/R₁ comes 2Y/R³ of it, 1/(K R₁).
  EXPECT_LT(std::abs(shortest.value + 2.0 * image.inverse), 2e-3 * image.inverse);
  EXPECT_LT(std::abs(shortest.along + 2.0 * image.inverseAlong), 4e-3 * image.inverse / 0.3);
}

}  // namespace
}  // namespace cutwater::test
