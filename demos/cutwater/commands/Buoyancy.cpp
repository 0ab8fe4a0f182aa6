#include "demos/cutwater/commands/Commands.h"
#include "demos/cutwater/input/ShipFile.h"
#include "demos/cutwater/output/Csv.h"
#include "hydro/ship/StillWater.h"

namespace cutwater::command {

namespace {

constexpr double kDegree = kPi / 180.0;
constexpr double kFarthest = 1e6;  // [m]

/// The values that were asked for, and what one of them shifts the ship by.
struct Poses {
  std::vector<double> values;
  Attitude unit;
};

Poses posesOf(const PoseOptions& options) {
  if (!options.heave.empty())
    return {rangeOption("--heave", options.heave, kFarthest, "-8:6:29"), {.height = 1.0}};
  if (!options.roll.empty())
    return {rangeOption("--roll", options.roll, 180.0, "-90:90:37"), {.roll = kDegree}};
  return {rangeOption("--pitch", options.pitch, 180.0, "-10:10:21"), {.pitch = kDegree}};
}

}  // namespace

void buoyancy(const std::string& path, const PoseOptions& options, const std::string& out) {
  const auto [values, unit] = posesOf(options);
  const ShipParticulars ship = readShipFile(path).particulars;
  Csv csv("value,F1,F2,F3,F4,F5,F6,linear_F1,linear_F2,linear_F3,linear_F4,linear_F5,linear_F6");
  naming(path, [&] {
    StillWater water(ship);
    for (const double value : values) {
      Attitude shift{value * unit.height, value * unit.roll, value * unit.pitch};
      const Vec6 linear = linearBuoyancyLoad(ship, shift);
      shift.height += ship.cog.z();
      const Vec6 load = buoyancyLoad(water, shift);
      std::vector<double> row{value};
      row.insert(row.end(), load.begin(), load.end());
      row.insert(row.end(), linear.begin(), linear.end());
      csv.row(row);
    }
  });
  csv.write(out);
}

}  // namespace cutwater::command
