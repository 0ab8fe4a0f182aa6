// Boxes stand on deck by friction alone: cargo DATABASE.h5 [OUT.csv]
// Look for: in calm water the hull carries their weight by its draught and heel. In a beam sea that
// grows, the box with friction 0.1 stands until the deck feels inclined by atan 0.1 = 5.7 degrees,
// then slides to and fro; the box with 0.5 stays.
#include <algorithm>
#include <deque>

#include "demos/scenes/DemoShip.h"
#include "demos/scenes/SceneRuns.h"

using namespace cutwater;

namespace {

constexpr double kTick = 1.0 / 64.0, kMass = 20e3, kDegree = kPi / 180.0;
constexpr double kHeight = 5.0;  // of a box's centre about G [m]: 1 m above deck

struct Scene {
  Scene(const Coefficients& frigate, const SeaState& sea, double side)
      : bullet(frigate.ship.gravity), seaway(bullet.world, sea) {
    bullet.world.getSolverInfo().m_numIterations = 50;
    // Boxes that do not overlap the deck a little keep their contact normals while the ship rolls.
    bullet.world.getSolverInfo().m_linearSlop = btScalar(0.002);
    bullet.world.getSolverInfo().m_solverMode |=
        SOLVER_USE_2_FRICTION_DIRECTIONS | SOLVER_DISABLE_VELOCITY_DEPENDENT_FRICTION_DIRECTION;
    settings.collision.shape = &deck;
    settings.start.offset = carrying(frigate.ship, 2.0 * kMass, Vec3(-7.0, side, kHeight));
    ship = &seaway.addShip(frigate, settings);
    ship->body().setFriction(1);
    put(-3.0, side, 0.1);
    put(-11.0, side, 0.5);
  }
  ~Scene() {
    for (btRigidBody& one : boxes) bullet.world.removeRigidBody(&one);
  }
  void put(double x, double y, double friction) {
    btVector3 inertia;
    box.calculateLocalInertia(btScalar(kMass), inertia);
    btRigidBody& one = boxes.emplace_back(btScalar(kMass), nullptr, &box, inertia);
    one.setCenterOfMassTransform(
        ship->body().getWorldTransform() *
        btTransform(btQuaternion::getIdentity(), toBullet(Vec3(x, y, kHeight))));
    one.setFriction(btScalar(friction));
    one.setActivationState(DISABLE_DEACTIVATION);
    bullet.world.addRigidBody(&one);
  }
  // Of a box's centre from amidships, in the ship's axes [m].
  double across(std::size_t i) const {
    return double(
        ship->body().getWorldTransform().invXform(boxes[i].getCenterOfMassPosition()).y());
  }
  // Tangent of the deck against what stands on it feels as upright.
  double slope() const {
    const Coefficients& c = ship->coefficients();
    const Vec3 moved = ship->pointMotion(c.ship.cog + Vec3(-7.0, 0.0, kHeight)).acceleration;
    const Vec3 felt = fromBullet(ship->body().getWorldTransform().getBasis()).transpose() *
                      (moved + Vec3(0.0, 0.0, c.ship.gravity));
    return std::hypot(felt.x(), felt.y()) / felt.z();
  }
  void tick() { bullet.world.stepSimulation(kTick, 1, kTick); }

  BulletWorld bullet;
  Seaway seaway;
  btBoxShape deck{btVector3(60, 7, 4)}, box{btVector3(3, btScalar(1.2), 1)};
  ShipSettings settings;
  Ship* ship = nullptr;
  std::deque<btRigidBody> boxes;
};

// Both on the port side: the ship sinks and heels by their weight.
bool inCalmWater(const Coefficients& frigate) {
  Scene scene(frigate, SeaState(), 4.0);
  const Vec6 expected = scene.ship->motion();
  scene.boxes[0].setFriction(btScalar(0.5));
  Vec6 mean = Vec6::Zero();
  const int ticks = 60 * 64;
  for (int i = 0; i < ticks; ++i) {
    scene.tick();
    mean += scene.ship->motion() / ticks;
  }
  bool good = agrees("sinkage [m]", -mean[Heave], -expected[Heave], 1e-5);
  good &= agrees("heel [deg]", mean[Roll] / kDegree, expected[Roll] / kDegree, 5e-3);
  good &= isBelow("slid at rest [m]", 4.0 - scene.across(0), 1e-3);
  return good && scene.seaway.faults() == kStepOk;
}

bool inBeamSea(const Coefficients& frigate, DemoTable& table) {
  Scene scene(frigate, SeaState({{0.5, 1.7, 0.0, kPi / 2.0}}, frigate.ship.gravity, 200.0), 0.0);
  SceneRuns runs(table, scene.seaway, kTick, 4);
  runs.ship("ship", *scene.ship, scene.settings);
  runs.box("slides", scene.boxes[0], {6.0, 2.4, 2.0});
  runs.box("stays", scene.boxes[1], {6.0, 2.4, 2.0});
  bool stands = true;
  double held = 0.0, before = 0.0, slid[2] = {0.0, 0.0};
  while (scene.seaway.time() < 200.0) {
    scene.tick();
    const double slope = scene.slope();
    for (std::size_t i : {0, 1}) slid[i] = std::max(slid[i], std::abs(scene.across(i)));
    stands = stands && std::abs(scene.across(0) - before) < 0.002 * kTick;  // 2 mm/s
    before = scene.across(0);
    if (stands) held = std::max(held, slope);
    table.row({scene.seaway.time(), scene.ship->motion()[Roll] / kDegree,
               std::atan(slope) / kDegree, scene.across(0), scene.across(1)});
  }
  runs.write();
  // 5 %: the slope grows so much from one roll to the next.
  bool good = agrees("held, friction 0.1, up to a slope of", held, 0.1, 0.005);
  good &= agrees("slid, friction 0.1 [m]", slid[0], 2.0, 1.9);
  good &= isBelow("slid, friction 0.5 [m]", slid[1], 1e-3);
  return good && scene.seaway.faults() == kStepOk;
}

}  // namespace

int main(int argc, char** argv) {
  return demoMain(argc, argv, "cargo", "t,roll_deg,felt_deg,slid_a,slid_b",
                  [](const Coefficients& frigate, DemoTable& table) {
                    const bool calm = inCalmWater(frigate);
                    return inBeamSea(frigate, table) && calm;
                  });
}
