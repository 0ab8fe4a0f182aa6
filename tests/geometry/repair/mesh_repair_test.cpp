#include <gtest/gtest.h>

#include "hydro/Errors.h"
#include "hydro/geometry/MeshIntegrals.h"
#include "hydro/geometry/panelling/Panelling.h"
#include "hydro/geometry/repair/MeshRepair.h"
#include "hydro/geometry/shapes/Shapes.h"
#include "tests/support/Hulls.h"

namespace cutwater {
namespace {

const std::vector<Vec3> kLeaks{{20, 5, -3}, {-30, -6, -2}, {0, 2, -4.9}};

/// 20 000 triangles.
SurfaceMesh frigateSoup() { return test::unwelded(closedFrigate(100, 20)); }

double wetVolume(const Hull& hull) { return volumeIntegrals(wholeWetSurface(hull)).volume; }

bool said(const RepairedHull& repaired, const std::string& words) {
  for (const std::string& line : repaired.done)
    if (line.find(words) != std::string::npos) return true;
  return false;
}

/// Repairs, and wants the sound hull again: its volume to 0.05 % (a filled hole of 1.6 m lies some
/// centimetres inside, a slit of 0.1 m at the keel adds half a cubic metre to 4500), both sides,
/// panels.
RepairedHull expectSound(const SurfaceMesh& spoilt) {
  RepairedHull repaired = repairedHull(spoilt, "spoilt.obj", Symmetry::Auto);
  const double sound = wetVolume(makeHull(closedFrigate(100, 20), "sound", Symmetry::Auto));
  EXPECT_NEAR(wetVolume(repaired.hull) / sound, 1.0, 5e-4);
  EXPECT_TRUE(repaired.hull.symmetric);
  const SurfaceMesh panels = panelled(repaired.hull, 224, "spoilt.obj");
  // 224 panels lack 1.2 % (panelling_test), whatever was repaired.
  EXPECT_NEAR(2 * volumeIntegrals(panels).volume / sound, 1 - 0.011, 2e-3);
  return repaired;
}

std::string refusal(const SurfaceMesh& mesh, Fault fault) {
  try {
    repairedHull(mesh, "hull.obj", Symmetry::Auto);
  } catch (const HydroError& error) {
    EXPECT_EQ(error.fault(), fault);
    EXPECT_EQ(std::string(error.what()).rfind("hull.obj: ", 0), 0u);
    return error.what();
  }
  ADD_FAILURE() << "not refused";
  return {};
}

TEST(MeshRepair, NothingIsSaidOfASoundHull) {
  const RepairedHull repaired = expectSound(closedFrigate(100, 20));
  EXPECT_TRUE(repaired.done.empty());
  EXPECT_TRUE(repaired.hull.closed);
}

TEST(MeshRepair, UnweldedVerticesAreMerged) {
  EXPECT_TRUE(expectSound(frigateSoup()).done.empty());  // equal ones: every format splits vertices
  EXPECT_TRUE(said(expectSound(test::shaken(frigateSoup(), 3e-4)), "merged"));
}

TEST(MeshRepair, FacesAreTurnedOutwards) {
  EXPECT_TRUE(said(expectSound(test::turnedAtRandom(frigateSoup())), "turned"));
  EXPECT_TRUE(said(expectSound(turnedOver(frigateSoup())), "turned"));
}

TEST(MeshRepair, DoublesAndFacesWithoutAreaGo) {
  const RepairedHull repaired = expectSound(test::withDoubles(frigateSoup()));
  EXPECT_TRUE(said(repaired, "double faces"));
  EXPECT_TRUE(said(repaired, "without area"));
}

TEST(MeshRepair, DecksBulkheadsAndTanksAreLeftOut) {
  const RepairedHull repaired = expectSound(test::withInterior(frigateSoup()));
  EXPECT_TRUE(said(repaired, "6 pieces inside the hull"));  // deck, four bulkheads, tank
}

TEST(MeshRepair, ABulkheadWeldedToTheShellIsLeftOut) {
  SurfaceMesh hull = closedFrigate(100, 20);
  std::vector<int> section;
  const double station = hull.vertices[50u * 21u].x();
  for (int i = 0; i < static_cast<int>(hull.vertices.size()); ++i) {
    const Vec3& p = hull.vertices[static_cast<std::size_t>(i)];
    if (std::abs(p.x() - station) < 1e-9 && p.z() <= 0) section.push_back(i);
  }
  std::sort(section.begin(), section.end(), [&](int a, int b) {
    const Vec3 &p = hull.vertices[static_cast<std::size_t>(a)],
               &q = hull.vertices[static_cast<std::size_t>(b)];
    return std::atan2(p.y(), 0.1 - p.z()) < std::atan2(q.y(), 0.1 - q.z());
  });
  ASSERT_GT(section.size(), 30u);
  for (std::size_t i = 1; i + 1 < section.size(); ++i)
    hull.faces.push_back({{section[0], section[i], section[i + 1], -1}});
  EXPECT_TRUE(said(expectSound(hull), "inside the hull"));
}

TEST(MeshRepair, SmallHolesAreClosed) {
  const RepairedHull repaired = expectSound(test::withHoles(frigateSoup(), kLeaks, 1.3));
  EXPECT_TRUE(said(repaired, "closed 3 holes"));
}

TEST(MeshRepair, AKeelThatDoesNotMeetIsClosed) {
  EXPECT_TRUE(said(expectSound(test::openAtKeel(frigateSoup(), 0.05)), "keel line"));
  const RepairedHull half = expectSound(test::openAtKeel(test::portHalf(frigateSoup()), 0.05));
  EXPECT_TRUE(said(half, "mirrored"));
  EXPECT_TRUE(said(half, "keel line"));
}

TEST(MeshRepair, AHalfHullIsMirrored) {
  EXPECT_TRUE(said(expectSound(test::portHalf(frigateSoup())), "mirrored"));
  EXPECT_TRUE(said(expectSound(mirroredInY(test::portHalf(frigateSoup()))), "mirrored"));
}

TEST(MeshRepair, PlatesOfNoThicknessAreLeftOut) {
  SurfaceMesh hull = frigateSoup();
  for (const double side : {1.0, -1.0}) {
    const int first = static_cast<int>(hull.vertices.size());
    for (const Vec3& p :
         {Vec3(-10, 6.3, -4.2), Vec3(10, 6.3, -4.2), Vec3(10, 7, -4.9), Vec3(-10, 7, -4.9)})
      hull.vertices.emplace_back(p.x(), side * p.y(), p.z());
    hull.faces.push_back({{first, first + 1, first + 2, first + 3}});
  }
  EXPECT_TRUE(said(expectSound(hull), "2 pieces of plates"));
}

TEST(MeshRepair, AnOpenTopIsNoFault) {
  SurfaceMesh hull = frigateSoup();
  std::erase_if(hull.faces, [&](const Face& f) {
    return std::max({hull.corner(f, 0).z(), hull.corner(f, 1).z(), hull.corner(f, 2).z()}) > 3.0;
  });
  const RepairedHull repaired = expectSound(hull);
  EXPECT_TRUE(repaired.done.empty());
  EXPECT_FALSE(repaired.hull.closed);
}

// A game's visual mesh: 100 000 triangles with everything at once.
TEST(MeshRepair, AVisualMeshWithEveryFaultIsAHull) {
  SurfaceMesh mesh = test::unwelded(closedFrigate(258, 38));
  EXPECT_GT(mesh.faces.size(), 100'000u);
  mesh = test::openAtKeel(test::withHoles(mesh, kLeaks, 0.9), 0.05);
  mesh = test::turnedAtRandom(test::withDoubles(test::withInterior(mesh)));
  const RepairedHull repaired = repairedHull(mesh, "visual.obj", Symmetry::Auto);
  for (const char* words :
       {"double faces", "without area", "inside the hull", "turned", "closed 3 holes", "keel line"})
    EXPECT_TRUE(said(repaired, words)) << words;
  // Inscribed: 4509 m³ of the formula less 0.04 %; slit and holes as above.
  EXPECT_NEAR(wetVolume(repaired.hull), 4507.5, 2.5);
  EXPECT_TRUE(repaired.hull.symmetric);
}

TEST(MeshRepair, AWideHoleIsRefusedWithItsPlace) {
  const std::string what =
      refusal(test::withHoles(frigateSoup(), {{0, 2, -4.9}}, 4.0), Fault::HullNotClosed);
  EXPECT_NE(what.find(" m wide below water"), std::string::npos) << what;
  EXPECT_NE(what.find("at ("), std::string::npos) << what;
}

// A bulb pushed through the bow: an ellipsoid whose volume outside the hull is known from its
// parts.
TEST(MeshRepair, ShellsThatPassThroughOneAnotherAreJoined) {
  SurfaceMesh bulb = closedSphere(1.3, 40, 20);
  for (Vec3& p : bulb.vertices) p = {61.0 + 4.0 * p.x(), p.y(), p.z() - 2.8};
  const RepairedHull repaired =
      repairedHull(joined(frigateSoup(), bulb), "bulb.obj", Symmetry::Auto);
  EXPECT_TRUE(said(repaired, "joined shells that pass through one another"));
  EXPECT_TRUE(repaired.hull.symmetric);
  const double frigate = wetVolume(makeHull(closedFrigate(100, 20), "frigate", Symmetry::Auto));
  const double whole = volumeIntegrals(bulb).volume;
  // Points of the ellipsoid that are not in the hull, by the hull's formula on a fine grid: 29.8 m³
  // of 36.8; the coarse ellipsoid lacks 1 %, and the hull's own polyhedron 0.1 m³ there.
  EXPECT_NEAR(wetVolume(repaired.hull) - frigate, 29.8 / 36.8 * whole, 0.3);
  const SurfaceMesh panels = panelled(repaired.hull, 433, "bulb.obj");
  EXPECT_NEAR(2 * volumeIntegrals(panels).volume / wetVolume(repaired.hull), 1.0, 0.01);
}

TEST(MeshRepair, ATankAgainstTheShellIsLeftOut) {
  const SurfaceMesh tank = test::moved(closedBox({10, 14.2, 1, 1}, 2, 2, 1), {0, 0, -3});
  const RepairedHull repaired =
      repairedHull(joined(frigateSoup(), tank), "tank.obj", Symmetry::Auto);
  const double frigate = wetVolume(makeHull(closedFrigate(100, 20), "frigate", Symmetry::Auto));
  EXPECT_GT(wetVolume(repaired.hull), frigate);  // its edges come out of the bilge
  EXPECT_LT(wetVolume(repaired.hull), 1.01 * frigate);
}

TEST(MeshRepair, AMeshOutOfTheWaterIsRefused) {
  refusal(test::moved(frigateSoup(), {0, 0, 10}), Fault::HullNotInWater);
  refusal(test::moved(frigateSoup(), {0, 0, -20}), Fault::HullNotInWater);
  refusal({}, Fault::MeshEmpty);
}

TEST(MeshRepair, SymmetryIsFoundFromTheSurface) {
  // Twice as finely divided on one side: no vertex has its image, the surface has (2 mm of
  // sagitta).
  const SurfaceMesh coarse = test::portHalf(closedFrigate(200, 40));
  const SurfaceMesh fine = mirroredInY(test::portHalf(closedFrigate(400, 80)));
  const SurfaceMesh both = joined(coarse, fine);
  SurfaceMesh heeled = closedFrigate(100, 20);
  const Eigen::AngleAxisd heel(0.05, Vec3::UnitX());
  for (Vec3& p : heeled.vertices) p = heel * p;
  EXPECT_FALSE(repairedHull(heeled, "heeled.obj", Symmetry::Auto).hull.symmetric);
  EXPECT_FALSE(repairedHull(frigateSoup(), "none.obj", Symmetry::None).hull.symmetric);
  EXPECT_TRUE(repairedHull(both, "both.obj", Symmetry::Auto).hull.symmetric);
}

}  // namespace
}  // namespace cutwater
