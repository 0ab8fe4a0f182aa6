#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "demos/cutwater/commands/Commands.h"
#include "demos/cutwater/input/RunFile.h"
#include "demos/cutwater/output/Csv.h"
#include "demos/cutwater/output/Listing.h"
#include "hydro/base/EnumNames.h"
#include "hydro/database/CoefficientsFile.h"
#include "hydro/waves/SeaStatistics.h"

namespace cutwater::command {

namespace {

constexpr double kDegrees = 180.0 / kPi;

double outsideOf(const SeaSystem& system) {
  const auto [from, to] = cutOffs(system.spectrum, system.settings);
  return 1.0 - shareOfEnergy(system.spectrum, from, to);
}

// What of m0 the cut-offs of all systems leave out together.
double shareOutside(const std::vector<SeaSystem>& systems) {
  double all = 0.0, outside = 0.0;
  for (const SeaSystem& system : systems) {
    const double m0 = system.spectrum.moment(0);
    all += m0;
    outside += m0 * outsideOf(system);
  }
  return all > 0.0 ? outside / all : 0.0;
}

std::string shapeText(const Spectrum& s) {
  std::string text = fmt::format("{}: Hs {:.6g} m, Tp {:.4g} s", nameOf(kSpectrumNames, s.shape),
                                 s.significantHeight(), 2.0 * kPi / s.peakFrequency());
  if (s.shape == SpectrumShape::Jonswap)
    text += fmt::format(", gamma {:.4g}, normalisation {}", s.gamma,
                        nameOf(kNormalisationNames, s.normalisation));
  if (s.shape == SpectrumShape::OchiHubble)
    text += fmt::format(", member {}, its published shares scaled to hs", s.member);
  return text;
}

std::string spreadText(const SeaStateSettings& s) {
  if (s.spreading == 0.0) return "long-crested";
  return fmt::format("{} {:.4g}, sigma {:.4g} deg", nameOf(kSpreadingNames, s.law), s.spreading,
                     kDegrees * spreadingWidth(s.law, s.spreading));
}

void sayOf(const SeaSystem& system) {
  const SeaStateSettings& s = system.settings;
  const auto [from, to] = cutOffs(system.spectrum, s);
  say(fmt::format(
      "{}; heading {:.4g} deg, {}; {} waves of {:.4g} to {:.4g} rad/s, seed {}; {:.3g} % "
      "of m0 lies outside and is spread over these",
      shapeText(system.spectrum), kDegrees * s.heading, spreadText(s), s.components, from, to,
      s.seed, 100.0 * outsideOf(system)));
}

void sayWhenItRepeats(const RepeatTime& repeat) {
  if (std::isfinite(repeat.time)) {
    say(fmt::format("repeats after {:.6g} s: there the correlation with itself is {:.3g} or more",
                    repeat.time, kRepeated));
  } else {
    say(fmt::format(
        "does not repeat within {:.6g} s: its correlation with itself stays below {:.3g}",
        repeat.searched, kRepeated));
  }
}

// Gravity, of which waves' lengths and a fully developed sea's period depend, is the database's.
double gravityOf(const RunFile& run) {
  if (run.database.empty()) return kStandardGravity;
  std::string warning;
  return readCoefficients(run.database, &warning).ship.gravity;
}

// In (−180, 180], as csvNumber writes it.
double degreesOf(double angle) { return phaseDegrees(std::polar(1.0, angle)); }

void writeWaves(const SeaState& sea, const std::string& out) {
  Csv csv("omega,heading_deg,amplitude,phase_deg");
  for (const WaveComponent& wave : sea.components())
    csv.row({wave.omega, degreesOf(wave.heading), wave.amplitude, degreesOf(wave.phase)});
  csv.write(out);
}

void writeMoments(const SeaState& sea, double outside, double repeat, const std::string& out) {
  const SeaMoments moments = momentsOf(sea);
  Listing rows;
  rows.add("hs", moments.significantHeight(), "m");
  rows.add("m0", moments.m0, "m2");
  rows.add("m1", moments.m1, "m2/s");
  rows.add("m2", moments.m2, "m2/s2");
  rows.add("tz", moments.zeroCrossingPeriod(), "s");
  rows.add("tm01", moments.meanPeriod(), "s");
  rows.add("repeat_time", repeat, "s");
  rows.add("share_outside", outside, "1");
  rows.write(out);
}

}  // namespace

void sea(const std::string& path, bool moments, const std::string& out) {
  const RunFile run = readRunFile(path, Mean::Free, RunUse::Sea);
  if (run.omega.size() > 1)
    throw HydroError(Fault::ValueOutOfRange,
                     path + ": [waves] omega: several waves one by one are several seas; give one");
  const double gravity = gravityOf(run);
  naming(path, [&] {
    const SeaState state = run.seaState(gravity);
    const std::vector<SeaSystem> systems = run.systemsAt(gravity);
    warnOfSea(run, gravity);
    for (const SeaSystem& system : systems) sayOf(system);
    const RepeatTime repeat = repeatTime(state);
    if (!state.components().empty()) sayWhenItRepeats(repeat);
    if (moments) {
      writeMoments(state, shareOutside(systems), repeat.time, out);
    } else {
      writeWaves(state, out);
    }
  });
}

}  // namespace cutwater::command
