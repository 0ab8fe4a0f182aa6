// A frigate at Froude numbers 0.12 and 0.20 in regular head seas of growing steepness, on a fixed
// course, surge held and free: steep_head_seas DATABASE.h5 [OUT.csv [FREQUENCIES]]
// Look for: linear amplitudes are the frequency domain's, and nonlinear ones in low waves; they
// part as H/λ grows. Figures 37 and 38 of [M03]: 21 frequencies, drawn by plot_steep.gp.
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "demos/scenes/DemoShip.h"
#include "demos/scenes/HarmonicFit.h"
#include "hydro/response/FrequencyResponse.h"

using namespace cutwater;

namespace {

constexpr double kTick = 0.04;
constexpr std::array kSteepness{1.0 / 300.0, 1.0 / 30.0, 1.0 / 20.0, 1.0 / 15.0};  // H/λ
const char* const kHeader =
    "froude,surge_free,omega_scaled,lambda_over_length,steepness,heave_nonlinear,pitch_nonlinear,"
    "heave_linear,pitch_linear,heave_frequency,pitch_frequency,mean_surge_force";

// First harmonics: heave over a, pitch over k a; mean of the loads along the course [N].
struct Answer {
  double heave = 0.0, pitch = 0.0, force = 0.0;
};

struct Sea {
  double speed, omega, steepness;
};

std::array<bool, 6> held(bool surgeIsFree) {
  return {!surgeIsFree, true, false, true, false, true};
}

// A ship with free surge hangs on a soft spring and a constant pull, as in a towing tank: waves of
// this height push it astern. It stays at its place so, where the fixed course has its diffraction.
Answer sail(const Coefficients& coefficients, HullPressure mode, const Sea& sea, bool surgeIsFree,
            double pull) {
  const double k = sea.omega * sea.omega / coefficients.ship.gravity;
  const double met = sea.omega + k * sea.speed, period = 2.0 * kPi / met;
  const double amplitude = sea.steepness * kPi / k;
  BulletWorld bullet(coefficients.ship.gravity);
  Seaway seaway(bullet.world, SeaState({{sea.omega, amplitude, 0.0, kPi}},
                                       coefficients.ship.gravity, 5.0 * period));
  const ShipModel model{.mean = Mean::Fixed, .mode = mode, .restrained = held(surgeIsFree)};
  Ship& ship = seaway.addShip(coefficients, {.start = {.speed = sea.speed}, .model = model});
  std::vector<double> time, phase, heave, pitch;
  double force = 0.0;
  while (seaway.time() < 20.0 * period) {
    const double ramp = seaway.sea().ramp(seaway.time());
    ship.body().applyCentralForce(btVector3(pull * ramp * ramp, 0, 0));
    bullet.world.stepSimulation(kTick, 1, kTick);
    if (seaway.time() < 12.0 * period) continue;
    for (const Vec6& load : ship.lastTick().loads) force += load[Surge];
    time.push_back(seaway.time());
    phase.push_back(met * seaway.time());
    heave.push_back(ship.motion()[Heave]);
    pitch.push_back(ship.motion()[Pitch]);
  }
  return {std::abs(command::harmonicFit(phase, time, heave).amplitude) / amplitude,
          std::abs(command::harmonicFit(phase, time, pitch).amplitude) / (k * amplitude),
          force / static_cast<double>(time.size())};
}

// What of the nonlinear answers differs from the linear ones, at each steepness.
struct Differences {
  double linear = 0.0;  // from the frequency domain, most
  std::array<double, 4> most{}, sum{};
};

void compare(const Coefficients& coefficients, double froude, double scaled, bool surgeIsFree,
             Differences& differences, DemoTable& table) {
  const Bounds hull = bounds(coefficients.ship.wetSurface);
  const double g = coefficients.ship.gravity, length = hull.high.x() - hull.low.x();
  Sea sea{froude * std::sqrt(g * length), scaled * std::sqrt(g / length), kSteepness[0]};
  const FrequencyResponse response(coefficients, held(surgeIsFree), ForwardSpeedForm::Tuck);
  const CVec6 expected = response.at(sea.omega, kPi, sea.speed);
  const double heave = std::abs(expected[Heave]);
  const double pitch = std::abs(expected[Pitch]) * g / (sea.omega * sea.omega);
  const Answer linear = sail(coefficients, HullPressure::Linear, sea, surgeIsFree, 0.0);
  for (const double off : {linear.heave - heave, linear.pitch - pitch})
    differences.linear = std::max(differences.linear, std::abs(off));
  for (std::size_t i = 0; i < kSteepness.size(); ++i) {
    sea.steepness = kSteepness[i];
    const Answer fast = sail(coefficients, HullPressure::Nonlinear, sea, false, 0.0);
    const Answer answer =
        surgeIsFree ? sail(coefficients, HullPressure::Nonlinear, sea, true, -fast.force) : fast;
    for (const double off : {answer.heave - linear.heave, answer.pitch - linear.pitch}) {
      differences.most[i] = std::max(differences.most[i], std::abs(off));
      differences.sum[i] += std::abs(off);
    }
    table.row({froude, double(surgeIsFree), scaled, 2.0 * kPi / (scaled * scaled), sea.steepness,
               answer.heave, answer.pitch, linear.heave, linear.pitch, heave, pitch, fast.force});
  }
}

bool run(Coefficients coefficients, DemoTable& table, int frequencies) {
  // Of the tank's spring: a tenth of the waves' frequencies.
  coefficients.ship.supplementary.stiffness[Surge] = 0.01 * coefficients.ship.mass;
  coefficients.ship.supplementary.damping[Surge] = 0.06 * coefficients.ship.mass;
  Differences all;
  for (const double froude : {0.12, 0.20}) {
    for (const bool surgeIsFree : {false, true}) {
      for (int i = 0; i < frequencies; ++i)
        compare(coefficients, froude, 1.5 + 2.0 * i / (frequencies - 1), surgeIsFree, all, table);
    }
  }
  // Parts of a and k a. 0.01: the fit of the memory at speed.
  bool good = isBelow("linear, off the frequency domain by", all.linear, 0.01);
  // The linear ship has panels where the nonlinear one has its hull.
  good &= isBelow("H/L = 1/300, off the linear ship by", all.most[0], 0.02);
  for (std::size_t i = 1; i < kSteepness.size(); ++i) {
    std::printf("H/L = 1/%.0f, off the linear ship by %.3f\n", 1.0 / kSteepness[i], all.most[i]);
    good &= isBelow("  in all, less in lower waves", all.sum[i - 1], all.sum[i]);
  }
  return good;
}

}  // namespace

int main(int argc, char** argv) {
  const int frequencies = argc > 3 ? std::max(2, std::atoi(argv[3])) : 3;
  return demoMain(
      argc, argv, "steep_head_seas", kHeader,
      [&](const Coefficients& c, DemoTable& table) { return run(c, table, frequencies); });
}
