#include <gtest/gtest.h>

#include <cmath>

#include "hydro/Errors.h"
#include "hydro/bem/matrices/PanelPairs.h"
#include "tests/bem/Bodies.h"

// What pairs of panels need, whatever the frequency.
namespace cutwater::test {
namespace {

PanelMesh boatWithLid() { return panels(wetHalfEllipsoid({10.0, 3.0, 2.0}, 8, 4), true, true); }

/// A square of side 1 on its edge, its centre `depth` below the surface.
Panel squareAt(double depth) {
  return flatPanel({{0.5, 0, 0.5 - depth},
                    {-0.5, 0, 0.5 - depth},
                    {-0.5, 0, -0.5 - depth},
                    {0.5, 0, -0.5 - depth}});
}

PanelPairs pairsOfSquares(const std::vector<double>& depths,
                          const InfluenceSettings& settings = {}) {
  PanelMesh mesh;
  for (const double depth : depths) mesh.panels.push_back(squareAt(depth));
  return PanelPairs(std::move(mesh), settings);
}

TEST(PanelPairs, RefusesPointsThatAreNoRuleAndNamesThem) {
  const auto message = [](const InfluenceSettings& settings) -> std::string {
    try {
      pairsOfSquares({1.0}, settings);
    } catch (const HydroError& error) {
      EXPECT_EQ(error.fault(), Fault::BadArgument);
      return error.what();
    }
    return "";
  };
  const auto has = [](const std::string& text, const std::string& word) {
    return text.find(word) != std::string::npos;
  };
  EXPECT_TRUE(has(message({.galerkinPoints = 2}), "galerkin_points = 2"));
  EXPECT_TRUE(has(message({.galerkinPoints = 0}), "galerkin_points = 0"));
  EXPECT_TRUE(has(message({.sourcePoints = 16}), "source_points = 16"));
  EXPECT_TRUE(has(message({.sourcePoints = -1}), "not 1, 4 or 9"));
  EXPECT_TRUE(has(message({.xDerivative = true}), "formulation"));
  EXPECT_EQ(message({.formulation = Formulation::Source, .xDerivative = true}), "");
}

TEST(PanelPairsIdentity, HullComesBeforeTheLid) {
  const PanelMesh mesh = boatWithLid();
  const PanelPairs pairs(mesh, {});
  EXPECT_EQ(pairs.hull(), 32);
  ASSERT_GT(mesh.lid.size(), 0u);
  EXPECT_EQ(pairs.all(), 32 + static_cast<int>(mesh.lid.size()));
  EXPECT_EQ(pairs.parities(), 2);
  EXPECT_EQ(pairs.panel(31).centroid, mesh.panels[31].centroid);
  EXPECT_EQ(pairs.panel(32).centroid, mesh.lid[0].centroid);
  for (int i = 0; i < pairs.all(); ++i) EXPECT_EQ(pairs.size(i), diameter(pairs.panel(i)));
}

// Every rule has the panel's area, and of several points its centroid. Round-off of some 16 terms.
TEST(PanelPairsIdentity, EveryRuleHasTheAreaOfThePanel) {
  for (const int galerkin : {1, 4, 9}) {
    const PanelPairs pairs(boatWithLid(), {.galerkinPoints = galerkin});
    for (int i = 0; i < pairs.all(); ++i) {
      std::vector<std::vector<QuadraturePoint>> rules{pairs.galerkin(i),
                                                      pairs.fewPoints(i, i, 3.0)};
      for (int n = 1; n <= PanelPairs::kMostPoints; ++n) rules.push_back(pairs.points(i, n));
      for (const auto& rule : rules) {
        double area = 0.0;
        Vec3 moment = Vec3::Zero();
        for (const QuadraturePoint& at : rule) {
          area += at.weight;
          moment += at.weight * (at.x - pairs.panel(i).centroid);
        }
        EXPECT_NEAR(area, pairs.panel(i).area, 1e-13 * pairs.panel(i).area) << i;
        if (rule.size() == 1) continue;  // the middle of the map, which is not always the centroid
        EXPECT_LT(moment.norm(), 1e-12 * pairs.panel(i).area * pairs.size(i)) << i;
      }
      if (galerkin == 1) {
        ASSERT_EQ(pairs.galerkin(i).size(), 1u);  // a triangle's rule would have three
        EXPECT_EQ(pairs.galerkin(i)[0].x, pairs.panel(i).centroid);
      }
    }
  }
}

// A wave function f(h, z + ζ) of two points: e·∇_ξ f must be its derivative along the source's
// normal (potential), or along the normal of the field panel, mirrored where that is (source).
// Central differences of 1e-5 leave 1e-10.
TEST(PanelPairsIdentity, DirectionTurnsTheFieldsNormalIntoADerivativeByTheSource) {
  const auto f = [](const Vec3& x, const Vec3& xi) {
    return std::exp(0.3 * (x.z() + xi.z())) *
           std::cos(0.7 * std::hypot(x.x() - xi.x(), x.y() - xi.y()));
  };
  for (const Formulation formulation : {Formulation::Potential, Formulation::Source}) {
    const PanelPairs pairs(boatWithLid(), {.formulation = formulation});
    for (const bool mirrored : {false, true})
      for (const auto& [i, j] : {std::pair{3, 17}, {30, 2}, {11, 12}}) {
        const Vec3 x = imageInY(pairs.panel(i).centroid, mirrored), xi = pairs.panel(j).centroid;
        const Vec3 n = formulation == Formulation::Potential
                           ? pairs.panel(j).normal
                           : imageInY(pairs.panel(i).normal, mirrored);
        constexpr double h = 1e-5;
        const double wanted = formulation == Formulation::Potential
                                  ? (f(x, xi + h * n) - f(x, xi - h * n)) / (2.0 * h)
                                  : (f(x + h * n, xi) - f(x - h * n, xi)) / (2.0 * h);
        const Vec3 e = pairs.direction({i, j, mirrored});
        EXPECT_NEAR((f(x, xi + h * e) - f(x, xi - h * e)) / (2.0 * h), wanted, 1e-9);
      }
  }
}

// A panel's own image is twice its depth away; near is less than 2.5 diameters, the greater one's.
TEST(PanelPairsClosedForm, NearIsTwoAndAHalfDiametersToTheImage) {
  const double reach = PanelPairs::kNearRatio * std::sqrt(2.0);  // of squares of side 1
  const PanelPairs pairs = pairsOfSquares({0.499 * reach, 0.501 * reach});
  EXPECT_TRUE(pairs.isNear({0, 0, false}));
  EXPECT_FALSE(pairs.isNear({1, 1, false}));
  const PanelPairs boat(boatWithLid(), {});
  int near = 0;
  for (int i = 0; i < boat.all(); ++i)
    for (int j = 0; j < boat.all(); ++j)
      for (const bool mirrored : {false, true}) {
        EXPECT_EQ(boat.isNear({i, j, mirrored}), boat.isNear({j, i, mirrored})) << i << ' ' << j;
        near += boat.isNear({i, j, mirrored}) ? 1 : 0;
      }
  EXPECT_GT(near, boat.all());
  EXPECT_LT(near, 2 * boat.all() * boat.all());
}

// n × n points must leave no more than 0.5 % of a wave, of whose decay with depth the square root
// counts; shorter waves never need fewer points, deeper panels never more.
TEST(PanelPairsConvergence, PointsAreAsManyAsTheWaveLengthAsksFor) {
  const PanelPairs pairs = pairsOfSquares({0.5, 8.0});
  int before = 1;
  for (double K = 0.05; K < 10.0; K *= 1.1) {
    const int n = pairs.pointsPerSide(0, 0, K);
    EXPECT_GE(n, before) << K;
    EXPECT_LE(pairs.pointsPerSide(1, 1, K), n) << K;
    before = n;
    if (n == PanelPairs::kMostPoints) continue;
    const double theta = 0.5 * K * pairs.size(0);
    double sum = 0.0;
    for (const auto& [s, weight] : gaussLegendre(n))
      sum += weight * std::cos(theta * (2.0 * s - 1.0));
    const double decay = std::exp(-0.5 * K * 0.5);  // centre at 0.5 m, upper edge at calm water
    EXPECT_LT(decay * std::abs(sum - std::sin(theta) / theta), 0.005) << K;
  }
  EXPECT_EQ(pairs.pointsPerSide(0, 0, 1e-3), 1);
  EXPECT_EQ(before, PanelPairs::kMostPoints);
  EXPECT_EQ(pairsOfSquares({0.5}, {.sourcePoints = 9}).pointsPerSide(0, 0, 1e-3), 3);
}

TEST(PanelPairs, FewPointsAreFourSevenOrNine) {
  const PanelPairs pairs = pairsOfSquares({0.5});
  EXPECT_EQ(pairs.fewPoints(0, 0, 0.1).size(), 4u);
  EXPECT_EQ(pairs.fewPoints(0, 0, 2.0).size(), 7u);
  EXPECT_EQ(pairs.fewPoints(0, 0, 8.0).size(), 9u);
  PanelMesh mesh;
  mesh.panels.push_back(flatPanel({{0, 0, -1}, {2, 1, -2}, {-0.5, 1.5, -1}}));
  for (const double K : {0.01, 1.0, 9.0}) {
    EXPECT_EQ(PanelPairs(mesh, {}).fewPoints(0, 0, K).size(), 7u) << K;
    EXPECT_EQ(PanelPairs(mesh, {.galerkinPoints = 1}).fieldPointsPerSide({0, 0, false}, K), 1);
    EXPECT_LE(PanelPairs(mesh, {}).fieldPointsPerSide({0, 0, false}, K), 2) << K;
  }
}

}  // namespace
}  // namespace cutwater::test
