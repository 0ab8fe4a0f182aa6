// Snapshots as bytes: the same future after them, and nothing believed that is not checked.
#include <gtest/gtest.h>

#include <cstring>

#include "hydro/Errors.h"
#include "hydro/base/Fnv1a.h"
#include "tests/plugin/TestScene.h"

namespace cutwater::test {
namespace {

using Bytes = std::vector<std::byte>;

// Magic, version, size of a scalar, key of the layout, length of the fields.
constexpr std::size_t kVersionAt = 8, kScalarAt = 12, kLayoutAt = 16, kLengthAt = 24,
                      kFieldsAt = 32;

// Behind time, number of ships, and what Bullet is given of the first one: poses, velocities, axes.
// Bullet does not check those.
constexpr std::size_t kLoadsAt =
    kFieldsAt + 2 * 8 + (2 * 12 + 4 * 3 + 2 * 3 + 9) * sizeof(btScalar) + 9 * 8 + 1 + 2 * 4 + 4 * 8;

template <class T>
void put(Bytes& bytes, std::size_t at, T value) {
  std::memcpy(bytes.data() + at, &value, sizeof value);
}

// With the checksum that belongs to them: as one who means harm would send them.
Bytes sealed(Bytes bytes) {
  Fnv1a sum;
  sum.add(bytes.data(), bytes.size() - 8);
  put(bytes, bytes.size() - 8, sum.value());
  return bytes;
}

Fault refusalOf(const Bytes& bytes) {
  try {
    Seaway::Snapshot::fromBytes(bytes);
  } catch (const HydroError& error) {
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    return error.fault();
  }
  ADD_FAILURE() << "was read";
  return Fault::BadArgument;
}

Bytes someBytes() {
  Scene scene({.start = {.offset = one(Heave, 0.5)}}, waves());
  scene.run(20);
  return scene.seaway.save().toBytes();
}

ShipSettings settingsOf(Mean mean, MemoryModel memory) {
  ShipSettings settings{.start = {.offset = one(Heave, 0.5)}};
  settings.model.mean = mean;
  settings.model.memory = memory;
  if (mean == Mean::Fixed) return settings;
  settings.start.speed = 2.0;
  settings.model.keepSpeed = SpeedKeeper{.speed = 3.0};
  return settings;
}

TEST(SnapshotBytesIdentity, AnotherWorldGoesOnWithTheSameBits) {
  for (const Mean mean : {Mean::Fixed, Mean::Free}) {
    for (const MemoryModel memory : {MemoryModel::Exponential, MemoryModel::Convolution}) {
      const ShipSettings settings = settingsOf(mean, memory);
      Scene scene(settings, waves(), slenderShip());
      scene.run(100);
      scene.sphere->body().applyCentralImpulse(btVector3(1e5, 2e4, 0));
      const Bytes bytes = scene.seaway.save().toBytes();
      const Seaway::Snapshot read = Seaway::Snapshot::fromBytes(bytes);
      EXPECT_TRUE(read.toBytes() == bytes);
      Scene other(settings, waves(), slenderShip());
      other.sphere->prepare(static_cast<double>(kTick));
      other.seaway.restore(read);
      for (int i = 0; i < 10; ++i) {
        scene.run(20);
        other.run(20);
        EXPECT_TRUE(sameBits(scene.sphere->body(), other.sphere->body())) << i;
      }
      EXPECT_EQ(scene.seaway.time(), other.seaway.time());
      EXPECT_TRUE(scene.seaway.save().toBytes() == other.seaway.save().toBytes());
    }
  }
}

// A sphere that lies on the ground.
struct Aground {
  Aground() {
    ground.setWorldTransform(btTransform(btQuaternion::getIdentity(), btVector3(0, 0, -8)));
    scene.world.world.addRigidBody(&ground);
    scene.sphere->body().setFriction(btScalar(0.8));
  }
  ~Aground() { scene.world.world.removeRigidBody(&ground); }

  Scene scene{{.start = {.offset = one(Heave, 0.5)}}, waves()};
  btBoxShape shape{btVector3(50, 50, 1)};
  btRigidBody ground{btRigidBody::btRigidBodyConstructionInfo(0, nullptr, &shape)};
};

TEST(SnapshotBytesIdentity, WhereBodiesTouchContactsAreForgottenAtBothEnds) {
  Aground first;
  first.scene.run(100);
  EXPECT_GT(first.scene.world.world.getDispatcher()->getNumManifolds(), 0);
  first.scene.seaway.forgetContacts();
  const Bytes bytes = first.scene.seaway.save().toBytes();
  first.scene.run(200);
  Aground other;
  other.scene.run(7);
  other.scene.seaway.restore(Seaway::Snapshot::fromBytes(bytes));
  other.scene.seaway.forgetContacts();
  other.scene.run(200);
  EXPECT_TRUE(sameBits(first.scene.sphere->body(), other.scene.sphere->body()));
}

TEST(SnapshotBytes, CutOffAnywhereTheyAreRefused) {
  const Bytes bytes = someBytes();
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_EQ(refusalOf(Bytes(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size))),
              Fault::FileMalformed)
        << size;
  }
  Bytes longer = bytes;
  longer.push_back(std::byte{0});
  EXPECT_EQ(refusalOf(longer), Fault::FileMalformed);
}

// FNV-1a finds every single byte that has changed: each step of it is one to one.
TEST(SnapshotBytes, WithAnyByteChangedTheyAreRefused) {
  const Bytes bytes = someBytes();
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    Bytes changed = bytes;
    changed[i] ^= std::byte{0x10};
    const Fault fault = refusalOf(changed);
    const bool ofVersion = i >= kVersionAt && i < kScalarAt;
    EXPECT_EQ(fault, ofVersion ? Fault::VersionNotSupported : Fault::FileMalformed) << i;
  }
}

TEST(SnapshotBytes, OfAnotherVersionPrecisionOrLayoutTheyAreRefused) {
  const Bytes bytes = someBytes();
  Bytes other = bytes;
  put(other, kVersionAt, std::uint32_t{2});
  EXPECT_EQ(refusalOf(sealed(other)), Fault::VersionNotSupported);
  other = bytes;
  put(other, kScalarAt, std::uint32_t{kDouble ? 4 : 8});
  EXPECT_EQ(refusalOf(sealed(other)), Fault::VersionNotSupported);
  other = bytes;
  put(other, kLayoutAt, std::uint64_t{1});
  EXPECT_EQ(refusalOf(sealed(other)), Fault::VersionNotSupported);
  other = bytes;
  put(other, kLengthAt, ~std::uint64_t{0});
  EXPECT_EQ(refusalOf(sealed(other)), Fault::FileMalformed);
  EXPECT_EQ(refusalOf(sealed(Bytes(100, std::byte{7}))), Fault::FileMalformed);
}

// Counts and sizes of any value, with a checksum that is right: refused, or numbers that a ship can
// be given, whatever they are. Under the address sanitizer nothing is read beyond its end.
TEST(SnapshotBytes, NoNumberInThemIsBelievedUnchecked) {
  const Bytes bytes = someBytes();
  Scene scene({.start = {.offset = one(Heave, 0.5)}}, waves());
  scene.run(20);
  std::size_t refused = 0;
  for (const std::uint64_t value : {~std::uint64_t{0}, std::uint64_t{1} << 61, std::uint64_t{3}}) {
    for (std::size_t at = kFieldsAt; at + 16 <= bytes.size(); ++at) {
      Bytes spoilt = bytes;
      put(spoilt, at, value);
      try {
        scene.seaway.restore(Seaway::Snapshot::fromBytes(sealed(spoilt)));
      } catch (const HydroError&) {
        ++refused;
      }
      if (at > kLoadsAt && at % 16 == 0) scene.run(2);
    }
  }
  EXPECT_GT(refused, 3 * 8u);  // those of the counts at least
  scene.seaway.restore(Seaway::Snapshot::fromBytes(bytes));
}

TEST(SnapshotBytes, TheShipOfAnotherDatabaseRefusesThem) {
  const Seaway::Snapshot read = Seaway::Snapshot::fromBytes(someBytes());
  Coefficients heavier = hemisphere();
  heavier.ship.restoring(2, 2) *= 1.001;
  Scene other({}, waves(), heavier);
  other.run(5);
  const Bytes before = other.seaway.save().toBytes();
  EXPECT_THROW(other.seaway.restore(read), HydroError);
  EXPECT_TRUE(other.seaway.save().toBytes() == before);
  TestWorld empty(kSphereGravity);
  Seaway none(empty.world);
  EXPECT_THROW(none.restore(read), HydroError);
}

}  // namespace
}  // namespace cutwater::test
