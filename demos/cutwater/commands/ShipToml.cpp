#include "demos/cutwater/commands/ShipToml.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cutwater::command {

namespace {

constexpr double kRollDamping = 0.05;    // of the critical one
constexpr double kWaterWithRoll = 1.25;  // inertia of ship and water, of the ship's own
constexpr double kHelm = 1.5;            // of √(g/L): how fast a helmsman brings the bow back
constexpr double kDefaultGravity = kStandardGravity;

// In quotes as TOML has them.
std::string quoted(const std::string& text) {
  std::string safe = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') safe += '\\';
    if (static_cast<unsigned char>(c) < 0x20)
      safe += fmt::format("\\u{:04X}", c);
    else
      safe += c;
  }
  return safe + '"';
}

// Digits that are worth a hundred-thousandth of the length.
std::string metres(double value, double length) {
  const int digits = std::clamp(5 - static_cast<int>(std::floor(std::log10(length))), 0, 9);
  const double rounded = std::round(value * std::pow(10.0, digits)) / std::pow(10.0, digits);
  return fmt::format("{:.{}f}", rounded == 0.0 ? 0.0 : rounded, digits);
}

// Two significant digits.
double rounded(double value, bool down) {
  const double one = std::pow(10.0, std::floor(std::log10(value)) - 1.0);
  return (down ? std::floor(value / one + 1e-9) : std::round(value / one)) * one;
}

std::string line(const std::string& setting, const std::string& comment) {
  return fmt::format("{:<34} # {}\n", setting, comment);
}

std::string comment(const NewShip& ship, const std::string& name) {
  for (const NewFact& fact : ship.facts)
    if (fact.name == name) return fact.word + (fact.reason.empty() ? "" : ": " + fact.reason);
  return {};
}

std::string hullSection(const NewShip& ship, const std::string& meshName) {
  const MeshReadOptions& o = ship.options;
  std::string text = "[hull]\nmesh = " + quoted(meshName) + "\n";
  text += line("up = " + quoted(o.up), comment(ship, "up"));
  text += line("forward = " + quoted(o.forward), comment(ship, "forward"));
  text += line("unit = " + quoted(o.unit), comment(ship, "unit"));
  text += line(fmt::format("waterline = {:.9g}", o.waterline), comment(ship, "waterline"));
  if (o.trimDeg != 0.0) text += line(fmt::format("trim_deg = {:g}", o.trimDeg), "bow down");
  if (o.heelDeg != 0.0) text += line(fmt::format("heel_deg = {:g}", o.heelDeg), "starboard down");
  if (o.anyFormat) text += "any_format = true\n";
  if (o.symmetric != "auto") text += "symmetric = " + quoted(o.symmetric) + "\n";
  text += line(fmt::format("panels = {}", ship.panels), "about that many a side");
  if (!ship.problem.empty()) text += "# Not solved yet: see what `cutwater new` said.\n";
  return text;
}

std::string massSection(const NewShip& ship) {
  const double length = ship.hydrostatics.length;
  const auto vector = [&](const Vec3& v) {
    return fmt::format("[{}, {}, {}]", metres(v.x(), length), metres(v.y(), length),
                       metres(v.z(), length));
  };
  std::string text = "\n[mass]\n";
  if (ship.givenMass)
    text += line(fmt::format("mass = {:.9g}", *ship.givenMass), "kg, given");
  else
    text += line("mass = \"auto\"", fmt::format("density x volume: {:.6g} kg", ship.mass));
  text += line("cog = " + vector(ship.cog),
               "over the centre of buoyancy; height " + comment(ship, "height of G"));
  text += line("gyradii = " + vector(ship.gyradii),
               ship.directed ? "estimated: 0.35 B, 0.25 L, 0.25 L"
                             : "estimated: at least 0.29 of the height in roll and pitch");
  return text;
}

std::string waterSection(const NewShip& ship) {
  return "\n[water]\n" +
         line(fmt::format("density = {:g}", ship.density),
              ship.density == kSeaWaterDensity ? "kg/m3, sea water" : "kg/m3, given") +
         line(fmt::format("gravity = {:g}", kDefaultGravity), "m/s2, as in the Bullet world");
}

// Frequencies as usualOmega and usualWaveOmega have them, in round numbers.
std::string solveSection(const NewShip& ship) {
  const double root = std::sqrt(kDefaultGravity / ship.hydrostatics.length);
  const double step = rounded(0.36 * root, true), waveStep = rounded(0.18 * root, true);
  const double last = step * std::ceil(21.6 * root / step);
  const double waves = waveStep * std::ceil(7.2 * root / waveStep);
  std::string text = "\n[solve]\n";
  text += line(fmt::format("omega = {{ from = {0:g}, to = {1:g}, step = {0:g} }}", step, last),
               "rad/s, by the length");
  text += line(fmt::format("wave_omega = {{ from = {:g}, to = {:g}, step = {:g} }}", 4.0 * waveStep,
                           std::min(waves, last), waveStep),
               "rad/s, waves of 12 to 0.1 lengths");
  text += "speeds = [0.0]" + std::string(20, ' ') + " # m/s, of tables; others need no new solve\n";
  text += ship.hull.symmetric ? "headings_deg = { from = 0.0, to = 180.0, step = 15.0 }\n"
                              : "headings_deg = { from = -165.0, to = 180.0, step = 15.0 }\n";
  return text + "forward_speed = \"tuck\"\n";
}

std::string otherSections(const NewShip& ship) {
  const Vec3& k = ship.gyradii;
  const Hydrostatics& h = ship.hydrostatics;
  std::string text = "\n[supplementary]\n";
  const double stiffness = h.restoring(3, 3), inertia = ship.mass * k.x() * k.x() * kWaterWithRoll;
  const double damping = stiffness > 0.0 ? 2.0 * kRollDamping * std::sqrt(stiffness * inertia) : 0;
  if (damping > 0.0)
    text += line(fmt::format("roll_damping = {:.3g}", damping),
                 "N m/(rad/s): 5 % of critical, viscosity and appendages");
  if (!ship.directed) return text;
  const double helm = 2.0 * ship.mass * k.z() * k.z() * kHelm * kHelm * kDefaultGravity / h.length;
  text +=
      line(fmt::format("yaw_stiffness = {:.3g}", helm), "N m/rad: the helmsman on a fixed course");
  text += "\n[engine]                           # all that is not given follows from the hull\n";
  return text + "[rudder]\n";
}

}  // namespace

std::string shipToml(const NewShip& ship, const std::string& meshName) {
  const Hydrostatics& h = ship.hydrostatics;
  return fmt::format(
             "# Made by `cutwater new`: {:.4g} x {:.4g} x {:.4g} m, {:.5g} m3, GM {:.3g} m. What "
             "is "
             "marked\n# as a guess is one: look at the picture beside this file.\n",
             h.length, h.beam, h.draft, h.volume, h.gmT) +
         hullSection(ship, meshName) + massSection(ship) + waterSection(ship) + solveSection(ship) +
         otherSections(ship);
}

}  // namespace cutwater::command
