#include "hydro/geometry/panelling/Panelling.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "hydro/Errors.h"
#include "hydro/geometry/MeshIntegrals.h"
#include "hydro/geometry/PlaceText.h"
#include "hydro/geometry/SurfaceTree.h"
#include "hydro/geometry/panelling/FlatPolygon.h"
#include "hydro/geometry/panelling/PanelQuality.h"
#include "hydro/geometry/panels/Lid.h"
#include "hydro/geometry/panels/PanelMesh.h"
#include "hydro/geometry/shapes/Shapes.h"
#include "tests/support/Hulls.h"
#include "tests/support/Results.h"

namespace cutwater {
namespace {

/// Heel on the waterline, starboard down, and trim, bow down.
SurfaceMesh turned(SurfaceMesh mesh, double heelDeg, double trimDeg) {
  const Mat3 turn = (Eigen::AngleAxisd(trimDeg * kPi / 180, Vec3::UnitY()) *
                     Eigen::AngleAxisd(heelDeg * kPi / 180, Vec3::UnitX()))
                        .toRotationMatrix();
  for (Vec3& p : mesh.vertices) p = turn * p;
  return mesh;
}

/// The acceptance lines; inscribed panels lack volume and area by the square of their size.
void expectGoodPanels(const Hull& hull, int count, const std::string& name) {
  SCOPED_TRACE(fmt::format("{} {}", name, count));
  const SurfaceMesh wet = wetSurface(hull), panels = panelled(hull, count, name);
  const double bound = 5e-3 * 1040 / count;
  const double v = volumeIntegrals(panels).volume / volumeIntegrals(wet).volume - 1,
               s = surfaceArea(panels) / surfaceArea(wet) - 1, stretched = stretchedShare(panels);
  const double aSide = static_cast<double>(panels.faces.size()) / (hull.symmetric ? 1 : 2);
  EXPECT_LT(std::abs(v), bound);
  EXPECT_LT(std::abs(s), bound);
  EXPECT_LE(stretched, 0.05);
  EXPECT_NEAR(aSide / count, 1.0, 0.06);
  const std::string about = fmt::format("{}, {:.0f} panels a side", name, aSide);
  test::recordResult("Panelling", about + ": V relative error", "fine mesh", v,
                     fmt::format("± {:.3f}", bound));
  test::recordResult("Panelling", about + ": share above aspect 3", "-", stretched, "≤ 0.05");
}

const std::vector<test::TestHull>& hulls() {
  static const std::vector<test::TestHull> all = test::testHulls();
  return all;
}

// The acceptance lines: 0.5 % of V and S at 1040 panels, 95 % of the panels within 3, at every
// count.
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

// Stations lean as the sphere does where its waterline ends: no section is closed below water.
TEST(PanellingVerification, ASphereMayBeSunkDeeperThanItsCentreOrLess) {
  for (const double sunk : {-8.0, 3.0, 6.0, 9.0})
    for (const int count : {224, 433, 1040}) {
      if (count > 224 && sunk != 3.0 && !test::fullSize()) continue;
      const Hull hull = makeHull(test::moved(closedSphere(10.0, 120, 60), {0, 0, -sunk}), "sphere",
                                 Symmetry::Auto);
      expectGoodPanels(hull, count, fmt::format("sphere, centre {} of R below water", sunk / 10));
    }
}

TEST(PanellingVerification, HeeledAndTrimmedHullsArePanelled) {
  struct Attitude {
    double heelDeg, trimDeg;
    int count;
  };
  std::vector<Attitude> all{{10, 0, 1040}, {12, -1, 433}, {20, 2, 224}};
  if (test::fullSize()) {
    all.clear();
    for (const double heel : {-10.0, 3.0, 5.0, 10.0, 12.0, 15.0, 20.0, 30.0})
      for (const double trim : {-1.0, 0.0, 2.0})
        for (const int count : {224, 433, 1040}) all.push_back({heel, trim, count});
  }
  const SurfaceMesh frigate = closedFrigate(400, 60);
  for (const Attitude& a : all)
    expectGoodPanels(makeHull(turned(frigate, a.heelDeg, a.trimDeg), "frigate", Symmetry::None),
                     a.count, fmt::format("frigate, heel {}°, trim {}°", a.heelDeg, a.trimDeg));
}

TEST(PanellingVerification, ABargeAndAWigleyHullMayHeelAndTrim) {
  const SurfaceMesh box = closedBox({60, 16, 4, 4}, 24, 8, 4);
  const SurfaceMesh sharp = closedWigley({60, 6, 3, 1}, 2, 100, 20);
  for (const double heel : {5.0, 20.0}) {
    expectGoodPanels(makeHull(turned(box, heel, 0), "barge", Symmetry::None), 300,
                     fmt::format("barge, heel {}°", heel));
    expectGoodPanels(makeHull(turned(sharp, heel, 2), "wigley", Symmetry::None), 300,
                     fmt::format("Wigley hull, heel {}°, trim 2°", heel));
  }
}

// Each side of a demi-hull has a quarter of a single hull's panels: rows are what it needs.
TEST(PanellingVerification, ACatamaranWithRoundBilgesHasItsVolume) {
  const SurfaceMesh one = closedWigley({60, 6, 3, 1}, 2, 100, 20);
  const SurfaceMesh both = joined(test::moved(one, {0, 10, 0}), test::moved(one, {0, -10, 0}));
  expectGoodPanels(makeHull(both, "catamaran", Symmetry::Auto), 1040, "Wigley catamaran");
}

TEST(PanellingConvergence, VolumeApproachesTheHullsAtSecondOrder) {
  const Hull frigate = test::testFrigate().hull;
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
    // Only at a stem narrower than a tenth of a panel edge (3 m at most) do corners leave the
    // surface.
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
  const Hull barge = test::testBarge().hull;
  for (const int count : {-1, 0, kFewestPanels - 1, kMostPanels + 1}) {
    try {
      panelled(barge, count, "barge.obj");
      ADD_FAILURE() << count;
    } catch (const HydroError& error) {
      EXPECT_EQ(error.fault(), Fault::ValueOutOfRange);
      EXPECT_NE(std::string(error.what()).find("barge.obj: panels = " + std::to_string(count)),
                std::string::npos);
    }
  }
}

TEST(PanellingClosedForm, AnOutlineWithANotchIsFilled) {
  // 6 × 6 m without a quarter, vertices 1 m apart, as a transom seen from aft.
  SurfaceMesh mesh;
  const auto line = [&](double y0, double z0, double y1, double z1) {
    const double length = std::abs(y1 - y0) + std::abs(z1 - z0);
    for (double s = 0.0; s < length - 0.5; s += 1.0)
      mesh.vertices.emplace_back(0.0, y0 + s / length * (y1 - y0), z0 + s / length * (z1 - z0));
  };
  line(3, 0, 3, -6);
  line(3, -6, 0, -6);
  line(0, -6, 0, -3);
  line(0, -3, -3, -3);
  line(-3, -3, -3, 0);
  line(-3, 0, 3, 0);
  std::vector<int> outline;
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) outline.push_back(static_cast<int>(v));
  addFlatPolygon(outline, 1.0, mesh);
  double area = 0.0;
  for (const Face& f : mesh.faces) {
    EXPECT_LT(vectorArea(mesh, f).x(), -0.2);
    EXPECT_LT(aspectRatio(mesh, f), 2.0);
    area -= vectorArea(mesh, f).x();
  }
  EXPECT_NEAR(area, 27.0, 1e-12);
  EXPECT_EQ(openEdges(mesh).size(), outline.size());
  EXPECT_NEAR(static_cast<double>(mesh.faces.size()), 27.0, 5.0);
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
