// A ship at a speed at which its own motions grow.
#include <gtest/gtest.h>

#include "hydro/Errors.h"
#include "hydro/forces/Hydrodynamics.h"
#include "tests/plugin/TestScene.h"

namespace cutwater::test {
namespace {

/// Surge that feeds itself: −10⁵ N/(m/s), which 4·10⁶ kg feel as .024 1/s.
Coefficients pushedShip() {
  Coefficients ship = slenderShip();
  ship.ship.supplementary.damping[Surge] = -1e5;
  return ship;
}

std::uint32_t faultsOf(const Coefficients& coefficients, ShipModel model, double speed) {
  Scene scene({.start = {.speed = speed}, .model = std::move(model)}, {}, coefficients);
  scene.run(3);
  return scene.seaway.faults();
}

TEST(SpeedOutsideTheory, IsAFaultBitOfTheTick) {
  for (const Mean mean : {Mean::Fixed, Mean::Free}) {
    EXPECT_EQ(faultsOf(slenderShip(), {.mean = mean}, 8.0), kStepOk);
    EXPECT_EQ(faultsOf(pushedShip(), {.mean = mean}, 8.0), kSpeedOutsideTheory);
    // It grows at rest as well.
    EXPECT_EQ(faultsOf(pushedShip(), {.mean = mean}, 0.0), kSpeedOutsideTheory);
  }
}

TEST(SpeedOutsideTheory, AModeThatIsHeldDoesNotGrow) {
  ShipModel held;
  held.restrained[Surge] = true;
  EXPECT_EQ(faultsOf(pushedShip(), held, 8.0), kStepOk);
}

TEST(HydrodynamicsStability, IsFoundOnceForTheShipsOwnTerms) {
  const Hydrodynamics ship(pushedShip());
  EXPECT_EQ(&ship.stability(), &ship.stability());
  EXPECT_EQ(ship.stability().ahead.speed, 0.0);
  EXPECT_EQ(ship.stability().ahead.mode, Surge);
  EXPECT_FALSE(Hydrodynamics(slenderShip()).stability().ahead.speed.has_value());
}

}  // namespace
}  // namespace cutwater::test
