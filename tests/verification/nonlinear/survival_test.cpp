#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "hydro/ship/StabilityRange.h"
#include "hydro/waves/Spectrum.h"
#include "tests/plugin/Shore.h"
#include "tests/support/Results.h"
#include "tests/verification/nonlinear/NonlinearShip.h"

// What ships in nonlinear mode must live through, or be lost in for a reason: storms, steep beam
// seas, falls, masses that their hulls were not made for.
namespace cutwater::test {
namespace {

constexpr const char* kSurvival = "16 Survival";
constexpr double kDegree = kPi / 180.0;

std::shared_ptr<const Hydrodynamics> frigate() {
  static const auto ship = readHydrodynamics(CUTWATER_SOLVED "/frigate.h5");
  return ship;
}

std::shared_ptr<const Hydrodynamics> boat() {
  static const auto ship = readHydrodynamics(CUTWATER_BOAT);
  return ship;
}

struct Named {
  const char* name;
  std::shared_ptr<const Hydrodynamics> ship;
};
std::array<Named, 2> both() { return {Named{"frigate", frigate()}, Named{"boat", boat()}}; }

// Mean, standard deviation and greatest absolute value.
struct Series {
  double sum = 0.0, squares = 0.0, most = 0.0;
  std::size_t count = 0;

  void take(double value) {
    sum += value;
    squares += value * value;
    most = std::max(most, std::abs(value));
    ++count;
  }
  double mean() const { return sum / static_cast<double>(count); }
  double deviation() const {
    return std::sqrt(std::max(0.0, squares / static_cast<double>(count) - mean() * mean()));
  }
};

struct Statistics {
  Series heave, roll, pitch;  // [m], [deg]
  double leastImmersion = 1.0;
  double energy = 0.0;                 // most, over m g [m]
  double farthest = 0.0, drift = 0.0;  // from the start [m]; mean speed over ground [m/s]
  double knockdowns = 0.0;             // times that it heeled to where its GZ vanishes
  bool capsized = false;               // beyond that in the end
  std::array<double, 32> shares{};     // of ticks with each fault bit
  std::uint32_t faults = kStepOk;
};

double vanishingHeel(const Hydrodynamics& ship) {
  Righting righting(ship.ship(), RightingTrim::Free);
  return stabilityRange(righting, kPi).vanishing.value_or(kPi);
}

Statistics sail(const std::shared_ptr<const Hydrodynamics>& hydrodynamics, const SeaState& sea,
                const ShipSettings& settings, double tick, double duration) {
  OneShip run(hydrodynamics, sea, settings);
  const ShipParticulars& ship = hydrodynamics->ship();
  const double vanishing = vanishingHeel(*hydrodynamics);
  const Vec3 start = run.ship.position();
  Statistics result;
  bool over = false;
  while (run.seaway.time() < duration - 0.5 * tick) {
    run.tick(tick);
    const Vec3 place = run.ship.position(), attitude = run.ship.attitude();
    result.farthest = std::max(result.farthest, (place - start).head<2>().norm());
    result.energy = std::max(result.energy, run.ship.energy() / (ship.mass * ship.gravity));
    result.leastImmersion = std::min(result.leastImmersion, run.ship.wetted()->immersion);
    const bool beyond = std::abs(attitude.x()) > vanishing;
    if (beyond && !over) ++result.knockdowns;
    if (beyond || std::abs(attitude.x()) < 0.5 * vanishing) over = beyond;
    if (run.seaway.time() < 60.0) continue;  // the waves' ramp
    result.heave.take(place.z() - ship.cog.z());
    result.roll.take(attitude.x() / kDegree);
    result.pitch.take(attitude.y() / kDegree);
    EXPECT_TRUE(place.allFinite() && attitude.allFinite());
  }
  result.drift = (run.ship.position() - start).head<2>().norm() / run.seaway.time();
  result.capsized = over;
  result.faults = run.seaway.faults();
  for (unsigned i = 0; i < 32; ++i) {
    const FaultCount count = run.seaway.faultCount(static_cast<StepFault>(1u << i));
    result.shares.at(i) = static_cast<double>(count.ticks) * tick / run.seaway.time();
  }
  return result;
}

void record(const std::string& run, const Statistics& of) {
  const auto add = [&](const char* what, double value, const char* bound = "stated") {
    recordResult(kSurvival, run + ": " + what, "", value, bound);
  };
  add("heave, std [m]", of.heave.deviation());
  add("heave, most [m]", of.heave.most);
  add("roll, std [deg]", of.roll.deviation());
  add("roll, most [deg]", of.roll.most);
  add("pitch, std [deg]", of.pitch.deviation());
  add("pitch, most [deg]", of.pitch.most);
  add("least immersion", of.leastImmersion);
  add("energy, most, over m g [m]", of.energy, "2 Hs");
  add("mean speed over ground [m/s]", of.drift);
  add("farthest from its start [m]", of.farthest);
  add("times heeled to where GZ vanishes", of.knockdowns);
  add("capsized in the end", of.capsized ? 1.0 : 0.0);
  for (unsigned i = 0; i < 32; ++i) {
    if (of.shares.at(i) > 0.0) {
      const std::string bit(faultName(static_cast<StepFault>(1u << i)));
      add(("share of ticks with " + bit).c_str(), of.shares.at(i));
    }
  }
}

// Bounds of any run. A hull that goes with the highest crest has about Hs of height and, at the
// speed of its water, half of that again; a hull that lies on its side is some metres higher.
void expectSound(const Statistics& of, double hs) {
  EXPECT_EQ(of.faults & ~kWarningBits, kStepOk);
  EXPECT_LT(of.energy, 2.0 * hs);
  EXPECT_LT(of.heave.most, 1.5 * hs);
}

// The storm: Hs 12 m, Tp 13 s. Wheeler's profile: that of the report has e^{kz} for each wave by
// itself up to its crests, and 8 m up the shortest waves of this sea (1.9 rad/s) press 20 times as
// much as at the surface.
constexpr double kHs = 12.0, kTp = 13.0;
SeaState storm(double heading, std::uint64_t seed, WaveProfile profile = WaveProfile::Wheeler) {
  return makeSeaState(
      {.hs = kHs, .tp = kTp},
      {.heading = heading, .components = 60, .seed = seed, .ramp = 60.0, .profile = profile});
}

// Under way at 10 knots, as one rides out a storm.
ShipSettings underWay(double speed) {
  ShipSettings settings;
  settings.start.speed = speed;
  settings.model.keepSpeed = SpeedKeeper{.speed = speed};
  settings.model.keepCourse = CourseKeeper{};
  return settings;
}

std::string stormName(double heading, std::uint64_t seed, double tick) {
  char name[100];
  std::snprintf(name, sizeof name, "frigate, Hs 12 m, %.0f deg, seed %u, tick 1/%.0f s", heading,
                static_cast<unsigned>(seed), 1.0 / tick);
  return name;
}

// One sea, one ship, two ticks. Heave and pitch to 2 % of what the waves have of them, their height
// and slope. Roll at its resonance remembers some three waves: 90 of them are worth 30, and paths
// that have parted agree to 1/sqrt(2 · 30).
void expectAlike(const Statistics& first, const Statistics& now, const std::string& name) {
  const double number = 4.0 * kPi * kPi / (kTp * kTp * frigate()->ship().gravity);  // [1/m]
  const double height = 0.25 * kHs, slope = number * height / kDegree;
  EXPECT_NEAR(now.heave.deviation(), first.heave.deviation(), 0.02 * height) << name;
  EXPECT_NEAR(now.pitch.deviation(), first.pitch.deviation(), 0.02 * slope) << name;
  if (first.roll.deviation() < 1.0) return;
  EXPECT_NEAR(now.roll.deviation() / first.roll.deviation(), 1.0, 0.13) << name;
}

class StormVerification : public testing::TestWithParam<double> {};

// Acceptance: 3 seeds, 4 headings, 3 ticks, 20 minutes each. The statistics of all ticks agree, as
// long as the ship has not been knocked down in one of them: beyond, whether it rights itself hangs
// on less than a tick's error.
TEST_P(StormVerification, AFrigateUnderWayLivesOrIsLostForAReason) {
  const double heading = GetParam(), duration = fullSize() ? 1200.0 : 75.0;
  for (const std::uint64_t seed : {1, 2, 3}) {
    if (!fullSize() && seed > 1) continue;
    std::optional<Statistics> first;
    for (const double tick : {1.0 / 30.0, 1.0 / 60.0, 1.0 / 240.0}) {
      if (!fullSize() && (tick < 0.01 || (tick < 0.03 && heading != 120.0))) continue;
      const Statistics now =
          sail(frigate(), storm(heading * kDegree, seed), underWay(5.0), tick, duration);
      const std::string name = stormName(heading, seed, tick);
      record(name, now);
      expectSound(now, kHs);
      if (heading == 180.0) {
        EXPECT_LT(now.roll.most, 1.0) << name;  // nothing rolls a ship that the waves meet ahead
      }
      if (!first) first = now;
      if (first->knockdowns + now.knockdowns > 0.0) continue;
      expectAlike(*first, now, name);
    }
  }
}
INSTANTIATE_TEST_SUITE_P(Headings, StormVerification, testing::Values(180.0, 120.0, 90.0, 30.0));

// Nobody at the helm, the engine stopped: 24 hours.
TEST(DeadShipVerification, AFrigateDriftsThroughADayOfStorm) {
  const double duration = fullSize() ? 24.0 * 3600.0 : 120.0;
  const Statistics day = sail(frigate(), storm(0.5 * kPi, 1), {}, 1.0 / 30.0, duration);
  record(fullSize() ? "dead frigate, Hs 12 m, 24 h" : "dead frigate, Hs 12 m, 2 min", day);
  expectSound(day, kHs);
}

// What the report's own profile does in that sea, which it was not made for: the frigate is thrown
// clear of the water abeam of the waves. Bounded, and a warning bit says so.
TEST(DeadShipVerification, TheExtrapolatedProfileThrowsAFrigateInAStorm) {
  const double duration = fullSize() ? 1200.0 : 90.0;
  const Statistics now = sail(frigate(), storm(0.5 * kPi, 2, WaveProfile::Extrapolated),
                              underWay(5.0), 1.0 / 30.0, duration);
  record("frigate, Hs 12 m, 90 deg, seed 2, extrapolated", now);
  EXPECT_EQ(now.faults & ~kWarningBits, kStepOk);
  EXPECT_LT(now.energy, 4.0 * kHs);
}

// Regular beam seas as long as 181 m. Their mean force is of the second order, and of it the theory
// has a part only; in low waves there is next to none.
TEST(DeadShipVerification, AFrigateInRegularBeamSeas) {
  constexpr double kOmega = 0.583;
  for (const double amplitude : {1.0, 3.0, 6.6}) {
    if (!fullSize() && amplitude == 3.0) continue;
    const SeaState sea({{.omega = kOmega, .amplitude = amplitude, .heading = 0.5 * kPi}},
                       frigate()->ship().gravity, 60.0, WaveProfile::Wheeler);
    const Statistics now = sail(frigate(), sea, {}, 1.0 / 30.0, fullSize() ? 1200.0 : 300.0);
    char name[80];
    std::snprintf(name, sizeof name, "dead frigate, regular beam seas of 0.583 rad/s, %g m",
                  amplitude);
    record(name, now);
    expectSound(now, 2.0 * amplitude);
    if (amplitude == 1.0) {
      EXPECT_LT(now.drift, 0.1);
    }
  }
}

struct End {
  double z = 0.0, roll = 0.0;  // mean of the last minute [m], [deg], roll of −180 is 180
  double highest = 0.0;        // keel over the water, before it rests [m]
  double gained = 0.0;         // energy above that at the start, over m g [m]
  double fastest = 0.0;        // [m/s]
  std::uint32_t faults = kStepOk;
};

// In calm water from a start. Falls have a tick in which the hull enters in more than one or two
// ticks: within the tick of a blow energy is not known, as it takes the mean of two velocities.
struct Watch {
  double tick, duration;  // [s]
};
constexpr Watch kFall{1.0 / 240.0, 150.0}, kLongRoll{1.0 / 60.0, 300.0};

End letGo(const std::shared_ptr<const Hydrodynamics>& hydrodynamics, const Vec6& offset,
          const Watch& watch) {
  OneShip run(hydrodynamics, SeaState(), {.start = {.offset = offset}});
  const ShipParticulars& ship = hydrodynamics->ship();
  const double keel = bounds(ship.hull).low.z() - ship.cog.z();
  End end;
  Series z, roll;
  double first = 0.0;
  for (int i = 0; i * watch.tick < watch.duration; ++i) {
    run.tick(watch.tick);
    const double weight = ship.mass * ship.gravity;
    if (i == 0) first = run.ship.energy();
    end.gained = std::max(end.gained, (run.ship.energy() - first) / weight);
    end.highest = std::max(end.highest, run.ship.position().z() + keel);
    end.fastest = std::max(end.fastest, run.ship.velocity().head<3>().norm());
    if (i * watch.tick < watch.duration - 60.0) continue;
    z.take(run.ship.position().z());
    roll.take(std::abs(run.ship.attitude().x()) / kDegree);
  }
  end.z = z.mean();
  end.roll = roll.mean();
  end.faults = run.seaway.faults();
  return end;
}

Vec6 one(int mode, double value) {
  Vec6 v = Vec6::Zero();
  v[mode] = value;
  return v;
}

// Comes to rest afloat and upright; energy is not gained but for a thousandth in the tick of a
// blow.
void expectAfloat(const Named& of, const End& end, double height) {
  EXPECT_EQ(end.faults & ~kWarningBits, kStepOk) << of.name;
  EXPECT_NEAR(end.z, of.ship->ship().cog.z(), 0.02) << of.name;
  EXPECT_LT(end.roll, 1.0) << of.name;
  EXPECT_LT(end.gained, 1e-3 * height) << of.name;
}

TEST(SurvivalVerification, FromFiftyMetresUpShipsComeToRestAfloat) {
  for (const Named& of : both()) {
    const End end = letGo(of.ship, one(Heave, 50.0), kFall);
    recordResult(kSurvival, std::string(of.name) + " dropped from 50 m: fastest [m/s]",
                 "sqrt(2 g h) = 31", end.fastest, "");
    EXPECT_LT(end.fastest, 1.01 * std::sqrt(2.0 * of.ship->ship().gravity * 50.0)) << of.name;
    expectAfloat(of, end, 50.0);
  }
}

// Rises by what it displaces more than it weighs, slowed by drag (Resistance.h), so that it leaps
// to less than a tenth of what the energy of 100 m would lift it to.
TEST(SurvivalVerification, FromAHundredMetresDownShipsComeUp) {
  for (const Named& of : both()) {
    const End end = letGo(of.ship, one(Heave, -100.0), kFall);
    StillWater water(of.ship->ship());
    const double most =
        100.0 * (of.ship->ship().density * water.wholeVolume() / of.ship->ship().mass - 1.0);
    const std::string name = std::string(of.name) + " from 100 m under water: ";
    char bound[60];
    std::snprintf(bound, sizeof bound, "its energy: %.0f", most);
    recordResult(kSurvival, name + "keel leaps to [m]", bound, end.highest, "a tenth");
    recordResult(kSurvival, name + "fastest [m/s]", "", end.fastest, "stated");
    EXPECT_GT(end.highest, 0.0) << of.name;
    EXPECT_LT(end.highest, 0.1 * most) << of.name;
    expectAfloat(of, end, most);
  }
}

// Keel up a ship stays where that is an equilibrium that it comes back to, as the frigate's is:
// GZ < 0 from where it vanishes to 180 degrees. The boat's GZ vanishes nowhere: it comes upright.
TEST(SurvivalVerification, KeelUpShipsStayWhereTheirRangeOfStabilitySaysSo) {
  for (const Named& of : both()) {
    Righting righting(of.ship->ship(), RightingTrim::Free);
    const RightingLever over = righting.at(kPi);
    const bool stays = vanishingHeel(*of.ship) < kPi;
    EXPECT_EQ(stays, std::string(of.name) == "frigate");
    Vec6 offset = one(Roll, 178.0 * kDegree);
    offset[Pitch] = over.trim;
    offset[Heave] = over.heightOfG - of.ship->ship().cog.z();
    const End end = letGo(of.ship, offset, kLongRoll);
    recordResult(kSurvival, std::string(of.name) + " let go keel up: heel in the end [deg]",
                 stays ? "180" : "0", end.roll, "+- 2");
    EXPECT_NEAR(end.roll, stays ? 180.0 : 0.0, 2.0) << of.name;
    EXPECT_NEAR(end.z, stays ? over.heightOfG : of.ship->ship().cog.z(), 0.02) << of.name;
    EXPECT_EQ(end.faults & ~kWarningBits, kStepOk) << of.name;
  }
}

// The draught of twice the mass is that at which the closed hull displaces it; where it cannot, the
// ship goes under.
TEST(SurvivalVerification, TwiceTheMassSinksToItsDraught) {
  for (const Named& of : both()) {
    Shore shore(of.ship, {});
    btRigidBody& body = shore.ship.body();
    const Vec3 inertia = 2.0 * fromBullet(body.getInvInertiaDiagLocal()).cwiseInverse();
    const double mass = 2.0 * shore.particulars.mass;
    body.setMassProps(mass, toBullet(inertia));
    shore.run(300.0, 1.0 / 60.0);
    StillWater water(shore.particulars);
    const double volume = mass / shore.particulars.density;
    const std::string name = std::string(of.name) + " with its mass doubled: ";
    recordResult(kSurvival, name + "water displaced over what it weighs", "1",
                 shore.ship.wetted()->volume / volume, "+- 0.001");
    recordResult(kSurvival, name + "height of G [m]", "", shore.ship.position().z(), "stated");
    recordResult(kSurvival, name + "heel [deg]", "", shore.ship.attitude().x() / kDegree, "stated");
    if (volume < water.wholeVolume()) {
      EXPECT_NEAR(shore.ship.wetted()->volume / volume, 1.0, 1e-3) << of.name;
    } else {
      EXPECT_LT(shore.ship.position().z(), -100.0) << of.name;
    }
    EXPECT_EQ(shore.seaway.faults() & ~kWarningBits, kStepOk) << of.name;
  }
}

// Acceptance: 1 %. Of the frigate and the boat, clear of the water.
TEST(SurvivalVerification, OnAHookAndOnATrailerShipsWeighWhatTheyWeigh) {
  for (const Named& of : both()) {
    const double keel = bounds(of.ship->ship().hull).low.z();
    const double length = of.ship->length();
    btBoxShape trailer(btVector3(0.25 * length, 0.5 * length, 0.5));
    const double clear = 3.0 - keel;
    const ShipSettings lifted{.start = {.offset = one(Heave, clear)}};
    Shore hook(of.ship, lifted);
    hook.hangFrom(0.5 * length);
    Shore stands(of.ship, lifted, &trailer,
                 btTransform(btQuaternion::getIdentity(), btVector3(0, 0, 2.4)));
    for (Shore* const shore : {&hook, &stands}) {
      shore->run(60.0, 1.0 / 60.0);
      const double carried = shore->balance(20.0, 1.0 / 60.0).carried / shore->weight();
      recordResult(kSurvival,
                   std::string(of.name) + (shore == &hook ? " on a hook" : " on a trailer") +
                       ": weight carried, of m g",
                   "1", carried, "+- 0.01");
      EXPECT_NEAR(carried, 1.0, 0.01) << of.name;
    }
  }
}

// The boat as hello_ship sails it, in a sea for which it is small: Hs 2 m, Tp 6 s, both profiles.
TEST(SurvivalVerification, TheBoatInTwoMetreSeas) {
  for (const WaveProfile profile : {WaveProfile::Wheeler, WaveProfile::Extrapolated}) {
    if (!fullSize() && profile != WaveProfile::Wheeler) continue;
    const SeaState sea =
        makeSeaState({.hs = 2.0, .tp = 6.0}, {.heading = 2.0, .ramp = 10.0, .profile = profile});
    const Statistics now = sail(boat(), sea, underWay(3.0), 1.0 / 60.0, fullSize() ? 600.0 : 75.0);
    record(std::string("boat, Hs 2 m, ") + kWaveProfileNames.at(static_cast<std::size_t>(profile)),
           now);
    EXPECT_EQ(now.faults & ~kWarningBits, kStepOk);
    EXPECT_LT(now.energy, 4.0 * 2.0);
  }
}

}  // namespace
}  // namespace cutwater::test
