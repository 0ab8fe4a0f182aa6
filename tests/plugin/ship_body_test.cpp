// What a ship is to Bullet: shape, mass, inertia, axes.
#include <gtest/gtest.h>

#include <cmath>

#include "hydro/Errors.h"
#include "hydro/geometry/shapes/Shapes.h"
#include "plugin/ShipAxes.h"
#include "plugin/ShipBody.h"
#include "tests/plugin/TestWorld.h"

namespace cutwater::test {
namespace {

ShipParticulars ellipsoid() {
  ShipParticulars ship;
  ship.hull = closedHalfEllipsoid({50.0, 6.0, 4.0}, 3.0, 60, 16);
  ship.mass = 2e6;
  ship.cog = Vec3(-1.0, 0.0, 0.5);
  ship.gyradii = Vec3(4.0, 25.0, 26.0);
  return ship;
}

// Farthest point of a shape along a direction, without Bullet's margin.
double reach(const btConvexHullShape& shape, const btVector3& direction) {
  return static_cast<double>(shape.localGetSupportingVertexWithoutMargin(direction).dot(direction));
}

TEST(ShipBody, TheConvexHullKeepsTheEndsOfASlenderShip) {
  const ShipParticulars ship = ellipsoid();
  const auto shape = convexHull(ship, WorldFrame{});
  const auto& hull = dynamic_cast<const btConvexHullShape&>(*shape);
  EXPECT_LE(hull.getNumPoints(), 124);
  // Vertices themselves, in axes about G.
  EXPECT_NEAR(reach(hull, btVector3(1, 0, 0)), 51.0, 1e-5);
  EXPECT_NEAR(reach(hull, btVector3(-1, 0, 0)), 49.0, 1e-5);
  EXPECT_NEAR(reach(hull, btVector3(0, 0, -1)), 4.5, 1e-5);
  EXPECT_NEAR(reach(hull, btVector3(0, 0, 1)), 2.5, 1e-5);
}

TEST(ShipBody, MassAndInertiaAreThoseOfTheLoadingInTheWorldsUnits) {
  const ShipParticulars ship = ellipsoid();
  btSphereShape shape(1);
  const WorldFrame tonnesYUp{.up = WorldFrame::Up::Y, .kilogramsPerUnit = 1000.0};
  const btRigidBody made(bodyInfo(ship, tonnesYUp, shape));
  const btRigidBody* body = &made;
  EXPECT_NEAR(1.0 / static_cast<double>(body->getInvMass()), 2000.0, 1e-3);
  // World y is up: yaw's inertia is about y, pitch's about z.
  const btVector3 inverse = body->getInvInertiaDiagLocal();
  const double inertia[3] = {16.0 * 2000, 676.0 * 2000, 625.0 * 2000};
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(1.0 / static_cast<double>(inverse[i]), inertia[i], 1e-6 * inertia[i]);
  }
}

TEST(ShipBody, AShapeInHullAxesIsMovedToG) {
  const ShipParticulars ship = ellipsoid();
  btSphereShape sphere(1);
  const auto moved = aboutG(sphere, ship, WorldFrame{});
  const auto& compound = dynamic_cast<const btCompoundShape&>(*moved);
  const Vec3 origin = fromBullet(compound.getChildTransform(0).getOrigin());
  EXPECT_LT((origin + ship.cog).norm(), 1e-6);
}

TEST(ShipBody, ShipsWithoutMassGyradiusOrHullAreRefused) {
  btSphereShape shape(1);
  ShipParticulars ship = ellipsoid();
  ship.mass = 0.0;
  EXPECT_THROW(bodyInfo(ship, WorldFrame{}, shape), HydroError);
  ship = ellipsoid();
  ship.gyradii[1] = -1.0;
  EXPECT_THROW(bodyInfo(ship, WorldFrame{}, shape), HydroError);
  ship.hull = {};
  EXPECT_THROW(convexHull(ship, WorldFrame{}), HydroError);
}

TEST(ShipAxesClosedForm, ForcesAndMomentsTurnByTheirOwnRotations) {
  Vec6 load;
  load << 1.0, 0.0, 2.0, 0.0, 3.0, 4.0;
  const Vec6 turned = rotated(rotationZ(kPi / 2), rotationZ(kPi), load);
  Vec6 expected;
  expected << 0.0, 1.0, 2.0, 0.0, -3.0, 4.0;
  EXPECT_LT((turned - expected).norm(), 1e-15);
}

}  // namespace
}  // namespace cutwater::test
