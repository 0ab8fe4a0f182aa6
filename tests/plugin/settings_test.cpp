#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "hydro/forces/Hydrodynamics.h"
#include "tests/plugin/TestScene.h"

// Every number of the settings of a ship: what is not finite or absurd is refused by name, and
// nothing has changed then.
namespace cutwater::test {
namespace {

struct Field {
  const char* name;
  std::function<double&(ShipSettings&)> of;
  double absurd;
};

SpeedKeeper& speedKeeper(ShipSettings& s) {
  if (!s.model.keepSpeed) s.model.keepSpeed.emplace();
  return *s.model.keepSpeed;
}
CourseKeeper& courseKeeper(ShipSettings& s) {
  if (!s.model.keepCourse) s.model.keepCourse.emplace();
  return *s.model.keepCourse;
}

std::vector<Field> fields() {
  std::vector<Field> all{
      {"start.x", [](auto& s) -> double& { return s.start.x; }, 1e12},
      {"start.y", [](auto& s) -> double& { return s.start.y; }, -1e12},
      {"start.heading", [](auto& s) -> double& { return s.start.heading; }, 1e9},
      {"start.speed", [](auto& s) -> double& { return s.start.speed; }, 1e6},
      {"SpeedKeeper::speed", [](auto& s) -> double& { return speedKeeper(s).speed; }, -1e6},
      {"SpeedKeeper::maxThrust", [](auto& s) -> double& { return speedKeeper(s).maxThrust; }, -1.0},
      {"SpeedKeeper::rate", [](auto& s) -> double& { return speedKeeper(s).rate; }, 0.0},
      {"CourseKeeper::heading", [](auto& s) -> double& { return courseKeeper(s).heading; }, 1e9},
      {"CourseKeeper::maxMoment", [](auto& s) -> double& { return courseKeeper(s).maxMoment; },
       1e300},
      {"CourseKeeper::rate", [](auto& s) -> double& { return courseKeeper(s).rate; }, 1e6},
  };
  static const char* const offsets[6] = {"start.offset[0]", "start.offset[1]", "start.offset[2]",
                                         "start.offset[3]", "start.offset[4]", "start.offset[5]"};
  static const char* const velocities[6] = {"start.velocity[0]", "start.velocity[1]",
                                            "start.velocity[2]", "start.velocity[3]",
                                            "start.velocity[4]", "start.velocity[5]"};
  for (int i = 0; i < 6; ++i) {
    all.push_back({offsets[i], [i](auto& s) -> double& { return s.start.offset[i]; }, 1e6});
    all.push_back({velocities[i], [i](auto& s) -> double& { return s.start.velocity[i]; }, -1e6});
  }
  return all;
}

/// What addShip says; "" if it takes the settings.
std::string refusal(Seaway& seaway, const std::shared_ptr<const Hydrodynamics>& hydro,
                    const ShipSettings& settings) {
  try {
    seaway.removeShip(seaway.addShip(hydro, settings));
  } catch (const HydroError& error) {
    EXPECT_EQ(error.fault(), Fault::ValueOutOfRange);
    return error.what();
  }
  return {};
}

TEST(ShipSettings, EveryFieldIsChecked) {
  TestWorld plain(kSphereGravity);
  Seaway seaway(plain.world);
  btSphereShape shape(5);
  const auto hydro = std::make_shared<const Hydrodynamics>(hemisphere());
  for (const Field& field : fields()) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    for (const double value : {std::nan(""), kInfinity, -kInfinity, field.absurd}) {
      ShipSettings settings{.collision = {.shape = &shape}};
      field.of(settings) = value;
      const std::string said = refusal(seaway, hydro, settings);
      EXPECT_NE(said.find(field.name), std::string::npos)
          << field.name << " = " << value << ": \"" << said << "\"";
      EXPECT_NE(said.find("Seaway::addShip"), std::string::npos);
    }
  }
  ShipSettings settings{.collision = {.shape = &shape}};
  settings.model.mean = static_cast<Mean>(7);
  EXPECT_NE(refusal(seaway, hydro, settings).find("model.mean = 7"), std::string::npos);
  settings.model.mean = Mean::Fixed;
  settings.model.memory = static_cast<MemoryModel>(-1);
  EXPECT_NE(refusal(seaway, hydro, settings).find("model.memory = -1"), std::string::npos);
  EXPECT_TRUE(seaway.ships().empty());
  EXPECT_EQ(plain.world.getNumCollisionObjects(), 0);
  EXPECT_EQ(plain.world.getNumConstraints(), 0);
}

// Degrees given for radians: 90 of a heading, 6 of a roll.
TEST(ShipSettings, DegreesAreRefused) {
  TestWorld plain(kSphereGravity);
  Seaway seaway(plain.world);
  btSphereShape shape(5);
  const auto hydro = std::make_shared<const Hydrodynamics>(hemisphere());
  int angles = 0;
  for (const Field& field : fields()) {
    const std::string name = field.name;
    const bool attitude = name >= "start.offset[3]" && name <= "start.offset[5]";
    if (!attitude && name != "start.heading" && name != "CourseKeeper::heading") continue;
    ++angles;
    ShipSettings settings{.collision = {.shape = &shape}};
    for (const double degrees : {90.0, -180.0, attitude ? 6.0 : 45.0}) {
      field.of(settings) = degrees;
      const std::string said = refusal(seaway, hydro, settings);
      EXPECT_NE(said.find(name + " = " + (degrees < 0.0 ? "-180" : "")), std::string::npos) << said;
      EXPECT_NE(said.find("radians; did you mean degrees?"), std::string::npos) << said;
    }
    field.of(settings) = attitude ? 180.0 * (kPi / 180.0) : 360.0 * (kPi / 180.0);
    EXPECT_EQ(refusal(seaway, hydro, settings), "");
  }
  EXPECT_EQ(angles, 5);
}

TEST(ShipSettings, OrdersAndPlacesAreCheckedLater) {
  TestWorld plain(kSphereGravity);
  Seaway seaway(plain.world);
  btSphereShape shape(5);
  Ship& ship = seaway.addShip(hemisphere(), {.collision = {.shape = &shape}});
  EXPECT_THROW(ship.keepSpeed({.speed = std::nan("")}), HydroError);
  EXPECT_THROW(ship.keepCourse({.rate = -1.0}), HydroError);
  EXPECT_THROW(ship.placeAt(std::nan(""), 0.0, 0.0), HydroError);
  EXPECT_THROW(ship.placeAt(0.0, 0.0, 0.0, one(Heave, 1e9)), HydroError);
  EXPECT_THROW(ship.placeAt(0.0, 0.0, 90.0), HydroError);
  EXPECT_THROW(ship.placeAt(0.0, 0.0, 0.0, one(Roll, 10.0)), HydroError);
  EXPECT_THROW(ship.keepCourse({.heading = 90.0}), HydroError);
  EXPECT_EQ(ship.position().x(), 0.0);
}

// What addShip says of settings with a body of the user's: the model acts, of the start only the
// speed of a fixed course, and of the shape nothing.
TEST(ShipSettings, OfABodyOfTheUsersTheModelIsUsed) {
  for (const Mean mean : {Mean::Fixed, Mean::Free}) {
    TestWorld plain(kSphereGravity);
    Seaway seaway(plain.world);
    btSphereShape own(5), other(3);
    const ShipParticulars& ship = hemisphere().ship;
    btRigidBody body(btRigidBody::btRigidBodyConstructionInfo(
        static_cast<btScalar>(ship.mass), nullptr, &own,
        toBullet(Vec3(ship.mass * ship.gyradii.cwiseAbs2()))));
    body.setCenterOfMassTransform(btTransform(btQuaternion::getIdentity(), btVector3(7, 8, -2)));
    body.setLinearVelocity(btVector3(2, 0, 0));
    plain.world.addRigidBody(&body);
    ShipSettings settings{.start = {.x = 100.0, .heading = 1.0, .speed = 5.0},
                          .model = {.mean = mean, .without = {"radiation"}},
                          .collision = {.shape = &other}};
    settings.start.offset[Heave] = 1.0;
    settings.start.velocity[Heave] = 1.0;
    settings.model.restrained[Sway] = true;
    settings.model.keepSpeed = {.speed = 2.0};
    Ship& added = seaway.addShip(hemisphere(), body, settings);
    EXPECT_EQ(plain.world.getNumConstraints(), 2);  // added mass, and the restraint
    EXPECT_FALSE(added.enabled("radiation"));
    EXPECT_EQ(body.getCollisionShape(), &own);
    EXPECT_EQ(added.position(), Vec3(7, 8, -2));
    EXPECT_EQ(added.velocity(), one(Surge, 2.0));
    EXPECT_EQ(added.course().x(), 7.0);
    EXPECT_EQ(added.course().heading(), 0.0);
    EXPECT_EQ(added.course().speed(), mean == Mean::Fixed ? 5.0 : 2.0);
    seaway.removeShip(added);
    plain.world.removeRigidBody(&body);
  }
}

TEST(ShipSettings, OneBodyIsOneShip) {
  TestWorld plain(kSphereGravity);
  Seaway seaway(plain.world);
  btSphereShape shape(5);
  const auto hydro = std::make_shared<const Hydrodynamics>(hemisphere());
  Ship& ship = seaway.addShip(hydro, {.collision = {.shape = &shape}});
  try {
    seaway.addShip(hydro, ship.body());
    ADD_FAILURE() << "the same body twice was accepted";
  } catch (const HydroError& error) {
    EXPECT_EQ(error.fault(), Fault::BadArgument);
    EXPECT_NE(std::string(error.what()).find("already"), std::string::npos) << error.what();
  }
  EXPECT_EQ(seaway.ships().size(), 1u);
  EXPECT_EQ(plain.world.getNumConstraints(), 1);
}

}  // namespace
}  // namespace cutwater::test
