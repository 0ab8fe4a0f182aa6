// A load of your own on a ship, here the wind on its superstructure: wind DATABASE.h5 [OUT.csv]
// Look for: moored abeam to a wind of 20 m/s the ship rolls about the heel at which its righting
// lever times its weight is the moment of the wind, and ends there.
#include "demos/scenes/DemoShip.h"
#include "hydro/base/FindRoot.h"

using namespace cutwater;

namespace {

constexpr double kWind = 20.0, kHeight = 9.0;        // [m/s] to port; [m] over G
constexpr double kDrag = 0.5 * 1.225 * 1.0 * 900.0;  // ½ρ C A [N/(m/s)²]

//! [part]
// Drag of the superstructure in the wind that the ship feels. In E, about G.
class Wind final : public ForceGenerator {
 public:
  std::string_view name() const noexcept override { return "wind"; }
  Wrench evaluate(const TickInput& now) noexcept override {
    const Vec3 felt = Vec3(0.0, kWind, 0.0) - now.attitude * now.velocityNow.head<3>();
    const Vec3 force = kDrag * felt.norm() * felt;
    Wrench wrench{.axes = Axes::Earth};
    wrench.load << force, (now.attitude * Vec3(0.0, 0.0, kHeight)).cross(force);
    return wrench;
  }
};
//! [part]

// Where m g GZ carries the moment of the wind [rad].
double heeled(const ShipParticulars& ship) {
  Righting righting(ship, RightingTrim::Free);
  const auto moment = [&](double heel) {
    return ship.mass * ship.gravity * righting.at(heel).gz +
           kHeight * kDrag * kWind * kWind * std::cos(heel);
  };
  const double most = -0.5;
  return findRoot(moment, {most, moment(most)}, {0.0, moment(0.0)}, 1e-9);
}

bool run(const Coefficients& frigate, DemoTable& table) {
  BulletWorld bullet(frigate.ship.gravity);
  Seaway calm(bullet.world);
  const ShipModel moored{.restrained = {true, true, false, false, false, true}};
  Ship& ship = calm.addShip(frigate, {.model = moored});
  //! [add]
  ship.addForce(std::make_unique<Wind>());
  //! [add]
  const auto roll = [&] { return ship.attitude().x() * 180.0 / kPi; };
  for (int i = 0; i < 600 * 50; ++i) {
    bullet.world.stepSimulation(0.02, 1, 0.02);
    const Vec6& wind = ship.load("wind");
    if (i % 10 == 0) table.row({calm.time(), roll(), wind[Sway], wind[Roll]});
  }
  return agrees("heel [deg]", roll(), heeled(frigate.ship) * 180.0 / kPi, 0.01) &&
         calm.faults() == kStepOk;
}

}  // namespace

int main(int argc, char** argv) {
  return demoMain(argc, argv, "wind", "t,roll_deg,wind_F2,wind_F4", run);
}
