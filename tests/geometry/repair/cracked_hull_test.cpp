#include <gtest/gtest.h>

#include "hydro/geometry/MeshIntegrals.h"
#include "hydro/geometry/repair/CrackedHull.h"
#include "tests/support/Meshes.h"
#include "tests/support/Refusal.h"

namespace cutwater {
namespace {

/// 8 x 4 x 2 m and 1 m above water, of squares of 1 m but for one side, which is one face.
SurfaceMesh boxWithHangingNodes() {
  SurfaceMesh box = test::cubes(test::cells({0, -2, -2}, {8, 2, 1}));
  std::erase_if(box.faces, [&](const Face& f) { return meanCorner(box, f).x() == 8.0; });
  const int first = static_cast<int>(box.vertices.size());
  for (const Vec3& p : {Vec3(8, -2, -2), Vec3(8, 2, -2), Vec3(8, 2, 1), Vec3(8, -2, 1)})
    box.vertices.push_back(p);
  box.faces.push_back({{first, first + 1, first + 2, first + 3}});
  return box;
}

TEST(CrackedHullClosedForm, HangingNodesAreTakenAndThreeVolumesProveIt) {
  const SurfaceMesh box = boxWithHangingNodes();
  test::expectRefusal(Fault::HullNotClosed, {"box"}, [&] { makeHull(box, "box", Symmetry::Auto); });
  const CrackedHull made = crackedHull(box, "box", Symmetry::Auto);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(made.volumes[i], 64.0, 1e-9);  // round-off
  EXPECT_TRUE(made.hull.symmetric);
  EXPECT_TRUE(made.hull.closed);
  EXPECT_GT(made.looseEdges, 4);
  // The faces stay those that were drawn: 8 x 2 of the bottom, 8 x 2 of the port side, 2 x 2 of one
  // end, and the other end in one face.
  EXPECT_EQ(made.panels.faces.size(), 16u + 16u + 4u + 1u);
  EXPECT_NEAR(volumeIntegrals(made.hull.surface).volume, 96.0, 1e-9);
}

TEST(CrackedHullIdentity, TurnedOverAsAWholeItIsTheSame) {
  const CrackedHull made = crackedHull(turnedOver(boxWithHangingNodes()), "box", Symmetry::Auto);
  EXPECT_NEAR(made.volumes.x(), 64.0, 1e-9);
  EXPECT_NEAR(volumeIntegrals(made.panels).volume, 32.0, 1e-9);
}

TEST(CrackedHullClosedForm, GapsBelowAThousandthOfTheLengthAreTaken) {
  SurfaceMesh box = boxWithHangingNodes();
  for (std::size_t i = box.vertices.size() - 4; i < box.vertices.size(); ++i)
    box.vertices[i].x() += 0.006;  // of 8 m; the volume by x is of the face moved
  const CrackedHull made = crackedHull(box, "box", Symmetry::Auto);
  EXPECT_NEAR(made.tolerance, 0.008006, 1e-9);
  EXPECT_NEAR(made.volumes.y(), 64.0, 1e-9);
  EXPECT_NEAR(made.volumes.x(), 64.0 + 0.006 * 8, 1e-9);
}

TEST(CrackedHull, AMissingPanelIsRefused) {
  SurfaceMesh box = boxWithHangingNodes();
  std::erase_if(box.faces, [&](const Face& f) {
    return (meanCorner(box, f) - Vec3(2.5, 0.5, -2)).norm() < 1e-9;
  });
  test::expectRefusal(Fault::HullNotClosed, {"box"},
                      [&] { crackedHull(box, "box", Symmetry::Auto); });
}

}  // namespace
}  // namespace cutwater
