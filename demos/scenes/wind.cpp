// A load of your own on a ship, here the wind on its superstructure: wind DATABASE.h5 [OUT.csv]
// Look for: moored abeam to a wind of 20 m/s the ship rolls about the heel at which C44 times the
// angle is the moment of the wind, and ends there.
#include "demos/scenes/DemoShip.h"

using namespace cutwater;

namespace {

constexpr double kArea = 900.0, kHeight = 9.0, kDrag = 1.0, kAir = 1.225;  // m², m over G, -, kg/m³

// Drag of the superstructure in the wind that the ship feels. In E, about G.
class Wind final : public ForceGenerator {
 public:
  explicit Wind(const Vec3& wind) : wind_(wind) {}
  std::string_view name() const noexcept override { return "wind"; }
  Wrench evaluate(const TickInput& now) noexcept override {
    const Vec3 felt = wind_ - now.attitude * now.velocityNow.head<3>();
    const Vec3 force = 0.5 * kAir * kDrag * kArea * felt.norm() * felt;
    const Vec3 arm = now.attitude * Vec3(0.0, 0.0, kHeight);
    Wrench wrench{.axes = Axes::Earth};
    wrench.load << force, arm.cross(force);
    return wrench;
  }

 private:
  Vec3 wind_;  // [m/s] in E
};

bool run(const Coefficients& frigate, DemoTable& table) {
  BulletWorld bullet(frigate.ship.gravity);
  Seaway calm(bullet.world);
  ShipSettings settings;
  settings.model.restrained = {true, true, false, false, false, true};  // moored
  Ship& ship = calm.addShip(frigate, settings);
  ship.addForce(std::make_unique<Wind>(Vec3(0.0, 20.0, 0.0)));  // to port
  for (int i = 0; i < 600 * 50; ++i) {
    bullet.world.stepSimulation(0.02, 1, 0.02);
    if (i % 10 == 0) {
      table.row({calm.time(), ship.attitude().x() * 180.0 / kPi, ship.load("wind")[Sway],
                 ship.load("wind")[Roll]});
    }
  }
  const double moment = -kHeight * 0.5 * kAir * kDrag * kArea * 20.0 * 20.0;
  const double heel = moment / frigate.ship.restoring(Roll, Roll);
  return agrees("heel [deg]", ship.attitude().x() * 180.0 / kPi, heel * 180.0 / kPi, 0.01) &&
         calm.faults() == kStepOk;
}

}  // namespace

int main(int argc, char** argv) {
  return demoMain(argc, argv, "wind", "t,roll_deg,wind_F2,wind_F4", run);
}
