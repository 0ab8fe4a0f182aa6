#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "hydro/geometry/MeshIntegrals.h"
#include "hydro/geometry/SurfaceTree.h"
#include "hydro/geometry/panelling/PanelQuality.h"
#include "hydro/geometry/panelling/SectionPanels.h"
#include "hydro/geometry/shapes/ShapeGrid.h"
#include "hydro/geometry/shapes/Shapes.h"
#include "hydro/geometry/shapes/Spacing.h"
#include "tests/support/Hulls.h"
#include "tests/support/Meshes.h"

namespace cutwater {
namespace {

/// Panels on every strand of a wet surface, stations across it, vertices shared.
SurfaceMesh strandPanels(const SurfaceMesh& wet, const PanelSize& size) {
  std::vector<double> x;
  for (const Vec3& p : wet.vertices) x.push_back(p.x());
  const SectionCutter cutter(wet, x);
  SurfaceMesh all;
  for (const SectionStrand& strand : sectionStrands(cutter, 0.25 * size.girthwise))
    all = joined(all, panelsOn(strand, cutter, size));
  return welded(all, 1e-3 * size.girthwise);
}

/// Open edges lie on calm water, or of a port half on the centreplane, to round-off of sections.
void expectOpenOnPlanesOnly(const SurfaceMesh& mesh, bool half) {
  for (const OpenEdge& e : openEdges(mesh)) {
    const Vec3 &a = mesh.vertices[static_cast<std::size_t>(e.from)],
               &b = mesh.vertices[static_cast<std::size_t>(e.to)];
    const bool onWater = std::max(std::abs(a.z()), std::abs(b.z())) < 1e-9;
    const bool onCentreplane = std::max(std::abs(a.y()), std::abs(b.y())) < 1e-9;
    EXPECT_TRUE(onWater || (half && onCentreplane)) << a.transpose() << ", " << b.transpose();
  }
}

// Knuckles stay, and both ends are divided: the panels are the box.
TEST(SectionPanelsClosedForm, ABoxIsCoveredExactly) {
  for (const double girthwise : {0.6, 1.1, 2.0})
    for (const double crowding : {0.05, 0.3}) {
      const PanelSize size{girthwise, 1.6 * girthwise, crowding, 0.1};
      const SurfaceMesh half = wetBox({30, 8, 3, 1}, 6, 2, 3);
      for (const bool whole : {false, true}) {
        const SurfaceMesh panels = strandPanels(whole ? bothHalves(half) : half, size);
        const double sides = whole ? 2 : 1;
        // Turns of straight chords are the root of round-off, 1e-8, and move corners by as much.
        EXPECT_NEAR(volumeIntegrals(panels).volume, sides * 360, 1e-5);
        EXPECT_NEAR(surfaceArea(panels), sides * (30 * 4 + 30 * 3 + 2 * 4 * 3), 1e-5);
        expectOpenOnPlanesOnly(panels, !whole);
        EXPECT_LT(std::abs(test::vectorAreaOf(panels).x()), 1e-6);
      }
    }
}

TEST(SectionPanels, TheNumberOfPanelsIsTheAreaByTheirSize) {
  const SurfaceMesh box = wetBox({60, 16, 4, 1}, 12, 4, 2);
  for (const double girthwise : {0.7, 1.0, 1.7}) {
    const PanelSize size{girthwise, 1.5 * girthwise, 0.05, 0.1, 0.0};
    const double due = surfaceArea(box) / (size.girthwise * size.lengthwise);
    // Ends are divided in squares, and parts come in whole numbers.
    EXPECT_NEAR(static_cast<double>(strandPanels(box, size).faces.size()) / due, 1.0, 0.15);
  }
}

// Inscribed panels: a surface of radius R lacks about (h/R)²/6 of its volume at an edge h.
TEST(SectionPanelsConvergence, AHemisphereIsApproachedAtSecondOrder) {
  const SurfaceMesh ball = wetHemisphere(10.0, 120, 60);
  const double volume = volumeIntegrals(ball).volume;
  const auto lacking = [&](double h) {
    const SurfaceMesh panels = strandPanels(ball, {h, 1.2 * h, 0.05, 0.1});
    expectOpenOnPlanesOnly(panels, true);
    return 1 - volumeIntegrals(panels).volume / volume;
  };
  const double coarse = lacking(2.0), fine = lacking(1.0);
  EXPECT_GT(fine, 0.0);
  EXPECT_NEAR(std::log2(coarse / fine), 2.0, 0.4);  // rows come in whole numbers
}

TEST(SectionPanelsIdentity, CornersLieOnTheSurface) {
  const SurfaceMesh hulls[] = {wetHemisphere(10.0, 60, 30), wetHalfEllipsoid({20, 3, 4}, 60, 20),
                               bothHalves(wetHalfEllipsoid({20, 3, 4}, 60, 20))};
  for (const SurfaceMesh& wet : hulls) {
    const SurfaceTree tree(wet);
    const SurfaceMesh panels = strandPanels(wet, {1.0, 1.6, 0.2, 0.1});
    ASSERT_GT(panels.faces.size(), 50u);
    for (const Vec3& p : panels.vertices)
      EXPECT_LT(tree.distance(p), 1e-9) << p.transpose();  // round-off of 20 m
  }
}

TEST(SectionPanels, ASectionThatShrinksToNothingEndsInOnePoint) {
  const SurfaceMesh panels = strandPanels(wetHemisphere(10.0, 60, 30), {1.5, 2.0, 0.1, 0.1});
  for (const double end : {-10.0, 10.0}) {
    int there = 0;
    for (const Vec3& p : panels.vertices) there += std::abs(p.x() - end) < 1e-6 ? 1 : 0;
    EXPECT_EQ(there, 1);
  }
  int triangles = 0;
  for (const Face& f : panels.faces) triangles += f.size() == 3 ? 1 : 0;
  EXPECT_GE(triangles, 2);
}

// A sunk spindle whose ends are loops of 0.2 m radius, 1.25 m round: 0.6 of a panel edge of 2.1 m.
TEST(SectionPanels, ASmallLoopEndsInOnePointToo) {
  const SurfaceMesh spindle = gridSurface(uniform(40), uniform(24), [](double u, double v) -> Vec3 {
    const double r = 0.2 + 2 * std::sin(kPi * u), angle = 2 * kPi * v;
    return {20 * u, 3 + r * std::cos(angle), -5 + r * std::sin(angle)};
  });
  const auto atEnd = [&](double girthwise) {
    int there = 0;
    for (const Vec3& p : strandPanels(spindle, {girthwise, 2.4, 0.1, 0.1}).vertices)
      there += p.x() > 19.999 ? 1 : 0;
    return there;
  };
  EXPECT_EQ(atEnd(2.2), 1);
  EXPECT_GE(atEnd(1.9), 3);  // a loop needs corners
}

TEST(SectionPanelsIdentity, ASunkBodyIsClosed) {
  const SurfaceMesh ball = test::moved(closedSphere(5.0, 48, 24), {0, 0, -8});
  const SurfaceMesh panels = strandPanels(ball, {0.8, 1.0, 0.1, 0.1});
  EXPECT_TRUE(openEdges(panels).empty());
  EXPECT_LT(test::vectorAreaOf(panels).norm(), 1e-9);  // round-off
  EXPECT_NEAR(volumeIntegrals(panels).volume / volumeIntegrals(ball).volume, 1.0, 0.03);
}

TEST(SectionPanelsIdentity, AHullAlikeForeAndAftHasItsPanelsSo) {
  for (const SurfaceMesh& wet : {wetBox({30, 8, 3, 1}, 6, 2, 3), wetHemisphere(10.0, 60, 30)}) {
    const SurfaceMesh panels = strandPanels(wet, {1.0, 1.5, 0.1, 0.1});
    // As many panels and as much volume on either side of midships, to the place of corners.
    EXPECT_NEAR(volumeIntegrals(panels).moment.x() / volumeIntegrals(panels).volume, 0.0, 1e-3);
    int fore = 0, aft = 0;
    for (const Face& f : panels.faces) {
      double x = 0.0;
      for (int i = 0; i < f.size(); ++i) x += panels.corner(f, i).x() / f.size();
      fore += x > 1e-6 ? 1 : 0;
      aft += x < -1e-6 ? 1 : 0;
    }
    EXPECT_EQ(fore, aft);
  }
}

// Twice as large in every direction, with panels twice as large: the same panels.
TEST(SectionPanelsIdentity, PanelsGrowWithTheHull) {
  const SurfaceMesh small = wetHalfEllipsoid({20, 3, 4}, 60, 20);
  SurfaceMesh large = small;
  for (Vec3& p : large.vertices) p *= 2.0;  // a power of two: exact
  SurfaceMesh panels = strandPanels(small, {1.0, 1.6, 0.2, 0.1});
  for (Vec3& p : panels.vertices) p *= 2.0;
  EXPECT_TRUE(test::sameFaces(panels, strandPanels(large, {2.0, 3.2, 0.2, 0.1})));
}

TEST(SectionPanels, RowsAreNarrowerAtCalmWater) {
  const SurfaceMesh wall = wetBox({30, 20, 10, 1}, 6, 2, 3);
  const auto uppermost = [&](double crowding) {
    double highest = -1e300;
    for (const Vec3& p : strandPanels(wall, {1.0, 1.6, crowding, 0.1}).vertices)
      if (p.z() < -1e-9) highest = std::max(highest, p.z());
    return -highest;
  };
  EXPECT_NEAR(uppermost(0.0), 1.0, 0.05);
  EXPECT_NEAR(uppermost(0.5), 0.5, 0.05);  // 1 − c of the mean
}

}  // namespace
}  // namespace cutwater
