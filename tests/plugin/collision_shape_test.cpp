// What a ship collides with unless its user says otherwise: margin and deck.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "hydro/Errors.h"
#include "hydro/geometry/shapes/Shapes.h"
#include "plugin/ShipBody.h"
#include "tests/plugin/TestScene.h"

namespace cutwater::test {
namespace {

constexpr double kDeck = 6.0;  // [m] above calm water
const double kNan = std::nan("");

/// A box of 110 m and 14 m with its deck at kDeck, and on it a mast up to 30 m.
SurfaceMesh hullWithMast() {
  SurfaceMesh mast = closedBox({1.0, 1.0, 1.0, 30.0 - kDeck}, 1, 1, 1);
  for (Vec3& vertex : mast.vertices) vertex.z() += kDeck;
  return joined(closedBox({110.0, 14.0, 5.0, kDeck}, 10, 2, 2), mast);
}

Coefficients shipWithMast() {
  Coefficients c = slenderShip();
  c.ship.hull = hullWithMast();
  return c;
}

/// The ship as a model of 1 : scale, for its shape only.
ShipParticulars model(double scale) {
  ShipParticulars ship;
  ship.hull = closedBox({110.0, 14.0, 5.0, kDeck}, 10, 2, 2);
  for (Vec3& vertex : ship.hull.vertices) vertex /= scale;
  ship.cog = Vec3(0, 0, 1.0 / scale);
  return ship;
}

/// A body at rest that does not move.
struct Fixed {
  explicit Fixed(btCollisionShape& shape)
      : body(btRigidBody::btRigidBodyConstructionInfo(0, nullptr, &shape)) {}
  void place(const btVector3& at) {
    body.setWorldTransform(btTransform(btQuaternion::getIdentity(), at));
  }
  btRigidBody body;
};

bool touch(btCollisionWorld& world, btCollisionObject& a, btCollisionObject& b) {
  struct Found : btCollisionWorld::ContactResultCallback {
    bool any = false;
    btScalar addSingleResult(btManifoldPoint& point, const btCollisionObjectWrapper*, int, int,
                             const btCollisionObjectWrapper*, int, int) override {
      any = any || point.getDistance() <= 0;
      return 0;
    }
  } found;
  world.contactPairTest(&a, &b, found);
  return found.any;
}

/// Distance from the ship's side, in half beams, at which a wall touches it.
double gap(const ShipParticulars& ship, const WorldFrame& frame) {
  const double half = bounds(ship.hull).high.y() / frame.metresPerUnit;
  TestWorld world;
  const auto shape = convexHull(ship, frame);
  Fixed hull(*shape);
  btBoxShape wall(btVector3(btScalar(20 * half), btScalar(half), btScalar(20 * half)));
  wall.setMargin(btScalar(1e-4 * half));
  Fixed other(wall);
  double clear = 4.0, touching = 0.5;
  while (clear - touching > 1e-4) {
    const double middle = 0.5 * (clear + touching);
    other.place(btVector3(0, btScalar((middle + 1.0) * half), 0));
    (touch(world.world, hull.body, other.body) ? touching : clear) = middle;
  }
  return clear - 1.0;
}

// The margin is 1 % of the half beam or less: 2 % with what float and the wall's own margin add.
TEST(CollisionShapeClosedForm, AWallTouchesWithinTwoPercentOfTheHalfBeam) {
  for (const double scale : {1.0, 50.0, 200.0}) {
    for (const double metresPerUnit : {1.0, 0.01}) {
      const double found = gap(model(scale), {.metresPerUnit = metresPerUnit});
      EXPECT_LT(found, 0.02) << "1:" << scale << ", unit " << metresPerUnit << " m";
      EXPECT_GT(found, -0.001) << "1:" << scale << ", unit " << metresPerUnit << " m";
    }
  }
  // Of a ship of full size it is Bullet's own.
  EXPECT_EQ(convexHull(model(1.0), {})->getMargin(), CONVEX_DISTANCE_MARGIN);
  EXPECT_NEAR(static_cast<double>(convexHull(model(50.0), {})->getMargin()), 0.01 * 7.0 / 50.0,
              1e-9);
}

// A shape of the user's stays as it is.
TEST(CollisionShape, TheUsersShapeKeepsItsMargin) {
  btBoxShape box(btVector3(50, 7, 5));
  const btScalar margin = box.getMargin();
  TestWorld world(kSphereGravity);
  Seaway seaway(world.world);
  const Ship& ship = seaway.addShip(slenderShip(), {.collision = {.shape = &box}});
  EXPECT_EQ(box.getMargin(), margin);
  EXPECT_EQ(ship.body().getCollisionShape(), &box);
}

// A ball rolls along the deck of a model of 1:50 for two seconds: it neither sinks in nor jumps,
// and rolling friction is not there to slow it. Its radius is 7 times the margin of the deck.
TEST(CollisionShape, ABallRollsOnAModelsDeck) {
  const ShipParticulars ship = model(50.0);
  const auto shape = convexHull(ship, {}, kDeck / 50.0);
  TestWorld world(9.81);
  Fixed hull(*shape);
  world.world.addRigidBody(&hull.body);
  const double radius = 0.01, speed = 0.3;
  btSphereShape sphere{btScalar(radius)};
  btRigidBody ball(btRigidBody::btRigidBodyConstructionInfo(
      btScalar(0.1), nullptr, &sphere, btVector3(1, 1, 1) * btScalar(0.4 * 0.1 * radius * radius)));
  const double deck = (kDeck - 1.0) / 50.0 + static_cast<double>(shape->getMargin());
  ball.setCenterOfMassTransform(btTransform(btQuaternion::getIdentity(),
                                            btVector3(btScalar(-0.5), 0, btScalar(deck + radius))));
  ball.setLinearVelocity(btVector3(btScalar(speed), 0, 0));
  ball.setAngularVelocity(btVector3(0, btScalar(speed / radius), 0));
  ball.setFriction(1);
  world.world.addRigidBody(&ball);
  double off = 0.0;
  for (int i = 0; i < 480; ++i) {
    world.world.stepSimulation(btScalar(1) / 240, 1, btScalar(1) / 240);
    const double height = static_cast<double>(ball.getWorldTransform().getOrigin().z());
    off = std::max(off, std::abs(height - deck - radius));
  }
  // What Bullet lets a contact sink in by a tick's fall, 2e-4 m, and not a margin more.
  EXPECT_LT(off, 5e-4);
  EXPECT_NEAR(static_cast<double>(ball.getWorldTransform().getOrigin().x()), -0.5 + 2.0 * speed,
              0.02 * 2.0 * speed);
  world.world.removeRigidBody(&ball);
  world.world.removeRigidBody(&hull.body);
}

/// Farthest point of a shape along a direction, without Bullet's margin.
double reach(const btCollisionShape& shape, const btVector3& direction) {
  const auto& hull = dynamic_cast<const btConvexHullShape&>(shape);
  return static_cast<double>(hull.localGetSupportingVertexWithoutMargin(direction).dot(direction));
}

// A prism of half breadth 2 m at the keel, 4 m below water, and 6 m at its top, 4 m above: no
// vertex lies at the deck, 2 m above water, where it is 5 m.
TEST(CollisionShapeClosedForm, TheHullIsCutWhereItsSidesCrossTheDeck) {
  ShipParticulars ship;
  ship.cog = Vec3(0.5, 0, 1.0);
  for (const double x : {-10.0, 10.0})
    for (const double side : {1.0, -1.0})
      for (const double z : {-4.0, 4.0})
        ship.hull.vertices.emplace_back(x, side * (4.0 + 0.5 * z), z);
  // Corners are 4·(bow) + 2·(starboard) + (top).
  ship.hull.faces = {{{0, 4, 5, 1}}, {{2, 3, 7, 6}}, {{0, 2, 6, 4}},
                     {{1, 5, 7, 3}}, {{0, 1, 3, 2}}, {{4, 6, 7, 5}}};
  const auto whole = convexHull(ship, {}), cut = convexHull(ship, {}, 2.0);
  constexpr double kRound = 1e-5;  // float
  EXPECT_NEAR(reach(*whole, btVector3(0, 0, 1)), 3.0, kRound);
  EXPECT_NEAR(reach(*cut, btVector3(0, 0, 1)), 1.0, kRound);
  EXPECT_NEAR(reach(*cut, btVector3(0, 1, 0)), 5.0, kRound);
  EXPECT_NEAR(reach(*cut, btVector3(0, -1, 0)), 5.0, kRound);
  EXPECT_NEAR(reach(*cut, btVector3(1, 0, 0)), 9.5, kRound);
  EXPECT_NEAR(reach(*cut, btVector3(0, 0, -1)), 5.0, kRound);
  // y up, centimetres: the same in that world.
  const auto turned = convexHull(ship, {.up = WorldFrame::Up::Y, .metresPerUnit = 0.01}, 2.0);
  EXPECT_NEAR(reach(*turned, btVector3(0, 1, 0)), 100.0, 100.0 * kRound);
}

/// How far a crate of 2 m put on the deck 20 m before the mast is from there after ten seconds [m],
/// seen from the ship; before it is let go it overlaps the shape or not.
struct Crate {
  bool overlaps = false;
  double moved = 0.0;
};
Crate crateOnDeck(std::optional<double> deck) {
  TestWorld world(kSphereGravity);
  Seaway seaway(world.world);
  Ship& ship = seaway.addShip(shipWithMast(), {.collision = {.deck = deck}});
  btBoxShape box(btVector3(1, 1, 1));
  btRigidBody crate(btRigidBody::btRigidBodyConstructionInfo(
      1000, nullptr, &box, btVector3(1, 1, 1) * btScalar(1000.0 * 4.0 / 6.0)));
  // Its half, and room for the margin of the ship.
  const auto above = static_cast<btScalar>(kDeck + 1.0 + 0.05);
  crate.setCenterOfMassTransform(btTransform(btQuaternion::getIdentity(), btVector3(20, 0, above)));
  Crate result;
  result.overlaps = touch(world.world, ship.body(), crate);
  world.world.addRigidBody(&crate);
  const auto fromShip = [&] {
    return ship.hullTransform().inverse() * crate.getWorldTransform().getOrigin();
  };
  const btVector3 start = fromShip();
  for (int i = 0; i < 640; ++i) world.world.stepSimulation(kTick, 1, kTick);
  result.moved = static_cast<double>((fromShip() - start).length());
  world.world.removeRigidBody(&crate);
  return result;
}

// 0.05 m: it falls the room left, and friction lets it creep by less than a millimetre a second.
TEST(CollisionShape, ACrateStaysOnTheDeckThatIsGiven) {
  const Crate on = crateOnDeck(kDeck);
  EXPECT_FALSE(on.overlaps);
  EXPECT_LT(on.moved, 0.06);
  const Crate thrown = crateOnDeck({});
  EXPECT_TRUE(thrown.overlaps);
  EXPECT_GT(thrown.moved, 1.0);
}

std::string refusal(const ShipSettings& settings, const Coefficients& ship = shipWithMast()) {
  TestWorld world(kSphereGravity);
  Seaway seaway(world.world);
  try {
    seaway.addShip(ship, settings);
  } catch (const HydroError& error) {
    EXPECT_EQ(world.world.getNumCollisionObjects(), 0);
    return error.what();
  }
  return {};
}

TEST(CollisionShape, ADeckOutsideTheMeshIsRefused) {
  for (const double deck :
       {0.0, -5.0, -20.0, 30.1, kNan, std::numeric_limits<double>::infinity()}) {
    const std::string said = refusal({.collision = {.deck = deck}});
    EXPECT_NE(said.find("Seaway::addShip: collision.deck = "), std::string::npos) << deck << said;
    EXPECT_NE(said.find("calm water, 0 m"), std::string::npos) << said;
    EXPECT_NE(said.find("mesh, 30.0"), std::string::npos) << said;
  }
  EXPECT_EQ(refusal({.collision = {.deck = 30.0}}), "");
  btBoxShape own(btVector3(50, 7, 5));
  EXPECT_NE(refusal({.collision = {.shape = &own, .deck = kDeck}}).find("collision.deck"),
            std::string::npos);
  // Vertices without faces cannot be cut.
  EXPECT_NE(refusal({.collision = {.deck = kDeck}}, slenderShip()).find("no faces"),
            std::string::npos);
}

}  // namespace
}  // namespace cutwater::test
