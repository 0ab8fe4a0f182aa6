#include <gtest/gtest.h>

#include <cmath>

#include "hydro/bem/matrices/RankineMatrices.h"
#include "tests/bem/Bodies.h"

// Integrals of 1/R and 1/R₁ of all pairs.
namespace cutwater::test {
namespace {

InfluenceSettings asSources(bool xDerivative = false) {
  return {.formulation = Formulation::Source, .xDerivative = xDerivative};
}

/// A closed box, its top at this depth: flat panels without gaps.
PanelMesh sunkenBox(double depth) {
  SurfaceMesh box = closedBox({4.0, 2.0, 1.0, 1.0}, 6, 2, 2);
  for (Vec3& x : box.vertices) x.z() -= 1.0 + depth;
  return makePanels(box, false);
}

PanelMesh halfBoat(bool lid) { return panels(wetHalfEllipsoid({10.0, 3.0, 2.0}, 8, 4), true, lid); }

// Gauss: seen from a panel of a closed surface the others fill half the sphere, −2π (its own part
// is 0), and the body's image in the surface, which it is outside of, nothing. Exact integrals:
// round-off of 100 solid angles.
TEST(RankineMatricesClosedForm, SolidAnglesOfAClosedBody) {
  for (const double depth : {0.2, 30.0}) {
    const PanelPairs pairs(sunkenBox(depth), {});
    const RankineMatrices rankine(pairs);
    const RankineParts& parts = rankine.parts(Parity::Even);
    const Eigen::VectorXd image = parts.imageNormal.rowwise().sum();
    const Eigen::VectorXd direct = (parts.rigidNormal - parts.imageNormal).rowwise().sum();
    for (int i = 0; i < pairs.all(); ++i) {
      // The far form's promise, 1e-6 of a gradient, on up to 100 panels of 0.01 sr each.
      EXPECT_NEAR(direct[i], -2.0 * kPi, 1e-6) << i;
      EXPECT_NEAR(image[i], 0.0, 1e-6) << i;
      EXPECT_EQ((parts.rigidNormal - parts.imageNormal)(i, i), 0.0) << i;
    }
  }
}

// Deep down the image is far: a sum over the panels is that of a body of the same area at its
// centre, to (size/distance)².
TEST(RankineMatricesClosedForm, ImageOfADeepBodyIsOneSource) {
  const double depth = 200.0;
  const PanelPairs pairs(sunkenBox(depth), {});
  const RankineMatrices rankine(pairs);
  double area = 0.0;
  for (int i = 0; i < pairs.all(); ++i) area += pairs.panel(i).area;
  const double mean = rankine.parts(Parity::Even).image.rowwise().sum().mean();
  const double expected = area / (2.0 * (depth + 1.0));
  EXPECT_NEAR(mean, expected, 1e-4 * expected);  // (2 m/400 m)²
}

// [M03] (57)-(60): the half hull's matrices are sum and difference of two blocks of the whole
// hull's. The same integrals at mirrored points: round-off; the far form may be taken on one side
// only where it is as good.
TEST(RankineMatricesIdentity, ParitiesAreSumAndDifferenceOfTheWholeHullsBlocks) {
  for (const InfluenceSettings& settings : {InfluenceSettings{}, asSources(true)}) {
    const PanelMesh port = halfBoat(false);
    const PanelPairs halfPairs(port, settings), wholePairs(bothSides(port), settings);
    const RankineMatrices half(halfPairs), whole(wholePairs);
    const int n = halfPairs.all();
    const auto compare = [&](const Eigen::MatrixXd RankineParts::*what, double sideOfField) {
      const Eigen::MatrixXd& all = whole.parts(Parity::Even).*what;
      const Eigen::MatrixXd pp = all.topLeftCorner(n, n), sp = all.bottomLeftCorner(n, n);
      for (const Parity parity : {Parity::Even, Parity::Odd}) {
        const double odd = sideOfField * (parity == Parity::Even ? 1.0 : -1.0);
        EXPECT_LT((half.parts(parity).*what - pp - odd * sp).cwiseAbs().maxCoeff(),
                  1e-11 * (1.0 + all.cwiseAbs().maxCoeff()));
      }
    };
    compare(&RankineParts::rigid, 1.0);
    compare(&RankineParts::image, 1.0);
    compare(&RankineParts::rigidNormal, 1.0);
    compare(&RankineParts::imageNormal, 1.0);
    if (!settings.xDerivative) continue;
    compare(&RankineParts::rigidX, 1.0);
    compare(&RankineParts::imageX, 1.0);
  }
}

// imageOf takes the two sides apart again.
TEST(RankineMatricesIdentity, ImageOfAPairIsThatOfTheWholeHull) {
  const PanelMesh port = halfBoat(false);
  const PanelPairs halfPairs(port, asSources(true)), wholePairs(bothSides(port), asSources(true));
  const RankineMatrices half(halfPairs), whole(wholePairs);
  const int n = halfPairs.all();
  for (const auto& [i, j] : {std::pair{0, 0}, {5, 20}, {31, 2}, {16, 17}})
    for (const bool mirrored : {false, true}) {
      const auto one = half.imageOf({i, j, mirrored});
      const auto other = whole.imageOf({mirrored ? n + i : i, j, false});
      EXPECT_NEAR(one.potential, other.potential, 1e-11);  // round-off, as above
      EXPECT_NEAR(one.normal, other.normal, 1e-11);
      EXPECT_NEAR(one.x, other.x, 1e-11);
    }
}

// ∫∫ 1/R over two panels does not ask which is the source. Exact over one, four Gauss points over
// the other: distant panels agree to (size/distance)⁴/100, neighbours less well.
TEST(RankineMatricesIdentity, PotentialsOfFarPairsAreReciprocal) {
  const PanelPairs pairs(sunkenBox(0.5), {.galerkinPoints = 9});
  const RankineMatrices rankine(pairs);
  const Eigen::MatrixXd& rigid = rankine.parts(Parity::Even).rigid;
  for (int i = 0; i < pairs.all(); ++i)
    for (int j = 0; j < i; ++j) {
      const double there = pairs.panel(i).area * rigid(i, j),
                   back = pairs.panel(j).area * rigid(j, i);
      const double apart = (pairs.panel(i).centroid - pairs.panel(j).centroid).norm();
      const bool isFar = apart > 2.0 * std::max(pairs.size(i), pairs.size(j));
      EXPECT_NEAR(there, back, (isFar ? 1e-5 : 0.05) * there) << i << ' ' << j;
    }
}

// Both formulations take the same integrals, along the normal of one panel or the other:
// transposes, weighed with the areas, to the same quadrature.
TEST(RankineMatricesIdentity, NormalDerivativesOfBothFormulationsAreTransposes) {
  const PanelMesh mesh = sunkenBox(0.5);
  const PanelPairs green(mesh, {.galerkinPoints = 9}),
      sources(mesh, {.formulation = Formulation::Source, .galerkinPoints = 9});
  const RankineMatrices ofGreen(green), ofSources(sources);
  for (int i = 0; i < green.all(); ++i)
    for (int j = 0; j < green.all(); ++j) {
      const double apart = (green.panel(i).centroid - green.panel(j).centroid).norm();
      if (apart < 2.0 * std::max(green.size(i), green.size(j))) continue;
      const double one = green.panel(i).area * ofGreen.parts(Parity::Even).rigidNormal(i, j),
                   other = green.panel(j).area * ofSources.parts(Parity::Even).rigidNormal(j, i);
      EXPECT_NEAR(one, other, 2e-5 * green.panel(i).area * green.panel(j).area) << i << ' ' << j;
    }
}

// ∂/∂x of the potential of one panel, from the potentials of a hull moved by ±h: central
// differences leave h².
TEST(RankineMatricesConvergence, XDerivativeIsThatOfThePotential) {
  const auto potentials = [](double shift) {
    PanelMesh mesh;
    mesh.panels = {
        flatPanel({{0, 0, -3}, {1, 0, -3}, {1, 1, -2.5}, {0, 1, -2.5}}),
        flatPanel(
            {{3 + shift, 0, -2}, {4 + shift, 0, -2}, {4 + shift, 1, -2}, {3 + shift, 1, -2}})};
    const PanelPairs pairs(std::move(mesh), asSources(true));
    return RankineMatrices(pairs).parts(Parity::Even);
  };
  constexpr double h = 1e-3;
  const RankineParts middle = potentials(0.0), after = potentials(h), before = potentials(-h);
  EXPECT_NEAR(middle.rigidX(1, 0), (after.rigid(1, 0) - before.rigid(1, 0)) / (2.0 * h), 1e-6);
  EXPECT_NEAR(middle.imageX(1, 0), (after.image(1, 0) - before.image(1, 0)) / (2.0 * h), 1e-6);
  EXPECT_LT(middle.rigidX(1, 0), 0.0);
  const PanelPairs without(halfBoat(false), asSources());
  EXPECT_EQ(RankineMatrices(without).parts(Parity::Odd).rigidX.size(), 0);
}

// Far apart the four points of a field panel are taken together, by the far form, which promises
// 2e-7 of the potential and 1e-6 of its gradient: against the exact form, point by point.
TEST(RankineMatricesIdentity, FarPairsAreTheExactFormPointByPoint) {
  PanelMesh mesh;
  mesh.symmetric = true;
  mesh.panels = {flatPanel({{0, 2, -3}, {1, 2, -3}, {1, 3, -2.5}, {0, 3, -2.5}}),
                 flatPanel({{40, 1, -1}, {41, 1.2, -1}, {41, 1.2, -2}, {40, 1, -2}})};
  for (const InfluenceSettings& settings : {InfluenceSettings{}, asSources(true)}) {
    const PanelPairs pairs(mesh, settings);
    const RankineMatrices rankine(pairs);
    const Panel &field = pairs.panel(1), &source = pairs.panel(0);
    const RankinePanel exact(std::span(source.corner.data(), 4));
    RankineMatrices::Sample sums[2][2];  // [mirrored][image]
    for (const bool mirrored : {false, true})
      for (const bool image : {false, true}) {
        RankineMatrices::Sample& sum = sums[mirrored ? 1 : 0][image ? 1 : 0];
        const auto seen = [&](const Vec3& x) {
          return image ? imageInZ(imageInY(x, mirrored)) : imageInY(x, mirrored);
        };
        for (const QuadraturePoint& at : pairs.galerkin(1)) {
          const RankineIntegrals one = exact.exactAt(seen(at.x));
          const double weight = at.weight / field.area;
          sum.potential += weight * one.potential;
          sum.normal +=
              weight * (pairs.isSource() ? seen(field.normal).dot(one.gradient) : one.doubleLayer);
          sum.x += weight * one.gradient.x();
        }
      }
    for (const Parity parity : {Parity::Even, Parity::Odd}) {
      const RankineParts& parts = rankine.parts(parity);
      const double odd = parity == Parity::Even ? 1.0 : -1.0;
      const auto expect = [&](const Eigen::MatrixXd& rigid, const Eigen::MatrixXd& images,
                              double RankineMatrices::Sample::*what, double promise) {
        const double image = sums[0][1].*what + odd * sums[1][1].*what;
        EXPECT_NEAR(images(1, 0), image, promise);
        EXPECT_NEAR(rigid(1, 0), image + sums[0][0].*what + odd * sums[1][0].*what, promise);
      };
      const double size = source.area / 40.0, slope = size / 40.0;  // of one of the four
      expect(parts.rigid, parts.image, &RankineMatrices::Sample::potential, 4.0 * 2e-7 * size);
      expect(parts.rigidNormal, parts.imageNormal, &RankineMatrices::Sample::normal,
             4.0 * 1e-6 * slope);
      if (!settings.xDerivative) continue;
      expect(parts.rigidX, parts.imageX, &RankineMatrices::Sample::x, 4.0 * 1e-6 * slope);
    }
  }
}

// Every near pair is listed once, in order, and knows where it stands seen the other way.
TEST(RankineMatricesIdentity, NearPairsAreAllThereAndKnowTheirOpposites) {
  const PanelPairs pairs(halfBoat(true), {});
  const RankineMatrices rankine(pairs);
  for (int source = 0; source < pairs.all(); ++source) {
    std::size_t at = 0;
    for (const bool mirrored : {false, true}) {
      std::size_t inThirds = 0;
      const int third = pairs.all() / 3;
      for (const auto& [from, to] :
           {std::pair{0, third}, {third, 2 * third}, {2 * third, pairs.all()}}) {
        for (const NearPair& pair : rankine.near(source, mirrored, from, to)) {
          EXPECT_GE(pair.pair.field, from);
          EXPECT_LT(pair.pair.field, to);
          ++inThirds;
        }
      }
      for (int field = 0; field < pairs.all(); ++field) {
        if (!pairs.isNear({field, source, mirrored})) continue;
        --inThirds;
        ASSERT_LT(at, rankine.near(source).size());
        const NearPair& near = rankine.near(source)[at++];
        EXPECT_EQ(near.pair.field, field);
        EXPECT_EQ(near.pair.source, source);
        EXPECT_EQ(near.pair.mirrored, mirrored);
        const Pair& back = rankine.near(field)[near.opposite].pair;
        EXPECT_EQ(back.field, source);
        EXPECT_EQ(back.source, field);
        EXPECT_EQ(back.mirrored, mirrored);
      }
      EXPECT_EQ(inThirds, 0u);
    }
    EXPECT_EQ(at, rankine.near(source).size());
  }
}

TEST(RankineMatricesIdentity, SameBitsWhateverTheNumberOfThreads) {
  const PanelMesh mesh = halfBoat(true);
  const PanelPairs one(mesh, {.threads = 1}), three(mesh, {.threads = 3});
  const RankineMatrices a(one), b(three);
  for (const Parity parity : {Parity::Even, Parity::Odd}) {
    EXPECT_EQ(a.parts(parity).rigid, b.parts(parity).rigid);
    EXPECT_EQ(a.parts(parity).imageNormal, b.parts(parity).imageNormal);
  }
  EXPECT_EQ(a.near(7).front().image.log, b.near(7).front().image.log);
}

}  // namespace
}  // namespace cutwater::test
