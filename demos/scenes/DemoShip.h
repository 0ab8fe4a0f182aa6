#pragma once
#include <cmath>
#include <cstdio>
#include <exception>
#include <initializer_list>
#include <optional>
#include <stdexcept>
#include <string>

#include "demos/scenes/BulletWorld.h"
#include "hydro/base/AtomicFile.h"
#include "hydro/base/CsvRow.h"
#include "hydro/database/CoefficientsFile.h"
#include "hydro/forces/Hydrodynamics.h"
#include "hydro/ship/StabilityRange.h"
#include "plugin/Seaway.h"

/// What demos share: the command line, a table, a check that prints.
namespace cutwater {

/// Where a demo whose OUT.csv was named may leave more files.
struct SceneFiles {
  std::string database, stem;  ///< its path; OUT without .csv
};

/// Rows of numbers that become a CSV.
class DemoTable {
 public:
  explicit DemoTable(const char* header, std::optional<SceneFiles> files = {})
      : text_(std::string(header) + '\n'), files_(std::move(files)) {}
  void row(std::initializer_list<double> values) { addCsvRow(text_, values); }
  const std::string& text() const noexcept { return text_; }
  /// Absent: OUT.csv was not named.
  const std::optional<SceneFiles>& files() const noexcept { return files_; }

 private:
  std::string text_;
  std::optional<SceneFiles> files_;
};

/// Prints a quantity beside what theory says; true if they agree.
inline bool agrees(const char* what, double value, double expected, double tolerance) {
  const bool good = std::abs(value - expected) <= tolerance;
  std::printf("%-52s %12.6g  theory %12.6g +- %.2g%s\n", what, value, expected, tolerance,
              good ? "" : "  NO");
  return good;
}

/// The same for a bound.
inline bool isBelow(const char* what, double value, double bound) {
  const bool good = value <= bound;
  std::printf("%-52s %12.6g  at most %11.6g%s\n", what, value, bound, good ? "" : "  NO");
  return good;
}

/// main() of a demo, NAME DATABASE.h5 [OUT.csv]: run(coefficients, table) says whether physics
/// held.
template <class Run>
int demoMain(int argc, char** argv, const std::string& name, const char* header, Run run) {
  if (argc < 2) {
    std::printf("usage: %s DATABASE.h5 [%s.csv]\n", name.c_str(), name.c_str());
    return 2;
  }
  try {
    std::optional<SceneFiles> files;
    if (argc > 2) {
      const std::string out = argv[2];
      files = SceneFiles{argv[1], out.substr(0, out.size() - (out.ends_with(".csv") ? 4 : 0))};
    }
    DemoTable table(header, files);
    const bool good = run(readCoefficients(argv[1]), table);
    writeWhole(argc > 2 ? argv[2] : name + ".csv", table.text());
    return good ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", name.c_str(), error.what());
    return 1;
  }
}

/// Heave, roll and pitch at rest of a ship that carries `mass` [kg] at a place about G [m] fixed to
/// the ship, by its hull: where ship and cargo as one ship have no righting lever.
/// @throws std::runtime_error if they have no such place but keel up.
inline Vec6 carrying(const ShipParticulars& ship, double mass, const Vec3& place) {
  ShipParticulars loaded = ship;
  loaded.mass += mass;
  loaded.cog += mass / loaded.mass * place;
  Righting righting(loaded, RightingTrim::Free);
  const auto heel = stabilityRange(righting, kPi).rest;
  if (!heel) throw std::runtime_error("this ship does not carry it upright; take the frigate");
  const RightingLever rest = righting.at(*heel);
  Vec6 motion = Vec6::Zero();
  motion[Roll] = rest.heel;
  motion[Pitch] = rest.trim;
  const Mat3 rotation = Attitude{.roll = rest.heel, .pitch = rest.trim}.rotation();
  motion[Heave] = rest.heightOfG + (rotation * (ship.cog - loaded.cog)).z() - ship.cog.z();
  return motion;
}

}  // namespace cutwater
