#include "demos/report_page/RunData.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>

#include "demos/cutwater/output/Messages.h"
#include "demos/cutwater/output/OutputFile.h"
#include "demos/report_page/CsvReader.h"
#include "demos/report_page/Encoding.h"
#include "demos/report_page/ShipData.h"
#include "demos/report_page/Tables.h"
#include "hydro/Errors.h"
#include "hydro/base/EnumNames.h"
#include "hydro/response/FrequencyResponse.h"

namespace cutwater::page {

namespace {

namespace fs = std::filesystem;

constexpr double kDegrees = 180.0 / kPi;

std::string csvBeside(const std::string& toml) {
  const std::string csv = fs::path(toml).replace_extension(".csv").string();
  std::error_code none;
  if (!fs::is_regular_file(csv, none))
    throw HydroError(Fault::FileNotReadable,
                     fmt::format("{}: there is no {} beside it; `cutwater simulate` or `sweep` "
                                 "writes it",
                                 toml, fs::path(csv).filename().string()));
  if (command::isOutput(csv))
    throw HydroError(Fault::FileNotWritable, csv + ": is the file that -o names");
  return csv;
}

std::string spectrumText(const Spectrum& s) {
  const std::string hs = fmt::format("Hs {:.4g} m, ", s.significantHeight());
  const std::string tp = fmt::format("Tp {:.4g} s", 2.0 * kPi / s.peakFrequency());
  switch (s.shape) {
    case SpectrumShape::Jonswap:
      return "JONSWAP, " + hs + tp;
    case SpectrumShape::Bretschneider:
      return "Bretschneider, " + hs + tp;
    case SpectrumShape::PiersonMoskowitz:
      return "Pierson-Moskowitz, " + hs + tp;
    case SpectrumShape::OchiHubble:
      return fmt::format("Ochi-Hubble, member {}, ", s.member) + hs + tp;
    case SpectrumShape::Table:
      break;
  }
  return "a spectrum of the run file's own, " + hs + tp;
}

std::string systemText(const SeaSystem& system) {
  std::string text = spectrumText(system.spectrum) +
                     fmt::format(", from {:.4g} deg", system.settings.heading * kDegrees);
  const bool half = system.settings.law == SpreadingLaw::Cos2s;
  if (system.settings.spreading > 0.0)
    text += fmt::format(", spread by {} = {:.4g}", half ? "cos^2s, s" : "cos^n, n",
                        system.settings.spreading);
  return text;
}

// The report's words for the sea of a run.
std::string seaText(const command::RunFile& run) {
  const std::string from = fmt::format("from {:.4g} deg", run.heading * kDegrees);
  switch (run.waves) {
    case command::RunFile::Waves::None:
      return "calm water";
    case command::RunFile::Waves::Regular:
      return fmt::format(
          "regular waves of {:.4g} rad/s, amplitude {:.4g} m, {}{}", run.omega.front(),
          run.amplitude,
          run.order > 1 ? fmt::format("of order {} in their steepness, ", run.order) : "", from);
    case command::RunFile::Waves::Components:
      return fmt::format("{} wave{} of the run file's own", run.components.size(),
                         run.components.size() == 1 ? "" : "s");
    case command::RunFile::Waves::Spectrum:
      break;
  }
  std::string text;
  for (const SeaSystem& system : run.systems)
    text += (text.empty() ? "" : "; and ") + systemText(system);
  return text;
}

/// What the page sums to the surface: a sea's components, or a steep wave's harmonics.
struct DrawnWaves {
  std::vector<WaveComponent> waves;
  std::vector<double> waveNumbers;
};

DrawnWaves drawnWaves(const SeaState& sea) {
  DrawnWaves drawn;
  for (std::size_t i = 0; i < sea.components().size(); ++i) {
    const WaveComponent& wave = sea.components()[i];
    const double k = sea.waveNumber(i);
    if (!sea.stokes()) {
      drawn.waves.push_back(wave);
      drawn.waveNumbers.push_back(k);
      continue;
    }
    const StokesWave::Series series = sea.stokes()->series(1.0);
    for (std::size_t j = 0; j < StokesWave::kHarmonics; ++j) {
      if (series.elevation[j] == 0.0) continue;
      const auto n = static_cast<double>(j + 1);
      drawn.waves.push_back({n * wave.omega, series.elevation[j], n * wave.phase, wave.heading});
      drawn.waveNumbers.push_back(n * k);
    }
  }
  return drawn;
}

void seaJson(Json& json, const command::RunFile& run, double gravity) {
  const SeaState sea = run.seaState(gravity);
  json.beginObject().field("text", seaText(run));
  if (run.systems.size() == 1) {
    Spectrum of = run.systems.front().spectrum;
    of.gravity = gravity;
    json.field("hs", of.significantHeight()).field("tp", 2.0 * kPi / of.peakFrequency());
    if (of.shape == SpectrumShape::Jonswap) json.field("gamma", of.gamma);
  }
  json.field("ramp", run.sea.ramp);
  const DrawnWaves drawn = drawnWaves(sea);
  const auto column = [&](const char* name, double WaveComponent::*part) {
    std::vector<double> numbers;
    for (const WaveComponent& wave : drawn.waves) numbers.push_back(wave.*part);
    json.key(name);
    blob64(json, numbers);
  };
  column("omega", &WaveComponent::omega);
  column("amplitude", &WaveComponent::amplitude);
  column("phase", &WaveComponent::phase);
  column("heading", &WaveComponent::heading);
  json.key("k");
  blob64(json, drawn.waveNumbers);
  json.end();
}

// Motions per metre of wave at the run's speed and heading; null where there are none.
void linearJson(Json& json, const ShownRun& run) {
  const Coefficients& c = *run.of;
  const ShipModel& model = run.file.model;
  const std::vector<double> omegas = waveGrid(c);
  std::vector<double> numbers;
  try {
    const FrequencyResponse response =
        model.mean == Mean::Free ? FrequencyResponse(c, {model.hullLift}, model.restrained)
                                 : FrequencyResponse(c, model.restrained, c.forwardSpeed);
    for (const double omega : omegas)
      append(numbers, response.atOrNan(omega, run.file.heading, run.file.start.speed));
  } catch (const HydroError& error) {
    command::warn(run.file.path + ": no linear prediction on the page: " + error.what());
    json.null();
    return;
  }
  json.beginObject().key("omega").list(omegas).key("values");
  blob32(json, numbers);
  json.end();
}

void bodyJson(Json& json, const ShownRun& run) {
  json.key("body");
  if (run.of) {
    json.null().key("hull");
    if (run.ofPage) {
      json.null();
    } else {
      hullJson(json, run.of->ship);
    }
    json.field("cogZ", run.of->ship.cog.z());
    return;
  }
  const Vec3& size = run.file.body->size;
  json.beginObject().key("size").list({size.data(), 3}).end();
  json.key("hull").null().key("cogZ").null();
}

// Rooms of the ship, about G as the hull; their water is in columns of theirs.
void compartmentsJson(Json& json, const ShownRun& run) {
  json.key("compartments").beginArray();
  for (const command::RunCompartment& room : run.file.compartments) {
    const CompartmentBox& box = room.box;
    const Vec3 centre = box.centre - (run.of ? run.of->ship.cog : Vec3(Vec3::Zero()));
    json.beginObject().field("name", box.name).field("permeability", box.permeability);
    json.key("centre").list({centre.data(), 3}).key("size").list({box.size.data(), 3}).end();
  }
  json.end();
}

const char* modeName(const ShownRun& run) {
  const ShipModel& model = run.file.model;
  const bool closed = run.of && !run.of->ship.hull.faces.empty();
  const bool usual = model.mean == Mean::Free && closed;
  return nameOf(kHullPressureNames,
                model.mode.value_or(usual ? HullPressure::Nonlinear : HullPressure::Linear));
}

}  // namespace

ShownRun readShownRun(const std::string& path, const std::string& database,
                      const Coefficients& coefficients) {
  ShownRun run;
  run.csv = csvBeside(path);
  run.kind = kindOf(run.csv);
  const bool sweep = run.kind == RunKind::Sweep;
  run.file = command::readRunFile(path, sweep ? Mean::Fixed : Mean::Free, command::RunUse::Show);
  if (run.file.database.empty()) {
    run.file.database = database;
    command::warnOfSea(run.file, coefficients.ship.gravity);
    return run;
  }
  std::error_code none;
  run.ofPage = fs::equivalent(run.file.database, database, none);
  run.of = command::readShipOfRun(run.file);
  return run;
}

void runJson(Json& json, const ShownRun& run, double gravity) {
  const fs::path path(run.file.path);
  const bool sweep = run.kind == RunKind::Sweep;
  json.beginObject().field("name", path.stem().string()).field("file", path.filename().string());
  json.field("kind", sweep ? "sweep" : "simulate");
  bodyJson(json, run);
  compartmentsJson(json, run);
  json.field("gravity", gravity).field("double", run.file.doublePrecision);
  json.field("dt", run.file.tick).field("mode", modeName(run));
  json.field("mean", run.file.model.mean == Mean::Free ? "free" : "fixed");
  json.field("speed", run.file.start.speed).field("headingDeg", run.file.heading * kDegrees);
  json.field("profile", nameOf(kWaveProfileNames, run.file.sea.profile)).key("sea");
  if (sweep) {
    json.null().key("columns").null().key("parts").beginArray().end();
  } else {
    seaJson(json, run.file, gravity);
    columnsJson(json, run.csv);
  }
  json.key("linear");
  if (run.of) {
    linearJson(json, run);
  } else {
    json.null();
  }
  json.key("sweep");
  if (sweep) {
    sweepJson(json, run.csv);
  } else {
    json.null();
  }
  json.end();
}

}  // namespace cutwater::page
