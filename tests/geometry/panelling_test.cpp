#include "hydro/geometry/Panelling.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "hydro/Errors.h"
#include "hydro/geometry/HullShells.h"
#include "hydro/geometry/Lid.h"
#include "hydro/geometry/MeshIntegrals.h"
#include "hydro/geometry/PanelMesh.h"
#include "hydro/geometry/Shapes.h"
#include "hydro/geometry/SurfaceTree.h"
#include "tests/support/Hulls.h"
#include "tests/support/Results.h"

namespace cutwater {
namespace {

double stretchedShare(const SurfaceMesh& panels) {
  const auto stretched = std::count_if(panels.faces.begin(), panels.faces.end(),
                                       [&](const Face& f) { return aspectRatio(panels, f) > 3.0; });
  return static_cast<double>(stretched) / static_cast<double>(panels.faces.size());
}

const std::vector<test::TestHull>& hulls() {
  static const std::vector<test::TestHull> all = test::testHulls();
  return all;
}

// The acceptance lines: 0.5 % of V and S at 1040 panels, 95 % of the panels within 3, at every count.
TEST(PanellingVerification, PanelsHaveTheVolumeAndAreaOfTheHull) {
  for (const test::TestHull& t : hulls()) {
    const SurfaceMesh wet = wetSurface(t.hull);
    const double volume = volumeIntegrals(wet).volume, area = surfaceArea(wet);
    for (const int count : {224, 433, 1040}) {
      const SurfaceMesh panels = panelled(t.hull, count, t.name);
      const double v = volumeIntegrals(panels).volume / volume - 1,
                   s = surfaceArea(panels) / area - 1;
      const double stretched = stretchedShare(panels);
      // Inscribed panels lack volume by the square of their size: 1.3 % is 0.3 % at 1040.
      EXPECT_LT(std::abs(v), count == 1040 ? 5e-3 : 1.3e-2) << t.name << " " << count;
      EXPECT_LT(std::abs(s), count == 1040 ? 5e-3 : 1.3e-2) << t.name << " " << count;
      EXPECT_LE(stretched, 0.05) << t.name << " " << count;
      // Rows and stations are whole numbers.
      EXPECT_NEAR(static_cast<double>(panels.faces.size()) / count, 1.0, 0.06) << t.name;
      const std::string about = fmt::format("{}, {} panels a side", t.name, panels.faces.size());
      if (count == 1040) {
        test::recordResult("Panelling", about + ": V relative error", "fine mesh", v, "± 0.005");
        test::recordResult("Panelling", about + ": S relative error", "fine mesh", s, "± 0.005");
      }
      test::recordResult("Panelling", about + ": share above aspect 3", "-", stretched, "≤ 0.05");
    }
  }
}

TEST(PanellingConvergence, VolumeApproachesTheHullsAtSecondOrder) {
  const Hull& frigate = hulls()[0].hull;
  const double volume = volumeIntegrals(wetSurface(frigate)).volume;
  const auto missing = [&](int count) {
    return 1 - volumeIntegrals(panelled(frigate, count, "frigate")).volume / volume;
  };
  // Error ~ 1/panels; rows come in whole numbers, so the ratio of 4 is met to a quarter.
  EXPECT_NEAR(missing(800) / missing(3200), 4.0, 1.0);
}

TEST(PanellingIdentity, PanelsAreWatertightAndEndOnCalmWater) {
  for (const test::TestHull& t : hulls()) {
    const SurfaceMesh panels = panelled(t.hull, 300, t.name);
    for (const OpenEdge& e : openEdges(panels)) {
      const Vec3 &p = panels.vertices[static_cast<std::size_t>(e.from)],
                 &q = panels.vertices[static_cast<std::size_t>(e.to)];
      EXPECT_TRUE((p.z() == 0 && q.z() == 0) || (p.y() == 0 && q.y() == 0))
          << t.name << " " << placeText(p);
    }
    const PanelMesh flat = makePanels(panels, true);
    double lid = 0.0;
    for (const Panel& panel : makeLid(panels, true)) lid += panel.area;
    // To a fraction of one panel, see Lid.h.
    EXPECT_NEAR(lid / waterplaneIntegrals(panels).area, 1.0, 0.01) << t.name;
    EXPECT_EQ(flat.panels.size(), panels.faces.size());
  }
}

TEST(PanellingIdentity, CornersLieOnTheHull) {
  for (const test::TestHull& t : hulls()) {
    const SurfaceMesh wet = wetSurface(t.hull), panels = panelled(t.hull, 433, t.name);
    const SurfaceTree tree(wet);
    double farthest = 0.0;
    std::size_t off = 0;
    for (const Vec3& p : panels.vertices) {
      const double distance = tree.distance(p);
      farthest = std::max(farthest, distance);
      off += distance > 1e-9 ? 1 : 0;
    }
    // Only at a stem narrower than a tenth of a panel edge (3 m at most) do corners leave the surface.
    EXPECT_LT(farthest, 0.15) << t.name;
    EXPECT_LE(off, panels.vertices.size() / 50) << t.name;
  }
}

TEST(PanellingIdentity, AForeAndAftSymmetricHullHasAsManyPanelsFore) {
  const Hull box = makeHull(closedBox({60, 16, 4, 4}, 6, 2, 1), "barge", Symmetry::Auto);
  const SurfaceMesh panels = panelled(box, 433, "barge");
  Vec3 sum = Vec3::Zero();
  for (const Face& f : panels.faces) sum += vectorArea(panels, f);
  EXPECT_NEAR(sum.x(), 0.0, 1e-9);
  EXPECT_NEAR(volumeIntegrals(panels).moment.x(), 0.0, 1e-6);
}

TEST(Panelling, KnucklesStay) {
  // Chine and keel of the barge: its volume and area are those of the box to round-off.
  const Hull box = makeHull(closedBox({60, 16, 4, 4}, 6, 2, 1), "barge", Symmetry::Auto);
  const SurfaceMesh panels = panelled(box, 433, "barge");
  EXPECT_NEAR(2 * volumeIntegrals(panels).volume, 60.0 * 16 * 4, 1e-6);
  EXPECT_NEAR(2 * surfaceArea(panels), 60.0 * 16 + 2 * 60 * 4 + 2 * 16 * 4, 1e-6);
}

TEST(Panelling, LeaningAndRoughEndsAreFlatEnds) {
  for (const double trim : {0.1, 2.0, 5.0}) {
    SurfaceMesh box = closedBox({60, 16, 4, 4}, 12, 4, 2);
    const Eigen::AngleAxisd turn(trim * kPi / 180, Vec3::UnitY());
    for (Vec3& p : box.vertices) p = turn * p;
    const Hull hull = makeHull(test::shaken(box, 1e-4), "barge", Symmetry::None);
    const SurfaceMesh wet = wetSurface(hull), panels = panelled(hull, 400, "barge");
    // All faces are flat: what is left is the shaking, 1e-4 m of 4 m.
    EXPECT_NEAR(volumeIntegrals(panels).volume / volumeIntegrals(wet).volume, 1.0, 1e-4) << trim;
    EXPECT_NEAR(surfaceArea(panels) / surfaceArea(wet), 1.0, 1e-4) << trim;
    EXPECT_LE(stretchedShare(panels), 0.05) << trim;
  }
}

TEST(Panelling, AHullWithoutSymmetryHasTwiceAsMany) {
  const Hull whole = makeHull(closedFrigate(200, 30), "frigate", Symmetry::None);
  const SurfaceMesh panels = panelled(whole, 224, "frigate");
  EXPECT_NEAR(static_cast<double>(panels.faces.size()) / 448, 1.0, 0.06);
  EXPECT_LE(stretchedShare(panels), 0.05);
}

TEST(Panelling, ThreeHullsHaveSectionsOfTheirOwn) {
  const SurfaceMesh middle = closedWigley({60, 6, 3, 1}, 2, 100, 20);
  const SurfaceMesh outrigger = closedWigley({30, 2, 1.5, 1}, 2, 60, 12);
  const SurfaceMesh all = joined(
      middle, joined(test::moved(outrigger, {-5, 9, 0}), test::moved(outrigger, {-5, -9, 0})));
  const Hull hull = makeHull(all, "trimaran", Symmetry::Auto);
  const SurfaceMesh panels = panelled(hull, 1040, "trimaran");
  // The outrigger has a fifth of the panels on its two sides: 1.2 % of its volume is missing.
  EXPECT_NEAR(volumeIntegrals(panels).volume / volumeIntegrals(wetSurface(hull)).volume, 1.0,
              0.012);
  EXPECT_LE(stretchedShare(panels), 0.05);
}

TEST(Panelling, ACountOutOfRangeIsRefused) {
  for (const int count : {-1, 0, kFewestPanels - 1, kMostPanels + 1}) {
    try {
      panelled(hulls()[2].hull, count, "barge.obj");
      ADD_FAILURE() << count;
    } catch (const HydroError& error) {
      EXPECT_EQ(error.fault(), Fault::ValueOutOfRange);
      EXPECT_NE(std::string(error.what()).find("barge.obj: panels = " + std::to_string(count)),
                std::string::npos);
    }
  }
}

TEST(PanellingClosedForm, AspectRatioOfSimpleShapes) {
  const SurfaceMesh shapes{{{0, 0, 0},
                            {3, 0, 0},
                            {3, 1, 0},
                            {0, 1, 0},
                            {0.5, 0, 0},
                            {-0.5, 0, 0},
                            {0, 0, std::sqrt(0.75)}},
                           {{{0, 1, 2, 3}}, {{4, 5, 6, -1}}}};
  EXPECT_NEAR(aspectRatio(shapes, shapes.faces[0]), 3.0, 1e-12);
  EXPECT_NEAR(aspectRatio(shapes, shapes.faces[1]), 1.0,
              1e-7);  // root of a difference of round-off
}

}  // namespace
}  // namespace cutwater
