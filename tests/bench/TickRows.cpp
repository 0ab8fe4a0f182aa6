#include <btBulletDynamicsCommon.h>

#include <cmath>
#include <utility>
#include <vector>

#include "demos/scenes/BulletWorld.h"
#include "hydro/forces/Hydrodynamics.h"
#include "hydro/forces/PredictedMotion.h"
#include "hydro/forces/PressureHull.h"
#include "hydro/forces/linear/Radiation.h"
#include "hydro/waves/Spectrum.h"
#include "hydro/waves/WaterMotion.h"
#include "hydro/waves/WaterPressure.h"
#include "plugin/Seaway.h"
#include "tests/bench/Rows.h"
#include "tests/forces/WaveLoads.h"

namespace cutwater::bench {
namespace {

using Shared = std::shared_ptr<const Hydrodynamics>;

constexpr double kTick60 = 1.0 / 60.0;

SeaState sea(int components) {
  if (components == 1) return SeaState({{0.7, 1.0, 0.0, 2.5}}, kStandardGravity);
  SeaStateSettings settings;
  settings.components = components;
  return makeSeaState(Spectrum{}, settings);
}

/// Ships on a line, 200 m apart, in a world of their own.
struct Fleet {
  Fleet(const Shared& ship, int ships, int components, const ShipSettings& settings,
        unsigned threads = 1)
      : seaway(bullet.world, sea(components)) {
    seaway.setThreads(threads);
    for (int i = 0; i < ships; ++i) {
      ShipSettings one = settings;
      one.start.y = 200.0 * i;
      seaway.addShip(ship, one);
    }
  }
  void step(int ticks, double tick) {
    for (int i = 0; i < ticks; ++i)
      bullet.world.stepSimulation(static_cast<btScalar>(tick), 1, static_cast<btScalar>(tick));
  }
  double checksum() const {
    double sum = 0.0;
    for (const auto& ship : seaway.ships()) sum += ship->position().z() + ship->attitude().x();
    return sum;
  }
  BulletWorld bullet;
  Seaway seaway;
};

/// Processor seconds of so many ticks of as many plain bodies: Bullet's own step.
double drySeconds(int bodies, int ticks) {
  BulletWorld bullet;
  btSphereShape shape(5);
  std::vector<std::unique_ptr<btRigidBody>> dry;
  for (int i = 0; i < bodies; ++i) {
    dry.push_back(std::make_unique<btRigidBody>(btScalar(1), nullptr, &shape, btVector3(1, 1, 1)));
    dry.back()->setWorldTransform(
        btTransform(btQuaternion::getIdentity(), btVector3(0, btScalar(200 * i), 0)));
    bullet.world.addRigidBody(dry.back().get());
  }
  const auto tick = static_cast<btScalar>(kTick60);
  bullet.world.stepSimulation(tick, 1, tick);
  const Time time = timeOf([&] {
    for (int i = 0; i < ticks; ++i) bullet.world.stepSimulation(tick, 1, tick);
  });
  for (const auto& body : dry) bullet.world.removeRigidBody(body.get());
  return time.processor;
}

Row rowOf(const std::string& name, const Shared& c) {
  Row row{name, c->ship().wetSurface.faces.size(), 1};
  return row;
}

/// Seconds of one of so many ticks, Bullet included, after some to begin with; the floor is Bullet
/// with as many plain bodies.
void timeTicks(Fleet& fleet, int first, int ticks, int share, Row& row) {
  fleet.step(first, kTick60);
  const Time time = timeOf([&] { fleet.step(ticks, kTick60); });
  const auto ships = static_cast<int>(fleet.seaway.ships().size());
  row.seconds = time.seconds / share;
  row.processor = time.processor / share;
  row.floor = drySeconds(ships, ticks) / share;
}

/// One tick of one ship.
void benchTick(std::string& csv, const std::string& name, const Shared& c, int components,
               double budget, const ShipSettings& settings = {}) {
  constexpr int kTicks = 20000;
  Fleet fleet(c, 1, components, settings);
  Row row = rowOf(name, c);
  timeTicks(fleet, 10, kTicks, kTicks, row);
  row.budget = budget;
  row.checksum = fleet.checksum();
  add(csv, row);
}

/// Our share of a tick without Bullet's step: beginTick and endTick of one ship.
void benchShare(std::string& csv, const std::string& name, const Shared& c, int components,
                double budget, const ShipSettings& settings = {}) {
  constexpr int kTicks = 50000;
  Fleet fleet(c, 1, components, settings);
  fleet.step(10, kTick60);
  Ship& ship = *fleet.seaway.ships().front();
  double time = fleet.seaway.time();
  Row row = rowOf(name, c);
  row.seconds = secondsOf([&] {
                  for (int i = 0; i < kTicks; ++i, time += kTick60) {
                    ship.beginTick(time, static_cast<btScalar>(kTick60));
                    ship.endTick(static_cast<btScalar>(kTick60));
                  }
                }) /
                kTicks;
  row.budget = budget;
  row.checksum = ship.load("radiation").allFinite() ? 1.0 : 0.0;
  add(csv, row);
}

template <class Work>
void benchPart(std::string& csv, const std::string& name, const Shared& c, Work work) {
  constexpr int kTimes = 100000;
  Row row = rowOf(name, c);
  TickInput motion;
  motion.etaDot << 0.1, 0.2, 0.3, 0.01, 0.02, 0.03;
  motion.etaDotNow = motion.etaDot;
  row.seconds = secondsOf([&] {
                  for (int i = 0; i < kTimes; ++i) {
                    motion.time += kTick60;
                    motion.etaDot[Heave] = std::sin(motion.time);
                    row.checksum += work(motion)[Heave];
                  }
                }) /
                kTimes;
  add(csv, row);
}

std::shared_ptr<const SeaTables> tablesOf(const Shared& c, int components) {
  return std::make_shared<const SeaTables>(c, std::make_shared<const SeaState>(sea(components)));
}

void benchParts(std::string& csv, const Shared& c) {
  for (const int components : {1, 20, 200}) {
    test::WaveLoads loads(tablesOf(c, components), {0.3, 5.0});
    benchPart(csv, "tick: excitation, components " + std::to_string(components), c,
              [&](TickInput& m) { return loads.evaluate(m); });
  }
  {
    const auto tables = tablesOf(c, 200);
    PredictedMotion predicted(tables, {});
    std::vector<Phasors4> phasors(tables->sea().phasorBlocks());
    constexpr double kTurn = 1.7e-2;  // [rad/s]
    benchPart(csv, "tick: excitation, components 200, while turning 1 deg/s", c, [&](TickInput& m) {
      m.meanHeading += kTurn * kTick60;
      tables->sea().phasors(m.time, 0.0, 0.0, phasors);
      predicted.follow({m.meanHeading, {5.0, 0.0}}, kTurn, kTick60);
      predicted.sum(phasors, 1.0);
      return predicted.now().froudeKrylov;
    });
  }
  for (const MemoryModel memory : {MemoryModel::Exponential, MemoryModel::Convolution}) {
    const std::string name = memory == MemoryModel::Exponential ? "tick: radiation, exponential sum"
                                                                : "tick: radiation, convolution";
    for (const double speed : {0.0, 10.0}) {
      Radiation part(c->radiation(), memory);
      part.prepare(kTick60);
      benchPart(csv, name + (speed > 0.0 ? ", under way" : ", at rest"), c, [&](TickInput& m) {
        m.speed = speed;
        return part.evaluate(m).load;
      });
    }
  }
}

/// Elevation and heads at as many points as the frigate's wetted hull has; the panels are points.
/// @param near  [m] as WaterPressure has it: all points need two heads, or none.
void benchWater(std::string& csv, const std::string& name, int components, double near) {
  constexpr std::size_t kPoints = 57 * WaterPressure::kLanes;
  const int times = 400000 / (components + 20);
  std::vector<double> x, y, z;
  for (std::size_t i = 0; i < kPoints; ++i) {
    const double at = static_cast<double>(i) / kPoints;
    x.push_back(100.0 * at - 50.0);
    y.push_back(6.0 * std::sin(100.0 * at));
    z.push_back(5.0 * std::sin(170.0 * at));
  }
  std::vector<double> elevation(kPoints), head(kPoints), surfaceHead(kPoints);
  WaterPressure water(sea(components));
  Row row{"water pressure: components " + std::to_string(components) + name, kPoints, 1};
  row.seconds =
      secondsOf([&] {
        for (int i = 0; i < times; ++i) {
          water.at(kTick60 * i, 0.0, 0.0, {x, y, z}, near, {elevation, head, surfaceHead});
          row.checksum += head[0];
        }
      }) /
      times;
  if (components == 1) row.budget = 8e-6;
  if (components == 200) row.budget = 200e-6;
  add(csv, row);
}

void benchWater(std::string& csv) {
  for (const int components : {1, 20, 200, 1000}) {
    benchWater(csv, "", components, 100.0);
    benchWater(csv, ", far below the surface", components, -100.0);
  }
}

/// What a renderer asks, a point: elevation alone, and all there is; and one point at a time.
void benchSea(std::string& csv) {
  constexpr std::size_t kPoints = 1024;
  std::vector<double> x(kPoints), y(kPoints), z(kPoints, -1.0);
  for (std::size_t i = 0; i < kPoints; ++i) {
    x[i] = static_cast<double>(i % 32);
    y[i] = static_cast<double>(i / 32);
  }
  std::vector<double> out[7];
  for (auto& column : out) column.resize(kPoints);
  const SeaState waves = sea(200);
  WaterMotion water(waves);
  const auto bench = [&](const std::string& name, std::size_t times, const auto& work) {
    Row row{"sea, 200 components: " + name, 1, 1};
    row.seconds = secondsOf([&] {
                    for (std::size_t i = 0; i < times; ++i) row.checksum += work(1e-2 * double(i));
                  }) /
                  static_cast<double>(times);
    if (name.find("many") != std::string::npos) row.seconds /= kPoints;
    add(csv, row);
  };
  bench("elevation of many points, a point", 200, [&](double t) {
    water.at(t, 0.0, 0.0, {x, y, z}, {.elevation = out[0]});
    return out[0][1];
  });
  bench("surface, velocity, pressure of many points, a point", 200, [&](double t) {
    water.at(t, 0.0, 0.0, {x, y, z}, {out[0], out[1], out[2], out[3], out[4], out[5], out[6]});
    return out[6][1];
  });
  bench("SeaState::elevation", 20000, [&](double t) { return waves.elevation(t, 1.0, 2.0); });
  bench("SeaState::motion", 20000, [&](double t) {
    return waves.motion(t, {1.0, 2.0, -1.0}).velocity.z();
  });
}

/// The tick that takes in another sea, and the one in which the old sea goes; budget 2 ms.
void benchSetSea(std::string& csv, const Shared& c, ShipSettings settings) {
  settings.model.mode = HullPressure::Nonlinear;
  Fleet fleet(c, 10, 100, settings);
  fleet.step(10, kTick60);
  Row comes = rowOf("setSea, 10 nonlinear ships, 100 to 200 components: the tick it comes in", c);
  Row usual = rowOf("setSea, 10 nonlinear ships, 100 to 200 components: another tick", c);
  fleet.seaway.setSea(sea(200), 0.5);
  fleet.seaway.waitForSea();
  comes.seconds = secondsOf([&] { fleet.step(1, kTick60); });
  usual.seconds = secondsOf([&] { fleet.step(10, kTick60); }) / 10;
  comes.budget = usual.seconds + 2e-3;
  comes.checksum = usual.checksum = fleet.checksum();
  add(csv, comes);
  add(csv, usual);
}

/// One second of a fleet at 60 Hz; the floor is Bullet with as many plain bodies.
void benchFleet(std::string& csv, const std::string& name, const Shared& c, int ships,
                int components, const ShipSettings& settings, unsigned threads = 1) {
  constexpr int kTicks = 60;
  Fleet fleet(c, ships, components, settings, threads);
  Row row = rowOf(name, c);
  row.threads = static_cast<int>(threads);
  timeTicks(fleet, 5, kTicks, 1, row);
  row.budget = ships == 1000 ? 1.0 : 0.0;
  row.checksum = fleet.checksum();
  add(csv, row);
}

/// Nonlinear ship, Bullet included, as triangles and components grow. What of the waves' pressure
/// so many triangles miss (PressureHull::pressureError) is the price of fewer.
void benchWetted(std::string& csv, const Shared& c, ShipSettings settings) {
  settings.model.mode = HullPressure::Nonlinear;
  const auto bench = [&](const std::string& name, int triangles, int components, double budget) {
    constexpr int kTicks = 4000;
    settings.model.hullTriangles = triangles;
    Fleet fleet(c, 1, components, settings);
    const PressureHull& hull = *fleet.seaway.ships().front()->pressureHull();
    Row row{name, hull.triangles().triangles() / 2, 1};
    timeTicks(fleet, 10, kTicks, kTicks, row);
    row.budget = budget;
    row.checksum = hull.pressureError();
    add(csv, row);
  };
  bench("nonlinear ship, 866 panels, regular wave, one tick", 1732, 1, 30e-6);
  bench("nonlinear ship, 866 panels, 200 wave components, one tick", 1732, 200, 300e-6);
  for (const int triangles : {500, 1000, 2000, 4000, 8000}) {
    const std::string name = "nonlinear ship, " + std::to_string(triangles) + " triangles, ";
    bench(name + "regular wave; checksum: pressure missed", triangles, 1, 0.0);
    bench(name + "50 wave components; checksum: pressure missed", triangles, 50, 0.0);
  }
}

/// Crates or barrels on a lattice in the water, beside whatever is in the world.
struct Crates {
  Crates(Fleet& fleet, btCollisionShape& shape, int count) : fleet_(fleet) {
    btVector3 inertia;
    shape.calculateLocalInertia(500, inertia);
    for (int i = 0; i < count; ++i) {
      bodies_.push_back(std::make_unique<btRigidBody>(btScalar(500), nullptr, &shape, inertia));
      bodies_.back()->setWorldTransform(
          btTransform(btQuaternion::getIdentity(),
                      btVector3(btScalar(4 * (i % 25)), btScalar(40 + 4 * (i / 25)), 0)));
      fleet.bullet.world.addRigidBody(bodies_.back().get());
      fleet.seaway.addFloat(*bodies_.back());
    }
  }
  ~Crates() {
    for (const auto& body : bodies_) fleet_.bullet.world.removeRigidBody(body.get());
  }
  Fleet& fleet_;
  std::vector<std::unique_ptr<btRigidBody>> bodies_;
};

/// One second of bodies that float beside a ship at 60 Hz, Bullet and ship included; the floor is
/// Bullet with as many plain bodies.
void benchFloats(std::string& csv, const Shared& c, ShipSettings settings) {
  constexpr int kTicks = 60, kCount = 500;
  settings.model.mode = HullPressure::Nonlinear;
  btBoxShape crate(btVector3(btScalar(0.5), btScalar(0.5), btScalar(0.5)));
  btCylinderShapeZ barrel(btVector3(btScalar(0.5), btScalar(0.5), btScalar(0.6)));
  btSphereShape buoy(btScalar(0.6));
  const std::pair<const char*, btCollisionShape*> shapes[] = {
      {"crates", &crate}, {"barrels", &barrel}, {"ball buoys", &buoy}};
  for (const auto& [name, shape] : shapes) {
    for (const int components : {100, 200}) {
      Fleet fleet(c, 1, components, settings);
      const Crates crates(fleet, *shape, kCount);
      Row row = rowOf(std::to_string(kCount) + " " + name + " beside a ship at 60 Hz, " +
                          std::to_string(components) + " wave components, one core",
                      c);
      fleet.step(30, kTick60);
      const Time time = timeOf([&] { fleet.step(kTicks, kTick60); });
      row.seconds = time.seconds;
      row.processor = time.processor;
      row.floor = drySeconds(kCount + 1, kTicks);
      row.budget = 1.0;
      for (const auto& one : fleet.seaway.floats()) row.checksum += one->immersion() / kCount;
      add(csv, row);
    }
  }
}

}  // namespace

void benchTimeDomain(std::string& csv, const Coefficients& coefficients) {
  const auto c = std::make_shared<const Hydrodynamics>(coefficients);
  ShipSettings free;
  free.model.mean = Mean::Free;
  free.model.mode = HullPressure::Linear;
  free.start.speed = 8.0;
  free.model.keepSpeed = SpeedKeeper{.speed = 8.0};
  free.model.keepCourse = CourseKeeper{};
  ShipSettings fixed;
  fixed.model.mean = Mean::Fixed;
  ShipSettings oracle = fixed;
  oracle.model.memory = MemoryModel::Convolution;
  benchWater(csv);
  benchSea(csv);
  benchSetSea(csv, c, free);
  benchShare(csv, "linear ship, one tick, 6 modes, 200 wave components", c, 200, 2e-6, fixed);
  benchShare(csv, "linear ship, one tick, 6 modes, regular wave", c, 1, 2e-6, fixed);
  benchShare(csv, "linear ship, one tick, free and kept, regular wave", c, 1, 0.0, free);
  benchShare(csv, "linear ship, one tick, convolution, 200 wave components", c, 200, 0.0, oracle);
  benchShare(csv, "linear ship, one tick, free and kept, 200 wave components", c, 200, 0.0, free);
  benchTick(csv, "linear ship and Bullet, one tick, 200 wave components", c, 200, 0.0, fixed);
  benchTick(csv, "linear ship and Bullet, one tick, regular wave", c, 1, 0.0, fixed);
  benchWetted(csv, c, free);
  benchFloats(csv, c, free);
  benchParts(csv, c);
  for (const int ships : {1, 10, 100}) {
    benchFleet(csv, std::to_string(ships) + " linear ships at 60 Hz, one core", c, ships, 20,
               fixed);
  }
  benchFleet(csv, "1000 linear ships at 60 Hz, one core", c, 1000, 20, fixed);
  benchFleet(csv, "1000 linear ships at 60 Hz, 200 wave components, one core", c, 1000, 200, free);
  benchFleet(csv, "1000 linear ships at 60 Hz, 200 wave components", c, 1000, 200, free, 2);
  // The report's own run: one ship in a regular wave at ticks of 0.1 s, 30 times real time there.
  Fleet report(c, 1, 1, fixed);
  constexpr int kTicks = 60000;
  Row row = rowOf("regular wave, ticks of 0.1 s, one second of one ship", c);
  row.seconds = secondsOf([&] { report.step(kTicks, 0.1); }) / (kTicks * 0.1);
  row.checksum = report.checksum();
  add(csv, row);
}

}  // namespace cutwater::bench
