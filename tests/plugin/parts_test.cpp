// The load as a list of parts: the user's own, parts switched off, their state, cost and columns.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "hydro/Errors.h"
#include "hydro/forces/Hydrodynamics.h"
#include "hydro/forces/linear/Autopilots.h"
#include "plugin/Recorder.h"
#include "tests/plugin/TestScene.h"

namespace cutwater::test {
namespace {

// A steady wrench of any axes.
class Steady : public ForceGenerator {
 public:
  Steady(const Vec6& load, Axes axes, std::string_view name = "steady")
      : wrench_{load, axes}, name_(name) {}
  std::string_view name() const noexcept override { return name_; }
  Wrench evaluate(const TickInput&) noexcept override { return wrench_; }

 private:
  Wrench wrench_;
  std::string_view name_;
};

// A pull that grows from tick to tick: a part with a state.
class Growing final : public ForceGenerator {
 public:
  std::string_view name() const noexcept override { return "growing"; }
  Wrench evaluate(const TickInput& now) noexcept override {
    pull_ += 1e4 * now.step;
    Wrench wrench;
    wrench.load[Surge] = pull_;
    return wrench;
  }
  void reset() noexcept override { pull_ = 0.0; }
  std::size_t stateSize() const noexcept override { return 1; }
  void save(std::span<double> state) const noexcept override { state[0] = pull_; }
  void restore(std::span<const double> state) noexcept override { pull_ = state[0]; }

 private:
  double pull_ = 0.0;  // [N]
};

// Carries the ship as a spring of its own does.
class Float final : public ForceGenerator {
 public:
  std::string_view name() const noexcept override { return "float"; }
  bool carriesWeight() const noexcept override { return true; }
  std::span<const std::string_view> replaces() const noexcept override { return kReplaced; }
  Wrench evaluate(const TickInput& now) noexcept override {
    Wrench wrench;
    wrench.load[Heave] = -2e5 * now.eta[Heave];
    wrench.load.head<3>() -= now.weight;
    return wrench;
  }

 private:
  static constexpr std::array<std::string_view, 1> kReplaced{"restoring"};
};

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

// Keeps the arrows that begin in a ship's centre of gravity.
struct Arrows final : LineDrawer {
  explicit Arrows(const Ship& ship) : middle(toBullet(ship.position())) {}
  void drawLine(const btVector3& from, const btVector3& to, const btVector3&) override {
    if (from == middle) arrows.push_back(fromBullet(to - from));
  }
  btVector3 middle;
  std::vector<Vec3> arrows;
};

TEST(Parts, AreListedInTheOrderOfTheColumns) {
  std::vector<std::string_view> expected{"gravity",   "restoring",  "froude_krylov", "diffraction",
                                         "radiation", "added_mass", "supplementary", "autopilots"};
  EXPECT_EQ(Scene({.model = {.mean = Mean::Fixed}}).sphere->parts(), expected);
  EXPECT_EQ(Scene({.model = {.hullLift = false, .resistance = false}}).sphere->parts(), expected);
  Scene scene;
  expected.emplace_back("hull_lift");
  expected.emplace_back("resistance");
  EXPECT_EQ(scene.sphere->parts(), expected);
  scene.sphere->addForce(std::make_unique<Growing>());
  EXPECT_EQ(scene.sphere->parts().back(), "growing");
}

// The weight would be an arrow of 100 m. With the part that carries it, restoring or another in
// restoring's place, only what is left of both is drawn; without any the weight is.
TEST(Parts, GravityIsDrawnWithThePartThatCarriesTheShip) {
  for (const bool replaced : {false, true}) {
    Scene scene({.start = {.offset = one(Heave, 0.1)}});
    if (replaced) scene.sphere->addForce(std::make_unique<Float>());
    scene.run(1);
    Arrows pen(*scene.sphere);
    scene.seaway.debugDraw(pen);
    const std::size_t carrier = scene.sphere->weightCarrier();
    ASSERT_EQ(scene.sphere->parts()[carrier], replaced ? "float" : "restoring");
    ASSERT_EQ(pen.arrows.size(), scene.sphere->parts().size() - 1);
    const ShipParticulars& ship = scene.sphere->coefficients().ship;
    const std::vector<Vec6>& loads = scene.sphere->lastTick().loads;
    const Vec3 left = (loads[0] + loads[carrier]).head<3>() * (100.0 / (ship.mass * ship.gravity));
    // Ends of an arrow are rounded to those of a place of some metres.
    EXPECT_LT((pen.arrows[carrier - 1] - left).norm(), 20 * kEpsilon);
    for (const Vec3& arrow : pen.arrows) EXPECT_LT(arrow.norm(), 10.0);
  }
  Scene falls({.model = {.without = {"restoring"}}});
  falls.run(1);
  Arrows pen(*falls.sphere);
  falls.seaway.debugDraw(pen);
  EXPECT_EQ(falls.sphere->weightCarrier(), falls.sphere->parts().size());
  ASSERT_EQ(pen.arrows.size(), falls.sphere->parts().size());
  EXPECT_NEAR(pen.arrows[0].z(), -100.0, 1e-3);  // g of a world in single precision, 1e-7 of it
}

// The same pull as Bullet's own applyCentralForce gives, which goes through the same solver; single
// steps, as Bullet clears forces once a call. Round-off of the velocity.
TEST(PartsIdentity, AForceOfTheUsersActsAsBulletsOwnDoes) {
  Scene part, bullet;
  part.sphere->addForce(std::make_unique<Steady>(one(Surge, 5e4), Axes::Earth));
  for (int i = 0; i < 200; ++i) {
    part.run(1);
    bullet.sphere->body().applyCentralForce(btVector3(5e4, 0, 0));
    bullet.run(1);
  }
  const Vec6 a = part.sphere->velocity(), b = bullet.sphere->velocity();
  EXPECT_GT(a[Surge], 0.3);  // it moved
  EXPECT_LT((a - b).norm(), 400 * kEpsilon);
  EXPECT_EQ(part.sphere->load("steady")[Surge], 5e4);
}

// One pull along the hull's own x axis, said in three ways; the ship's heading is 0.7, upright.
TEST(PartsIdentity, AxesOfAWrenchAreThoseItSays) {
  Vec6 inEarth = Vec6::Zero();
  inEarth.head<3>() = 4e4 * Vec3(std::cos(0.7), std::sin(0.7), 0.0);
  const std::pair<Vec6, Axes> ways[] = {
      {one(Surge, 4e4), Axes::Course}, {inEarth, Axes::Earth}, {one(Surge, 4e4), Axes::Own}};
  for (const auto& [load, axes] : ways) {
    Scene scene({.start = {.heading = 0.7}});
    scene.sphere->addForce(std::make_unique<Steady>(load, axes));
    scene.run(64);
    EXPECT_LT((scene.sphere->load("steady") - one(Surge, 4e4)).norm(), 4e4 * 100 * kEpsilon);
    EXPECT_NEAR(scene.sphere->velocity()[Sway], 0.0, 100 * kEpsilon);
  }
}

TEST(PartsIdentity, WithoutRadiationTheSphereHeavesForEver) {
  Scene scene({.start = {.offset = one(Heave, 1.0)}, .model = {.without = {"radiation"}}});
  double highest = 0.0;
  for (int i = 0; i < 64 * 60; ++i) {
    scene.run(1);
    if (i > 64 * 50) highest = std::max(highest, scene.sphere->motion()[Heave]);
  }
  // Semi-implicit ticks keep the amplitude of an undamped oscillation but for its phase in the
  // tick: 1 - (ω h)²/8, ω = 1.4 rad/s.
  EXPECT_NEAR(highest, 1.0, 1e-3);
  EXPECT_EQ(scene.sphere->load("radiation"), Vec6(Vec6::Zero()));
  EXPECT_FALSE(scene.sphere->enabled("radiation"));
}

TEST(Parts, SwitchedOnAgainAPartHasForgottenItsPast) {
  Scene scene;
  scene.sphere->addForce(std::make_unique<Growing>());
  scene.run(64);
  EXPECT_NEAR(scene.sphere->load("growing")[Surge], 1e4, 1e-6);
  scene.sphere->setEnabled("growing", false);
  scene.run(64);
  EXPECT_EQ(scene.sphere->load("growing")[Surge], 0.0);
  scene.sphere->setEnabled("growing", true);
  scene.run(32);
  EXPECT_NEAR(scene.sphere->load("growing")[Surge], 0.5e4, 1e-6);
}

// Let go without added mass the sphere falls with g, as a plain body does.
TEST(PartsIdentity, AddedMassIsAPartThatCanBeSwitchedOff) {
  Scene scene({.model = {.without = {"added_mass", "restoring", "radiation"}}});
  scene.run(64);
  EXPECT_NEAR(scene.sphere->velocity()[Heave], -kSphereGravity, 100 * kEpsilon);
  scene.sphere->setEnabled("added_mass", true);
  const double before = scene.sphere->velocity()[Heave];
  scene.run(64);
  // m g / (m + A33(inf)): l is A33 over the mass, which the solver's single pass gives exactly.
  const double l = scene.coefficients.addedMass.atInfinity(2, 2) / scene.coefficients.ship.mass;
  EXPECT_NEAR(scene.sphere->velocity()[Heave] - before, -kSphereGravity / (1.0 + l),
              400 * kEpsilon);
}

TEST(Parts, AReplacedPartIsNotEvaluated) {
  Scene scene({.start = {.offset = one(Heave, 0.1)}});
  scene.sphere->addForce(std::make_unique<Float>());
  scene.run(1);
  EXPECT_EQ(scene.sphere->load("restoring"), Vec6(Vec6::Zero()));
  EXPECT_FALSE(scene.sphere->enabled("restoring"));
  EXPECT_NEAR((scene.sphere->load("float") + scene.sphere->load("gravity"))[Heave], -2e4,
              3e6 * kEpsilon);
  scene.sphere->setEnabled("float", false);
  scene.run(1);
  EXPECT_TRUE(scene.sphere->enabled("restoring"));
  EXPECT_GT(scene.sphere->load("restoring")[Heave], 1e6);  // the weight, less 7.7e4
}

TEST(Parts, ALoadThatIsNotFiniteIsLeftOutAndNamedAndTheOthersGoOn) {
  Scene scene({.start = {.offset = one(Heave, 0.5)}}, waves()),
      twin({.start = {.offset = one(Heave, 0.5)}}, waves());
  scene.sphere->addForce(std::make_unique<Steady>(one(Roll, kNan), Axes::Own, "broken"));
  scene.run(100);
  twin.run(100);
  EXPECT_EQ(scene.seaway.faults(), kLoadNotFinite);
  EXPECT_EQ(scene.sphere->brokenPart(), "broken");
  EXPECT_EQ(scene.sphere->brokenPart(), "");
  EXPECT_TRUE(sameBits(scene.sphere->body(), twin.sphere->body()));
}

TEST(Parts, SnapshotsHoldTheStateOfTheUsersParts) {
  Scene scene({}, waves()), twin({}, waves());
  for (Scene* one : {&scene, &twin}) {
    one->sphere->addForce(std::make_unique<Growing>());
    one->run(50);
  }
  scene.run(37);
  scene.sphere->setEnabled("diffraction", false);
  scene.run(10);
  const Seaway::Snapshot saved = scene.seaway.save();
  scene.run(100);
  twin.seaway.restore(saved);
  twin.run(100);
  EXPECT_TRUE(sameBits(scene.sphere->body(), twin.sphere->body()));
  EXPECT_FALSE(twin.sphere->enabled("diffraction"));
  EXPECT_EQ(scene.sphere->load("growing"), twin.sphere->load("growing"));
}

TEST(Parts, ASnapshotOfAShipWithOtherPartsIsRefused) {
  Scene scene;
  scene.run(3);
  const Seaway::Snapshot before = scene.seaway.save();
  scene.sphere->addForce(std::make_unique<Growing>());
  EXPECT_THROW(scene.seaway.restore(before), HydroError);
  const std::unique_ptr<ForceGenerator> back = scene.sphere->removeForce("growing");
  ASSERT_NE(back, nullptr);
  EXPECT_NO_THROW(scene.seaway.restore(before));
}

TEST(Parts, NamesThatAreTakenOrNoneAreRefusedWithTheReason) {
  Scene scene;
  const auto whyNot = [&](std::string_view name) -> std::string {
    try {
      scene.sphere->addForce(std::make_unique<Steady>(Vec6::Zero(), Axes::Own, name));
    } catch (const HydroError& error) {
      return error.what();
    }
    return {};
  };
  EXPECT_NE(whyNot("radiation").find("\"radiation\" already"), std::string::npos);
  EXPECT_NE(whyNot("wind, port").find("letters, digits"), std::string::npos);
  EXPECT_NE(whyNot("").find("no name"), std::string::npos);
  EXPECT_THROW(scene.sphere->addForce(nullptr), HydroError);
  EXPECT_THROW(scene.sphere->removeForce("radiation"), HydroError);  // none of the user's
  EXPECT_THROW(scene.sphere->setEnabled("gravity", false), HydroError);
  try {
    scene.sphere->load("sail");
    FAIL();
  } catch (const HydroError& error) {
    EXPECT_NE(std::string(error.what()).find("\"sail\"; there are gravity, restoring"),
              std::string::npos)
        << error.what();
  }
}

TEST(Parts, CostsAreMeasuredOnlyWhenAskedFor) {
  Scene scene({}, waves());
  const auto all = [&] {
    double sum = 0.0;
    for (const double cost : scene.sphere->costs()) sum += cost;
    return sum;
  };
  scene.run(10);
  EXPECT_EQ(all(), 0.0);
  scene.sphere->measureCosts(true);
  scene.run(10);
  EXPECT_EQ(scene.sphere->costs().size(), scene.sphere->parts().size());
  EXPECT_GT(all(), 0.0);
  EXPECT_EQ(scene.sphere->costs().front(), 0.0);  // gravity is Bullet's
}

TEST(Parts, APartThatJoinsWhileRecordingGetsColumns) {
  Scene scene;
  Recorder recorder(scene.seaway, *scene.sphere, {.forces = true});
  scene.run(5);
  const std::size_t before = recorder.columns().size();
  const double heave = recorder.at(4, 3);
  scene.sphere->addForce(std::make_unique<Steady>(one(Sway, 7e3), Axes::Course));
  scene.run(5);
  ASSERT_EQ(recorder.columns().size(), before + 6);
  EXPECT_EQ(recorder.columns()[before + 1], "steady_F2");
  ASSERT_EQ(recorder.rows(), 10u);
  EXPECT_EQ(recorder.at(4, 3), heave);
  EXPECT_EQ(recorder.at(4, before + 1), 0.0);
  EXPECT_EQ(recorder.at(5, before + 1), 7e3);
  scene.sphere->removeForce("steady");
  scene.run(1);
  EXPECT_EQ(recorder.columns().size(), before + 6);
  EXPECT_EQ(recorder.at(10, before + 1), 0.0);
}

TEST(Parts, ShipsOfOneHydrodynamicsShareItAndTemporariesMayBePassed) {
  TestWorld world{kSphereGravity};
  btSphereShape shape{5};
  Seaway seaway(world.world, waves());
  const auto sphere = std::make_shared<const Hydrodynamics>(hemisphere());
  const ShipSettings settings{.collision = {.shape = &shape}};
  const Ship& one = seaway.addShip(sphere, settings);
  const Ship& two = seaway.addShip(sphere, settings);
  const Ship& alone = seaway.addShip(hemisphere(), settings);
  EXPECT_EQ(&one.hydrodynamics(), &two.hydrodynamics());
  EXPECT_NE(&one.hydrodynamics(), &alone.hydrodynamics());
  EXPECT_EQ(sphere->radiation(), sphere->radiation());
  EXPECT_THROW(seaway.addShip(std::shared_ptr<const Hydrodynamics>{}), HydroError);
}

// d/dt (M + A∞)v is the sum of the loads without added mass; the momentum of a free ship's water
// holds that of its memory too, so that its radiation is no load on both. In a head sea the sphere
// does not turn, so axes do not matter; velocities are stored to ε.
TEST(ShipIdentity, MomentumOfShipAndWaterChangesByTheLoadsAlone) {
  const SeaState head({{.omega = 0.9, .amplitude = 0.4, .heading = kPi}}, kSphereGravity, 2.0);
  for (const Mean mean : {Mean::Fixed, Mean::Free}) {
    Scene scene({.start = {.offset = one(Heave, 0.5)}, .model = {.mean = mean}}, head);
    scene.run(200);
    const Vec6 before = scene.sphere->momentum();
    scene.run(1);
    Vec6 sum = -scene.sphere->load("added_mass");
    if (mean == Mean::Free) sum -= scene.sphere->load("radiation");
    for (const Vec6& load : scene.sphere->lastTick().loads) sum += load;
    const Vec6 rate = (scene.sphere->momentum() - before) / static_cast<double>(kTick);
    EXPECT_LT((rate - sum).head<3>().norm(), 8 * kEpsilon * 400e3 * 64.0);
    EXPECT_GT(sum.norm(), 1e4);
  }
}

// A drop from h has ½C33h² to begin with; what it loses, the waves take.
TEST(ShipClosedForm, EnergyAtTheStartIsThatOfTheSpring) {
  Scene scene({.start = {.offset = one(Heave, 0.5)}});
  EXPECT_NEAR(scene.sphere->energy(), 0.5 * 7.695e5 * 0.25, 1e6 * kEpsilon);
  double before = scene.sphere->energy();
  scene.run(64 * 20);
  EXPECT_LT(scene.sphere->energy(), 0.5 * before);
}

}  // namespace
}  // namespace cutwater::test
