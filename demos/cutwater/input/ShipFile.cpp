#include "demos/cutwater/input/ShipFile.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "demos/cutwater/input/Floating.h"
#include "demos/cutwater/input/HeightOfG.h"
#include "demos/cutwater/input/HullFile.h"
#include "demos/cutwater/input/Toml.h"
#include "demos/cutwater/output/Messages.h"
#include "hydro/Errors.h"

namespace cutwater::command {

namespace {

constexpr double kDegree = kPi / 180.0;
constexpr double kHighest = 1e4;  // that G may be above or below calm water [m]

// What "auto" stands for [m above calm water]. The depth is taken between 1.5 and 2 draughts, as
// masts and houses are no part of it.
double usualHeightOfG(const PanelledHull& hull, const Hydrostatics& h) {
  const double height = bounds(hull.surface).high.z() + h.draft;
  return heightOfG(std::clamp(height, 1.5 * h.draft, 2.0 * h.draft), h.draft, h).height();
}

/// @param lower  [m] how far the origin of `hull` lies above that of the hull as drawn.
void readCog(TomlSection& mass, const PanelledHull& hull, const std::string& path, double lower,
             Loading& loading) {
  const std::string axes = mass.text("axes", "hull", {"hull", "file"});
  if (!mass.has("cog")) {
    const Vec3 buoyancy = afloat(hull).hydrostatics.buoyancy;
    mass.refuse("cog",
                fmt::format("is missing; the centre of buoyancy is at [{:.3f}, {:.3f}, {:.3f}] m; "
                            "with \"auto\" G is above it",
                            buoyancy.x(), buoyancy.y(), buoyancy.z()));
  }
  if (!mass.isText("cog")) {
    if (mass.has("cog_height")) {
      mass.number("cog_height", 0.0, -kHighest, kHighest);
      mass.refuse("cog_height", "goes with cog = \"auto\"");
    }
    const Vec3 given = mass.vector("cog", Vec3::Zero());
    loading.cog = axes == "file" ? hull.file.toHull(given) : Vec3(given - lower * Vec3::UnitZ());
    return;
  }
  if (axes == "file") mass.refuse("axes", "goes with a cog of three numbers");
  mass.text("cog", "auto", {"auto"});
  loading.level = true;
  const Hydrostatics h = afloat(hull).hydrostatics;
  const bool given = mass.has("cog_height");
  loading.cog.z() = mass.number("cog_height", usualHeightOfG(hull, h), -kHighest, kHighest);
  if (!given && loading.cog.z() < h.buoyancy.z())
    warn(path +
         ": [mass] cog: a usual height of G is not stable, so G is put below B; is the hull "
         "upright ([hull] up)?");
  say(
      fmt::format("{}: [mass] cog is [{:.4g}, {:.4g}, {:.4g}] m, above the centre of buoyancy{}; "
                  "GM {:.3g} m",
                  path, h.buoyancy.x(), hull.symmetric ? 0.0 : h.buoyancy.y(), loading.cog.z(),
                  given ? "" : ", its height a usual one (cog_height)",
                  h.buoyancy.z() + h.bmT - loading.cog.z()));
}

Loading readMass(TomlSection mass, const PanelledHull& hull, const std::string& path,
                 double lower) {
  Loading loading;
  if (mass.isText("mass")) {
    mass.text("mass", "auto", {"auto"});
  } else if (mass.has("mass")) {
    loading.mass = mass.number("mass", 0.0, 1e-9, 1e15);
  }
  readCog(mass, hull, path, lower, loading);
  if (mass.isText("gyradii")) {
    mass.text("gyradii", "auto", {"auto"});
    const Vec3 r = afloat(hull).ship.gyradii;
    say(fmt::format("{}: [mass] gyradii are [{:.4g}, {:.4g}, {:.4g}] m: 0.35 B, 0.25 L, 0.25 L",
                    path, r.x(), r.y(), r.z()));
  } else if (mass.has("gyradii")) {
    loading.gyradii = mass.vector("gyradii", Vec3::Ones());
    if (!(loading.gyradii->minCoeff() > 0.0)) mass.refuse("gyradii", "must be above 0");
  }
  mass.finish();
  return loading;
}

void readSupplementary(TomlSection section, Supplementary& terms) {
  for (int j = 0; j < 6; ++j) {
    const std::string mode = kModeNames[j];
    terms.damping[j] = section.number(mode + "_damping", 0.0, 0.0, 1e18);
    terms.stiffness[j] = section.number(mode + "_stiffness", 0.0, 0.0, 1e18);
  }
  terms.rollDampingQuadratic = section.number("roll_damping_quadratic", 0.0, 0.0, 1e18);
  section.finish();
}

constexpr double kAny = 1e18;  // requireUsable() has the bounds

// "auto", as is what is absent, or a number.
std::optional<double> automatic(TomlSection& section, const std::string& key) {
  if (section.isText(key)) section.text(key, "auto", {"auto"});
  if (!section.isNumber(key)) return std::nullopt;
  return section.number(key, 0.0, -kAny, kAny);
}

// The same of a place in hull axes.
std::optional<Vec3> automaticPlace(TomlSection& section) {
  const std::string key = "place";
  if (section.isText(key)) {
    section.text(key, "auto", {"auto"});
    return std::nullopt;
  }
  if (!section.has(key)) return std::nullopt;
  return section.vector(key, Vec3::Zero());
}

HullDrag readResistance(TomlSection section, const std::string& path) {
  HullDrag drag;
  drag.crossFlow = section.number("cross_flow_drag", drag.crossFlow, -kAny, kAny);
  drag.formFactor = section.number("form_factor", drag.formFactor, -kAny, kAny);
  section.finish();
  requireUsable(drag, path);
  return drag;
}

EngineParticulars readEngine(TomlSection section, const std::string& path) {
  EngineParticulars engine;
  engine.maxThrust = automatic(section, "max_thrust");
  engine.astern = section.number("astern", engine.astern, -kAny, kAny);
  engine.noThrustSpeed = automatic(section, "no_thrust_speed");
  engine.timeConstant = automatic(section, "time_constant");
  engine.diameter = automatic(section, "diameter");
  engine.place = automaticPlace(section);
  section.finish();
  requireUsable(engine, path);
  return engine;
}

RudderParticulars readRudder(TomlSection section, const std::string& path) {
  RudderParticulars rudder;
  const auto degrees = [&section](const std::string& key, double fallback) {
    return kDegree * section.number(key, fallback / kDegree, -kAny, kAny);
  };
  rudder.area = automatic(section, "area");
  rudder.place = automaticPlace(section);
  rudder.aspectRatio = section.number("aspect_ratio", rudder.aspectRatio, -kAny, kAny);
  rudder.limit = degrees("limit_deg", rudder.limit);
  rudder.rate = automatic(section, "rate_deg");
  if (rudder.rate) *rudder.rate *= kDegree;
  rudder.stall = degrees("stall_deg", rudder.stall);
  rudder.slipstream = section.number("slipstream", rudder.slipstream, -kAny, kAny);
  rudder.flowStraightening =
      section.number("flow_straightening", rudder.flowStraightening, -kAny, kAny);
  section.finish();
  requireUsable(rudder, path);
  return rudder;
}

// Frequencies as given, increasing and above 0.
std::vector<double> frequencies(TomlSection& section, const std::string& key,
                                const std::vector<double>& fallback) {
  const std::vector<double> values = section.numbers(key, fallback, 1e-3, 1e3);
  for (std::size_t i = 0; i + 1 < values.size(); ++i) {
    if (values[i + 1] <= values[i]) section.refuse(key, "must increase");
  }
  if (values.empty()) section.refuse(key, "must hold a frequency");
  return values;
}

// As given; absent: the usual ones as far as `omega` goes, or all of `omega` if it has none there.
std::vector<double> waveFrequencies(TomlSection& solve, const std::vector<double>& omega,
                                    const ShipParticulars& ship) {
  std::vector<double> values = frequencies(solve, "wave_omega", usualWaveOmega(ship));
  const double first = omega.front() * (1.0 - 1e-9), last = omega.back() * (1.0 + 1e-9);
  if (solve.has("wave_omega")) {
    if (values.back() > last) {
      solve.refuse("wave_omega",
                   fmt::format("ends at {:.6g}, must end at or below the last omega, {:.6g}",
                               values.back(), omega.back()));
    }
    return values;
  }
  std::erase_if(values, [&](double value) { return value < first || value > last; });
  return values.empty() ? omega : values;
}

// 1, 4 or 9; "auto" is 0 where it is allowed.
int points(TomlSection& solve, const std::string& key, int fallback, bool automatic) {
  if (automatic && solve.isText(key)) {
    solve.text(key, "auto", {"auto"});
    return 0;
  }
  const int count = solve.integer(key, fallback, 1, 9);
  if (solve.has(key) && count != 1 && count != 4 && count != 9) {
    solve.refuse(key, automatic ? "must be 1, 4, 9 or \"auto\"" : "must be 1, 4 or 9");
  }
  return count;
}

// "auto", true or false. "auto" is `fallback`: flat for panels that are filled out. Curved, they
// would enclose what inscribed ones lack twice.
PanelShape panelShape(TomlSection& solve, PanelShape fallback) {
  const std::string key = "curved_panels";
  if (!solve.has(key)) return fallback;
  if (solve.isText(key)) {
    solve.text(key, "auto", {"auto"});
    return fallback;
  }
  if (!solve.boolean(key, false)) return PanelShape::Flat;
  if (fallback == PanelShape::Flat)
    solve.refuse(key, "does not go with panels laid over the surface: they have the hull's volume");
  return PanelShape::Curved;
}

ConditionLimit conditionLimit(TomlSection& solve, const std::string& key) {
  ConditionLimit limit = solve.pairs(key, 0.0, 1e18);
  for (std::size_t i = 0; i < limit.size(); ++i) {
    if (i > 0 && limit[i].first <= limit[i - 1].first) solve.refuse(key, "omega must increase");
    if (!(limit[i].second >= 1.0)) solve.refuse(key, "a condition number is never below 1");
  }
  return limit;
}

void readMethods(TomlSection& solve, SolveSettings& settings) {
  settings.formulation = solve.choice("formulation", kFormulationNames, settings.formulation);
  settings.derivatives = solve.choice("derivatives", kDerivativesNames, settings.derivatives);
  if (settings.derivatives == Derivatives::Source && settings.formulation != Formulation::Source) {
    solve.refuse("derivatives", "needs formulation = \"source\"");
  }
  settings.forwardSpeed = solve.choice("forward_speed", kForwardSpeedNames, settings.forwardSpeed);
  settings.influence = solve.choice("influence", kInfluenceNames, settings.influence);
  settings.sourcePoints = points(solve, "source_points", settings.sourcePoints, true);
  settings.galerkinPoints = points(solve, "galerkin_points", settings.galerkinPoints, false);
  settings.panelShape = panelShape(solve, settings.panelShape);
  settings.lid = solve.boolean("lid", settings.lid);
  settings.conditionLimitEven = conditionLimit(solve, "condition_limit_even");
  settings.conditionLimitOdd = conditionLimit(solve, "condition_limit_odd");
}

// Each direction once, in order: 0 and 360 are one column of the table.
std::vector<double> headings(TomlSection& solve) {
  std::vector<double> all, distinct;
  for (const double degrees : solve.numbers("headings_deg", {180.0}, -360.0, 360.0)) {
    all.push_back(degrees * kDegree);
  }
  std::sort(all.begin(), all.end());
  const auto same = [](double a, double b) {
    return std::abs(std::remainder(a - b, 2.0 * kPi)) < 1e-9;
  };
  for (const double heading : all) {
    const bool known = std::any_of(distinct.begin(), distinct.end(),
                                   [&](double other) { return same(heading, other); });
    if (!known) distinct.push_back(heading);
  }
  return distinct;
}

void readSolve(TomlSection solve, const ShipParticulars& ship, SolveSettings& settings) {
  settings.omega = frequencies(solve, "omega", usualOmega(ship));
  settings.waveOmega = waveFrequencies(solve, settings.omega, ship);
  settings.headings = headings(solve);
  settings.speeds = solve.numbers("speeds", {0.0}, 0.0, 100.0);
  std::sort(settings.speeds.begin(), settings.speeds.end());
  settings.speeds.erase(std::unique(settings.speeds.begin(), settings.speeds.end()),
                        settings.speeds.end());
  readMethods(solve, settings);
  if (settings.influence != Influence::Adjoint && settings.headings.empty()) {
    solve.refuse("headings_deg", "must hold a heading unless influence is \"adjoint\"");
  }
  if (settings.influence != Influence::Adjoint && settings.speeds.empty()) {
    solve.refuse("speeds", "must hold a speed unless influence is \"adjoint\"");
  }
  solve.finish();
}

// Beyond this the hull does not float near to where it is drawn, and what is solved for is
// another ship: a fifth of the mass, three degrees.
constexpr double kMostExcess = 0.2, kMostTilt = 3.0 * kDegree;

void requireNearBalance(const std::string& path, const ShipFile& ship, double excess,
                        const Vec3& lever) {
  const ShipParticulars& p = ship.particulars;
  const Hydrostatics& h = ship.hydrostatics;
  if (std::abs(excess) > kMostExcess)
    throw HydroError(
        Fault::ValueOutOfRange,
        fmt::format("{}: [mass] mass is {:.6g} kg, the hull displaces {:.6g} kg as it is drawn; {}",
                    path, p.mass, h.displacement,
                    std::abs(1e3 * p.mass / h.displacement - 1) < 0.5
                        ? "it is in kilograms, not in tonnes"
                        : "with [hull] float = true it sinks or rises, or is waterline wrong?"));
  const double trim = h.gmL > 0 ? std::atan(lever.x() / h.gmL) : 0.0,
               heel = h.gmT > 0 ? std::atan(lever.y() / h.gmT) : 0.0;
  if (std::max(std::abs(trim), std::abs(heel)) > kMostTilt)
    throw HydroError(
        Fault::ValueOutOfRange,
        fmt::format("{}: [mass] cog stands {:+.3f} m forward and {:+.3f} m to port of the centre "
                    "of buoyancy: the ship would trim by {:.1f} and heel by {:.1f} deg; with "
                    "[hull] float = true it does, with cog = \"auto\" G is above B",
                    path, lever.x(), lever.y(), std::abs(trim) / kDegree,
                    std::abs(heel) / kDegree));
}

void warnIfUnbalanced(const std::string& path, const ShipFile& ship, Balance balance) {
  const ShipParticulars& p = ship.particulars;
  const double excess = p.mass / ship.hydrostatics.displacement - 1.0;
  const Vec3 lever = p.cog - ship.hydrostatics.buoyancy;
  if (balance == Balance::Needed) requireNearBalance(path, ship, excess, lever);
  if (std::abs(excess) > 1e-3) {
    warn(fmt::format(
        "{}: [mass] mass is {:+.2f} % of density x volume; linear theory takes the hull as it lies",
        path, 100.0 * excess));
  }
  if (std::abs(lever.x()) > 1e-3 * ship.hydrostatics.length ||
      std::abs(lever.y()) > 1e-3 * ship.hydrostatics.beam) {
    warn(
        fmt::format("{}: [mass] cog is not above the centre of buoyancy ({:+.3f} m forward, "
                    "{:+.3f} m to port): the ship would trim or heel",
                    path, lever.x(), lever.y()));
  }
  for (const auto& [gm, name] :
       {std::pair{ship.hydrostatics.gmT, "gm_t"}, std::pair{ship.hydrostatics.gmL, "gm_l"}}) {
    if (gm <= 0.0)
      warn(fmt::format("{}: {} = {:.3f} m: the ship is not stable upright", path, name, gm));
  }
}

/// Reads the hull of a file that is to float, upright, where it displaces the mass given.
/// @return how much higher its origin lies than that of the hull as drawn [m].
double readUpright(TomlFile& file, HullRequest& request, PanelledHull& hull, const Water& water) {
  TomlSection mass = file.section("mass");
  if (!mass.isNumber("mass")) mass.refuse("mass", "is needed in kg with [hull] float = true");
  const double drawn = request.options.waterline;
  request.quiet = true;
  request.options = inWater(request.mesh, request.options);
  hull = readPanelled(request);
  request.options =
      sunk(request.mesh, hull, request.options, mass.number("mass", 0.0, 1e-9, 1e15), water);
  hull = readPanelled(request);
  return (request.options.waterline - drawn) * hull.file.metresPerUnit;
}

}  // namespace

ShipFile readShipFile(const std::string& path, Balance balance) {
  TomlFile file(path);
  HullRequest request = readHullRequest(file);
  TomlSection section = file.section("water");
  Water water;
  water.density = section.number("density", water.density, 1.0, 1e5);
  water.gravity = section.number("gravity", water.gravity, 1e-3, 1e3);
  section.finish();
  const double drawn = request.options.waterline;
  PanelledHull hull;
  double lower = 0.0;
  if (request.floats) {
    lower = readUpright(file, request, hull, water);
  } else {
    hull = readPanelled(request);
  }
  Loading loading = readMass(file.section("mass"), hull, path, lower);
  readSupplementary(file.section("supplementary"), loading.supplementary);
  if (request.floats) {
    const FloatingHull found = floating(request.mesh, hull, request.options, loading, water, drawn);
    request.options = found.options;
    request.quiet = false;
    hull = readPanelled(request);
    loading.cog = found.cog;
    loading.level = false;
  }

  ShipFile ship;
  Afloat atRest = afloat(hull, loading, water);
  ship.particulars = std::move(atRest.ship);
  ship.hydrostatics = atRest.hydrostatics;
  ship.particulars.drag = readResistance(file.section("resistance"), path);
  if (file.root().has("engine")) ship.particulars.engine = readEngine(file.section("engine"), path);
  if (file.root().has("rudder")) ship.particulars.rudder = readRudder(file.section("rudder"), path);
  ship.particulars.name = std::filesystem::absolute(path).parent_path().filename().string();
  if (hull.filledOut) ship.solve.panelShape = PanelShape::Flat;
  readSolve(file.section("solve"), ship.particulars, ship.solve);
  file.root().finish();
  warnIfUnbalanced(path, ship, balance);
  return ship;
}

}  // namespace cutwater::command
