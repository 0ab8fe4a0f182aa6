#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "hydro/geometry/shapes/Shapes.h"
#include "tests/support/Results.h"
#include "tests/verification/nonlinear/NonlinearShip.h"

// Nothing but still water's pressure acts: what a hull has of energy it keeps.
namespace cutwater::test {
namespace {

constexpr int kTicksAPeriod = 240;

struct Swing {
  const char* name;
  Vec6 offset;                // how it is let go
  btVector3 linear, angular;  // Bullet's factors: the plane that it moves in
};

Vec6 offsetOf(double heave, double roll, double pitch) {
  Vec6 offset = Vec6::Zero();
  offset[Heave] = heave;
  offset[Roll] = roll;
  offset[Pitch] = pitch;
  return offset;
}

// About half a draught, and roll or pitch that brings the bow or the deck's edge near the water.
const Swing kHeaveAndPitch{"heave and pitch", offsetOf(2.0, 0.0, 0.05), btVector3(1, 0, 1),
                           btVector3(0, 1, 0)};
const Swing kHeaveAndRoll{"heave and roll", offsetOf(1.0, 0.4, 0.0), btVector3(0, 1, 1),
                          btVector3(1, 0, 0)};

struct NamedShip {
  std::string name;
  std::shared_ptr<const Hydrodynamics> ship;
};

std::vector<NamedShip> ships() {
  const SurfaceMesh box = closedBox({60.0, 16.0, 4.0, 6.0}, 8, 4, 4);
  return {
      {"frigate", bareShip({.closed = closedFrigate(32, 7),
                            .cog = Vec3(0.0, 0.0, 1.29),
                            .gyradii = Vec3(5.82, 28.8, 28.8)})},
      {"box",
       bareShip({.closed = box, .cog = Vec3(0.0, 0.0, -0.5), .gyradii = Vec3(5.0, 16.0, 16.0)})}};
}

// Of small heave alone, without added mass: other periods of these ships are longer.
double heavePeriod(const ShipParticulars& ship) {
  return 2.0 * kPi * std::sqrt(ship.mass / ship.restoring(Heave, Heave));
}

struct Kept {
  double worst = 0.0;  // energy less that at first, of what the swing has
  double risen = 0.0;  // mean of a period over the least of those before, alike
  double last = 0.0;   // mean of the last period, alike
};

// Energy is counted from that of the ship at rest in its place.
Kept swing(const std::shared_ptr<const Hydrodynamics>& ship, const ShipSettings& given,
           const Swing& swing, int periods) {
  ShipSettings settings = given;
  settings.start.offset = swing.offset;
  OneShip run(ship, {}, settings);
  run.ship.body().setLinearFactor(swing.linear);
  run.ship.body().setAngularFactor(swing.angular);
  const double step = heavePeriod(ship->ship()) / kTicksAPeriod;
  run.tick(step);
  const double atFirst = run.ship.energy();
  Kept kept;
  double least = 1.0;
  for (int period = 0; period < periods; ++period) {
    double mean = 0.0;
    for (int i = 0; i < kTicksAPeriod; ++i) {
      run.tick(step);
      const double share = run.ship.energy() / atFirst;
      kept.worst = std::max(kept.worst, std::abs(share - 1.0));
      mean += share / kTicksAPeriod;
    }
    kept.risen = std::max(kept.risen, mean - least);
    least = std::min(least, mean);
    kept.last = mean;
  }
  return kept;
}

const char* courseName(Mean mean) { return mean == Mean::Free ? "free" : "fixed course"; }

// Acceptance: 0.1 % over 1000 periods. Ticks let it swing by (ωh)²/4 = 1.7e-4 of the potential
// energy within a period. With added mass on and off; it is another in each direction, so that
// turning it counts.
void expectKept(const Swing& how) {
  const int periods = fullSize() ? 1000 : 20;
  for (const NamedShip& each : ships()) {
    for (const Mean mean : {Mean::Fixed, Mean::Free}) {
      for (const bool added : {false, true}) {
        ShipSettings settings = pressureOnly(mean);
        settings.model.immersion = Immersion::Constant;
        if (added) std::erase(settings.model.without, "added_mass");
        const Kept kept = swing(each.ship, settings, how, periods);
        const std::string what = each.name + ", " + how.name + ", " + courseName(mean) +
                                 (added ? ", added mass" : ", no added mass");
        recordResult(kTopic,
                     "energy in still water, " + std::to_string(periods) +
                         " periods of heave: worst change, " + what,
                     "0", kept.worst, "1e-3");
        EXPECT_LT(kept.worst, 1e-3) << what;
      }
    }
  }
}

TEST(NonlinearEnergyIdentity, HullsThatHeaveAndPitchKeepTheirEnergy) { expectKept(kHeaveAndPitch); }
TEST(NonlinearEnergyIdentity, HullsThatHeaveAndRollKeepTheirEnergy) { expectKept(kHeaveAndRoll); }

// Added mass that goes with immersion takes energy where the hull leaves the water and where it
// comes in, and never gives any: no period's mean is above one before by more than ticks let it
// swing. The second hull lifts clear of the water.
TEST(NonlinearEnergyIdentity, AddedMassThatComesAndGoesGivesNothing) {
  const int periods = fullSize() ? 100 : 20;
  Swing leap = kHeaveAndPitch;
  leap.name = "dropped from above the water";
  leap.offset = offsetOf(9.0, 0.0, 0.1);
  for (const NamedShip& each : ships()) {
    for (const Swing& how : {kHeaveAndPitch, kHeaveAndRoll, leap}) {
      for (const Mean mean : {Mean::Fixed, Mean::Free}) {
        ShipSettings settings = pressureOnly(mean);
        std::erase(settings.model.without, "added_mass");
        const Kept kept = swing(each.ship, settings, how, periods);
        const std::string what = each.name + ", " + how.name + ", " + courseName(mean);
        recordResult(kTopic,
                     "energy in still water, s scaled: a period's mean over one before, " + what,
                     "<= 0", kept.risen, "2e-4");
        EXPECT_LT(kept.risen, 2e-4) << what;
      }
    }
  }
}

}  // namespace
}  // namespace cutwater::test
