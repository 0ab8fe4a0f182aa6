// Seas that change while ships sail: Seaway::setSea, and SeaView.
#include <gtest/gtest.h>

#include <cmath>
#include <thread>
#include <vector>

#include "hydro/waves/Spectrum.h"
#include "plugin/SeaView.h"
#include "tests/plugin/TestScene.h"
#include "tests/support/Meshes.h"

namespace cutwater::test {
namespace {

SeaState irregular(double hs, std::uint64_t seed, bool oblique = true) {
  SeaStateSettings settings{.heading = oblique ? 2.5 : kPi,
                            .spreading = oblique ? 8.0 : 0.0,
                            .components = 30,
                            .seed = seed};
  settings.omegaMax = 1.6;
  return makeSeaState({.hs = hs, .tp = 9.0, .gravity = kSphereGravity}, settings);
}

/// What of a ship in waves is compared: linear on a fixed course, free, and free on its wetted
/// hull.
struct Kind {
  const char* name;
  Mean mean;
  HullPressure mode;
};
const std::vector<Kind> kKinds{{"fixed", Mean::Fixed, HullPressure::Linear},
                               {"free", Mean::Free, HullPressure::Linear},
                               {"wetted", Mean::Free, HullPressure::Nonlinear}};

/// The slender ship as a closed box that floats at its weight.
Coefficients boxShip() {
  Coefficients c = slenderShip();
  SurfaceMesh box = cubes(cells({0, 0, 0}, {8, 2, 2}));
  const double draught = c.ship.volume / (110.0 * 14.0);
  for (Vec3& v : box.vertices)
    v = Vec3(110.0 * (v.x() / 8.0 - 0.5), 14.0 * (v.y() / 2.0 - 0.5),
             v.z() < 1.0 ? -draught : (v.z() - 1.0) * 6.0);
  c.ship.hull = box;
  return c;
}

struct Sailing {
  Sailing(const Kind& kind, SeaState sea) : seaway(world.world, std::move(sea)) {
    ship = &seaway.addShip(boxShip(),
                           {.start = {.speed = kind.mean == Mean::Free ? 4.0 : 0.0},
                            .model = {.mean = kind.mean, .mode = kind.mode, .hullTriangles = 300}});
  }
  void run(int ticks) {
    for (int i = 0; i < ticks; ++i) world.world.stepSimulation(kTick, 1, kTick);
  }
  TestWorld world{kSphereGravity};
  Seaway seaway;
  Ship* ship = nullptr;
};

constexpr double kT = static_cast<double>(kTick);

/// Root mean squares of the loads over some ticks, by part and mode.
std::vector<Vec6> squaresOf(Sailing& scene, int ticks) {
  std::vector<Vec6> sums(scene.ship->parts().size(), Vec6::Zero());
  for (int i = 0; i < ticks; ++i) {
    scene.run(1);
    for (std::size_t part = 0; part < sums.size(); ++part)
      sums[part] += scene.ship->lastTick().loads[part].cwiseAbs2();
  }
  for (Vec6& sum : sums) sum = (sum / ticks).cwiseSqrt();
  return sums;
}

/// Largest difference of two ships' loads, over the root mean square of the part's load in that
/// mode, or a thousandth of its largest of forces (of moments) where it has hardly any.
double difference(const Sailing& a, const Sailing& b, const std::vector<Vec6>& scale) {
  double worst = 0.0;
  for (std::size_t part = 0; part < scale.size(); ++part) {
    const Vec6 apart = a.ship->lastTick().loads[part] - b.ship->lastTick().loads[part];
    for (int j = 0; j < 6; ++j) {
      const double largest =
          j < 3 ? scale[part].head<3>().maxCoeff() : scale[part].tail<3>().maxCoeff();
      const double size = std::max(scale[part][j], 1e-3 * largest);
      if (size > 0.0) worst = std::max(worst, std::abs(apart[j]) / size);
    }
  }
  return worst;
}

// In the tick that takes the coming sea in, surface and loads are those of a ship without it, and
// in the next one the new sea has grown to 8e-9. A free ship that turns has some amplitudes renewed
// in each tick, for a heading that it will have when their turn comes again, which is later among
// more waves (PredictedMotion::follow); so free ships meet head seas here, in which they do not
// turn.
TEST(SetSeaIdentity, NothingJumpsWhereItBegins) {
  for (const Kind& kind : kKinds) {
    const bool turns = kind.mean == Mean::Fixed;
    const SeaState first = irregular(2.0, 1, turns), second = irregular(6.0, 2, turns);
    Sailing stays(kind, first), changes(kind, first);
    stays.run(640);
    changes.run(640);
    changes.seaway.setSea(second, 20.0);
    changes.seaway.waitForSea();
    EXPECT_TRUE(changes.seaway.seaIsChanging());
    Sailing sailing(kind, first);
    const std::vector<Vec6> scale = squaresOf(sailing, 640);
    for (int tick = 0; tick < (kind.mean == Mean::Fixed ? 2 : 1); ++tick) {
      stays.run(1);
      changes.run(1);
      EXPECT_EQ(changes.seaway.sea().components().size(), 60U);
      EXPECT_NEAR(changes.seaway.waveHeight(3.0, 4.0), stays.seaway.waveHeight(3.0, 4.0), 1e-7);
      EXPECT_LT(difference(stays, changes, scale), 1e-6) << kind.name;
    }
  }
}

// A sea that changes is one that was to change from the beginning. Amplitudes of a free ship are
// renewed at other times then, each within a thousandth: some millimetres of motions of metres,
// which its drift adds up.
TEST(SetSeaIdentity, IsASeaThatGoesOver) {
  if (!kDouble) GTEST_SKIP() << "differences of single precision grow";
  for (const Kind& kind : kKinds) {
    const SeaState first = irregular(2.0, 1), second = irregular(4.0, 2);
    Sailing changes(kind, first), planned(kind, first.goingOver(second, 320 * kT, 10.0));
    changes.run(320);
    changes.seaway.setSea(second, 10.0);
    changes.seaway.waitForSea();
    planned.run(320);
    double apart = 0.0;
    for (int i = 0; i < 20; ++i) {
      changes.run(32);
      planned.run(32);
      apart = std::max(apart, (changes.ship->position() - planned.ship->position()).norm());
    }
    EXPECT_LT(apart, kind.mean == Mean::Fixed ? 1e-6 : 1e-2) << kind.name;
    changes.run(320);
    planned.run(320);
    EXPECT_FALSE(changes.seaway.seaIsChanging());
    EXPECT_EQ(changes.seaway.sea().components().size(), 30U);
    EXPECT_LT((changes.ship->position() - planned.ship->position()).norm(),
              kind.mean == Mean::Fixed ? 1e-6 : 5e-2)
        << kind.name;
    EXPECT_EQ(changes.seaway.faults() & ~kWarningBits, kStepOk);
  }
}

// Where the old sea has gone, its waves leave without a jump.
TEST(SetSeaIdentity, NothingJumpsWhereItEnds) {
  for (const Kind& kind : kKinds) {
    Sailing changes(kind, irregular(2.0, 1));
    changes.run(64);
    changes.seaway.setSea(irregular(4.0, 2), 5.0);
    changes.seaway.waitForSea();
    changes.run(320);
    EXPECT_TRUE(changes.seaway.seaIsChanging());
    Sailing planned(kind, irregular(2.0, 1).goingOver(irregular(4.0, 2), 64 * kT, 5.0));
    const std::vector<Vec6> scale = squaresOf(planned, 640);
    // Loads of three ticks and the one after: what is beyond their parabola is of third order in
    // the tick, (ωh)³ = 2e-5 of the waves' loads, as it is in all other ticks.
    std::vector<std::vector<Vec6>> last;
    double usual = 0.0, atEnd = 0.0;
    for (int i = 0; i < 40; ++i) {
      changes.run(1);
      last.push_back(changes.ship->lastTick().loads);
      if (last.size() < 4) continue;
      const auto n = last.size();
      double beyond = 0.0;
      for (std::size_t part = 0; part < scale.size(); ++part) {
        const Vec6 rest = last[n - 1][part] - 3.0 * last[n - 2][part] + 3.0 * last[n - 3][part] -
                          last[n - 4][part];
        const double force = scale[part].head<3>().maxCoeff();
        if (force > 0.0) beyond = std::max(beyond, rest.head<3>().cwiseAbs().maxCoeff() / force);
      }
      const bool ends = changes.seaway.sea().components().size() == 30 && atEnd == 0.0;
      (ends ? atEnd : usual) = std::max(ends ? atEnd : usual, beyond);
    }
    EXPECT_GT(atEnd, 0.0) << kind.name;
    EXPECT_LT(atEnd, 2.0 * usual + 1e-6) << kind.name;
  }
}

TEST(SetSea, CalmWaterToStormAndBack) {
  for (const Kind& kind : kKinds) {
    Sailing scene(kind, SeaState());
    scene.run(64);
    scene.seaway.setSea(irregular(3.0, 4), 4.0);
    scene.seaway.waitForSea();
    scene.run(64 * 8);
    EXPECT_EQ(scene.seaway.sea().components().size(), 30U);
    scene.seaway.setSea(SeaState(), 4.0);
    scene.seaway.waitForSea();
    scene.run(64 * 8);
    EXPECT_FALSE(scene.seaway.seaIsChanging());
    EXPECT_EQ(scene.seaway.waveHeight(1.0, 2.0), 0.0);
    EXPECT_EQ(scene.seaway.faults() & ~kWarningBits, kStepOk);
  }
}

// Without waiting it begins by itself, at some tick.
TEST(SetSea, BeginsByItself) {
  Sailing scene(kKinds[1], irregular(1.0, 1));
  scene.seaway.setSea(irregular(3.0, 4), 1.0);
  for (int i = 0; i < 10000 && scene.seaway.seaIsChanging(); ++i) {
    scene.run(1);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  EXPECT_FALSE(scene.seaway.seaIsChanging());
  EXPECT_EQ(scene.seaway.sea().key(), irregular(3.0, 4).key());
}

TEST(SetSea, ShipsComeAndGoWhileItChanges) {
  Sailing scene(kKinds[1], irregular(1.0, 1));
  scene.seaway.setSea(irregular(3.0, 4), 3.0);
  Ship& second = scene.seaway.addShip(
      slenderShip(), {.start = {.y = 400.0, .speed = 3.0}, .model = {.mean = Mean::Free}});
  scene.run(64);
  Ship& third = scene.seaway.addShip(
      slenderShip(), {.start = {.y = 800.0, .speed = 3.0}, .model = {.mean = Mean::Free}});
  scene.run(32);
  scene.seaway.removeShip(second);
  scene.run(64 * 4);
  EXPECT_FALSE(scene.seaway.seaIsChanging());
  EXPECT_EQ(scene.seaway.faults() & ~kWarningBits, kStepOk);
  EXPECT_TRUE(third.position().allFinite());
  scene.seaway.setSea(irregular(2.0, 5), 3.0);  // and the end while tables are being made
}

TEST(SetSea, AChangeDuringAChange) {
  Sailing scene(kKinds[2], irregular(1.0, 1));
  for (const std::uint64_t seed : {2, 3, 4}) {
    scene.seaway.setSea(irregular(2.0, seed), 3.0);
    scene.seaway.waitForSea();
    scene.run(64);
  }
  EXPECT_EQ(scene.seaway.sea().components().size(), 120U);
  scene.run(64 * 4);
  EXPECT_EQ(scene.seaway.sea().key(), irregular(2.0, 4).key());
}

TEST(SetSea, SnapshotsBelongToTheirSea) {
  Sailing scene(kKinds[1], irregular(1.0, 1));
  const Seaway::Snapshot before = scene.seaway.save();
  scene.seaway.setSea(irregular(3.0, 4), 3.0);
  scene.seaway.waitForSea();
  EXPECT_THROW(scene.seaway.restore(before), HydroError);
  scene.run(20);
  const Seaway::Snapshot within = scene.seaway.save();
  scene.run(40);
  const Vec3 there = scene.ship->position();
  scene.seaway.restore(within);
  scene.run(40);
  EXPECT_EQ(scene.ship->position(), there);
}

TEST(SetSea, SeasThatDoNotFitAreRefused) {
  Sailing scene(kKinds[1], irregular(1.0, 1));
  EXPECT_THROW(scene.seaway.setSea(SeaState({{1.0, 1.0}}, 1.62), 5.0), HydroError);
  EXPECT_THROW(scene.seaway.setSea(irregular(2.0, 1), 0.0), HydroError);
  Sailing calm(kKinds[1], SeaState());
  EXPECT_THROW(calm.seaway.setSea(SeaState({{1.0, 1.0}}, 1.62), 5.0), HydroError);
  EXPECT_FALSE(calm.seaway.seaIsChanging());
}

// A world with y up, in centimetres: points, normals, velocities and the shader's waves are those
// of the sea.
TEST(SeaViewIdentity, IsTheSeaInTheWorldsAxesAndUnits) {
  TestWorld world(kSphereGravity);
  world.world.setGravity(btVector3(0, btScalar(-100.0 * kSphereGravity), 0));
  const WorldFrame frame{.up = WorldFrame::Up::Y, .metresPerUnit = 0.01, .seaLevel = 50.0};
  Seaway seaway(world.world, irregular(3.0, 7), frame);
  for (int i = 0; i < 64; ++i) world.world.stepSimulation(kTick, 1, kTick);
  SeaView view = seaway.view();
  view.update();
  EXPECT_EQ(view.time(), seaway.time());
  const std::vector<btVector3> places{{1000, -300, 500}, {-2000, 40, 700}, {300, 900, -4000}};
  std::vector<btVector3> surface(3), normal(3), velocity(3);
  std::vector<btScalar> pressure(3);
  const auto& waves = view.waves(places[0]);
  std::thread([&] { view.at(places, {surface, normal, velocity, pressure}); }).join();
  // Single precision in sums and in Bullet: of 40 m in units of a centimetre.
  const double close = kDouble ? 2e-3 : 2e-2;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 at = frame.placeToEarth(places[i]);
    const double zeta = seaway.sea().elevation(view.time(), at.x(), at.y());
    EXPECT_NEAR(surface[i].y(), 50.0 + 100.0 * zeta, close);
    EXPECT_NEAR(surface[i].distance(seaway.waterAt(places[i])), 0.0, close);
    EXPECT_NEAR(normal[i].length(), 1.0, 1e-6);
    const double h = 1e-4;
    const double slope = (seaway.sea().elevation(view.time(), at.x() + h, at.y()) - zeta) / h;
    EXPECT_NEAR(-normal[i].x() / normal[i].y(), slope, 1e-4);
    EXPECT_EQ(pressure[i] > 0, at.z() < zeta);
    double sum = 0.0;
    for (const SeaView::Wave& w : waves) {
      const double dx = places[i].x() - places[0].x(), dz = places[i].z() - places[0].z();
      sum += static_cast<double>(w.amplitude) *
             std::cos(static_cast<double>(w.phase) - static_cast<double>(w.kx) * dx -
                      static_cast<double>(w.ky) * dz);
    }
    EXPECT_NEAR(sum, 100.0 * zeta, 2e-2);  // floats: k d of 30 rad to 1e-6, of 300 cm
  }
}

}  // namespace
}  // namespace cutwater::test
