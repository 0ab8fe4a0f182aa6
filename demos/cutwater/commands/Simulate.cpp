#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "demos/cutwater/commands/Commands.h"
#include "demos/cutwater/commands/HullWarnings.h"
#include "demos/cutwater/commands/Precision.h"
#include "demos/cutwater/commands/RunShip.h"
#include "demos/cutwater/output/Csv.h"
#include "demos/cutwater/output/Progress.h"
#include "hydro/Errors.h"
#include "hydro/base/EnumNames.h"
#include "hydro/memory/SpeedStability.h"
#include "plugin/Recorder.h"

namespace cutwater::command {

namespace {

// What each part of the load did in this run, and what it cost.
void printParts(const Recorder& recorder, const Ship& ship) {
  const std::vector<std::string_view> parts = ship.parts();
  const std::vector<double> costs = ship.costs();
  const auto first = recorder.columns().size() - 6 * parts.size();
  for (std::size_t i = 0; i < parts.size(); ++i) {
    Vec6 mean = Vec6::Zero();
    for (std::size_t row = 0; row < recorder.rows(); ++row) {
      for (std::size_t j = 0; j < 6; ++j)
        mean[static_cast<int>(j)] += recorder.at(row, first + 6 * i + j);
    }
    mean /= static_cast<double>(recorder.rows());
    std::string line = fmt::format("{}: mean", parts[i]);
    for (const double value : mean) line += fmt::format(" {:.5g}", value);
    if (costs[i] > 0.0) line += fmt::format(", {:.0f} ns a tick", costs[i]);
    say(line);
  }
}

// Refuses a speed at which the ship's own motions grow; a ship that leaves its course is warned of.
void checkStability(const RunFile& run, const Hydrodynamics& ship) {
  const SpeedStability& stability = ship.stability();
  const double speed = run.start.speed;
  const GrowthLimit& limit = speed < 0.0 ? stability.astern : stability.ahead;
  const bool held = run.model.restrained.at(static_cast<std::size_t>(limit.mode));
  if (limit.speed && !held && std::abs(speed) >= *limit.speed) {
    const std::string line =
        fmt::format("[motion] speed = {} m/s: {} (form {})", speed, describe(limit, speed < 0.0),
                    nameOf(kForwardSpeedNames, ship.form()));
    const char* other =
        ship.form() == ForwardSpeedForm::Tuck ? "" : "solve with forward_speed = \"tuck\", ";
    if (!run.allowUnstable)
      throw HydroError(
          Fault::ValueOutOfRange,
          line + "; " + other + "go slower, restrain that mode, or set allow_unstable = true");
    warn(run.path + ": " + line);
  }
  if (run.model.mean == Mean::Free && !run.model.keepCourse && stability.course &&
      speed >= *stability.course)
    warn(
        fmt::format("{}: [motion] speed = {} m/s: the ship does not keep its course by itself from "
                    "{:.3g} m/s on",
                    run.path, speed, *stability.course));
}

// A ship on a steady course whose yaw nothing holds leaves it, which its theory does not know.
void warnOfLooseYaw(const RunFile& run, const ShipParticulars& ship) {
  const ShipModel& model = run.model;
  const bool held = model.restrained.at(Yaw) || model.keepCourse.has_value() ||
                    ship.supplementary.stiffness[Yaw] > 0.0;
  if (model.mean == Mean::Free || run.start.speed == 0.0 || held) return;
  warn(
      fmt::format("{}: [motion] speed = {} m/s on a fixed course, and nothing holds the yaw: give "
                  "yaw_stiffness or keep_course, restrain it, or set mean = \"free\"",
                  run.path, run.start.speed));
}

// Without adjoint vectors diffraction is known at rest alone.
void warnOfDiffraction(const RunFile& run, const Coefficients& coefficients) {
  if (run.model.mean == Mean::Fixed || !coefficients.adjoint.empty()) return;
  if (run.waves == RunFile::Waves::None) return;
  warn(
      fmt::format("{}: {} holds no adjoint vectors: a free ship's diffraction forces are those at "
                  "rest, whatever way it makes; `cutwater solve` makes databases that hold them",
                  run.path, run.database));
}

// Of the run, if they and their text, which grows by doubling, fit into memory.
std::size_t rowsOf(const RunFile& run, std::size_t columns) {
  const double rows = std::floor(run.duration / run.tick + 1e-6) + 1.0;
  constexpr double kBytes = 8.0 + 2.0 * 14.0;  // of a number, and as text
  const std::string what = fmt::format("{}: [bullet] duration = {}, dt = {}: {:.6g} rows", run.path,
                                       run.duration, run.tick, rows);
  requireMemory(what, kBytes * rows * static_cast<double>(columns));
  if (rows > 2e9) throw HydroError(Fault::ValueOutOfRange, what + ", more than 2e9");
  return static_cast<std::size_t>(rows);
}

// Rows of the ticks before the one that broke are kept.
void writeRows(const RunFile& run, const Recorder& recorder, RunShip& world,
               const std::string& out) {
  const RunFaults faults = world.faults();
  const std::size_t rows = world.broken() ? world.goodTicks() : recorder.rows();
  writeText(recorder.csv(rows), out);
  for (const std::string& line : warningLines({faults})) warn(run.path + ": " + line);
  if (!world.broken()) return;
  throw HydroError(
      Fault::ValueOutOfRange,
      fmt::format("{}: {}; the run ended there, {} row{} before it {} written", run.path,
                  brokenLine(faults), rows, rows == 1 ? "" : "s", rows == 1 ? "is" : "are"));
}

// A free ship may come to any heading, so that a table of headings has to go all round.
void placeShip(const RunFile& run, const std::shared_ptr<const Hydrodynamics>& ship,
               std::optional<RunShip>& made) {
  try {
    made.emplace(run, ship);
  } catch (const HydroError& error) {
    std::string advice;
    if (run.model.mean == Mean::Free && ship->coefficients().adjoint.empty())
      advice = "; a free ship needs all headings: solve them, or set [motion] mean = \"fixed\"";
    throw HydroError(error.fault(), run.path + ": " + error.what() + advice);
  }
}

// "t = 123/600 s, 58x real time, 8 s left, roll 3.1 pitch -0.4 deg, heave 0.52 m": 80 columns.
std::string stateText(RunShip& world, const RunFile& run, double elapsed, double left) {
  const Ship& ship = world.ship();
  const double time = world.seaway().time();
  const Vec3 degrees = ship.attitude() * (180.0 / kPi);
  return fmt::format(
      "t = {:.0f}/{:.0f} s, {:.0f}x real time, {:.0f} s left, roll {:.1f} pitch {:.1f} deg, heave "
      "{:.2f} m",
      time, run.duration, elapsed > 0.0 ? time / elapsed : 0.0, left, degrees.x(), degrees.y(),
      ship.position().z() - ship.hydrodynamics().ship().cog.z());
}

// All ticks of the run, or those up to the one that breaks something.
void stepAll(const RunFile& run, const Recorder& recorder, RunShip& world, std::size_t rows) {
  Progress progress("simulate", Progress::Elsewhere::Nothing);
  while (recorder.rows() < rows && !world.broken()) {
    world.step();
    progress.show(
        static_cast<int>(std::min(recorder.rows(), rows)), static_cast<int>(rows),
        [&](double elapsed, double left) { return stateText(world, run, elapsed, left); });
  }
}

void requireWetted(const RunFile& run, const RunColumns& columns, const Ship& ship) {
  if (!columns.wetted || ship.wetted()) return;
  throw HydroError(Fault::BadArgument,
                   run.path +
                       ": --wetted: this run is in mode = \"linear\", whose hull is always wet as "
                       "it is at rest; set [motion] mode = \"nonlinear\"");
}

}  // namespace

std::shared_ptr<const Hydrodynamics> hydrodynamicsOf(RunFile& run) {
  Coefficients coefficients = readShipOfRun(run);
  warnOfResonances(run.database, coefficients);
  std::shared_ptr<const Hydrodynamics> ship;
  naming(run.database,
         [&] { ship = std::make_shared<const Hydrodynamics>(std::move(coefficients)); });
  naming(run.path, [&] { checkStability(run, *ship); });
  warnOfLooseYaw(run, ship->ship());
  warnOfDiffraction(run, ship->coefficients());
  return ship;
}

void simulate(const std::string& path, const RunColumns& columns, const std::string& out) {
  RunFile run = readRunFile(path, Mean::Free);
  usePrecision(run.doublePrecision);
  if (run.omega.size() > 1) {
    throw HydroError(Fault::ValueOutOfRange,
                     path + ": [waves] omega: simulate takes one frequency; `sweep` takes several");
  }
  const auto ship = hydrodynamicsOf(run);
  std::optional<RunShip> made;
  placeShip(run, ship, made);
  RunShip& world = *made;
  for (const std::string& line : hullWarnings(run, {hullNotes(world.ship())}))
    warn(run.path + ": " + line);
  if (const std::string line = world.ship().seaWarning(); !line.empty())
    warn(run.path + ": [waves] " + line);
  requireWetted(run, columns, world.ship());
  world.ship().measureCosts(columns.forces);
  Recorder recorder(world.seaway(), world.ship(),
                    {.forces = columns.forces,
                     .compartments = !run.compartments.empty(),
                     .wetted = columns.wetted});
  const std::size_t rows = rowsOf(run, recorder.columns().size());
  recorder.reserve(rows + static_cast<std::size_t>(run.substeps));
  stepAll(run, recorder, world, rows);
  writeRows(run, recorder, world, out);
  if (columns.forces) printParts(recorder, world.ship());
}

}  // namespace cutwater::command
