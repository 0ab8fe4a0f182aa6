// Weights and flooded compartments of a box that floats, against equilibria and motions worked out
// here by other means.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "hydro/forces/nonlinear/CarriedLoad.h"
#include "hydro/geometry/shapes/Shapes.h"
#include "tests/plugin/Shore.h"
#include "tests/plugin/TestScene.h"
#include "tests/support/BareHull.h"
#include "tests/support/Refusal.h"
#include "tests/support/Results.h"

namespace cutwater::test {
namespace {

constexpr const char* kTopic = "23 Loading and flooding";
constexpr BoxShape kBox{20.0, 8.0, 2.0, 2.5};  // [m]
constexpr btScalar kStep = btScalar(1) / 60;
const Vec3 kCog(0.0, 0.0, -0.2);

// Damped so that it comes to rest within a minute or two; damping shifts no equilibrium.
std::shared_ptr<const Hydrodynamics> floatingBox(double damping) {
  Coefficients c = bareCoefficients(
      {.closed = closedBox(kBox, 10, 4, 4), .cog = kCog, .gyradii = Vec3(2.6, 6.0, 6.2)});
  const Vec6 inertia = c.ship.massMatrix().diagonal();
  c.ship.supplementary.damping = damping * inertia;
  return std::make_shared<const Hydrodynamics>(std::move(c));
}
std::shared_ptr<const Hydrodynamics> damped() {
  static const auto ship = floatingBox(1.5);
  return ship;
}
std::shared_ptr<const Hydrodynamics> undamped() {
  static const auto ship = floatingBox(0.0);
  return ship;
}

// Volume and first moment of a box of which the columns along z are filled up to up·x = height:
// up.z > 0. 400 by 400 columns: to some 1e-5 where the surface meets an edge.
struct Filled {
  double volume = 0.0;
  Vec3 moment = Vec3::Zero();
};
Filled filled(const Vec3& centre, const Vec3& size, const Vec3& up, double height) {
  constexpr int kCells = 400;
  Filled sum;
  const double cell = size.x() * size.y() / (kCells * kCells);
  const double low = centre.z() - 0.5 * size.z();
  for (int i = 0; i < kCells; ++i) {
    const double x = centre.x() + size.x() * ((i + 0.5) / kCells - 0.5);
    for (int j = 0; j < kCells; ++j) {
      const double y = centre.y() + size.y() * ((j + 0.5) / kCells - 0.5);
      const double top = (height - up.x() * x - up.y() * y) / up.z();
      const double h = std::clamp(top - low, 0.0, size.z());
      sum.volume += cell * h;
      sum.moment += cell * h * Vec3(x, y, low + 0.5 * h);
    }
  }
  return sum;
}

double heightOf(const Vec3& centre, const Vec3& size, const Vec3& up, double volume) {
  double low = -20.0, high = 20.0;
  for (int i = 0; i < 45; ++i) {
    const double middle = 0.5 * (low + high);
    (filled(centre, size, up, middle).volume < volume ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

// What floats: hull, a weight, and water in a room, to a volume or open to the sea.
struct Afloat {
  double mass = 0.0, density = 0.0;
  double weight = 0.0;
  Vec3 at = Vec3::Zero();
  CompartmentBox room{};
  double volume = 0.0;
  bool open = false;
};
struct Rest {
  double height = 0.0, roll = 0.0, pitch = 0.0;  // of G [m], [rad]
};

// Forces along up and moments about x and y of the hull, by weight: zero at rest.
Vec3 unbalance(const Afloat& ship, const Vec3& at) {
  const double roll = at[1], pitch = at[2];
  const Vec3 up(-std::sin(pitch), std::cos(pitch) * std::sin(roll),
                std::cos(pitch) * std::cos(roll));
  const double sea = up.dot(kCog) - at[0];  // of calm water, along up from the hull's origin
  const Vec3 hullCentre(0.0, 0.0, 0.5 * (kBox.freeboard - kBox.draft));
  const Vec3 hullSize(kBox.length, kBox.breadth, kBox.draft + kBox.freeboard);
  const Filled water = filled(hullCentre, hullSize, up, sea);
  Filled inside;
  if (ship.open) {
    inside = filled(ship.room.centre, ship.room.size, up, sea);
  } else if (ship.volume > 0.0) {
    const double geometric = ship.volume / ship.room.permeability;
    inside = filled(ship.room.centre, ship.room.size, up,
                    heightOf(ship.room.centre, ship.room.size, up, geometric));
  }
  const double mu = ship.room.permeability;
  const double lift = ship.density * (water.volume - mu * inside.volume) - ship.mass - ship.weight;
  const Vec3 moment =
      ship.density * (water.moment - mu * inside.moment) - ship.mass * kCog - ship.weight * ship.at;
  const Vec3 turn = moment.cross(up);
  return Vec3(lift, turn.x(), turn.y()) / ship.mass;
}

Rest atRest(const Afloat& ship) {
  Vec3 at(kCog.z(), 0.0, 0.0);
  for (int i = 0; i < 30; ++i) {
    const Vec3 off = unbalance(ship, at);
    Mat3 slope;
    for (int k = 0; k < 3; ++k)
      slope.col(k) = (unbalance(ship, at + 1e-4 * Vec3::Unit(k)) - off) / 1e-4;
    Vec3 step = -slope.inverse() * off;
    const double most = step.cwiseAbs().maxCoeff();
    if (most > 0.1) step *= 0.1 / most;
    at += step;
    if (most < 1e-9) break;
  }
  return {at[0], at[1], at[2]};
}

Afloat boxAfloat() {
  const ShipParticulars& ship = damped()->ship();
  return {.mass = ship.mass, .density = ship.density};
}

void settle(Shore& shore, double seconds) { shore.run(seconds, kStep, 2); }

// Keel under water at the middle of the hull [m], trim and heel [rad], to 0.1 % of the draught, and
// of the angle.
void expectRest(Shore& shore, const Rest& rest, const char* what) {
  const Vec3 now = shore.ship.attitude();
  const auto draught = [&](double height, double roll, double pitch) {
    const Vec3 up(-std::sin(pitch), std::cos(pitch) * std::sin(roll),
                  std::cos(pitch) * std::cos(roll));
    return -(height + up.dot(Vec3(0.0, 0.0, -kBox.draft) - kCog));
  };
  const double right = draught(rest.height, rest.roll, rest.pitch);
  const double there = draught(shore.ship.position().z(), now.x(), now.y());
  EXPECT_NEAR(there, right, 1e-3 * right);
  EXPECT_NEAR(now.x(), rest.roll, 1e-3 * std::abs(rest.roll) + 1e-5);
  EXPECT_NEAR(now.y(), rest.pitch, 1e-3 * std::abs(rest.pitch) + 1e-5);
  char line[120];
  std::snprintf(line, sizeof line, "draught %.4f m, heel %.3f, trim %.3f deg", right,
                rest.roll * 180.0 / kPi, rest.pitch * 180.0 / kPi);
  const double worst =
      std::max({std::abs(there / right - 1.0),
                std::abs(now.x() - rest.roll) / std::max(0.01, std::abs(rest.roll)),
                std::abs(now.y() - rest.pitch) / std::max(0.01, std::abs(rest.pitch))});
  std::printf("%s: %s, off %.2e\n", what, line, worst);
  recordResult(kTopic, withPrecision(std::string(what) + ": " + line), "equilibrium by hand", worst,
               "1e-3");
}

const CompartmentBox kRoom{
    .name = "wing", .centre = {4.0, 2.0, -0.25}, .size = {5.0, 3.0, 3.0}, .permeability = 0.85};

TEST(FloodingClosedForm, AWeightHeelsTrimsAndSinks) {
  Shore shore(damped(), {});
  shore.ship.setWeights({{.name = "crate", .mass = 20e3, .place = {5.0, 1.5, 2.0}}});
  settle(shore, 120.0);
  Afloat ship = boxAfloat();
  ship.weight = 20e3;
  ship.at = Vec3(5.0, 1.5, 2.0);
  expectRest(shore, atRest(ship), "a weight of 20 t");
  EXPECT_EQ(shore.seaway.faults(), kStepOk);
  EXPECT_NEAR(shore.ship.loading().mass, ship.mass + 20e3, 1e-6);
}

TEST(FloodingClosedForm, AGivenVolumeInARoomToOneSide) {
  Shore shore(damped(), {});
  Compartment& room = shore.ship.addCompartment(kRoom);
  room.setRate(0.5);
  while (room.volume() < 18.0) shore.tick(kStep);
  room.setRate(0.0);
  room.setVolume(18.0);
  settle(shore, 120.0);
  Afloat ship = boxAfloat();
  ship.room = kRoom;
  ship.volume = 18.0;
  expectRest(shore, atRest(ship), "18 m3 in a wing compartment");
}

TEST(FloodingClosedForm, ARoomOpenToTheSea) {
  Shore shore(damped(), {});
  Compartment& room = shore.ship.addCompartment(kRoom);
  room.openTo({.place = {4.0, 3.5, -1.7}, .area = 0.2});
  settle(shore, 240.0);
  Afloat ship = boxAfloat();
  ship.room = kRoom;
  ship.open = true;
  expectRest(shore, atRest(ship), "a wing compartment open to the sea");
  EXPECT_NEAR(room.level(), 0.0, 1e-4);  // as high as the sea
}

// Small rolls about upright: (GM_fluid/GM_solid)^1/2, GM_fluid = GM_solid - i/V of the ship and its
// water. The inertia is the same in both.
double rollPeriod(bool freeSurface) {
  Shore shore(undamped(), {.start = {.offset = one(Roll, 0.01)}});
  shore.ship.addCompartment({.name = "hold",
                             .centre = {0.0, 0.0, -0.8},
                             .size = {8.0, 6.0, 2.0},
                             .volume = 40.0,
                             .freeSurface = freeSurface});
  // Afloat at the depth of what it carries.
  ShipStart start;
  start.offset = one(Roll, 0.01);
  start.offset[Heave] = -40.0 / (kBox.length * kBox.breadth);
  shore.ship.reset(start);
  double first = 0.0, before = 0.01;
  int crossings = 0;
  while (crossings < 13) {
    shore.tick(kStep);
    const double roll = shore.ship.attitude().x(), now = shore.seaway.time();
    if (roll * before < 0.0) {
      const double at = now - static_cast<double>(kStep) * roll / (roll - before);
      if (++crossings == 1) first = at;
      if (crossings == 13) return (at - first) / 6.0;
    }
    before = roll;
    if (now > 200.0) break;
  }
  return 0.0;
}

TEST(FloodingClosedForm, AFreeSurfaceLengthensTheRoll) {
  const double volume = kBox.length * kBox.breadth * kBox.draft + 40.0;
  const double draught = volume / (kBox.length * kBox.breadth);
  const double mass = volume - 40.0;
  const double height = kBox.draft + kCog.z();  // of G over the keel
  // Water of 40 m³ on 48 m², from 0.2 m over the keel.
  const double kg = (mass * height + 40.0 * (0.2 + 0.5 * 40.0 / 48.0)) / volume;
  const double inertia = kBox.length * std::pow(kBox.breadth, 3) / 12.0;
  const double solid = 0.5 * draught + inertia / volume - kg;
  const double fluid = solid - 8.0 * std::pow(6.0, 3) / 12.0 / volume;
  const double ratio = rollPeriod(true) / rollPeriod(false), expected = std::sqrt(solid / fluid);
  std::printf("roll period, free surface over none: %.5f expected %.5f\n", ratio, expected);
  recordResult(kTopic, withPrecision("roll period with a free surface over that without"),
               "(GM/(GM - i/V))^1/2", ratio / expected - 1.0, "5e-3");
  // Added mass depends on frequency in the memory of the bare hull: a few parts in a thousand.
  EXPECT_NEAR(ratio, expected, 5e-3 * expected);
}

// A room across the whole ship without a hole: it sinks by what it holds, V/(L B).
TEST(FloodingClosedForm, SymmetricalFloodingSinksByTheWaterplane) {
  Shore shore(damped(), {});
  shore.ship.addCompartment({.name = "hold", .size = {4.0, 4.0, 3.0}, .volume = 16.0});
  settle(shore, 90.0);
  EXPECT_NEAR(kCog.z() - shore.ship.position().z(), 16.0 / (kBox.length * kBox.breadth), 1e-5);
  EXPECT_NEAR(shore.ship.attitude().norm(), 0.0, 1e-5);
}

// With G so high, by a weight on a mast, that GM < 0, it turns over.
TEST(Flooding, CapsizesWhereGmIsNegative) {
  Shore shore(damped(), {.start = {.offset = one(Roll, 0.01)}});
  const ShipParticulars& p = shore.particulars;
  // BM 2.67, KB 1, KG 1.8: 20 % of the mass 14 m over the keel brings G above M.
  shore.ship.setWeights({{.name = "mast", .mass = 0.2 * p.mass, .place = {0, 0, 12}}});
  settle(shore, 120.0);
  EXPECT_GT(std::abs(shore.ship.attitude().x()), 0.5 * kPi);
  EXPECT_EQ(shore.seaway.faults() & ~kWarningBits, 0u);
}

// Holed along its whole length it goes down, and it is said.
TEST(Flooding, Founders) {
  Shore shore(damped(), {});
  for (const double x : {-6.0, 0.0, 6.0}) {
    Compartment& room = shore.ship.addCompartment(
        {.name = "hold", .centre = {x, 0.0, 0.25}, .size = {6.0, 7.8, 4.3}, .permeability = 0.95});
    room.openTo({.place = {x, 3.9, -1.5}, .area = 0.3});
  }
  shore.ship.setWeights({{.name = "ore", .mass = 40e3, .place = {0, 0, -1.5}}});
  double sinks = 0.0;
  while (shore.seaway.time() < 600.0 && !shore.ship.foundered()) shore.tick(kStep);
  EXPECT_TRUE(shore.ship.foundered());
  std::printf("founders at %.1f s\n", shore.seaway.time());
  sinks = shore.ship.position().z();
  shore.run(30.0, kStep);
  EXPECT_LT(shore.ship.position().z(), sinks - 5.0);
  EXPECT_EQ(shore.seaway.faults() & ~kWarningBits, 0u);
  EXPECT_NE(shore.seaway.faults() & kFoundered, 0u);
  EXPECT_TRUE(shore.ship.position().allFinite());
}

// Deck edge under water: the pressure above the deck presses on it. A box held at a heel has the
// buoyancy of what of it is under water, deck and all.
TEST(FloodingClosedForm, WaterOverTheDeckEdgePressesOnIt) {
  const double roll = 0.6;  // the edge is 0.4 m under water
  Shore shore(undamped(), {.start = {.offset = one(Roll, roll)}});
  shore.tick(kStep);
  const Vec3 up(0.0, std::sin(roll), std::cos(roll));
  const Filled water =
      filled(Vec3(0.0, 0.0, 0.25), Vec3(kBox.length, kBox.breadth, kBox.draft + kBox.freeboard), up,
             up.dot(kCog) - kCog.z());
  const ShipParticulars& p = shore.particulars;
  const double force = p.density * p.gravity * water.volume;
  const Vec6& load = shore.ship.load("wetted_pressure");
  EXPECT_NEAR(load[Heave], force, 1e-4 * force);
  // About G: the lever across, with the deck's part in it.
  const double lever = (water.moment / water.volume - kCog).cross(up).x();
  EXPECT_NEAR(load[Roll], force * lever, 1e-3 * force);
}

// The composite of hull and weight without any water: its centre of gravity goes straight on, and
// it turns by Euler's equations.
struct Composite {
  MassMoments moments;
  Mat3 inertia;  // about its own centre
  Vec3 arm;
};
Composite composite(const ShipParticulars& ship, const Weight& weight) {
  Composite all;
  all.moments = MassMoments::of(ship.mass, Vec3::Zero(), ship.gyradii);
  all.moments.add(MassMoments::of(weight.mass, weight.place - ship.cog, weight.gyradii));
  all.arm = all.moments.first / all.moments.mass;
  all.inertia = all.moments.second - MassMoments::of(all.moments.mass, all.arm).second;
  return all;
}

std::vector<std::string> allOfTheWater() {
  return {"wetted_pressure", "restoring",     "froude_krylov", "diffraction", "radiation",
          "added_mass",      "supplementary", "autopilots",    "hull_lift",   "resistance"};
}

ShipSettings without(const std::vector<std::string>& names) {
  ShipSettings settings;
  settings.model.without = names;
  return settings;
}

// In E, with the attitude of the tick in which the velocity was solved for.
Vec3 momentumOf(const Ship& ship, const MassMoments& moments, const Mat3& attitude) {
  const Vec6 v = velocityOf(ship.body());
  return moments.mass * v.head<3>() + v.tail<3>().cross(attitude * moments.first);
}

struct Spin {
  double attitude, place, momentum, energy;  // largest errors
};
Spin spin(btScalar step) {
  const ShipParticulars& p = undamped()->ship();
  TestWorld world(0.0);
  Seaway seaway(world.world);
  Ship& ship = seaway.addShip(undamped(), without(allOfTheWater()));
  const Weight weight{.name = "crate",
                      .mass = 0.3 * p.mass,
                      .place = p.cog + Vec3(6.0, 2.5, 1.5),
                      .gyradii = Vec3(1.0, 0.5, 0.7)};
  ship.setWeights({weight});
  const Composite all = composite(p, weight);
  const Vec3 speed(1.0, -0.5, 0.3), rate(0.3, 0.2, -0.25);
  ship.resetVelocity(speed, rate);
  // Reference: RK4 of R' = R [w], I w' = -w x I w, in B.
  Mat3 R = Mat3::Identity();
  Vec3 w = rate;
  const Vec3 centre0 = ship.position() + all.arm, drift = speed + rate.cross(all.arm);
  const Vec3 inertial = all.inertia * rate;
  const double energy0 = 0.5 * rate.dot(inertial) + 0.5 * all.moments.mass * drift.squaredNorm();
  Spin worst{};
  const double h = static_cast<double>(step);
  const Mat3 inverse = all.inertia.inverse();
  const auto turning = [&](const Vec3& v) { return Vec3(-inverse * v.cross(all.inertia * v)); };
  for (int i = 1; h * i <= 20.0; ++i) {
    const Mat3 before = fromBullet(ship.body().getWorldTransform().getBasis());
    world.world.stepSimulation(step, 1, step);
    const Vec3 k1 = turning(w), k2 = turning(w + 0.5 * h * k1), k3 = turning(w + 0.5 * h * k2),
               k4 = turning(w + h * k3);
    const Vec3 next = w + h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
    const Vec3 middle = w + 0.5 * h * k2;
    const Vec3 mean = (w + 4.0 * middle + next) / 6.0;
    R = R * Eigen::AngleAxisd(h * mean.norm(), mean.normalized()).toRotationMatrix();
    w = next;
    const Mat3 there = fromBullet(ship.body().getWorldTransform().getBasis());
    worst.attitude = std::max(worst.attitude, (there - R).norm());
    const Vec3 centre = ship.position() + there * all.arm;
    worst.place = std::max(worst.place, (centre - centre0 - h * i * drift).norm());
    const Vec3 momentum = momentumOf(ship, all.moments, before);
    worst.momentum = std::max(worst.momentum, (momentum / all.moments.mass - drift).norm());
    const Vec6 v = ship.velocity();
    const double energy = 0.5 * v.dot(all.moments.matrix() * v);
    worst.energy = std::max(worst.energy, std::abs(energy / energy0 - 1.0));
  }
  return worst;
}

// Errors of the first order in the tick, that go with it.
TEST(LoadingConvergence, WithoutWaterItTurnsAsTheCompositeBody) {
  const Spin coarse = spin(btScalar(1) / 64), fine = spin(btScalar(1) / 256);
  for (const Spin& s : {coarse, fine})
    std::printf("attitude %.3e place %.3e momentum %.3e energy %.3e\n", s.attitude, s.place,
                s.momentum, s.energy);
  EXPECT_LT(fine.attitude, 0.02);
  EXPECT_LT(fine.attitude, 0.35 * coarse.attitude + 1e-4);
  EXPECT_LT(fine.place, 0.02);
  // Momentum, of a body of 300 t, is what a velocity of 1 m/s is to the last digits.
  EXPECT_LT(fine.momentum, 1e4 * kEpsilon);
  EXPECT_LT(fine.energy, 0.01);
  recordResult(kTopic, withPrecision("composite body without water, attitude off in 20 s"),
               "Euler's equations", fine.attitude, "0.02");
}

// Level momentum at 5 m/s without the water's forces: what comes in at rest slows it down and keeps
// the momentum; what leaves takes its own; what moves about on board changes nothing.
TEST(LoadingClosedForm, MomentumGoesWithTheMass) {
  const ShipParticulars& p = undamped()->ship();
  TestWorld world(0.0);
  Seaway seaway(world.world);
  Ship& ship = seaway.addShip(undamped(), without(allOfTheWater()));
  Compartment& hold =
      ship.addCompartment({.name = "hold", .centre = p.cog, .size = {4.0, 4.0, 3.0}});
  ship.resetVelocity(Vec3(5.0, 0.0, 0.0), Vec3::Zero());
  const auto tick = [&] { world.world.stepSimulation(kTick, 1, kTick); };
  const auto moments = [&] {
    MassMoments all = MassMoments::of(p.mass, Vec3::Zero(), p.gyradii);
    for (const Weight& w : ship.weights()) all.add(MassMoments::of(w.mass, w.place - p.cog));
    return all.add(MassMoments::of(hold.mass(), hold.centre() - p.cog));
  };
  Mat3 attitude = Mat3::Identity();
  const auto ahead = [&](int ticks) {  // momentum after so many
    for (int i = 0; i < ticks; ++i) {
      attitude = fromBullet(ship.body().getWorldTransform().getBasis());
      tick();
    }
    return momentumOf(ship, moments(), attitude).x();
  };
  const double digits = 1e3 * kEpsilon;  // some tens of ticks of numbers of Bullet's
  EXPECT_NEAR(ahead(10), 5.0 * p.mass, digits * 5.0 * p.mass);
  hold.setVolume(40.0);
  const double held = ahead(10);
  EXPECT_NEAR(held, 5.0 * p.mass, digits * 5.0 * p.mass);
  EXPECT_NEAR(ship.loading().mass, p.mass + 1025.0 * 40.0, 1.0);
  // A quarter of the water goes, with its speed.
  const double speed = held / ship.loading().mass;
  hold.setVolume(30.0);
  EXPECT_NEAR(ahead(1), held - speed * 1025.0 * 10.0, 0.01 * speed * 1025.0 * 10.0);
  // Put on board gently, moved, and set down again.
  hold.setVolume(0.0);
  tick();
  ship.resetVelocity(Vec3(5.0, 0.0, 0.0), Vec3::Zero());
  tick();
  ship.setWeights({{.name = "crate", .mass = 30e3, .place = p.cog}});
  EXPECT_NEAR(ahead(1), 5.0 * (p.mass + 30e3), digits * 5.0 * p.mass);
  ship.setWeights({{.name = "crate", .mass = 30e3, .place = p.cog + Vec3(3.0, 0.0, 0.0)}});
  EXPECT_NEAR(ahead(1), 5.0 * (p.mass + 30e3), digits * 5.0 * p.mass);
  // From a place that turns with the ship, by what is left of the water's turning: 1e-8 of it.
  ship.setWeights({});
  EXPECT_NEAR(ahead(1), 5.0 * p.mass, std::max(digits, 1e-8) * 5.0 * p.mass);
}

// The first weight of all, put on board gently after the ship has turned by 86 degrees: as a ship
// that had one of a gram from the start. Nothing changes but for what a tick of 1/64 s turns.
TEST(LoadingIdentity, TheFirstWeightIsPutDownWhereTheShipHasTurnedTo) {
  TestWorld world(0.0);
  Seaway seaway(world.world);
  Ship& ship = seaway.addShip(undamped(), without(allOfTheWater()));
  ship.resetVelocity(Vec3(5.0, 0.0, 0.0), Vec3(0.0, 0.0, 0.3));
  for (int i = 0; i < 320; ++i) world.world.stepSimulation(kTick, 1, kTick);
  ship.setWeights({{.name = "crate", .mass = 50e3, .place = Vec3(8.0, 0.0, 0.0)}});
  for (int i = 0; i < 2; ++i) world.world.stepSimulation(kTick, 1, kTick);
  const Vec6 after = ship.velocity();
  EXPECT_NEAR(after[Yaw], 0.3, 0.002);
  EXPECT_NEAR(after.head<2>().norm(), 5.0, 0.02);
}

// What is put in and taken out again between two ticks has not been on board.
TEST(LoadingIdentity, VolumesThatNoTickHasFeltHaveNoMomentum) {
  const ShipParticulars& p = undamped()->ship();
  TestWorld world(0.0);
  Seaway seaway(world.world);
  Ship& ship = seaway.addShip(undamped(), without(allOfTheWater()));
  const auto tick = [&] { world.world.stepSimulation(kTick, 1, kTick); };
  ship.setWeights({{.name = "crate", .mass = 1e3, .place = p.cog}});
  ship.resetVelocity(Vec3(5.0, 0.0, 0.0), Vec3::Zero());
  tick();
  Compartment& hold = ship.addCompartment(
      {.name = "hold", .centre = p.cog, .size = {4.0, 4.0, 3.0}, .volume = 30.0});
  hold.setVolume(0.0);
  tick();
  EXPECT_NEAR(ship.velocity()[Surge], 5.0, 1e4 * kEpsilon);
  hold.setVolume(20.0);
  tick();
  const double held = ship.velocity()[Surge];
  hold.setVolume(40.0);
  hold.setVolume(20.0);
  tick();
  // What a tick changes of it anyway, 1e-7: the water lies below G and turns the ship a little. Of
  // 20 t that came in at rest and left at 4.7 m/s it would be 0.2 m/s.
  EXPECT_NEAR(ship.velocity()[Surge], held, 1e-5);
}

// Rolling without radiation, lift and drag, energy stays: it swings by 45 J without cargo, which is
// what ticks of 1/60 s leave of 200 kJ. Cargo that counted its height from another point than the
// ship's G, 0.2 m off, would add 1.7 kJ.
TEST(LoadingIdentity, EnergyOfARollingShipWithCargoStays) {
  Shore shore(undamped(), [] {
    ShipSettings settings = without({"radiation", "hull_lift", "resistance", "autopilots"});
    settings.start.offset = one(Roll, 0.3);
    return settings;
  }());
  const ShipParticulars& p = undamped()->ship();
  shore.ship.setWeights({{.name = "cargo", .mass = 20e3, .place = p.cog + Vec3(0.0, 0.0, 0.5)}});
  for (int i = 0; i < 120; ++i) shore.tick(kStep);
  double low = HUGE_VAL, high = -HUGE_VAL, swing = 0.0;
  for (int i = 0; i < 400; ++i) {
    shore.tick(kStep);
    low = std::min(low, shore.ship.energy());
    high = std::max(high, shore.ship.energy());
    swing = std::max(swing, std::abs(shore.ship.attitude().x()));
  }
  EXPECT_GT(swing, 0.2);
  EXPECT_LT(high - low, 200.0);
}

// A sailing, rolling ship with weights and open compartments goes on with the same bits, also after
// a change of what it carries, and from bytes.
TEST(LoadingIdentity, ASnapshotGoesOnWithTheSameBits) {
  Shore shore(undamped(), {.start = {.speed = 2.0, .offset = one(Roll, 0.1)}});
  Compartment& room = shore.ship.addCompartment(kRoom);
  room.openTo({.place = {4.0, 3.5, -1.7}, .area = 0.05});
  shore.ship.setWeights({{.name = "crate", .mass = 5e3, .place = {-5.0, 1.0, 2.0}}});
  shore.run(5.0, kStep);
  const Seaway::Snapshot snapshot = shore.seaway.save();
  const auto goOn = [&] {
    shore.run(2.0, kStep);
    shore.ship.setWeights({{.name = "crate", .mass = 4e3, .place = {-5.0, -1.0, 2.0}},
                           {.name = "more", .mass = 1e3, .place = {5.0, -1.0, 2.0}}});
    room.setRate(0.02);
    shore.run(3.0, kStep);
    return std::make_pair(shore.ship.body().getWorldTransform(), room.volume());
  };
  const auto first = goOn();
  shore.seaway.restore(snapshot);
  EXPECT_EQ(shore.ship.weights().size(), 1u);
  EXPECT_EQ(shore.ship.weights()[0].name, "crate");
  const auto second = goOn();
  shore.seaway.restore(Seaway::Snapshot::fromBytes(snapshot.toBytes()));
  const auto third = goOn();
  for (const auto& other : {second, third}) {
    EXPECT_EQ(other.second, first.second);
    for (int i = 0; i < 3; ++i) {
      EXPECT_EQ(other.first.getOrigin()[i], first.first.getOrigin()[i]);
      for (int k = 0; k < 3; ++k)
        EXPECT_EQ(other.first.getBasis()[i][k], first.first.getBasis()[i][k]);
    }
  }
}

// What the column added_mass holds is the water's alone: without added mass, none.
TEST(LoadingClosedForm, AddedMassIsTheWatersAlone) {
  Coefficients c = bareCoefficients({.closed = closedBox(kBox, 10, 4, 4),
                                     .cog = kCog,
                                     .gyradii = Vec3(2.6, 6.0, 6.2),
                                     .share = Vec6::Constant(1e-9)});
  Shore shore(std::make_shared<const Hydrodynamics>(std::move(c)),
              {.start = {.offset = one(Roll, 0.2)}});
  shore.ship.setWeights({{.name = "crate", .mass = 20e3, .place = {5.0, 1.5, 2.0}}});
  shore.run(1.0, kStep);
  const Vec6& load = shore.ship.load("added_mass");
  EXPECT_LT(load.head<3>().norm(), 2e-5 * shore.weight());
  EXPECT_LT(load.tail<3>().norm(), 2e-5 * shore.weight() * kBox.breadth);
}

// In linear mode it settles by C, and a weight beyond 5 % of the ship's is said.
TEST(LoadingClosedForm, LinearModeTakesSmallWeights) {
  ShipSettings settings;
  settings.model.mode = HullPressure::Linear;
  Shore shore(damped(), settings);
  const ShipParticulars& p = shore.particulars;
  shore.ship.setWeights({{.name = "crate", .mass = 0.02 * p.mass, .place = p.cog}});
  settle(shore, 90.0);
  EXPECT_NEAR(p.cog.z() - shore.ship.position().z(), 0.02 * kBox.draft, 1e-4 * kBox.draft);
  EXPECT_EQ(shore.seaway.faults(), kStepOk);
  shore.ship.setWeights({{.name = "crate", .mass = 0.06 * p.mass, .place = p.cog}});
  shore.tick(kStep);
  EXPECT_EQ(shore.seaway.faults(), kLoadedBeyondLinear);
}

TEST(LoadingRefusals, NameWeightFieldAndValue) {
  Shore shore(damped(), {});
  expectRefusal(Fault::ValueOutOfRange, {"Ship::setWeights", "\"fuel\"", "mass = -1"},
                [&] { shore.ship.setWeights({{.name = "fuel", .mass = -1.0}}); });
  expectRefusal(Fault::BadArgument, {"two weights", "\"fuel\""}, [&] {
    shore.ship.setWeights({{.name = "fuel"}, {.name = "fuel"}});
  });
  expectRefusal(Fault::ValueOutOfRange, {"compartment \"hold\"", "size[0]"},
                [&] { shore.ship.addCompartment({.name = "hold"}); });
  EXPECT_FALSE(hasPart(shore.ship, "loading"));  // nothing is left of it
}

}  // namespace
}  // namespace cutwater::test
