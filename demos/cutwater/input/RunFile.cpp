#include "demos/cutwater/input/RunFile.h"

#include <algorithm>
#include <cmath>

#include "demos/cutwater/input/ShipFile.h"
#include "demos/cutwater/input/Toml.h"
#include "demos/cutwater/output/Messages.h"
#include "hydro/Errors.h"
#include "hydro/database/CoefficientsFile.h"

namespace cutwater::command {

namespace {

constexpr double kDegree = kPi / 180.0;
constexpr double kTurn = 720.0;  // largest angle accepted [deg]

void readBullet(TomlSection bullet, RunFile& run) {
  run.tick = bullet.number("dt", run.tick, 1e-4, 1.0);
  run.substeps = bullet.integer("substeps", run.substeps, 1, 1000);
  run.duration = bullet.number("duration", run.duration, 0.0, 1e6);
  run.doublePrecision = bullet.boolean("double", run.doublePrecision);
  bullet.finish();
}

void readRegular(TomlSection& waves, RunFile& run) {
  run.waves = RunFile::Waves::Regular;
  if (!waves.has("omega")) waves.refuse("omega", "is missing; regular waves need it [rad/s]");
  run.omega = waves.numbers("omega", {}, 1e-3, 100.0);
  if (run.omega.empty()) waves.refuse("omega", "must hold a frequency");
  run.amplitude = waves.number("amplitude", run.amplitude, 0.0, 100.0);
  run.phase = kDegree * waves.number("phase_deg", 0.0, -kTurn, kTurn);
  if (waves.integer("order", 1, 1, 2) != 1) {
    waves.refuse("order",
                 "second-order waves need mode = \"nonlinear\", which is not in this version");
  }
}

void readSpectrum(TomlSection& waves, const std::string& type, RunFile& run) {
  run.waves = RunFile::Waves::Spectrum;
  run.spectrum.shape = type == "jonswap"         ? SpectrumShape::Jonswap
                       : type == "bretschneider" ? SpectrumShape::Bretschneider
                                                 : SpectrumShape::PiersonMoskowitz;
  const bool developed = type == "pierson-moskowitz";
  run.spectrum.hs = waves.number("hs", run.spectrum.hs, 0.0, 100.0);
  run.spectrum.tp = waves.number("tp", developed ? 0.0 : run.spectrum.tp, 0.1, 1000.0);
  if (type == "jonswap") run.spectrum.gamma = waves.number("gamma", run.spectrum.gamma, 1.0, 20.0);
  run.sea.spreading = waves.number("spreading", 0.0, 0.0, 1000.0);
  run.sea.components = waves.integer("components", run.sea.components, 1, 100000);
  run.sea.seed = static_cast<std::uint64_t>(waves.integer("seed", 1, 0, 2147483647));
  run.sea.omegaMin = waves.number("omega_min", 0.0, 1e-3, 100.0);
  run.sea.omegaMax = waves.number("omega_max", 0.0, 1e-3, 100.0);
  if (waves.has("omega_min") && waves.has("omega_max") && run.sea.omegaMax <= run.sea.omegaMin) {
    waves.refuse("omega_max", "must be above omega_min");
  }
}

void readComponents(TomlSection& waves, RunFile& run) {
  run.waves = RunFile::Waves::Components;
  for (TomlSection item : waves.tables("components")) {
    for (const char* key : {"omega", "amplitude"}) {
      if (!item.has(key)) item.refuse(key, "is missing");
    }
    WaveComponent wave;
    wave.omega = item.number("omega", 1.0, 1e-3, 100.0);
    wave.amplitude = item.number("amplitude", 0.0, 0.0, 100.0);
    wave.phase = kDegree * item.number("phase_deg", 0.0, -kTurn, kTurn);
    wave.heading = item.has("direction_deg")
                       ? kDegree * item.number("direction_deg", 0.0, -kTurn, kTurn)
                       : run.heading;
    item.finish();
    run.components.push_back(wave);
  }
  if (run.components.empty()) waves.refuse("components", "is missing or empty");
}

void readWaves(TomlSection waves, RunFile& run) {
  const std::string type = waves.text(
      "type", "none",
      {"regular", "jonswap", "bretschneider", "pierson-moskowitz", "components", "none"});
  run.sea.ramp = waves.number("ramp", 20.0, 0.0, 1e5);
  waves.text("profile", "extrapolated", {"extrapolated", "wheeler", "constant"});
  if (type == "regular") {
    readRegular(waves, run);
  } else if (type == "components") {
    readComponents(waves, run);
  } else if (type != "none") {
    readSpectrum(waves, type, run);
  }
  waves.finish();
}

void readStart(TomlSection start, RunFile& run) {
  const char* offsets[6] = {"x", "y", "z", "roll_deg", "pitch_deg", "yaw_deg"};
  const char* velocities[6] = {"u", "v", "w", "p", "q", "r"};
  for (int i = 0; i < 6; ++i) {
    const bool angle = i >= 3;
    run.start.offset[i] = start.number(offsets[i], 0.0, angle ? -kTurn : -1e5, angle ? kTurn : 1e5);
    if (angle) run.start.offset[i] *= kDegree;
    run.start.velocity[i] = start.number(velocities[i], 0.0, -1e3, 1e3);
  }
  start.finish();
}

void readMotion(TomlSection motion, RunFile& run) {
  run.start.speed = motion.number("speed", 0.0, -100.0, 100.0);
  run.heading = kDegree * motion.number("heading_deg", 180.0, -kTurn, kTurn);
  if (motion.text("mode", "linear", {"linear", "nonlinear"}) != "linear") {
    motion.refuse("mode", "only \"linear\" is possible in this version");
  }
  ShipModel& model = run.model;
  const bool follows = motion.text("mean", "fixed", {"fixed", "filtered"}) == "filtered";
  model.mean = follows ? Mean::Filtered : Mean::Fixed;
  model.followTime = motion.number("follow_time", model.followTime, 1.0, 1e4);
  model.hullLift = motion.boolean("hull_lift", model.hullLift);
  const bool keepSpeed = motion.boolean("keep_speed", false);
  const bool keepCourse = motion.boolean("keep_course", false);
  const bool convolution =
      motion.text("memory", "exponential", {"exponential", "convolution"}) == "convolution";
  model.memory = convolution ? MemoryModel::Convolution : MemoryModel::Exponential;
  model.without = motion.texts("without");
  run.allowUnstable = motion.boolean("allow_unstable", false);
  for (const double mode : motion.numbers("restrain", {}, 1.0, 6.0)) {
    if (mode != std::floor(mode)) motion.refuse("restrain", "must hold modes 1..6");
    model.restrained[static_cast<std::size_t>(mode) - 1] = true;
  }
  readStart(motion.table("start"), run);
  motion.finish();
  // On the initial course and speed.
  if (keepSpeed) model.keepSpeed = SpeedKeeper{.speed = run.start.speed};
  if (keepCourse) model.keepCourse = CourseKeeper{.heading = run.start.offset[Yaw]};
}

}  // namespace

RunFile readRunFile(const std::string& path) {
  TomlFile file(path);
  RunFile run;
  run.path = path;
  TomlSection& root = file.root();
  if (!root.has("database")) root.refuse("database", "is missing; make one with `cutwater solve`");
  run.database = file.beside(root.text("database", ""));
  if (root.has("ship")) run.ship = file.beside(root.text("ship", ""));
  readBullet(file.section("bullet"), run);
  readMotion(file.section("motion"), run);
  readWaves(file.section("waves"), run);
  root.finish();
  return run;
}

SeaState RunFile::seaState(double gravity, std::size_t index) const {
  switch (waves) {
    case Waves::None:
      return SeaState({}, gravity, sea.ramp);
    case Waves::Regular:
      return SeaState({{omega.at(index), amplitude, phase, heading}}, gravity, sea.ramp);
    case Waves::Components:
      return SeaState(components, gravity, sea.ramp);
    case Waves::Spectrum:
      break;
  }
  Spectrum shape = spectrum;
  shape.gravity = gravity;
  SeaStateSettings settings = sea;
  settings.heading = heading;
  return makeSeaState(shape, settings);
}

double RunFile::highestOmega(double gravity) const {
  double highest = 0.0;
  for (std::size_t i = 0; i < std::max<std::size_t>(1, omega.size()); ++i) {
    const SeaState state = seaState(gravity, i);
    for (const WaveComponent& wave : state.components()) highest = std::max(highest, wave.omega);
  }
  return highest;
}

Coefficients readShipOfRun(const RunFile& run) {
  std::string warning;
  Coefficients coefficients = readCoefficients(run.database, &warning);
  warn(warning);
  warnIfUnresolved(run.database, coefficients, run.highestOmega(coefficients.ship.gravity));
  if (run.ship.empty()) return coefficients;
  const ShipFile file = readShipFile(run.ship);
  const ShipParticulars &given = file.particulars, &solved = coefficients.ship;
  const auto same = [](double a, double b) {
    return std::abs(a - b) <= 1e-6 * (1.0 + std::abs(b));
  };
  const auto refuse = [&](const char* field) {
    throw HydroError(Fault::ValueOutOfRange, run.ship + ": [mass] " + field + ": differs from " +
                                                 run.database + "; solve again for this loading");
  };
  if (!same(given.mass, solved.mass)) refuse("mass");
  for (int i = 0; i < 3; ++i) {
    if (!same(given.cog[i], solved.cog[i])) refuse("cog");
    if (!same(given.gyradii[i], solved.gyradii[i])) refuse("gyradii");
  }
  coefficients.ship.supplementary = given.supplementary;
  return coefficients;
}

}  // namespace cutwater::command
