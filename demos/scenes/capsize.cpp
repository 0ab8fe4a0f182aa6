// A ship let go at a large heel, in calm water: capsize DATABASE.h5 [OUT.csv]
// Look for: from a heel inside the range of stability (GZ > 0) it comes back upright, from one
// beyond it turns over and stays keel up. A boat whose GZ vanishes nowhere comes back from any.
#include <algorithm>

#include "demos/scenes/DemoShip.h"
#include "hydro/ship/StabilityRange.h"

using namespace cutwater;

namespace {

constexpr double kTick = 0.02, kDegree = kPi / 180.0;
constexpr int kTicks = 15000;  // five minutes

// As it floats when somebody holds it at that heel, and at rest.
ShipStart heldAt(const RightingLever& lever, const ShipParticulars& ship) {
  ShipStart start;
  start.offset << 0.0, 0.0, lever.heightOfG - ship.cog.z(), lever.heel, lever.trim, 0.0;
  return start;
}

bool letGo(const Coefficients& coefficients, const RightingLever& lever, DemoTable& table) {
  const ShipParticulars& particulars = coefficients.ship;
  BulletWorld bullet(particulars.gravity);
  Seaway calm(bullet.world);
  Ship& ship = calm.addShip(coefficients, {.start = heldAt(lever, particulars)});
  const double rest = lever.gz > 0.0 ? 0.0 : kPi, scale = particulars.mass * particulars.gravity;
  double roll = lever.heel, gz = 0.0, first = 0.0, gained = 0.0, mean = 0.0, farthest = 0.0;
  for (int i = 0; i < kTicks; ++i) {
    bullet.world.stepSimulation(kTick, 1, kTick);
    roll += std::remainder(ship.attitude().x() - roll, 2.0 * kPi);  // it may go on beyond 180
    if (i == 0) {
      gz = ship.lastTick().position.y() - ship.wetted()->centre.y();
      first = ship.energy();
    }
    gained = std::max(gained, ship.energy() - first);
    if (i >= kTicks / 2) {
      mean += roll / (kTicks - kTicks / 2);
      farthest = std::max(farthest, std::abs(roll - rest));
    }
    if (i % 5 == 0)
      table.row({lever.heel / kDegree, calm.time(), roll / kDegree, ship.attitude().y() / kDegree,
                 ship.position().z(), ship.wetted()->area, ship.energy()});
  }
  std::printf("let go at %.1f deg\n", lever.heel / kDegree);
  bool good = (calm.faults() & ~kWarningBits) == 0;
  // Of the hull that the pressure is integrated on, which is the ship's own thinned.
  good &= agrees("  GZ there [m]", gz, lever.gz, 1e-3 * particulars.beam());
  good &= agrees("  heel, mean of the last half [deg]", mean / kDegree, rest / kDegree, 1.0);
  good &= isBelow("  farthest from there [deg]", farthest / kDegree, 60.0);
  good &=
      isBelow("  energy gained [weight times beam]", gained / (scale * particulars.beam()), 1e-6);
  return good;
}

bool run(const Coefficients& coefficients, DemoTable& table) {
  Righting righting(coefficients.ship, RightingTrim::Free);
  const auto vanishing = stabilityRange(righting, kPi).vanishing;
  const double at = vanishing.value_or(kPi) / kDegree;
  std::printf("GZ vanishes at %.1f deg\n", at);
  bool good = true;
  for (const double from : {-10.0, -2.0, 2.0, 10.0}) {
    const double heel = (at + from) * kDegree;
    if (heel < kPi) good = letGo(coefficients, righting.at(heel), table) && good;
  }
  return good;
}

}  // namespace

int main(int argc, char** argv) {
  return demoMain(argc, argv, "capsize", "heel_deg,t,roll_deg,pitch_deg,z,wetted_area,energy", run);
}
