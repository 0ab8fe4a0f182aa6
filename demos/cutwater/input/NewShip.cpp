#include "demos/cutwater/input/NewShip.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "demos/cutwater/input/HeightOfG.h"
#include "demos/cutwater/input/HullFile.h"
#include "demos/cutwater/input/HullVolume.h"
#include "demos/cutwater/output/Messages.h"
#include "hydro/Errors.h"
#include "hydro/geometry/guess/HullGuess.h"

namespace cutwater::command {

namespace {

constexpr double kBoat = 25.0;  // [m]: below it panels as games have them
constexpr int kBoatPanels = 250, kShipPanels = 433;
constexpr double kLeastDepth = 1.1, kUsualDepth = 1.8;  // in draughts
constexpr double kRod = 0.29;  // gyradius of a rod, 1/sqrt(12) of its length

bool isGltf(const std::string& mesh) {
  std::string end = mesh.substr(std::min(mesh.size(), mesh.rfind('.')));
  std::transform(end.begin(), end.end(), end.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return end == ".glb" || end == ".gltf";
}

// The axes of `up` and `forward` in a mesh: extents [unit] forward, across, up.
Vec3 extents(const SurfaceMesh& mesh, const MeshReadOptions& options) {
  const Bounds box = bounds(mesh);
  return (filePlacement({.up = options.up, .forward = options.forward}).rotation *
          (box.high - box.low))
      .cwiseAbs();
}

NewFact fact(const std::string& name, const Guess<std::string>& guess, bool given,
             const std::string& option) {
  return {name, guess.value, given ? "given" : guess.word(), given ? "" : guess.reason, option};
}

void settleAxes(const SurfaceMesh& mesh, const NewOptions& said, NewShip& ship) {
  AxesHints hints{{}, said.up, said.forward};
  if (isGltf(ship.mesh)) hints.conventional = {"y", "z", "glTF"};
  const AxesGuess axes = guessAxes(mesh, hints);
  ship.options.up = axes.up.value;
  ship.options.forward = axes.forward.value;
  ship.directed = axes.ship;
  ship.facts.push_back(fact("up", axes.up, said.up.has_value(), "--up"));
  ship.facts.push_back(fact("forward", axes.forward, said.forward.has_value(), "--forward"));
}

void settleUnit(const SurfaceMesh& mesh, const NewOptions& said, NewShip& ship) {
  const Vec3 size = extents(mesh, ship.options);
  const double length = size.x();
  const bool game = isGltf(ship.mesh) || ship.options.up.back() == 'y';
  Guess<std::string> unit = guessUnit(size.maxCoeff(), game);
  if (said.unit) unit.value = *said.unit;
  if (unit.value.empty())
    throw HydroError(
        Fault::ValueOutOfRange,
        fmt::format("{}: is {:.4g} long, and {}; --unit says what its unit is (m, mm, cm, ft, in), "
                    "or scale the file",
                    ship.mesh, length, unit.reason));
  ship.options.unit = unit.value;
  if (unit.value != "m" && !said.unit)
    unit.reason += fmt::format(" ({:.4g} long: {:.4g} m in cm, {:.4g} m in mm, {:.4g} m in ft)",
                               length, 0.01 * length, 0.001 * length, 0.3048 * length);
  ship.facts.push_back(fact("unit", unit, said.unit.has_value(), "--unit"));
}

// A first waterline [unit] at which the hull, seen from below, holds the volume [m³].
double firstWaterline(const SurfaceMesh& mesh, const std::string& up, const WaterlineGuess& guess,
                      double volume, double unit) {
  double low = guess.low, high = guess.high;
  for (int i = 0; i < 8; ++i) {
    const double middle = 0.5 * (low + high);
    const double there = volumeFromBelow(mesh, up, middle) * unit * unit * unit;
    (there < volume ? low : high) = middle;
  }
  return std::min(high, guess.deck);
}

// Calm water above or below all of the mesh is a slip.
void requireInHull(const NewShip& ship, const WaterlineGuess& guess) {
  const MeshReadOptions& o = ship.options;
  const bool inside =
      o.waterline > guess.low && o.waterline < guess.high + 2e-3 * (guess.high - guess.low);
  if (inside || o.trimDeg != 0.0 || o.heelDeg != 0.0) return;
  throw HydroError(Fault::HullNotInWater,
                   fmt::format("{}: calm water at {:.6g} along {} is outside the mesh, which lies "
                               "from {:.6g} to {:.6g} ({}); see --waterline and --draught",
                               ship.mesh, o.waterline, o.up, guess.low, guess.high, o.unit));
}

WaterlineGuess settleWaterline(const SurfaceMesh& mesh, const NewOptions& said, NewShip& ship) {
  WaterlineGuess guess = guessWaterline(mesh, ship.options.up);
  const double unit = filePlacement(ship.options).metresPerUnit;
  NewFact line{"waterline", "", guess.height.word(), guess.height.reason,
               "--waterline, --draught or --displacement"};
  if (said.waterline) {
    guess.height.value = *said.waterline;
    line.word = "given";
    line.reason.clear();
  } else if (said.draught) {
    guess.height.value = guess.low + *said.draught / unit;
    line.word = "given";
    line.reason = fmt::format("--draught {:g} m above the lowest point", *said.draught);
  } else if (said.displacement || said.mass) {
    const double mass = said.displacement.value_or(said.mass.value_or(0.0));
    const double volume = mass / said.density;
    const double first = firstWaterline(mesh, ship.options.up, guess, volume, unit);
    guess.height.value = waterlineFor(ship.mesh, ship.options, volume, first,
                                      guess.deck - 1e-6 * (guess.deck - guess.low));
    line.word = "given";
    line.reason = fmt::format("found for {:.6g} kg", mass);
  }
  ship.options.waterline = guess.height.value;
  line.value = fmt::format("{:.5g}", guess.height.value);
  ship.facts.push_back(line);
  requireInHull(ship, guess);
  return guess;
}

void layPanels(const NewOptions& said, double length, NewShip& ship) {
  ship.panels = said.panels.value_or(length < kBoat ? kBoatPanels : kShipPanels);
  ship.facts.push_back({"panels", std::to_string(ship.panels), said.panels ? "given" : "chosen",
                        said.panels ? "" : "a side: 250 for boats, 433 for ships", "--panels"});
  try {
    ship.hull = readPanelled(ship.mesh, ship.options, ship.panels);
  } catch (const HydroError& error) {
    ship.problem = error.what();
    Hull hull = readTrustedHull(ship.mesh, ship.options);
    ship.hull = {std::move(hull.surface), {}, hull.symmetric, hull.file};
  }
}

NewFact settleHeightOfG(const NewOptions& said, const WaterlineGuess& guess, const Hydrostatics& h,
                        const MeshReadOptions& options, double& height) {
  NewFact line{"height of G", "", "a guess", "60 % of the depth, above calm water", "--cog-height"};
  const double unit = filePlacement(options).metresPerUnit;
  const double draught = (options.waterline - guess.low) * unit;  // without trim
  double depth = (guess.deck - guess.low) * unit;
  if (depth < kLeastDepth * draught) {  // the mesh ends at calm water, or little above
    depth = kUsualDepth * draught;
    line.reason = fmt::format("60 % of a depth of {:g} draughts, above calm water", kUsualDepth);
  }
  const HeightOfG found = heightOfG(depth, draught, h);
  if (found.usual > found.highest)
    line.reason = "what leaves a GM of 5 % of the beam, above calm water";
  height = said.cogHeight.value_or(found.height());
  if (said.cogHeight) line = {"height of G", "", "given", "above calm water", "--cog-height"};
  line.value = fmt::format("{:.4g} m", height);
  return line;
}

void settleLoading(const NewOptions& said, const WaterlineGuess& guess, NewShip& ship) {
  const Water water{.density = said.density};
  const Hydrostatics h = afloat(ship.hull, {}, water).hydrostatics;
  ship.cog = h.buoyancy;
  if (ship.hull.symmetric) ship.cog.y() = 0.0;
  for (double& place : ship.cog)  // round-off of what is alike on both sides
    if (std::abs(place) < 1e-9 * (h.length + h.beam)) place = 0.0;
  ship.facts.push_back(settleHeightOfG(said, guess, h, ship.options, ship.cog.z()));
  const Afloat floating = afloat(ship.hull, {.mass = said.mass, .cog = ship.cog}, water);
  ship.hydrostatics = floating.hydrostatics;
  ship.mass = floating.ship.mass;
  ship.givenMass = said.mass;
  ship.gyradii = floating.ship.gyradii;
  const double height = bounds(ship.hull.surface).high.z() + h.draft;
  if (!ship.directed) ship.gyradii = ship.gyradii.cwiseMax(Vec3(kRod * height, kRod * height, 0));
}

}  // namespace

NewShip newShip(const std::string& mesh, const NewOptions& said) {
  NewShip ship;
  ship.mesh = mesh;
  ship.density = said.density;
  ship.options.anyFormat = said.anyFormat;
  ship.options.symmetric = said.symmetric.value_or("auto");
  ship.options.trimDeg = said.trimDeg;
  ship.options.heelDeg = said.heelDeg;
  const SurfaceMesh raw = readSurface(mesh, {.anyFormat = said.anyFormat});
  settleAxes(raw, said, ship);
  settleUnit(raw, said, ship);
  const WaterlineGuess guess = settleWaterline(raw, said, ship);
  layPanels(said, extents(raw, ship.options).x() * filePlacement(ship.options).metresPerUnit, ship);
  settleLoading(said, guess, ship);
  return ship;
}

}  // namespace cutwater::command
