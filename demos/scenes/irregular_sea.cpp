// The ship in a JONSWAP sea from 150 deg, half an hour: irregular_sea DATABASE.h5 [OUT.csv]
// Look for: the standard deviation of each motion is that of the frequency domain, Σ ½ |RAO a|².
// The course is fixed: a free ship without way would turn by and by, and meet another sea.
#include <cmath>
#include <cstdio>

#include "demos/scenes/BulletWorld.h"
#include "hydro/database/CoefficientsFile.h"
#include "hydro/response/FrequencyResponse.h"
#include "hydro/waves/Spectrum.h"
#include "plugin/Recorder.h"

int main(int argc, char** argv) try {
  using namespace cutwater;
  if (argc < 2) {
    std::puts("usage: irregular_sea DATABASE.h5 [OUT.csv]");
    return 2;
  }
  const Coefficients frigate = readCoefficients(argv[1]);
  Spectrum spectrum;
  spectrum.gravity = frigate.ship.gravity;
  SeaStateSettings settings;
  settings.heading = 150.0 * kPi / 180.0;
  settings.ramp = 60.0;
  const SeaState sea = makeSeaState(spectrum, settings);
  BulletWorld bullet(frigate.ship.gravity);
  Seaway seaway(bullet.world, sea);
  Ship& ship = seaway.addShip(frigate, {.model = {.mean = Mean::Fixed}});
  Recorder recorder(seaway, ship, {.every = 5});

  const double tick = 0.02, settled = 200.0, duration = 2000.0;
  Vec6 sum = Vec6::Zero(), squares = Vec6::Zero();
  double count = 0.0;
  while (seaway.time() < duration) {
    bullet.world.stepSimulation(tick, 1, tick);
    if (seaway.time() < settled) continue;
    sum += ship.motion();
    squares += ship.motion().cwiseAbs2();
    count += 1.0;
  }
  const FrequencyResponse response(frigate);
  Vec6 variance = Vec6::Zero();
  for (const WaveComponent& wave : sea.components()) {
    variance +=
        0.5 * wave.amplitude * wave.amplitude * response.at(wave.omega, wave.heading).cwiseAbs2();
  }
  bool agree = seaway.faults() == kStepOk;
  std::printf("standard deviation\nmode    Bullet    frequency domain\n");
  for (int j = 0; j < 6; ++j) {
    const double measured = std::sqrt(squares[j] / count - sum[j] * sum[j] / count / count);
    std::printf("%-6s %9.6f %9.6f %s\n", kModeNames[j], measured, std::sqrt(variance[j]),
                j < 3 ? "m" : "rad");
    // Half an hour of components 2π/Δω apart leaves about 3 % of chance in a variance of
    // neighbours' beats.
    if (j == Heave || j == Pitch)
      agree = agree && std::abs(measured / std::sqrt(variance[j]) - 1.0) < 0.05;
  }
  if (argc > 2) recorder.write(argv[2]);
  return agree ? 0 : 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "irregular_sea: %s\n", error.what());
  return 1;
}
