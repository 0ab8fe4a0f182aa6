#include <gtest/gtest.h>

#include <memory>
#include <random>

#include "hydro/bem/matrices/NearWave.h"
#include "hydro/bem/matrices/WaveTile.h"
#include "hydro/geometry/panels/PanelQuadrature.h"

// Wave terms of 16 × 16 pairs at once, against single points and against panels cut fine.
namespace cutwater::test {
namespace {

constexpr std::size_t kTileSide = WaveTile::kSide;

/// Mean products of the distances from the centroid, and what else a tile asks of a panel. As a
/// field panel the horizontal parts of normal and mixed moments are reversed.
void putInto(WaveTile::Panels& to, std::size_t place, const Panel& panel, bool asField) {
  const double side = asField ? -1.0 : 1.0;
  Mat3 M = Mat3::Zero();
  for (const QuadraturePoint& at : panelQuadrature(panel, 3)) {
    const Vec3 s = at.x - panel.centroid;
    M += at.weight / panel.area * s * s.transpose();
  }
  to.x[place] = panel.centroid.x();
  to.y[place] = panel.centroid.y();
  to.z[place] = panel.centroid.z();
  to.size[place] = diameter(panel);
  to.nx[place] = side * panel.normal.x();
  to.ny[place] = side * panel.normal.y();
  to.nz[place] = panel.normal.z();
  to.xx[place] = M(0, 0);
  to.xy[place] = M(0, 1);
  to.yy[place] = M(1, 1);
  to.xz[place] = side * M(0, 2);
  to.yz[place] = side * M(1, 2);
  to.zz[place] = M(2, 2);
}

/// Square of this size about a centre, turned at will.
Panel turnedSquare(const Vec3& centre, double size, double turn, double tilt) {
  const Vec3 u = 0.5 * size * Vec3(std::cos(turn), std::sin(turn), 0.0);
  const Vec3 across(-std::sin(turn), std::cos(turn), 0.0);
  const Vec3 v = 0.5 * size * (std::cos(tilt) * across + std::sin(tilt) * Vec3::UnitZ());
  return flatPanel({centre + u + v, centre - u + v, centre - u - v, centre + u - v});
}

/// 16 source and 16 field panels, 3 m deep and more, up to 12 m apart.
struct TwoBlocks {
  std::vector<Panel> field, source;
  WaveTile::Panels fieldPanels{}, sourcePanels{};

  explicit TwoBlocks(double size) {
    std::mt19937 random(9);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    for (std::size_t i = 0; i < kTileSide; ++i)
      for (std::vector<Panel>* panels : {&field, &source}) {
        const double x = 8.0 * unit(random) + (panels == &source ? 2.0 : -2.0);
        const double y = 4.0 * unit(random), z = -1.5 - 2.0 * unit(random);
        const double turn = 6.0 * unit(random);
        panels->push_back(turnedSquare(Vec3(x, y, z), size, turn, 3.0 * unit(random)));
      }
    for (std::size_t i = 0; i < kTileSide; ++i) {
      putInto(fieldPanels, i, field[i], true);
      putInto(sourcePanels, i, source[i], false);
    }
  }

  /// Form factors by quadrature.
  std::unique_ptr<WaveTile> tileAt(double K, bool images) const {
    auto tile = std::make_unique<WaveTile>();
    tile->source = &sourcePanels;
    tile->field = &fieldPanels;
    tile->takeImages = images;
    tile->place(K);
    for (std::size_t j = 0; j < kTileSide; ++j)
      for (std::size_t i = 0; i < kTileSide; ++i) {
        const std::size_t k = kTileSide * j + i;
        const auto form = [&](const Panel& panel) {
          Complex sum = 0.0;
          for (const QuadraturePoint& at : panelQuadrature(panel, 6)) {
            const Vec3 s = at.x - panel.centroid;
            sum += at.weight / panel.area *
                   std::exp(K * Complex(s.z(), -tile->ex[k] * s.x() - tile->ey[k] * s.y()));
          }
          return sum;
        };
        const Complex both = form(source[j]) * std::conj(form(field[i]));
        tile->formRe[k] = both.real();
        tile->formIm[k] = both.imag();
      }
    tile->evaluate(K);
    return tile;
  }
};

/// g and its derivatives along n of the source, and of the field reversed, mean over both panels.
struct MeanWave {
  Complex value, source, field, x;
};
MeanWave meanWave(const Panel& field, const Panel& source, double K, int n) {
  MeanWave mean{};
  for (const QuadraturePoint& a : panelQuadrature(field, n))
    for (const QuadraturePoint& b : panelQuadrature(source, n)) {
      const double dx = b.x.x() - a.x.x(), dy = b.x.y() - a.x.y(), h = std::hypot(dx, dy);
      const WavePoint w(K, K * h, -K * (a.x.z() + b.x.z()));
      const double weight = a.weight * b.weight / (field.area * source.area);
      const auto along = [&](double nx, double ny, double nz) {
        return weight * ((nx * dx + ny * dy) / h * w.slope - nz * w.rise);
      };
      const Vec3 &m = field.normal, &s = source.normal;
      mean.value += weight * w.value;
      mean.source += along(s.x(), s.y(), s.z());
      mean.field += along(-m.x(), -m.y(), m.z());
      mean.x += along(1.0, 0.0, 0.0);
    }
  return mean;
}

MeanWave resultOf(const WaveTile& tile, std::size_t k) {
  return {{tile.valueRe[k], tile.valueIm[k]},
          {tile.sourceRe[k], tile.sourceIm[k]},
          {tile.fieldRe[k], tile.fieldIm[k]},
          {tile.xRe[k], tile.xIm[k]}};
}

double distanceOf(const MeanWave& a, const MeanWave& b, double K) {
  return std::max({std::abs(a.value - b.value), std::abs(a.source - b.source) / K,
                   std::abs(a.field - b.field) / K, std::abs(a.x - b.x) / K});
}

// Panels of a millimetre are points: g itself and its gradient, to (1 mm/3 m)² and what the tables
// leave.
TEST(WaveTileClosedForm, SmallPanelsAreSinglePoints) {
  const TwoBlocks blocks(1e-3);
  for (const double K : {0.02, 0.3, 2.0}) {
    const auto tile = blocks.tileAt(K, false);
    for (std::size_t k = 0; k < WaveTile::kPairs; ++k) {
      const MeanWave exact =
          meanWave(blocks.field[k % kTileSide], blocks.source[k / kTileSide], K, 1);
      EXPECT_LT(distanceOf(resultOf(*tile, k), exact, K), 1e-6 * (K + std::abs(exact.value))) << k;
    }
  }
}

// Second moments of squares leave fourth ones: halved panels, a sixteenth of the error. At K = 1
// waves count, of which the ring's curvature leaves the same order.
TEST(WaveTileConvergence, WhatMomentsLeaveFallsWithTheFourthPowerOfTheSize) {
  for (const double K : {0.05, 0.4, 1.0}) {
    const auto worst = [K](double size) {
      const TwoBlocks blocks(size);
      const auto tile = blocks.tileAt(K, false);
      double error = 0.0, whole = 0.0;
      for (std::size_t k = 0; k < WaveTile::kPairs; ++k) {
        const MeanWave exact =
            meanWave(blocks.field[k % kTileSide], blocks.source[k / kTileSide], K, 6);
        error += std::norm(distanceOf(resultOf(*tile, k), exact, K));
        whole += std::norm(exact.value);
      }
      return std::sqrt(error / whole);
    };
    const double coarse = worst(0.8), fine = worst(0.4);
    EXPECT_GT(std::log2(coarse / fine), 3.5) << K << ' ' << coarse << ' ' << fine;
    EXPECT_LT(fine, 1e-3) << K;
  }
}

// Of panels so small the share of −1/R₁ that is taken out is missing from g, and from nothing else.
TEST(WaveTileIdentity, ShareOfTheImageIsWhatIsTakenOut) {
  const TwoBlocks blocks(1e-3);
  for (const double K : {0.3, 2.0}) {
    const auto with = blocks.tileAt(K, true), without = blocks.tileAt(K, false);
    for (std::size_t k = 0; k < WaveTile::kPairs; ++k) {
      const double R1 = with->R1[k], share = with->share[k];
      EXPECT_EQ(without->share[k], 0.0);
      EXPECT_DOUBLE_EQ(share, 2.0 * inverseShare(1.0 / (K * R1)));
      // 1e-7: second moments of 1/R₁ itself, (1 mm/3 m)².
      EXPECT_NEAR(with->valueRe[k], without->valueRe[k] + share / R1, 1e-7 * share / R1) << k;
      EXPECT_EQ(with->valueIm[k], without->valueIm[k]);
      const double dx =
          blocks.source[k / kTileSide].centroid.x() - blocks.field[k % kTileSide].centroid.x();
      EXPECT_NEAR(with->xRe[k], without->xRe[k] - share * dx / (R1 * R1 * R1),
                  1e-7 * share / (R1 * R1))
          << k;
    }
  }
}

TEST(WaveTileIdentity, PlacesAreDistancesAndDirections) {
  TwoBlocks blocks(0.5);
  blocks.fieldPanels.x[3] = blocks.sourcePanels.x[5];  // one above the other
  blocks.fieldPanels.y[3] = blocks.sourcePanels.y[5];
  auto tile = std::make_unique<WaveTile>();
  tile->source = &blocks.sourcePanels;
  tile->field = &blocks.fieldPanels;
  const double K = 0.7, nearest = tile->place(K);
  double least = 1e300;
  for (std::size_t j = 0; j < kTileSide; ++j)
    for (std::size_t i = 0; i < kTileSide; ++i) {
      const std::size_t k = kTileSide * j + i;
      const double dx = blocks.sourcePanels.x[j] - blocks.fieldPanels.x[i];
      const double dy = blocks.sourcePanels.y[j] - blocks.fieldPanels.y[i];
      const double depth = -blocks.sourcePanels.z[j] - blocks.fieldPanels.z[i];
      const double R1 = std::hypot(dx, dy, depth);
      EXPECT_NEAR(std::hypot(tile->ex[k], tile->ey[k]), 1.0, 1e-15) << k;
      EXPECT_NEAR(tile->ex[k] * tile->X[k], K * dx, 1e-14) << k;
      EXPECT_NEAR(tile->ey[k] * tile->X[k], K * dy, 1e-14) << k;
      EXPECT_NEAR(tile->Y[k], K * depth, 1e-14) << k;
      EXPECT_NEAR(tile->R1[k], R1, 1e-14 * R1) << k;
      EXPECT_EQ(tile->active[k], 1.0);
      least =
          std::min(least, R1 / std::max(blocks.sourcePanels.size[j], blocks.fieldPanels.size[i]));
    }
  EXPECT_NEAR(nearest, least, 1e-14 * least);
}

TEST(WaveTileIdentity, DroppedPairsAreZeroAndOthersAsBefore) {
  const TwoBlocks blocks(0.5);
  const double K = 0.7;
  const auto whole = blocks.tileAt(K, true);
  auto tile = std::make_unique<WaveTile>(*whole);
  tile->drop(4, 9, K);
  tile->evaluate(K);
  const std::size_t dropped = kTileSide * 9 + 4;
  for (std::size_t k = 0; k < WaveTile::kPairs; ++k) {
    const MeanWave got = resultOf(*tile, k), before = resultOf(*whole, k);
    EXPECT_EQ(got.value, k == dropped ? Complex(0.0) : before.value) << k;
    EXPECT_EQ(got.source, k == dropped ? Complex(0.0) : before.source) << k;
    EXPECT_EQ(got.field, k == dropped ? Complex(0.0) : before.field) << k;
    EXPECT_EQ(tile->share[k], k == dropped ? 0.0 : whole->share[k]) << k;
  }
}

TEST(WaveTileIdentity, ParitiesAreSumAndDifference) {
  const TwoBlocks blocks(0.5), others(0.9);
  const auto a = blocks.tileAt(0.7, true), b = others.tileAt(0.7, true);
  auto even = std::make_unique<WaveTile>(*a), odd = std::make_unique<WaveTile>(*b);
  WaveTile::toParities(*even, *odd);
  for (const auto column :
       {&WaveTile::valueRe, &WaveTile::valueIm, &WaveTile::sourceRe, &WaveTile::sourceIm,
        &WaveTile::fieldRe, &WaveTile::fieldIm, &WaveTile::xRe, &WaveTile::xIm, &WaveTile::share})
    for (std::size_t k = 0; k < WaveTile::kPairs; ++k) {
      EXPECT_EQ(((*even).*column)[k], ((*a).*column)[k] + ((*b).*column)[k]);
      EXPECT_EQ(((*odd).*column)[k], ((*a).*column)[k] - ((*b).*column)[k]);
    }
}

}  // namespace
}  // namespace cutwater::test
