// A free ship in a regular head sea: head_seas DATABASE.h5 [OUT.csv]
// Look for: surge, heave and pitch settle to the amplitudes of the frequency domain of a free ship;
// sway, roll and yaw stay zero. Nothing holds the ship at its place, and first-order waves do not
// push it away either: it stays there. Pressure is linear here, as in the frequency domain.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "demos/scenes/BulletWorld.h"
#include "hydro/database/CoefficientsFile.h"
#include "hydro/response/FrequencyResponse.h"
#include "plugin/Recorder.h"

int main(int argc, char** argv) try {
  using namespace cutwater;
  if (argc < 2) {
    std::puts("usage: head_seas DATABASE.h5 [OUT.csv]");
    return 2;
  }
  const double omega = 0.7, amplitude = 0.5, tick = 0.02;
  const Coefficients frigate = readCoefficients(argv[1]);
  BulletWorld bullet(frigate.ship.gravity);
  Seaway seaway(bullet.world, SeaState({{omega, amplitude, 0.0, kPi}}, frigate.ship.gravity, 60.0));
  Ship& ship = seaway.addShip(frigate, {.model = {.mode = HullPressure::Linear}});
  Recorder recorder(seaway, ship);

  Vec6 largest = Vec6::Zero();
  const double settled = 200.0, periods = 5 * 2.0 * kPi / omega;
  while (seaway.time() < settled + periods) {
    bullet.world.stepSimulation(tick, 1, tick);
    if (seaway.time() > settled) largest = largest.cwiseMax(ship.motion().cwiseAbs());
  }
  const CVec6 expected =
      amplitude * FrequencyResponse(frigate, FrequencyResponse::Free{}).at(omega, kPi);
  const Vec3 at = ship.position();
  std::printf("mode    Bullet    frequency domain\n");
  for (int j = 0; j < 6; ++j) {
    std::printf("%-6s %9.6f %9.6f %s\n", kModeNames[j], largest[j], std::abs(expected[j]),
                j < 3 ? "m" : "rad");
  }
  std::printf("away from the start by %.3f m\n", std::hypot(at.x(), at.y()));
  if (argc > 2) recorder.write(argv[2]);
  const auto near = [&](int j) {
    return std::abs(largest[j] / std::abs(expected[j]) - 1.0) < 0.02;
  };
  const double lateral = std::max({largest[Sway], largest[Roll], largest[Yaw]});
  return seaway.faults() == kStepOk && near(Surge) && near(Heave) && near(Pitch) &&
                 lateral < 1e-3 * amplitude
             ? 0
             : 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "head_seas: %s\n", error.what());
  return 1;
}
