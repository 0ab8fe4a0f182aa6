#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>
#include <vector>

#include "hydro/Errors.h"
#include "hydro/green/RankineIntegrals.h"
#include "tests/support/Results.h"

namespace cutwater {
namespace {

using Corners = std::vector<Vec3>;

Corners rectangle(double a, double b) {
  return {{-a / 2, -b / 2, 0}, {a / 2, -b / 2, 0}, {a / 2, b / 2, 0}, {-a / 2, b / 2, 0}};
}

// A lopsided quadrilateral, a triangle and a slender panel, all in one slanting plane.
std::vector<Corners> oddPanels() {
  const Mat3 turn = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  std::vector<Corners> panels = {{{0, 0, 0}, {2, 0.2, 0}, {1.6, 1.1, 0}, {-0.1, 0.6, 0}},
                                 {{0, 0, 0}, {1, 0, 0}, {0.2, 0.9, 0}},
                                 {{0, 0, 0}, {5, 0, 0}, {5, 0.4, 0}, {0, 0.5, 0}}};
  for (Corners& panel : panels) {
    for (Vec3& c : panel) c = turn * c + Vec3(3, -1, -2);
  }
  return panels;
}

Vec3 randomDirection(std::mt19937& random) {
  std::normal_distribution<double> normal;
  Vec3 d(normal(random), normal(random), normal(random));
  return d.normalized();
}

struct Solid {
  std::vector<Corners> faces;
  Vec3 inside;
};

// A box with quadrilateral faces and a tetrahedron, normals outwards.
std::vector<Solid> solids() {
  const auto at = [](int i) { return Vec3((i & 1) * 2.0, ((i >> 1) & 1) * 3.0, (i >> 2) * 1.0); };
  const auto face = [&](int a, int b, int c, int d) { return Corners{at(a), at(b), at(c), at(d)}; };
  const Solid box = {{face(0, 2, 3, 1), face(4, 5, 7, 6), face(0, 1, 5, 4), face(2, 6, 7, 3),
                      face(0, 4, 6, 2), face(1, 3, 7, 5)},
                     {0.3, 2.1, 0.7}};
  const Vec3 o(0, 0, 0), x(1, 0, 0), y(0, 2, 0), z(0.1, 0.2, 1.5);
  const Solid tetrahedron = {{{o, y, x}, {o, x, z}, {x, y, z}, {o, z, y}}, {0.2, 0.4, 0.3}};
  return {box, tetrahedron};
}

double sumOfDoubleLayers(const Solid& solid, const Vec3& x) {
  double sum = 0.0;
  for (const Corners& face : solid.faces) sum += RankinePanel(face).exactAt(x).doubleLayer;
  return sum;
}

// Solid angle of an a × b rectangle from height z on its axis: 4 atan(ab / (2z √(a² + b² + 4z²))).
TEST(RankineIntegralsClosedForm, SolidAngleOfARectangleFromItsAxis) {
  const double a = 1.3, b = 0.7;
  for (const double z : {1e-6, 1e-3, 0.1, 1.0, 5.0, -1.0}) {
    const double expected =
        4.0 * std::atan(a * b / (2.0 * z * std::sqrt(a * a + b * b + 4.0 * z * z)));
    const RankineIntegrals r = RankinePanel(rectangle(a, b)).exactAt({0, 0, z});
    EXPECT_NEAR(r.doubleLayer, expected, 4e-15) << z;  // a few units in the last place of 2π
    EXPECT_EQ(r.gradient.z(), -r.doubleLayer);
  }
}

// A square of side a holds ∫ 1/r dS = 4a ln(1 + √2) at its centre and half as much at a corner of
// it.
TEST(RankineIntegralsClosedForm, PotentialOfASquareOnItself) {
  const double a = 2.5, centre = 4.0 * a * std::log(1.0 + std::sqrt(2.0));
  const RankinePanel square(rectangle(a, a));
  const RankineIntegrals self = square.at({0, 0, 0});
  EXPECT_NEAR(self.potential, centre, 1e-14 * centre);  // round-off
  EXPECT_NEAR(self.gradient.norm(), 0.0, 1e-15);
  EXPECT_EQ(self.doubleLayer, 0.0);
  const RankineIntegrals corner = square.at({a / 2, a / 2, 0});
  EXPECT_NEAR(corner.potential, centre / 2.0, 1e-14 * centre);
  EXPECT_TRUE(corner.gradient.allFinite());
}

// Right triangle with legs a, b: at the right angle, c the hypotenuse,
// ∫∫ 1/r dS = ∫ R(φ) dφ = (ab/c) [asinh(a/b) + asinh(b/a)].
TEST(RankineIntegralsClosedForm, PotentialOfARightTriangleAtItsCorner) {
  const double a = 1.7, b = 0.6, c = std::hypot(a, b);
  const double expected = a * b / c * (std::asinh(a / b) + std::asinh(b / a));
  const Corners triangle = {{0, 0, 0}, {a, 0, 0}, {0, b, 0}};
  EXPECT_NEAR(rankineIntegrals({0, 0, 0}, triangle).potential, expected, 1e-14);
}

// Square of half side h: ∫ ln ρ dS = 4h² [ln(h√2) + π/4 − 3/2] at its centre.
TEST(RankineIntegralsClosedForm, LogarithmOverASquare) {
  const double h = 0.35;
  const double expected = 4.0 * h * h * (std::log(h * std::sqrt(2.0)) + kPi / 4.0 - 1.5);
  EXPECT_NEAR(RankinePanel(rectangle(2 * h, 2 * h)).logarithmInPlane({0, 0, 3}), expected, 1e-15);
}

// In the plane ln ρ is the potential of a point: its Laplacian is 2π on the panel and 0 beside it.
TEST(RankineIntegralsIdentity, LogarithmSolvesPoissonsEquationInThePlane) {
  const RankinePanel panel(Corners{{0, 0, 0}, {2, 0.2, 0}, {1.6, 1.1, 0}, {-0.1, 0.6, 0}});
  const double h = 1e-3;
  const auto laplacian = [&](const Vec3& x) {
    double sum = -4.0 * panel.logarithmInPlane(x);
    for (const Vec3& step : {Vec3(h, 0, 0), Vec3(0, h, 0)}) {
      sum += panel.logarithmInPlane(x + step) + panel.logarithmInPlane(x - step);
    }
    return sum / (h * h);
  };
  // Truncation h²/12 times fourth derivatives of order 10; round-off 1e-16·4/h² = 4e-10.
  EXPECT_NEAR(laplacian(panel.centroid()), 2.0 * kPi, 1e-5);
  EXPECT_NEAR(laplacian({0.7, 0.2, 0}), 2.0 * kPi, 1e-5);
  EXPECT_NEAR(laplacian({2.5, 0.4, 0}), 0.0, 1e-5);
  EXPECT_NEAR(laplacian({-1.0, 3.0, 0}), 0.0, 1e-5);
}

TEST(RankineIntegralsIdentity, GradientIsTheDerivativeOfThePotential) {
  std::mt19937 random(1);
  const double h = 1e-4;
  for (const Corners& corners : oddPanels()) {
    const RankinePanel panel(corners);
    for (int k = 0; k < 40; ++k) {
      const Vec3 x = panel.centroid() + (0.5 + 0.15 * k) * panel.radius() * randomDirection(random);
      if (std::abs(panel.normal().dot(x - panel.centroid())) < 0.05 * panel.radius()) continue;
      Vec3 difference;
      for (int i = 0; i < 3; ++i) {  // fourth order
        const auto p = [&](double s) { return panel.exactAt(x + s * h * Vec3::Unit(i)).potential; };
        difference[i] = (8.0 * (p(1) - p(-1)) - (p(2) - p(-2))) / (12.0 * h);
      }
      // Round-off 1e-15 / h; truncation h⁴ φ⁗'/30 with the fifth derivative up to 1e5 next to an
      // edge.
      EXPECT_NEAR((panel.exactAt(x).gradient - difference).norm(), 0.0, 1e-9);
    }
  }
}

TEST(RankineIntegralsIdentity, PotentialIsHarmonic) {
  std::mt19937 random(2);
  const double h = 2e-3;
  for (const Corners& corners : oddPanels()) {
    const RankinePanel panel(corners);
    for (int k = 0; k < 40; ++k) {
      const Vec3 x = panel.centroid() + (1.5 + 0.1 * k) * panel.radius() * randomDirection(random);
      double divergence = 0.0;
      for (int i = 0; i < 3; ++i) {
        const auto g = [&](double s) {
          return panel.exactAt(x + s * h * Vec3::Unit(i)).gradient[i];
        };
        divergence += (8.0 * (g(1) - g(-1)) - (g(2) - g(-2))) / (12.0 * h);
      }
      // Truncation h⁴/30 ∂⁵g with ∂⁵g ~ 6!·A/r⁷ ≤ 1e3 at 1.5 radii; round-off 1e-15 / h.
      EXPECT_NEAR(divergence, 0.0, 2e-9);
    }
  }
}

TEST(RankineIntegralsIdentity, DoubleLayersOfAClosedSurfaceAddUpToTheSolidAngle) {
  for (const Solid& solid : solids()) {
    const double roundOff = 1e-14;  // a handful of arctangents of size π
    EXPECT_NEAR(sumOfDoubleLayers(solid, solid.inside), -4.0 * kPi, roundOff);
    EXPECT_NEAR(sumOfDoubleLayers(solid, {9.0, -4.0, 2.0}), 0.0, roundOff);
    for (const Corners& face :
         solid.faces) {  // on the surface half of it, the own panel giving none
      const RankinePanel own(face);
      EXPECT_EQ(own.at(own.centroid()).doubleLayer, 0.0);
      EXPECT_NEAR(sumOfDoubleLayers(solid, own.centroid()), -2.0 * kPi, roundOff);
      const Vec3 justOutside = own.centroid() + 1e-7 * own.normal();
      EXPECT_NEAR(sumOfDoubleLayers(solid, justOutside), 0.0,
                  1e-7);  // round-off/height: 1e-15/1e-7
    }
  }
}

// Cutting a panel in two changes nothing; the two halves share an edge, which the point may lie on.
TEST(RankineIntegralsIdentity, PanelIsTheSumOfItsParts) {
  std::mt19937 random(3);
  for (const Corners& q : oddPanels()) {
    if (q.size() != 4) continue;
    const RankinePanel whole(q), first(Corners{q[0], q[1], q[2]}),
        second(Corners{q[0], q[2], q[3]});
    std::vector<Vec3> points = {0.5 * (q[0] + q[2]), 0.3 * q[0] + 0.7 * q[2]};
    for (int k = 0; k < 50; ++k) {
      points.push_back(whole.centroid() + randomDirection(random) * 0.1 * k);
    }
    const double height = 1e-5;
    points.push_back(0.3 * q[0] + 0.7 * q[2] + height * whole.normal());
    for (const Vec3& x : points) {
      // Round-off; the last point sees the edge under angles that depend on its place:
      // 1e-15 m / height.
      const double tolerance = &x == &points.back() ? 5e-15 / height : 1e-13;
      const RankineIntegrals w = whole.exactAt(x), a = first.exactAt(x), b = second.exactAt(x);
      EXPECT_NEAR(w.potential, a.potential + b.potential, 2e-14);
      EXPECT_NEAR((w.gradient - a.gradient - b.gradient).norm(), 0.0, tolerance);
      EXPECT_NEAR(w.doubleLayer, a.doubleLayer + b.doubleLayer, tolerance);
    }
  }
}

TEST(RankineIntegralsIdentity, FarFormAgreesWithTheExactOne) {
  std::mt19937 random(4);
  double worstPotential = 0.0, worstGradient = 0.0;
  std::vector<Corners> panels = oddPanels();
  panels.push_back(rectangle(1.0, 1.0));
  panels.push_back({{0, 0, 0}, {1, 0, 0}, {0.5, 1e-3, 0}});
  for (const Corners& corners : panels) {
    const RankinePanel panel(corners);
    for (int k = 0; k < 2000; ++k) {
      const double distance = (k % 2 ? 1.0 : 3.0) * RankinePanel::kFarRatio * panel.radius();
      const Vec3 x = panel.centroid() + distance * randomDirection(random);
      const RankineIntegrals exact = panel.exactAt(x), far = panel.farAt(x);
      worstPotential = std::max(worstPotential, std::abs(far.potential / exact.potential - 1.0));
      worstGradient =
          std::max(worstGradient, (far.gradient - exact.gradient).norm() / exact.gradient.norm());
      EXPECT_NEAR(far.doubleLayer, -panel.normal().dot(far.gradient), 1e-15);
    }
  }
  EXPECT_LT(worstPotential, 2e-7);  // the promises of the header
  EXPECT_LT(worstGradient, 1e-6);
  test::recordResult("green", "Rankine far form, relative error of the potential at the switch",
                     "exact form", worstPotential, "2e-7");
  test::recordResult("green", "Rankine far form, relative error of the gradient at the switch",
                     "exact form", worstGradient, "1e-6");
}

// The first moment left out is the fifth: the error of the potential falls as (radius/distance)^5.
TEST(RankineIntegralsConvergence, FarFormIsOfFifthOrder) {
  const RankinePanel triangle(oddPanels()[1]);
  const auto error = [&](double ratio) {
    double worst = 0.0;
    std::mt19937 random(5);
    for (int k = 0; k < 500; ++k) {
      const Vec3 x = triangle.centroid() + ratio * triangle.radius() * randomDirection(random);
      worst = std::max(worst,
                       std::abs(triangle.farAt(x).potential / triangle.exactAt(x).potential - 1.0));
    }
    return worst;
  };
  EXPECT_NEAR(std::log2(error(4.0) / error(8.0)), 5.0,
              0.3);  // 0.3: the sixth-order term at 4 radii
}

TEST(RankineIntegrals, StayFiniteOnEdgesCornersAndDegenerateEdges) {
  Corners q = oddPanels()[0];
  for (std::size_t i = 0; i < 4; ++i) {
    for (const double t : {0.0, 0.25, 0.5, -0.5, 1.5}) {
      const RankineIntegrals r = rankineIntegrals(q[i] + t * (q[(i + 1) % 4] - q[i]), q);
      EXPECT_TRUE(std::isfinite(r.potential) && r.gradient.allFinite());
      EXPECT_EQ(r.doubleLayer, 0.0);
      EXPECT_GT(r.potential, 0.0);
    }
  }
  const Vec3 x(4, 0, -1);
  for (std::size_t i = 0; i < 4; ++i) {  // a repeated corner makes the quadrilateral a triangle
    Corners triangle = q, repeated = q;
    triangle.erase(triangle.begin() + static_cast<long>(i));
    repeated[i] = repeated[(i + 1) % 4];
    const RankineIntegrals a = rankineIntegrals(x, triangle), b = rankineIntegrals(x, repeated);
    EXPECT_NEAR(a.potential, b.potential, 1e-14);
    EXPECT_NEAR((a.gradient - b.gradient).norm(), 0.0, 1e-14);
  }
}

TEST(RankineIntegrals, ScaleWithThePanelFarFromTheOrigin) {
  Corners q = oddPanels()[0], big = q;
  for (Vec3& c : big) c *= 1e6;
  const Vec3 x(4, 0, -1);
  EXPECT_NEAR(rankineIntegrals(1e6 * x, big).potential / rankineIntegrals(x, q).potential, 1e6,
              1e-6);
}

TEST(RankineIntegrals, RefusePanelsWithoutArea) {
  const auto faultOf = [](const Corners& c) {
    try {
      RankinePanel panel(c);
    } catch (const HydroError& e) {
      return e.fault();
    }
    return Fault::FileNotReadable;  // anything that is not expected below
  };
  EXPECT_EQ(faultOf({{0, 0, 0}, {1, 0, 0}}), Fault::BadArgument);
  EXPECT_EQ(faultOf({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}), Fault::ValueOutOfRange);
  EXPECT_EQ(faultOf({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}), Fault::ValueOutOfRange);
  EXPECT_EQ(faultOf({{0, 0, 0}, {1, 0, 0}, {0, std::nan(""), 0}}), Fault::ValueOutOfRange);
}

}  // namespace
}  // namespace cutwater
