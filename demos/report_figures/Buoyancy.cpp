#include <cmath>

#include "demos/report_figures/Report.h"
#include "hydro/ship/StillWater.h"

namespace cutwater::report {

namespace {

/// What one figure draws: the load of a mode, over values of which 1 shifts the ship by `unit`.
struct Axis {
  const char* file;
  const char* name;
  double first, last, step;
  Attitude unit;
  int mode;
};

/// Pressure of calm water on the ship held there, less the weight in heave, over Δ g: as `cutwater
/// buoyancy` has it, in the report's unit.
void writeBuoyancy(const Job& job, const Axis& axis) {
  const ShipParticulars& ship = job.medium().ship;
  StillWater water(ship);
  const double weight = ship.mass * ship.gravity, atRest = axis.mode == Heave ? weight : 0.0;
  command::Csv csv(std::string(axis.name) + ",nonlinear,linear");
  const int count = static_cast<int>(std::lround((axis.last - axis.first) / axis.step));
  for (int i = 0; i <= count; ++i) {
    const double value = axis.first + axis.step * i;
    Attitude shift{value * axis.unit.height, value * axis.unit.roll, value * axis.unit.pitch};
    const double linear = linearBuoyancyLoad(ship, shift)[axis.mode];
    shift.height += ship.cog.z();
    const double nonlinear = buoyancyLoad(water, shift)[axis.mode];
    csv.row({value, (nonlinear - atRest) / weight, (linear - atRest) / weight});
  }
  csv.write(job.file(axis.file));
}

}  // namespace

void writeFigures34To36(const Job& job) {
  writeBuoyancy(job, {"figure34.csv", "heave", -8.0, 6.0, 0.25, {.height = 1.0}, Heave});
  writeBuoyancy(job, {"figure35.csv", "roll_deg", -90.0, 90.0, 2.5, {.roll = kDegree}, Roll});
  writeBuoyancy(job, {"figure36.csv", "pitch_deg", -10.0, 10.0, 0.25, {.pitch = kDegree}, Pitch});
}

}  // namespace cutwater::report
