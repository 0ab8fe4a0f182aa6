// The ship at 20 knots overtakes a sea from astern: following_seas DATABASE.h5 [OUT.csv]
// Look for: crests pass from bow to stern (wave_bow leads wave_stern) though they travel the ship's
// way, because the encounter frequency is negative, here that of roll. Heave and roll settle to the
// frequency domain. The course is fixed, as in a towing tank, so that the speed is exact.
#include "demos/scenes/DemoShip.h"
#include "hydro/response/FrequencyResponse.h"

using namespace cutwater;

static bool run(const Coefficients& frigate, DemoTable& table) {
  const double speed = 10.29, heading = kPi / 6.0, amplitude = 0.5, tick = 0.02;
  const double omega = 1.46;  // [rad/s]: 29 m long and slower than the ship
  const double waveNumber = omega * omega / frigate.ship.gravity;
  const double omegaE = omega - waveNumber * speed * std::cos(heading);
  BulletWorld bullet(frigate.ship.gravity);
  Seaway seaway(bullet.world,
                SeaState({{omega, amplitude, 0.0, heading}}, frigate.ship.gravity, 60.0));
  ShipSettings settings;
  settings.start.speed = speed;
  settings.model.mean = Mean::Fixed;
  Ship& ship = seaway.addShip(frigate, settings);

  // η̂ of η = Re{η̂ e^{iω′t}} over ten encounters: waves 5 m before and behind G, heave, roll.
  Complex harmonic[4] = {};
  const double apart = 5.0, settled = 300.0, sampled = 10.0 * 2.0 * kPi / std::abs(omegaE);
  while (seaway.time() < settled + sampled) {
    bullet.world.stepSimulation(tick, 1, tick);
    const double t = seaway.time();
    const Vec3 g = ship.position();
    const Vec6 motion = ship.motion();
    const double values[4] = {seaway.waveHeight(g.x() + apart, g.y()),
                              seaway.waveHeight(g.x() - apart, g.y()), motion[Heave], motion[Roll]};
    table.row({t, values[0], values[1], values[2], values[3] * 180.0 / kPi});
    if (t <= settled) continue;
    for (int i = 0; i < 4; ++i) {
      harmonic[i] += 2.0 * tick / sampled * values[i] * std::polar(1.0, -omegaE * t);
    }
  }
  const CVec6 expected = amplitude * FrequencyResponse(frigate).at(omega, heading, speed);
  const double bowFirst = std::arg(harmonic[0] / harmonic[1]) / omegaE;
  bool good = seaway.faults() == kStepOk;
  good &= isBelow("encounter frequency [rad/s]", omegaE, 0.0);
  good &= agrees("a crest is at the bow before the stern by [s]", bowFirst,
                 waveNumber * 2.0 * apart * std::cos(heading) / -omegaE, 0.01);
  // 1 %: the fit of the memory at speed, where B is small beside its parts.
  good &= agrees("heave / frequency domain", std::abs(harmonic[2] / expected[Heave]), 1.0, 0.01);
  good &= agrees("roll / frequency domain", std::abs(harmonic[3] / expected[Roll]), 1.0, 0.01);
  good &= agrees("heave, phase off by [rad]", std::arg(harmonic[2] / expected[Heave]), 0.0, 0.01);
  good &= agrees("roll, phase off by [rad]", std::arg(harmonic[3] / expected[Roll]), 0.0, 0.01);
  return good;
}

int main(int argc, char** argv) {
  return demoMain(argc, argv, "following_seas", "t,wave_bow,wave_stern,heave,roll_deg", run);
}
