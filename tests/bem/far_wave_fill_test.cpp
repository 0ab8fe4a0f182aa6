#include <gtest/gtest.h>

#include "hydro/bem/matrices/FarWave.h"
#include "tests/bem/Bodies.h"

// Which entry goes where: blocks, mirror images, lid and both formulations. The size of an entry
// against brute force is in far_wave_test.cpp.
namespace cutwater::test {
namespace {

using FarSystems = FarWave::Systems;

/// All that FarWave fills, of all panels.
FarSystems filled(const PanelMesh& mesh, const InfluenceSettings& settings, double K,
                  double lidShare = 0.75) {
  const PanelPairs pairs(mesh, settings);
  const RankineMatrices rankine(pairs);
  const int n = pairs.hull(), all = pairs.all();
  FarSystems systems;
  for (int p = 0; p < pairs.parities(); ++p) {
    InfluenceSystem<Complex>& system = systems[static_cast<std::size_t>(p)];
    system.L.resize(all, all);
    system.R.resize(pairs.isSource() ? n : all, pairs.isSource() ? all : n);
    if (settings.xDerivative) system.H.resize(n, all);
  }
  FarWave(pairs, rankine).fill({K, lidShare, all}, systems);
  return systems;
}

InfluenceSettings sourceSettings() {
  return {.formulation = Formulation::Source, .xDerivative = true};
}

/// 40 panels, two and a half blocks, and a lid of less than one.
PanelMesh portBoat(bool lid) {
  return panels(wetHalfEllipsoid({10.0, 3.0, 2.0}, 10, 4), true, lid);
}

double largest(const Eigen::MatrixXcd& m) { return m.cwiseAbs().maxCoeff(); }

// In blocks of 16 or not: the panels in another order give the same entries in that order. Form
// factors of the two directions and sums in another order leave round-off; the image's share is
// taken by whole blocks and is exact to 1e-4 either way.
TEST(FarWaveIdentity, OrderOfThePanelsDoesNotMatter) {
  const PanelMesh mesh = portBoat(false);
  PanelMesh turned = mesh;
  const int n = static_cast<int>(mesh.panels.size());
  Eigen::PermutationMatrix<Eigen::Dynamic> order(n);
  for (int i = 0; i < n; ++i) {
    order.indices()[i] = (7 * i + 3) % n;  // 7 and 40 have no common factor
    turned.panels[static_cast<std::size_t>(order.indices()[i])] =
        mesh.panels[static_cast<std::size_t>(i)];
  }
  for (const InfluenceSettings& settings : {InfluenceSettings{}, sourceSettings()}) {
    const FarSystems before = filled(mesh, settings, 0.8), after = filled(turned, settings, 0.8);
    for (std::size_t p = 0; p < 2; ++p) {
      const auto same = [&order](const Eigen::MatrixXcd& a, const Eigen::MatrixXcd& b) {
        const Eigen::MatrixXcd back = order.transpose() * b * order;
        EXPECT_LT(largest(back - a), 1e-4 * largest(a));
      };
      same(before[p].L, after[p].L);
      same(before[p].R, after[p].R);
      if (settings.xDerivative) same(before[p].H, after[p].H);
    }
  }
}

// Equations at centroids: an entry depends on the extent of its source panel alone, so that in
// reverse order, where every pair of blocks is met the other way round, it is the same. Within the
// error of one evaluation a pair.
TEST(FarWaveIdentity, CentroidsSeeTheExtentOfTheSource) {
  const PanelMesh mesh = portBoat(true);
  PanelMesh turned = mesh;
  std::reverse(turned.panels.begin(), turned.panels.end());
  const int n = static_cast<int>(mesh.panels.size());
  for (const bool source : {false, true}) {
    InfluenceSettings settings;
    settings.formulation = source ? Formulation::Source : Formulation::Potential;
    settings.galerkinPoints = 1;
    const double K = 1.5;
    const FarSystems before = filled(mesh, settings, K), after = filled(turned, settings, K);
    for (std::size_t p = 0; p < 2; ++p) {
      const Eigen::MatrixXcd back = after[p].L.topLeftCorner(n, n).reverse();
      EXPECT_LT(largest(back - before[p].L.topLeftCorner(n, n)), 1e-4 * largest(before[p].L));
      // Rows and columns of the lid, whose panels are larger than the hull's.
      const Eigen::MatrixXcd columns = after[p].L.topRightCorner(n, after[p].L.cols() - n);
      EXPECT_LT(
          largest(columns.colwise().reverse() - before[p].L.topRightCorner(n, columns.cols())),
          1e-4 * largest(columns));
    }
  }
}

// [M03] (57)-(60): even and odd are sum and difference of two blocks of the whole hull's matrix.
TEST(FarWaveIdentity, ParitiesAreSumAndDifferenceOfTheWholeHullsBlocks) {
  const PanelMesh port = portBoat(false);
  const int n = static_cast<int>(port.panels.size());
  for (const InfluenceSettings& settings : {InfluenceSettings{}, sourceSettings()})
    for (const double K : {0.1, 0.8}) {
      const FarSystems half = filled(port, settings, K);
      const InfluenceSystem<Complex> whole = filled(bothSides(port), settings, K)[0];
      for (const double odd : {1.0, -1.0}) {
        const InfluenceSystem<Complex>& system = half[odd > 0.0 ? 0 : 1];
        const auto same = [&](const Eigen::MatrixXcd& a, const Eigen::MatrixXcd& b) {
          const Eigen::MatrixXcd sum = b.topLeftCorner(n, n) + odd * b.bottomLeftCorner(n, n);
          EXPECT_LT(largest(a - sum), 1e-4 * largest(sum)) << K;  // images by blocks, as above
        };
        same(system.L, whole.L);
        same(system.R, whole.R);
        if (settings.xDerivative) same(system.H, whole.H);
      }
    }
}

// One evaluation of the wave term serves both ways: without the Rankine part R is symmetric when
// weighed with the areas, and the two formulations' L are transposes of each other, to round-off.
// Far enough apart that no image is taken by its exact integral.
TEST(FarWaveIdentity, WavePartsAreReciprocalAndTransposes) {
  PanelMesh mesh;
  for (int i = 0; i < 20; ++i) {
    const Vec3 c(3.0 * i, 2.0 + (i % 3), -9.0 - 0.2 * i);
    mesh.panels.push_back(
        flatPanel({c, c + Vec3(1, 0.2, 0), c + Vec3(1, 0.3, 1), c + Vec3(0, 0.1, 1)}));
  }
  for (const bool symmetric : {false, true})
    for (const double K : {0.05, 0.3}) {
      mesh.symmetric = symmetric;
      const PanelPairs green(mesh, {}), sources(mesh, sourceSettings());
      const RankineMatrices ofGreen(green), ofSources(sources);
      const FarSystems a = filled(mesh, {}, K), b = filled(mesh, sourceSettings(), K);
      for (int p = 0; p < green.parities(); ++p) {
        const auto parity = static_cast<Parity>(p);
        const auto at = static_cast<std::size_t>(p);
        Eigen::VectorXcd area(20);
        for (int i = 0; i < 20; ++i) area[i] = green.panel(i).area;
        const auto weighed = [&](const Eigen::MatrixXcd& m, const Eigen::MatrixXd& rigid) {
          return Eigen::MatrixXcd(area.asDiagonal() * (m - kG * rigid.cast<Complex>()));
        };
        const Eigen::MatrixXcd R = weighed(a[at].R, ofGreen.parts(parity).rigid);
        EXPECT_GT(largest(R), 1e-6);
        EXPECT_LT(largest(R - R.transpose()), 1e-12 * largest(R)) << K;
        const Eigen::MatrixXcd L = weighed(a[at].L, ofGreen.parts(parity).rigidNormal),
                               ofSource = weighed(b[at].L, ofSources.parts(parity).rigidNormal);
        EXPECT_LT(largest(L - ofSource.transpose()), 1e-12 * largest(L)) << K;
      }
    }
}

// Pairs that are near get their Rankine part and no wave at all: that is NearWave's.
TEST(FarWaveIdentity, NearPairsAreLeftWithoutWaves) {
  const PanelMesh mesh = portBoat(false);
  const PanelPairs pairs(mesh, {});
  const RankineMatrices rankine(pairs);
  const FarSystems systems = filled(mesh, {}, 0.8);
  int found = 0;
  for (int i = 0; i < pairs.all(); ++i)
    for (int j = 0; j < pairs.all(); ++j) {
      if (!pairs.isNear({i, j, false}) || !pairs.isNear({i, j, true})) continue;
      ++found;
      for (const Parity parity : {Parity::Even, Parity::Odd}) {
        const InfluenceSystem<Complex>& system = systems[static_cast<std::size_t>(parity)];
        const Complex rigid = kG * rankine.parts(parity).rigidNormal(i, j);
        EXPECT_LT(std::abs(system.L(i, j) - rigid), 1e-15 + 1e-13 * std::abs(rigid));
      }
    }
  EXPECT_GT(found, 0);
}

// The lid's rows carry its share as a factor, the hull's rows none; columns of the lid are
// potentials times K, of the hull derivatives.
TEST(FarWaveIdentity, LidRowsCarryTheirShare) {
  const PanelMesh mesh = portBoat(true);
  const int n = static_cast<int>(mesh.panels.size()), m = static_cast<int>(mesh.lid.size());
  ASSERT_GT(m, 0);
  const FarSystems whole = filled(mesh, {}, 0.8, 1.0), part = filled(mesh, {}, 0.8, 0.25);
  for (std::size_t p = 0; p < 2; ++p) {
    EXPECT_EQ(part[p].L.topRows(n), whole[p].L.topRows(n));
    // Powers of two: exact.
    EXPECT_EQ(part[p].L.bottomRows(m), 0.25 * whole[p].L.bottomRows(m));
    EXPECT_EQ(part[p].R.bottomRows(m), 0.25 * whole[p].R.bottomRows(m));
    // The hull does not notice the lid's rows and columns.
    const FarSystems hullOnly = filled(portBoat(false), {}, 0.8);
    EXPECT_LT(largest(whole[p].L.topLeftCorner(n, n) - hullOnly[p].L),
              1e-14 * largest(hullOnly[p].L));
  }
}

}  // namespace
}  // namespace cutwater::test
