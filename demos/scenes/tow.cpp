// A tug pulls a ship off sideways by a line of eight links: tow DATABASE.h5 [OUT.csv]
// Look for: the pull over the ship's acceleration is m + A22(inf) at first, m + A22(0) once the
// water moves, never m alone. Tug, links, ship and water have taken up the impulse given, at enough
// iterations. The tug pulls with 300 kN. Drag is off: it would be a second answer to the pull.
#include <algorithm>
#include <deque>

#include "demos/scenes/DemoShip.h"
#include "demos/scenes/SceneRuns.h"

using namespace cutwater;

namespace {

constexpr double kTick = 1.0 / 64.0, kPull = 3e5, kTug = 400e3, kLink = 1e3, kLength = 5.0;
constexpr int kLinks = 8, kMostIterations = 400;

// The tug and the links float, but move no water.
struct Line {
  explicit Line(BulletWorld& owner, Ship& ship) : world(owner.world) {
    const double side = 7.5, height = ship.coefficients().ship.cog.z();
    for (int i = 0; i <= kLinks; ++i) {
      const bool tug = i == kLinks;
      const double mass = tug ? kTug : kLink, half = 0.5 * kLength;
      btVector3 inertia;
      rod.calculateLocalInertia(btScalar(mass), inertia);
      btRigidBody& body = bodies.emplace_back(btScalar(mass), nullptr, &rod, inertia);
      body.setCenterOfMassTransform(btTransform(
          btQuaternion::getIdentity(), toBullet(Vec3(0.0, side + half + i * kLength, height))));
      body.setActivationState(DISABLE_DEACTIVATION);
      world.addRigidBody(&body, 0, 0);  // collides with nothing
      body.setGravity(btVector3(0, 0, 0));
      btRigidBody& before = i == 0 ? ship.body() : bodies[static_cast<std::size_t>(i - 1)];
      const btVector3 there(0, btScalar(i == 0 ? side : half), 0), here(0, btScalar(-half), 0);
      joints.emplace_back(before, body, there, here);
    }
    for (btPoint2PointConstraint& joint : joints) world.addConstraint(&joint, true);
    joints.front().setJointFeedback(&feedback);
  }
  ~Line() {
    for (btPoint2PointConstraint& joint : joints) world.removeConstraint(&joint);
    for (btRigidBody& body : bodies) world.removeRigidBody(&body);
  }
  double tension() const { return double(feedback.m_appliedForceBodyA.y()); }  // at the ship
  double momentum() const {
    double sum = 0.0;
    for (const btRigidBody& body : bodies) {
      sum += double(body.getLinearVelocity().y() / body.getInvMass());
    }
    return sum;
  }
  btDiscreteDynamicsWorld& world;
  btBoxShape rod{btVector3(1, 2, 1)};
  std::deque<btRigidBody> bodies;
  std::deque<btPoint2PointConstraint> joints;
  btJointFeedback feedback;
};

struct Result {
  double lost = 0.0, stretch = 0.0;    // of the impulse, of the length
  double atFirst = 0.0, atLast = 0.0;  // the pull over the acceleration [kg]
  std::uint32_t faults = kStepOk;
};

Result pull(const Coefficients& frigate, int iterations, DemoTable& table) {
  BulletWorld bullet(frigate.ship.gravity);
  bullet.world.getSolverInfo().m_numIterations = iterations;
  Seaway calm(bullet.world);
  ShipSettings settings;
  settings.model.resistance = false;
  settings.model.restrained[Yaw] = true;
  Ship& ship = calm.addShip(frigate, settings);
  Line line(bullet, ship);
  SceneRuns runs(table, calm, kTick, 4);
  runs.ship("ship", ship, settings);
  for (int i = 0; i < kLinks; ++i)
    runs.box("link" + std::to_string(i + 1), line.bodies[static_cast<std::size_t>(i)],
             {0.4, kLength, 0.4});
  runs.box("tug", line.bodies.back(), {8.0, kLength, 4.0});
  Result result;
  double pulled = 0.0, given = 0.0, pulledBefore = 0.0, speedBefore = 0.0;
  for (int i = 1; i <= 30 * 64; ++i) {
    line.bodies.back().applyCentralForce(btVector3(0, btScalar(kPull), 0));
    bullet.world.stepSimulation(kTick, 1, kTick);
    given += kTick * kPull;
    pulled += kTick * line.tension();
    const double ofShip = ship.momentum()[Sway], ofTug = line.momentum(),
                 speed = ship.velocity()[Sway];
    result.lost = std::max(result.lost, std::abs(ofShip + ofTug - given) / given);
    if (i == 16) result.atFirst = pulled / speed;
    if (i == 20 * 64) {
      pulledBefore = pulled;
      speedBefore = speed;
    }
    if (i == 30 * 64) result.atLast = (pulled - pulledBefore) / (speed - speedBefore);
    table.row({double(iterations), calm.time(), ship.position().y(), speed, line.tension(), ofShip,
               ofTug, given});
  }
  result.faults = calm.faults();
  if (iterations == kMostIterations) runs.write();
  return result;
}

bool run(const Coefficients& database, DemoTable& table) {
  Coefficients frigate = database;
  frigate.ship.supplementary = {};
  std::puts("iterations  impulse lost");
  Result r;
  for (const int iterations : {10, 20, 50, 100, 200, kMostIterations}) {
    r = pull(frigate, iterations, table);
    std::printf("%10d %13.2e\n", iterations, r.lost);
  }
  // Yaw is held, roll is not.
  const Mat6 inertia = frigate.ship.massMatrix() + frigate.addedMass.atInfinity;
  const double mass = frigate.ship.mass,
               atFirst = 1.0 / inertia.topLeftCorner<5, 5>().inverse()(Sway, Sway);
  bool good = agrees("pull / m dv/dt in the first 1/4 s", r.atFirst / mass, atFirst / mass, 0.02);
  good &= agrees("pull / m dv/dt after 20 s", r.atLast / mass,
                 1.0 + frigate.addedMass.atZero(Sway, Sway) / mass, 0.02);
  good &= isBelow("impulse lost at 400 iterations", r.lost, 1e-3);
  return good && r.faults == kStepOk;
}

}  // namespace

int main(int argc, char** argv) {
  return demoMain(argc, argv, "tow",
                  "iterations,t,y,speed,tension,momentum_ship,momentum_tug,impulse", run);
}
