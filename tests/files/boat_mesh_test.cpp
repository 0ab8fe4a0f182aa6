// The boat of meshes/boat is a visual model: its hull is found among its parts.
#include <gtest/gtest.h>

#include "hydro/Errors.h"
#include "hydro/files/MeshIO.h"
#include "hydro/geometry/SurfaceMesh.h"
#include "tests/support/Refusal.h"

namespace cutwater {
namespace {

const std::string kBoat = std::string(CUTWATER_MESHES) + "/boat/boat.glb";
const MeshReadOptions kAxes{.up = "y", .forward = "z"};

TEST(BoatMesh, HullIsClosedAndSymmetricAndOnlyTheRudderBladeIsLeftOut) {
  const RepairedHull boat = readRepaired(kBoat, kAxes);
  EXPECT_TRUE(boat.hull.symmetric);
  EXPECT_TRUE(boat.hull.closed);
  ASSERT_EQ(boat.done.size(), 1u);
  EXPECT_NE(boat.done[0].find("plates that the water touches on both sides"), std::string::npos);
}

TEST(BoatMesh, WetSurfaceReachesFromTransomToStemAndDownToTheKeel) {
  const RepairedHull boat = readRepaired(kBoat, kAxes);
  const Bounds wet = bounds(wetSurface(boat.hull));
  EXPECT_NEAR(wet.low.x(), -6.0, 1e-6);
  EXPECT_NEAR(wet.high.x(), 5.3, 1e-6);
  EXPECT_NEAR(wet.low.z(), -0.88, 1e-6);
}

// Taken as it is, the model is no hull: the blade is open all round.
TEST(BoatMesh, AsItIsIsRefusedForItsRudderBlade) {
  test::expectRefusal(Fault::HullNotClosed, {"boat.glb"}, [] { readHull(kBoat, kAxes); });
}

}  // namespace
}  // namespace cutwater
