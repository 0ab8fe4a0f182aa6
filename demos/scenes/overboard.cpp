// A deck cargo goes overboard, floats, and is hauled in again: overboard DATABASE.h5 [OUT.csv]
// Look for: nine crates in stacks of three stand on deck in calm water. A beam sea grows; as the
// ship rolls they slide, topple and fall over the side one by one, float at their draught and drift
// with the waves. Then a crane's rope lifts one out of the water: by its weight, once it hangs.
#include <algorithm>
#include <deque>
#include <optional>

#include "demos/scenes/DemoShip.h"
#include "demos/scenes/SceneRuns.h"

using namespace cutwater;

namespace {

constexpr double kTick = 1.0 / 60.0, kMass = 5200.0, kDegree = kPi / 180.0;
constexpr double kDeck = 4.0;                                 // about G [m]
constexpr double kFriction = 0.35;                            // of a box on deck
constexpr double kCalm = 20.0, kStorm = 160.0, kHaul = 40.0;  // [s]
constexpr double kRope = 7.0;     // from the hook to the middle of a crate [m]
const Vec3 kHalf(1.2, 1.2, 1.2);  // of a crate [m]

struct Overboard {
  Overboard(const Coefficients& frigate)
      : bullet(frigate.ship.gravity),
        seaway(bullet.world, SeaState({{0.55, 3.0, 0.0, kPi / 2.0}, {0.9, 0.4, 1.0, 1.2}},
                                      frigate.ship.gravity, kCalm + 100.0, WaveProfile::Wheeler)) {
    bullet.world.getSolverInfo().m_numIterations = 50;
    // Boxes that do not overlap the deck a little keep their contact normals while the ship rolls.
    bullet.world.getSolverInfo().m_linearSlop = btScalar(0.002);
    settings.collision.shape = &deck;
    settings.start.offset = carrying(frigate.ship, 9.0 * kMass, Vec3(-20.0, 0.0, kDeck + 3.6));
    ship = &seaway.addShip(frigate, settings);
    ship->body().setFriction(btScalar(kFriction));
    for (int stack = 0; stack < 3; ++stack) {
      for (int level = 0; level < 3; ++level) put(-16.0 - 4.0 * stack, kDeck + 1.2 + 2.4 * level);
    }
  }
  ~Overboard() {
    if (rope) bullet.world.removeConstraint(&*rope);
    for (btRigidBody& one : crates) bullet.world.removeRigidBody(&one);
  }
  void put(double x, double z) {
    btVector3 inertia;
    box.calculateLocalInertia(btScalar(kMass), inertia);
    btRigidBody& one = crates.emplace_back(btScalar(kMass), nullptr, &box, inertia);
    one.setCenterOfMassTransform(
        ship->body().getWorldTransform() *
        btTransform(btQuaternion::getIdentity(), toBullet(Vec3(x, 0.0, z))));
    one.setFriction(btScalar(kFriction));
    one.setActivationState(DISABLE_DEACTIVATION);
    bullet.world.addRigidBody(&one);
    floats.push_back(&seaway.addFloat(one));
  }
  Vec3 place(std::size_t i) const { return fromBullet(crates[i].getCenterOfMassPosition()); }
  // Of a crate's centre about G, in the ship's axes.
  Vec3 aboard(std::size_t i) const {
    return fromBullet(
        ship->body().getWorldTransform().invXform(crates[i].getCenterOfMassPosition()));
  }
  int overboard() const {
    int count = 0;
    for (const Float* one : floats) count += one->immersion() > 0.2 ? 1 : 0;
    return count;
  }
  void tick() { bullet.world.stepSimulation(kTick, 1, kTick); }

  BulletWorld bullet;
  Seaway seaway;
  btBoxShape deck{btVector3(60, 7, btScalar(kDeck))}, box{toBullet(kHalf)};
  ShipSettings settings;
  Ship* ship = nullptr;
  std::deque<btRigidBody> crates;
  std::vector<Float*> floats;
  std::optional<btPoint2PointConstraint> rope;
};

void addRow(DemoTable& table, const Overboard& scene) {
  double mean = 0.0;
  for (const Float* one : scene.floats) mean += one->immersion() / 9.0;
  table.row({scene.seaway.time(), scene.ship->motion()[Roll] / kDegree, double(scene.overboard()),
             mean, scene.aboard(0).y(), scene.place(0).z(), scene.place(2).z()});
}

// The rope's end goes up, and the crate as a pendulum with it; it pulls with the crate's weight.
bool haul(Overboard& scene, DemoTable& table, SceneRuns& runs) {
  std::size_t chosen = 0;
  for (std::size_t i = 0; i < scene.crates.size(); ++i) {
    if (scene.floats[i]->immersion() > 0.2) chosen = i;
  }
  btRigidBody& crate = scene.crates[chosen];
  btVector3 hook = crate.getCenterOfMassPosition() + btVector3(0, 0, btScalar(kRope));
  const btVector3 eye = crate.getWorldTransform().invXform(hook);
  scene.rope.emplace(crate, eye);
  scene.rope->setPivotB(hook);
  scene.bullet.world.addConstraint(&*scene.rope);
  btJointFeedback feedback;
  scene.rope->setJointFeedback(&feedback);
  double pull = 0.0, from = 0.0;  // its mean in the last ten seconds; rising then
  int counted = 0;
  const double end = scene.seaway.time() + kHaul;
  while (scene.seaway.time() < end) {
    // Half a metre a second, until the crate is 12 m above calm water, and slowly to a stop there.
    const double left = 12.0 + kRope - double(hook.z());
    hook.setZ(hook.z() + btScalar(kTick * std::clamp(0.5 * left, 0.0, 0.8)));
    scene.rope->setPivotB(hook);
    scene.tick();
    addRow(table, scene);
    if (scene.seaway.time() < end - 10.0) continue;
    if (counted++ == 0) {
      from = double(crate.getLinearVelocity().z());
      continue;
    }
    pull += double(feedback.m_appliedForceBodyA.z());
  }
  runs.write();
  const double weight = kMass * scene.ship->coefficients().ship.gravity;
  const double rise = (double(crate.getLinearVelocity().z()) - from) / (kTick * (counted - 1));
  // Of a crate that swings; the last tick's rounding is all that is left.
  bool good = agrees("rope of the crate hauled in, less m dw/dt [kN]",
                     1e-3 * (pull / (counted - 1) - kMass * rise), 1e-3 * weight, 1e-3);
  good &= isBelow("wet share of it", scene.floats[chosen]->immersion(), 0.0);
  return good;
}

bool run(const Coefficients& frigate, DemoTable& table) {
  Overboard scene(frigate);
  SceneRuns runs(table, scene.seaway, kTick, 4);
  runs.ship("ship", *scene.ship, scene.settings);
  for (std::size_t i = 0; i < scene.crates.size(); ++i)
    runs.box("crate" + std::to_string(i + 1), scene.crates[i], 2.0 * kHalf);
  double slid = 0.0;
  while (scene.seaway.time() < kCalm) {
    scene.tick();
    addRow(table, scene);
    for (std::size_t i = 0; i < scene.crates.size(); ++i)
      slid = std::max(slid, std::abs(scene.aboard(i).y()));
  }
  bool good = isBelow("slid in the first 20 s [m]", slid, 0.02);
  while (scene.seaway.time() < kCalm + kStorm) {
    scene.tick();
    addRow(table, scene);
  }
  // How deep they lie: by their mass. They heave in the waves: a mean over 20 s, over all.
  double immersed = 0.0, off = 0.0;
  int counted = 0;
  const double end = scene.seaway.time() + 20.0;
  while (scene.seaway.time() < end) {
    scene.tick();
    addRow(table, scene);
    for (std::size_t i = 0; i < scene.crates.size(); ++i) {
      if (scene.floats[i]->immersion() < 0.2) continue;
      const Vec3 at = scene.place(i);
      immersed += scene.floats[i]->immersion();
      off = std::max(off, std::abs(at.z() - scene.seaway.waveHeight(at.x(), at.y())));
      ++counted;
    }
  }
  good &= agrees("crates overboard", scene.overboard(), 9.0, 4.0);
  const double share = kMass / (1025.0 * 8.0 * kHalf.prod());
  good &= agrees("wet share of those", immersed / std::max(1, counted), share, 0.03);
  good &= isBelow("farthest of a crate's centre off the waves [m]", off, 1.2);
  good &= scene.overboard() > 0 && haul(scene, table, runs);
  const std::uint32_t broken = scene.seaway.faults() & ~kWarningBits;
  if (broken != 0) std::printf("%s\n", faultText(broken).c_str());
  return good && broken == 0;
}

}  // namespace

int main(int argc, char** argv) {
  return demoMain(argc, argv, "overboard", "t,roll_deg,overboard,wet_share,across_1,z_1,z_3", run);
}
