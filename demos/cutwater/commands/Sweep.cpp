#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>

#include "demos/cutwater/commands/Commands.h"
#include "demos/cutwater/commands/HullWarnings.h"
#include "demos/cutwater/commands/Precision.h"
#include "demos/cutwater/commands/RunShip.h"
#include "demos/cutwater/output/Csv.h"
#include "demos/cutwater/output/Progress.h"
#include "demos/scenes/HarmonicFit.h"
#include "hydro/Errors.h"
#include "hydro/base/ParallelFor.h"
#include "hydro/response/FrequencyResponse.h"
#include "hydro/waves/Wave.h"

namespace cutwater::command {

namespace {

double encounterOf(const RunFile& run, double gravity, std::size_t index) {
  return encounterFrequency(run.omega[index], run.start.speed, run.heading, gravity);
}

constexpr double kOtherWay = 0.01;    // of the encounter frequency
constexpr double kLargestRest = 0.5;  // of the harmonic: r.m.s. of what a fit may leave

// What one wave gave.
struct WaveRun {
  CVec6 amplitude = CVec6::Constant(Complex(std::nan(""), std::nan("")));  // of a run that broke
  std::string ranAway{};  // why motions are no answer to the wave
  RunFaults faults{};
  HullNotes hull{};
};

// The second half of a run.
struct Motions {
  std::vector<double> time;
  std::array<std::vector<double>, 6> of;
};

// Of a free ship its place, attitude and heading, of which the fit takes a straight line.
Vec6 motionOf(const Ship& ship, const RunFile& run) {
  if (run.model.mean == Mean::Fixed) return ship.motion();
  Vec6 motion;
  motion << ship.position(), ship.attitude();
  return motion;
}

// Phase of the wave where the ship is in the mean: on its course, or on the line that fits a free
// ship's track.
std::vector<double> phasesOf(const RunFile& run, std::size_t index, double gravity,
                             const Motions& motion) {
  const double omega = run.omega[index], k = omega * omega / gravity;
  const double omegaE = encounterOf(run, gravity, index);
  std::vector<double> phase;
  for (const double t : motion.time) phase.push_back(omegaE * t);
  if (run.model.mean == Mean::Fixed) return phase;
  const HarmonicFit x = harmonicFit(phase, motion.time, motion.of[Surge]);
  const HarmonicFit y = harmonicFit(phase, motion.time, motion.of[Sway]);
  for (std::size_t i = 0; i < phase.size(); ++i) {
    const double t = motion.time[i];
    phase[i] = omega * t - k * ((x.constant + x.slope * t) * std::cos(run.heading) -
                                (y.constant + y.slope * t) * std::sin(run.heading));
  }
  return phase;
}

// Amplitudes per metre and relative to the wave's crest at G. What is mostly no harmonic is no
// answer to the wave: a mode that nothing holds ran away.
void fit(const RunFile& run, std::size_t index, double gravity, const Motions& motion,
         WaveRun& result) {
  const std::vector<double> phase = phasesOf(run, index, gravity, motion);
  const double nominal = encounterOf(run, gravity, index);
  const double met = (phase.back() - phase.front()) / (motion.time.back() - motion.time.front());
  if (std::abs(met - nominal) > kOtherWay * std::abs(nominal)) {
    result.ranAway = fmt::format(
        "the ship did not keep its way and met the waves at {:.4g} instead "
        "of {:.4g} rad/s (keep_speed, keep_course, resistance = false)",
        met, nominal);
    return;
  }
  const double k = run.omega[index] * run.omega[index] / gravity;
  for (std::size_t j = 0; j < 6; ++j) {
    const HarmonicFit found = harmonicFit(phase, motion.time, motion.of[j]);
    const double usual = run.amplitude * (j < 3 ? 1.0 : k);
    const double size = std::max(std::abs(found.amplitude), usual) / std::sqrt(2.0);
    if (found.rest > kLargestRest * size) {
      result.ranAway += std::string(result.ranAway.empty() ? "" : ", ") + kModeNames[j];
    } else {
      result.amplitude[static_cast<int>(j)] =
          found.amplitude / std::polar(run.amplitude, run.phase);
    }
  }
  if (!result.ranAway.empty())
    result.ranAway +=
        ": the motion is no harmonic: nothing holds that mode, or it has not settled yet and "
        "needs a longer duration";
}

// Motions in one regular wave, fitted over the second half.
WaveRun motionInBullet(const RunFile& run, const std::shared_ptr<const Hydrodynamics>& ship,
                       std::size_t index) {
  RunShip world(run, ship, index);
  Motions motion;
  while (world.seaway().time() < run.duration && !world.broken()) {
    world.step();
    if (world.seaway().time() < 0.5 * run.duration) continue;
    motion.time.push_back(world.seaway().time());
    const Vec6 now = motionOf(world.ship(), run);
    for (std::size_t j = 0; j < 6; ++j) motion.of[j].push_back(now[static_cast<int>(j)]);
  }
  WaveRun result{.faults = world.faults(), .hull = hullNotes(world.ship())};
  result.faults.of = result.hull.of = "omega = " + csvNumber(run.omega[index]);
  if (!world.broken()) fit(run, index, ship->ship().gravity, motion, result);
  return result;
}

void check(const RunFile& run) {
  const auto refuse = [&](const std::string& what) {
    throw HydroError(Fault::ValueOutOfRange, run.path + ": " + what);
  };
  if (run.waves != RunFile::Waves::Regular) refuse("[waves] type: a sweep needs \"regular\"");
  if (!(run.amplitude > 0.0)) refuse("[waves] amplitude = 0: a sweep needs waves");
}

// Leaves out, saying so, what is met too slowly.
void keepWhatCanBeMet(RunFile& run, const Coefficients& coefficients) {
  std::vector<double> met;
  for (std::size_t i = 0; i < run.omega.size(); ++i) {
    const double omega = run.omega[i], omegaE = encounterOf(run, coefficients.ship.gravity, i);
    if (std::abs(omegaE) < kLeastEncounterFrequency) {
      warn(run.path + ": [waves] omega = " + csvNumber(omega) +
           " is met at omega_e = " + csvNumber(omegaE) + " rad/s, below " +
           csvNumber(kLeastEncounterFrequency) + ": left out");
      continue;
    }
    // The second half of the run must hold two periods and the ramp must be over.
    if (run.duration < std::max(2.0 * run.sea.ramp, 8.0 * kPi / std::abs(omegaE))) {
      throw HydroError(Fault::ValueOutOfRange,
                       run.path + ": [bullet] duration = " + csvNumber(run.duration) +
                           ": too short to fit omega = " + csvNumber(omega) + ", omega_e = " +
                           csvNumber(omegaE) + "; needs twice the ramp and four periods");
    }
    met.push_back(omega);
  }
  run.omega = met;
  if (!met.empty()) return;
  throw HydroError(Fault::ValueOutOfRange,
                   run.path + ": [waves] omega: no wave is met at omega_e of " +
                       csvNumber(kLeastEncounterFrequency) + " rad/s or more");
}

// Every wave in a Bullet world of its own, waves shared among threads.
std::vector<WaveRun> runAll(const RunFile& run, const std::shared_ptr<const Hydrodynamics>& ship,
                            int threads) {
  std::vector<WaveRun> results(run.omega.size());
  std::atomic<int> done{0};
  Progress progress("sweep", Progress::Elsewhere::Nothing);
  const int total = static_cast<int>(results.size());
  parallelFor(results.size(), threads, [&](std::size_t i) {
    results[i] = motionInBullet(run, ship, i);
    const int now = ++done;
    progress.show(now, total, [=](double elapsed, double left) {
      return fmt::format("sweep: {}/{} frequencies, {:.0f} s, {:.0f} s left", now, total, elapsed,
                         left);
    });
  });
  return results;
}

// Warns of all runs together; ends the command if one broke.
void tellFaults(const std::string& path, const std::vector<WaveRun>& waves) {
  std::vector<RunFaults> runs;
  for (const WaveRun& wave : waves) runs.push_back(wave.faults);
  for (const std::string& line : warningLines(runs)) warn(path + ": " + line);
  std::string broken;
  for (const RunFaults& run : runs) {
    if (run.broken()) broken += (broken.empty() ? ": " : "; ") + brokenLine(run);
  }
  if (broken.empty()) return;
  throw HydroError(Fault::ValueOutOfRange, path + broken + "; written as nan, the others are good");
}

// Warns of motions that were no answer to the wave.
void warnOfRunaways(const RunFile& run, const std::vector<WaveRun>& waves) {
  for (std::size_t i = 0; i < waves.size(); ++i) {
    if (waves[i].ranAway.empty()) continue;
    warn(fmt::format("{}: [waves] omega = {}: {}; written as nan", run.path,
                     csvNumber(run.omega[i]), waves[i].ranAway));
  }
}

void warnOfHulls(const RunFile& run, const std::vector<WaveRun>& waves) {
  std::vector<HullNotes> hulls;
  for (const WaveRun& wave : waves) hulls.push_back(wave.hull);
  for (const std::string& line : hullWarnings(run, hulls)) warn(run.path + ": " + line);
}

// Ends the command if no mode that was free answered a wave.
void requireAnAnswer(const RunFile& run, const std::vector<WaveRun>& waves) {
  bool ran = false;
  for (const WaveRun& wave : waves) {
    ran = ran || !wave.ranAway.empty();
    for (std::size_t j = 0; j < 6; ++j) {
      const bool answered = std::isfinite(wave.amplitude[static_cast<int>(j)].real());
      if (answered && !run.model.restrained.at(j)) return;
    }
  }
  if (ran)
    throw HydroError(Fault::ValueOutOfRange,
                     run.path +
                         ": [motion]: in no wave a motion was harmonic; hold the modes that "
                         "run away (restrain, stiffness, keep_course)");
}

}  // namespace

void sweep(const std::string& path, int threads, const std::string& out) {
  RunFile run = readRunFile(path, Mean::Fixed);
  usePrecision(run.doublePrecision);
  check(run);
  const auto ship = hydrodynamicsOf(run);
  const Coefficients& coefficients = ship->coefficients();
  keepWhatCanBeMet(run, coefficients);
  const double ticks = 0.5 * run.duration / run.tick;  // of each, in seven series that double
  requireMemory(
      fmt::format("{}: [bullet] duration = {}, dt = {}", run.path, run.duration, run.tick),
      2.0 * 7.0 * 8.0 * ticks *
          static_cast<double>(std::min(workersFor(threads), run.omega.size())));
  const bool free = run.model.mean == Mean::Free;
  const FrequencyResponse response =
      free ? FrequencyResponse(coefficients, {run.model.hullLift}, run.model.restrained)
           : FrequencyResponse(coefficients, run.model.restrained, ship->form());
  std::vector<WaveRun> waves;
  naming(path, [&] { waves = runAll(run, ship, threads); });
  Csv csv("omega,omega_e,j,time_amplitude,time_phase_deg,freq_amplitude,freq_phase_deg");
  for (std::size_t i = 0; i < run.omega.size(); ++i) {
    const CVec6 frequency = response.at(run.omega[i], run.heading, run.start.speed);
    const double omegaE = encounterOf(run, coefficients.ship.gravity, i);
    const CVec6& inTime = waves[i].amplitude;
    for (int j = 0; j < 6; ++j) {
      csv.row({run.omega[i], omegaE, j + 1.0, std::abs(inTime[j]), phaseDegrees(inTime[j]),
               std::abs(frequency[j]), phaseDegrees(frequency[j])});
    }
  }
  csv.write(out);
  warnOfHulls(run, waves);
  warnOfRunaways(run, waves);
  tellFaults(path, waves);
  requireAnAnswer(run, waves);
}

}  // namespace cutwater::command
