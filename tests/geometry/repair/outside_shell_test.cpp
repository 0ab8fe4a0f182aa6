#include <gtest/gtest.h>

#include <algorithm>

#include "hydro/geometry/MeshIntegrals.h"
#include "hydro/geometry/PlaceText.h"
#include "hydro/geometry/repair/OutsideShell.h"
#include "tests/support/Hulls.h"
#include "tests/support/Meshes.h"
#include "tests/support/Refusal.h"

namespace cutwater {
namespace {

/// 6 × 4 × 3 m, open on calm water: 72 m³.
SurfaceMesh shellBarge() {
  return test::openOnWater(test::cubes(test::cells({-3, -2, -3}, {3, 2, 0})));
}

bool saidOfShell(const OutsideShell& shell, const std::string& words) {
  return std::any_of(shell.done.begin(), shell.done.end(), [&](const std::string& line) {
    return line.find(words) != std::string::npos;
  });
}

/// Closed below water, normals out, and this volume. The tolerance is round-off, or where shells
/// were split the distance at which corners are made one, 1e-6 of the size, times the surface.
void expectShell(const OutsideShell& shell, double volume, double tolerance = 1e-12) {
  EXPECT_EQ(test::openEdgesBelowWater(shell.mesh), 0);
  EXPECT_NEAR(volumeIntegrals(shell.mesh).volume, volume, tolerance * volume);
}

TEST(OutsideShellIdentity, ASoundShellStaysAsItIs) {
  const SurfaceMesh barge = shellBarge();
  const OutsideShell shell = outsideShell(barge, "barge");
  EXPECT_TRUE(shell.done.empty());
  EXPECT_TRUE(test::sameFaces(shell.mesh, barge));
}

TEST(OutsideShell, FacesAreTurnedTowardsTheWater) {
  const SurfaceMesh barge = shellBarge();
  const OutsideShell turned = outsideShell(turnedOver(barge), "barge");
  EXPECT_TRUE(saidOfShell(turned, "turned 84 faces outwards"));  // 24 + 2 × 18 + 2 × 12
  expectShell(turned, 72);
  expectShell(outsideShell(test::turnedAtRandom(barge), "barge"), 72);
  expectShell(outsideShell(test::shuffled(test::turnedAtRandom(barge)), "barge"), 72);
}

TEST(OutsideShell, InnerShellsAreLeftOut) {
  const SurfaceMesh tanks = joined(test::cubes({{0, 0, -2}}), test::cubes({{-2, 0, -2}}));
  const OutsideShell shell = outsideShell(joined(shellBarge(), tanks), "barge");
  EXPECT_TRUE(saidOfShell(shell, "left out 12 faces in 2 pieces inside the hull"));
  EXPECT_FALSE(saidOfShell(shell, "turned"));
  expectShell(shell, 72);
}

TEST(OutsideShell, PlatesAreLeftOut) {
  SurfaceMesh plate{{{-1, 3, -4}, {1, 3, -4}, {1, 3, -2}, {-1, 3, -2}}, {{{0, 1, 2, 3}}}};
  const OutsideShell shell =
      outsideShell(joined(shellBarge(), joined(plate, mirroredInY(plate))), "barge");
  EXPECT_TRUE(saidOfShell(shell, "left out 2 faces in 2 pieces of plates"));
  expectShell(shell, 72);
}

// A box stuck through the bottom: 2 × 2 m, 1.15 m of it below.
TEST(OutsideShellClosedForm, ShellsThatPassThroughOneAnotherHaveTheVolumeOfTheirUnion) {
  SurfaceMesh box = test::cubes(test::cells({0, 0, 0}, {2, 2, 2}));
  for (Vec3& p : box.vertices) p += Vec3(-0.85, -0.85, -4.15);  // no edge in a plane of the barge
  for (const SurfaceMesh& both :
       {joined(shellBarge(), box), joined(box, shellBarge()), joined(shellBarge(), turnedOver(box)),
        test::shuffled(joined(shellBarge(), box))}) {
    const OutsideShell shell = outsideShell(both, "barge");
    EXPECT_TRUE(saidOfShell(shell, "joined shells that pass through one another"));
    expectShell(shell, 72 + 4 * 1.15, 1e-5);
    EXPECT_NEAR(surfaceArea(shell.mesh), 24 + 60 + 8 * 1.15,
                1e-4);  // bottom, sides, the box's sides
  }
}

TEST(OutsideShell, ASurfaceWithoutAnInsideIsRefused) {
  const SurfaceMesh plate{{{-1, 0, -4}, {1, 0, -4}, {1, 0, -2}, {-1, 0, -2}}, {{{0, 1, 2, 3}}}};
  test::expectRefusal(
      Fault::HullNotClosed,
      {"plate.obj: no face below water has an inside", "the hull is open, at (-1, 0, -4)"},
      [&] { outsideShell(plate, "plate.obj"); });
}

// A chamber that only a shaft of 1 m² leads to: most of its walls see no water; nothing crosses.
TEST(OutsideShell, AShellThatHidesItselfIsRefused) {
  std::vector<std::array<int, 3>> body = test::cells({0, 0, -9}, {9, 9, 0});
  std::erase_if(body, [](const std::array<int, 3>& c) {
    const bool chamber = c[0] > 0 && c[0] < 8 && c[1] > 0 && c[1] < 8 && c[2] > -4 && c[2] < -1;
    return chamber || (c[0] == 4 && c[1] == 4 && c[2] <= -4);
  });
  const SurfaceMesh hull = test::openOnWater(test::cubes(body));
  test::expectRefusal(Fault::HullPartHidden,
                      {"hull.obj: ", " % of a shell is hidden from the water by another",
                       "first at (", "give the outer surface alone"},
                      [&] { outsideShell(hull, "hull.obj"); });
}

// Four faces from calm water to one point: rays from their inner sides go up to the waterplane and
// meet the face that they left.
TEST(OutsideShell, AShallowHullOfFewFacesIsNoPlate) {
  const SurfaceMesh raft{{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {0, 0, -0.1}},
                         {{{0, 4, 1, -1}}, {{1, 4, 2, -1}}, {{2, 4, 3, -1}}, {{3, 4, 0, -1}}}};
  const OutsideShell shell = outsideShell(raft, "raft");
  EXPECT_TRUE(shell.done.empty());
  expectShell(shell, 0.4 / 3);
}

TEST(OutsideShell, ThingsAreCountedInPlainEnglish) {
  EXPECT_EQ(counted(1, "face"), "1 face");
  EXPECT_EQ(counted(0, "face"), "0 faces");
  EXPECT_EQ(counted(2, "vertex", "vertices"), "2 vertices");
  EXPECT_EQ(counted(1, "vertex", "vertices"), "1 vertex");
}

}  // namespace
}  // namespace cutwater
