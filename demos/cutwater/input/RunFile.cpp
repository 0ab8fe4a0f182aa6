#include "demos/cutwater/input/RunFile.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "demos/cutwater/input/ShipFile.h"
#include "demos/cutwater/input/Toml.h"
#include "demos/cutwater/output/Messages.h"
#include "hydro/Errors.h"
#include "hydro/base/EnumNames.h"
#include "hydro/database/CoefficientsFile.h"

namespace cutwater::command {

namespace {

constexpr double kDegree = kPi / 180.0;
constexpr double kTurn = 720.0;  // largest angle accepted [deg]

// [rad] of an angle in degrees; the same direction within ±`largest` where it is beyond.
double radians(double degrees, double largest) {
  return kDegree * (std::abs(degrees) <= largest ? degrees : std::remainder(degrees, 360.0));
}

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
  run.order = waves.integer("order", 1, 1, 5);
  if (run.order == 1) return;
  if (run.order != 2 && run.order != 5) waves.refuse("order", "there are 1, 2 and 5");
  const ShipModel& model = run.model;
  if (model.mode ? *model.mode == HullPressure::Linear : model.mean == Mean::Fixed)
    waves.refuse(
        "order",
        "of steep waves acts on the wetted hull; take [motion] mode = \"nonlinear\", or 1");
  if (waves.has("profile"))
    waves.refuse("profile", "is not for steep waves, whose pressure is their own; leave it out");
}

constexpr const char* kDeep =
    "waves and ships are those of deep water; leave it out. In water less deep than half a wave's "
    "length real waves of this period are shorter and steeper, and their loads are not these";

bool isSpectrum(const std::string& type) {
  return fromName<SpectrumShape>(kSpectrumNames, type).has_value();
}

// What belongs to one shape alone.
void readShape(TomlSection& waves, Spectrum& spectrum) {
  const SpectrumShape shape = spectrum.shape;
  if (shape == SpectrumShape::Table) {
    if (!waves.has("file")) waves.refuse("file", "is missing; a CSV file with columns omega,S");
    spectrum.table = readSpectrumTable(waves.file("file"));
    return;
  }
  spectrum.hs = waves.number("hs", spectrum.hs, 0.0, 100.0);
  if (shape == SpectrumShape::OchiHubble) {
    spectrum.member = waves.integer("member", 0, 0, 10);
    return;
  }
  const bool developed = shape == SpectrumShape::PiersonMoskowitz;
  spectrum.tp = waves.number("tp", developed ? 0.0 : spectrum.tp, 0.1, 1000.0);
  if (shape != SpectrumShape::Jonswap) return;
  spectrum.gamma = waves.number("gamma", spectrum.gamma, 1.0, 20.0);
  spectrum.normalisation =
      waves.choice("normalisation", kNormalisationNames, spectrum.normalisation);
}

void requireCutOffs(const TomlSection& waves, const SeaSystem& system) {
  const auto [from, to] = cutOffs(system.spectrum, system.settings);
  if (from < to) return;
  const bool ownMin = waves.has("omega_min"), ownMax = waves.has("omega_max");
  if (ownMax)
    waves.refuse("omega_max", fmt::format("must be above omega_min{} {:.4g} rad/s",
                                          ownMin ? " =" : ", of itself", from));
  waves.refuse("omega_min", fmt::format("must be below omega_max, of itself {:.4g} rad/s", to));
}

void readSystem(TomlSection& waves, const std::string& type, double heading, RunFile& run) {
  SeaSystem system;
  system.spectrum.shape = *fromName<SpectrumShape>(kSpectrumNames, type);
  readShape(waves, system.spectrum);
  SeaStateSettings& sea = system.settings;
  sea.heading = heading;
  sea.spreading = waves.number("spreading", 0.0, 0.0, 1000.0);
  sea.law = waves.choice("spreading_law", kSpreadingNames, sea.law);
  sea.components = waves.integer("components", sea.components, 1, 100000);
  sea.seed = static_cast<std::uint64_t>(waves.integer("seed", 1, 0, 2147483647));
  sea.omegaMin = waves.number("omega_min", 0.0, 1e-3, 100.0);
  sea.omegaMax = waves.number("omega_max", 0.0, 1e-3, 100.0);
  requireCutOffs(waves, system);
  run.systems.push_back(std::move(system));
}

// Each with its own heading; the usual kind is JONSWAP.
void readSystems(TomlSection& waves, RunFile& run) {
  for (TomlSection item : waves.tables("systems")) {
    const std::string type =
        item.text("type", "jonswap", {kSpectrumNames.begin(), kSpectrumNames.end()});
    const double heading = item.has("heading_deg")
                               ? radians(item.number("heading_deg", 0.0, -kTurn, kTurn), 360.0)
                               : run.heading;
    if (item.holds("depth")) item.refuse("depth", kDeep);
    readSystem(item, type, heading, run);
    item.finish();
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
                       ? radians(item.number("direction_deg", 0.0, -kTurn, kTurn), 360.0)
                       : run.heading;
    item.finish();
    run.components.push_back(wave);
  }
  if (run.components.empty()) waves.refuse("components", "is missing or empty");
}

void readWaves(TomlSection waves, RunFile& run) {
  std::vector<std::string> types{"none", "regular", "components"};
  types.insert(types.end(), kSpectrumNames.begin(), kSpectrumNames.end());
  const std::string type = waves.text("type", "none", types);
  if (waves.holds("depth")) waves.refuse("depth", kDeep);
  run.sea.ramp = waves.number("ramp", 20.0, 0.0, 1e5);
  const bool single = type == "regular" || type == "components";
  if (single && waves.has("systems"))
    waves.refuse("systems", "is for seas of spectra, not for type = \"" + type + "\"");
  if (type == "regular") {
    readRegular(waves, run);
  } else if (type == "components") {
    readComponents(waves, run);
  } else {
    if (isSpectrum(type)) readSystem(waves, type, run.heading, run);
    readSystems(waves, run);
    if (!run.systems.empty()) run.waves = RunFile::Waves::Spectrum;
  }
  run.sea.profile = waves.choice("profile", kWaveProfileNames, run.usualProfile());
  waves.finish();
}

// @param ship  the body is a ship's: it has gyradii too.
void readBody(TomlSection body, bool ship, RunFile& run) {
  run.body.emplace();
  for (const auto& [key, value] :
       {std::pair{"gyradii", &run.body->gyradii}, std::pair{"size", &run.body->size}}) {
    if (!ship && value == &run.body->gyradii) continue;
    if (!body.has(key)) body.refuse(key, "is missing: three lengths in metres");
    *value = body.vector(key, Vec3::Zero());
    if (!(value->minCoeff() > 0.0)) body.refuse(key, "must be above 0");
  }
  body.finish();
}

// The name begins a column of the CSV.
std::string readName(TomlSection& item, const RunFile& run) {
  std::string name =
      item.has("name") ? item.text("name", "") : fmt::format("room{}", run.compartments.size() + 1);
  const auto good = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; };
  if (name.empty() || !std::all_of(name.begin(), name.end(), good))
    item.refuse("name", "must be of letters, digits and _: it begins a column");
  for (const RunCompartment& other : run.compartments)
    if (other.box.name == name) item.refuse("name", "there is another \"" + name + "\"");
  return name;
}

void readCompartments(TomlSection& root, RunFile& run) {
  for (TomlSection item : root.tables("compartment")) {
    RunCompartment room;
    room.box.name = readName(item, run);
    for (const char* key : {"centre", "size"})
      if (!item.has(key)) item.refuse(key, "is missing: three lengths in metres, in hull axes");
    room.box.centre = item.vector("centre", Vec3::Zero());
    room.box.size = item.vector("size", Vec3::Zero());
    if (!(room.box.size.minCoeff() > 0.0)) item.refuse("size", "must be above 0");
    room.box.permeability = item.number("permeability", 1.0, 0.01, 1.0);
    room.box.volume = item.number("volume", 0.0, 0.0, 1e6);
    const double capacity = room.box.permeability * room.box.size.prod();
    if (room.box.volume > capacity)
      item.refuse("volume", fmt::format("must be at most {:.6g}, all that fits in", capacity));
    room.box.freeSurface = item.boolean("free_surface", true);
    room.rate = item.number("rate", 0.0, -1e4, 1e4);
    for (TomlSection hole : item.tables("openings")) {
      Opening opening;
      for (const char* key : {"place", "area"})
        if (!hole.has(key)) hole.refuse(key, "is missing");
      opening.place = hole.vector("place", Vec3::Zero());
      opening.area = hole.number("area", 1.0, 1e-6, 1e4);
      opening.discharge = hole.number("discharge", 0.6, 0.01, 1.0);
      hole.finish();
      room.openings.push_back(opening);
    }
    item.finish();
    run.compartments.push_back(std::move(room));
  }
}

void readStart(TomlSection start, RunFile& run) {
  const char* offsets[6] = {"x", "y", "z", "roll_deg", "pitch_deg", "yaw_deg"};
  const char* velocities[6] = {"u", "v", "w", "p", "q", "r"};
  for (int i = 0; i < 6; ++i) {
    const bool angle = i >= 3;
    run.start.offset[i] = start.number(offsets[i], 0.0, angle ? -kTurn : -1e5, angle ? kTurn : 1e5);
    if (angle) run.start.offset[i] = radians(run.start.offset[i], 180.0);
    run.start.velocity[i] = start.number(velocities[i], 0.0, -1e3, 1e3);
  }
  start.finish();
}

void readMean(TomlSection& motion, ShipModel& model) {
  const char* usual = model.mean == Mean::Free ? "free" : "fixed";
  if (motion.text("mean", usual) == "filtered")
    motion.refuse("mean",
                  "is no more; \"free\" is the ship that is free to go, \"fixed\" one on a steady "
                  "course");
  const std::string mean = motion.text("mean", usual, {"fixed", "free"});
  if (motion.holds("follow_time"))
    motion.refuse("follow_time", "is no more: a free ship needs no filter");
  model.mean = mean == "free" ? Mean::Free : Mean::Fixed;
}

void readHullPressure(TomlSection& motion, ShipModel& model) {
  if (motion.has("mode"))
    model.mode = motion.text("mode", "linear", {"linear", "nonlinear"}) == "linear"
                     ? HullPressure::Linear
                     : HullPressure::Nonlinear;
  for (const char* key : {"immersion", "hull_triangles"}) {
    const bool linear = model.mode ? model.mode == HullPressure::Linear : model.mean == Mean::Fixed;
    if (motion.has(key) && linear) motion.refuse(key, "is for mode = \"nonlinear\"; leave it out");
  }
  const bool scaled = motion.text("immersion", "scaled", {"scaled", "constant"}) == "scaled";
  model.immersion = scaled ? Immersion::Scaled : Immersion::Constant;
  model.hullTriangles = motion.integer("hull_triangles", model.hullTriangles, 100, 1000000);
}

void readMotion(TomlSection motion, RunFile& run) {
  run.start.speed = motion.number("speed", 0.0, -100.0, 100.0);
  run.heading = radians(motion.number("heading_deg", 180.0, -kTurn, kTurn), 360.0);
  ShipModel& model = run.model;
  readMean(motion, model);
  readHullPressure(motion, model);
  model.hullLift = motion.boolean("hull_lift", model.hullLift);
  model.resistance = motion.boolean("resistance", model.resistance);
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

RunFile readRunFile(const std::string& path, Mean usual, RunUse use) {
  TomlFile file(path);
  RunFile run;
  run.model.mean = usual;
  if (usual == Mean::Fixed) {  // a sweep is compared with what knows of neither
    run.model.resistance = false;
    run.model.mode = HullPressure::Linear;
  }
  run.path = path;
  TomlSection& root = file.root();
  const bool ship =
      use == RunUse::Run || root.has("database") || (use == RunUse::Show && !root.has("body"));
  if (ship && !root.has("database"))
    root.refuse("database", "is missing; make one with `cutwater solve`");
  if (ship) run.database = root.file("database");
  if (root.has("ship")) run.ship = root.file("ship");
  readBullet(file.section("bullet"), run);
  readMotion(file.section("motion"), run);
  readWaves(file.section("waves"), run);
  readCompartments(root, run);
  if (root.has("body")) readBody(file.section("body"), ship, run);
  root.finish();
  return run;
}

SeaState RunFile::seaState(double gravity, std::size_t index) const {
  switch (waves) {
    case Waves::None:
      return SeaState({}, gravity, sea.ramp, sea.profile);
    case Waves::Regular:
      if (order > 1)
        return SeaState::steep({omega.at(index), amplitude, phase, heading}, gravity, order,
                               sea.ramp);
      return SeaState({{omega.at(index), amplitude, phase, heading}}, gravity, sea.ramp,
                      sea.profile);
    case Waves::Components:
      return SeaState(components, gravity, sea.ramp, sea.profile);
    case Waves::Spectrum:
      break;
  }
  return makeSeaState(systemsAt(gravity));
}

std::vector<SeaSystem> RunFile::systemsAt(double gravity) const {
  std::vector<SeaSystem> all = systems;
  for (SeaSystem& system : all) {
    system.spectrum.gravity = gravity;
    system.settings.ramp = sea.ramp;
    system.settings.profile = sea.profile;
  }
  return all;
}

double RunFile::highestOmega(double gravity) const {
  double highest = 0.0;
  for (std::size_t i = 0; i < std::max<std::size_t>(1, omega.size()); ++i) {
    const SeaState state = seaState(gravity, i);
    for (const WaveComponent& wave : state.components()) highest = std::max(highest, wave.omega);
  }
  return highest;
}

namespace {

[[noreturn]] void refuse(const RunFile& run, const std::string& what) {
  throw HydroError(Fault::ValueOutOfRange, run.path + ": " + what);
}

}  // namespace

namespace {

// Mass and centre of gravity of another code's ship must be those of the hull that is given for it,
// as far as two meshes agree.
void takeHull(const RunFile& run, const ShipParticulars& given, ShipParticulars& ship) {
  const auto differs = [&](const char* field, double value, double other) {
    throw HydroError(Fault::ValueOutOfRange,
                     fmt::format("{}: [mass] {}: {:.6g} here, {:.6g} in {}", run.ship, field, value,
                                 other, run.database));
  };
  if (std::abs(given.mass - ship.mass) > 0.02 * ship.mass) differs("mass", given.mass, ship.mass);
  for (int i = 0; i < 3; ++i) {
    if (std::abs(given.cog[i] - ship.cog[i]) > 0.01 * given.beam())
      differs("cog", given.cog[i], ship.cog[i]);
  }
  ship.hull = given.hull;
  ship.file = given.file;
  ship.gyradii = given.gyradii;
}

void completeForeign(const RunFile& run, const ShipParticulars* given, Coefficients& c) {
  if (given != nullptr && run.body)
    refuse(run, "[body]: ship names a hull already; one of the two is enough");
  if (given != nullptr) {
    takeHull(run, *given, c.ship);
  } else if (run.body) {
    if (run.body->size.z() <= -2.0 * c.ship.centreOfBuoyancy.z())
      refuse(run, fmt::format("[body] size: height {:.4g} m, must be above twice the depth of the "
                              "centre of buoyancy, {:.4g} m",
                              run.body->size.z(), -2.0 * c.ship.centreOfBuoyancy.z()));
    giveBody(c, *run.body);
  } else {
    refuse(run, run.database +
                    " holds neither gyradii nor a hull: add [body] gyradii = [a, b, c] and size = "
                    "[length, beam, height], or ship = \"ship.toml\" with both");
  }
  makeConsistent(c, run.database);
}

void requireSameLoading(const RunFile& run, const ShipParticulars& given,
                        const ShipParticulars& solved) {
  const auto same = [](double a, double b) {
    return std::abs(a - b) <= 1e-6 * (1.0 + std::abs(b));
  };
  const auto differs = [&](const char* field) {
    throw HydroError(Fault::ValueOutOfRange, run.ship + ": [mass] " + field + ": differs from " +
                                                 run.database + "; solve again for this loading");
  };
  if (!same(given.mass, solved.mass)) differs("mass");
  for (int i = 0; i < 3; ++i) {
    if (!same(given.cog[i], solved.cog[i])) differs("cog");
    if (!same(given.gyradii[i], solved.gyradii[i])) differs("gyradii");
  }
}

// Waves that break before they are as steep: nothing of their answer is of use.
void warnOfSteepWaves(const RunFile& run, double gravity) {
  constexpr double kBreaks = 0.142;  // H/λ of the highest wave in deep water [Michell 1893]
  const double omega = *std::max_element(run.omega.begin(), run.omega.end());
  const double steepness = run.amplitude * omega * omega / (kPi * gravity);
  if (steepness <= kBreaks) return;
  warn(
      fmt::format("{}: [waves] amplitude = {:.4g}: waves of {:.4g} rad/s would be {:.2g} of "
                  "their length high; they break at {}",
                  run.path, run.amplitude, omega, steepness, kBreaks));
}

void warnOfSteepSea(const RunFile& run, const SeaSystem& system, const std::string& where) {
  constexpr double kSteepest = 1 / 15.0;  // 2πHs/(g Tp²) of the steepest seas [DNV-RP-C205]
  const Spectrum& spectrum = system.spectrum;
  const double omega = spectrum.peakFrequency(), hs = spectrum.significantHeight();
  const double steepness = hs * omega * omega / (2.0 * kPi * spectrum.gravity);
  if (steepness <= kSteepest) return;
  warn(
      fmt::format("{}: {} hs = {:.4g}: steeper than seas are at tp = {:.4g}, whose hs is "
                  "at most {:.2g}",
                  run.path, where, hs, 2.0 * kPi / omega, hs * kSteepest / steepness));
}

void warnOfHeight(const RunFile& run, const SeaSystem& system, const std::string& where) {
  const Spectrum& spectrum = system.spectrum;
  const bool dnv = spectrum.shape == SpectrumShape::Jonswap &&
                   spectrum.normalisation == JonswapNormalisation::Dnv;
  if (!dnv || spectrum.hs == 0.0) return;
  const double height = spectrum.significantHeight(), off = height / spectrum.hs - 1.0;
  warn(fmt::format(
      "{}: {} normalisation = \"dnv\": the sea's Hs is {:.6g} m, {:.3g} % {} hs = "
      "{:.6g}",
      run.path, where, height, 100.0 * std::abs(off), off < 0.0 ? "below" : "above", spectrum.hs));
}

void warnOfCutOffs(const RunFile& run, const SeaSystem& system, const std::string& where) {
  constexpr double kMuch = 0.02;  // of m0: a height that is 1 % off
  const auto [from, to] = cutOffs(system.spectrum, system.settings);
  const double outside = 1.0 - shareOfEnergy(system.spectrum, from, to);
  if (outside <= kMuch) return;
  warn(fmt::format(
      "{}: {} omega_min, omega_max = {:.4g}, {:.4g} rad/s leave out {:.3g} % of m0; the "
      "waves between them are that much higher, so that Hs is kept",
      run.path, where, from, to, 100.0 * outside));
}

// What potential flow lacks: a ship file's own, without solving again.
void takeAdded(const ShipParticulars& given, ShipParticulars& ship) {
  ship.supplementary = given.supplementary;
  ship.drag = given.drag;
  ship.engine = given.engine;
  ship.rudder = given.rudder;
}

}  // namespace

void warnOfSea(const RunFile& run, double gravity) {
  if (run.waves == RunFile::Waves::Regular) warnOfSteepWaves(run, gravity);
  const std::vector<SeaSystem> systems = run.systemsAt(gravity);
  for (std::size_t i = 0; i < systems.size(); ++i) {
    const std::string where =
        systems.size() == 1 ? "[waves]" : fmt::format("[waves] system {}:", i);
    warnOfSteepSea(run, systems[i], where);
    warnOfHeight(run, systems[i], where);
    warnOfCutOffs(run, systems[i], where);
  }
}

Coefficients readShipOfRun(RunFile& run) {
  std::string warning;
  Coefficients coefficients = readCoefficients(run.database, &warning);
  warn(warning);
  naming(run.path, [&] {  // what is beyond the last frequency has no forces, which Ship says
    const double highest = run.highestOmega(coefficients.ship.gravity);
    const double last = coefficients.omega.empty() ? highest : coefficients.omega.back();
    warnIfUnresolved(run.database, coefficients, std::min(highest, last));
    warnOfSea(run, coefficients.ship.gravity);
  });
  std::optional<ShipParticulars> given;
  if (!run.ship.empty()) given = readShipFile(run.ship).particulars;
  if (isForeign(coefficients)) {
    completeForeign(run, given ? &*given : nullptr, coefficients);
  } else if (run.body) {
    refuse(run, "[body]: " + run.database + " holds hull and gyradii of its own");
  } else if (given) {
    requireSameLoading(run, *given, coefficients.ship);
  }
  if (given) takeAdded(*given, coefficients.ship);
  return coefficients;
}

}  // namespace cutwater::command
