#pragma once
#include <optional>
#include <string>
#include <vector>

#include "demos/cutwater/input/ForeignDatabase.h"
#include "hydro/database/Coefficients.h"
#include "hydro/forces/Compartment.h"
#include "hydro/forces/ShipSettings.h"
#include "hydro/waves/SeaState.h"
#include "hydro/waves/Spectrum.h"

namespace cutwater::command {

/// [[compartment]]: a room of the ship that water can be in.
struct RunCompartment {
  CompartmentBox box;
  double rate = 0.0;  ///< [m³/s]
  std::vector<Opening> openings;
};

/// A RUN.toml: what one simulation is made of. Units SI, angles in radians here.
struct RunFile {
  std::string path;
  std::string ship;      ///< SHIP.toml, resolved; empty if the database alone is used
  std::string database;  ///< resolved; empty only of a body that is no ship (RunUse::Show)

  double tick = 0.02;       ///< Bullet's fixed tick [s]
  int substeps = 1;         ///< ticks per stepSimulation
  double duration = 400.0;  ///< [s]
  bool doublePrecision = true;

  enum class Waves { None, Regular, Spectrum, Components };
  Waves waves = Waves::None;
  std::vector<double> omega;       ///< regular waves; more than one only for `sweep`
  double amplitude = 1.0;          ///< [m]
  double phase = 0.0;              ///< [rad]
  int order = 1;                   ///< of regular waves in their steepness: 1, 2, 5
  std::vector<SeaSystem> systems;  ///< Waves::Spectrum: one or several, their gravity not yet known
  SeaStateSettings sea;            ///< ramp and profile of all seas
  std::optional<ForeignBody> body;  ///< [body]
  std::vector<WaveComponent> components;
  std::vector<RunCompartment> compartments;  ///< [[compartment]]

  /// β of regular waves and mean β of spectra, relative to the initial course.
  double heading = kPi;
  ShipStart start;  ///< speed along the initial course, offsets from it
  ShipModel model;
  bool allowUnstable = false;  ///< also at speeds at which the ship's own motions grow

  /// The sea of this run; of regular waves the one at `omega[index]`.
  SeaState seaState(double gravity, std::size_t index = 0) const;
  /// The systems, with gravity, ramp and profile.
  std::vector<SeaSystem> systemsAt(double gravity) const;
  /// The sea's, unless the file says another: Wheeler's of a spectrum, else the report's.
  WaveProfile usualProfile() const {
    return waves == Waves::Spectrum ? WaveProfile::Wheeler : WaveProfile::Extrapolated;
  }
  /// Of all waves of this run [rad/s]; 0 in calm water.
  double highestOmega(double gravity) const;
};

/// What a run file is read for.
enum class RunUse {
  Run,   ///< to be run: it names a database
  Show,  ///< to show a run that is there: also of a body of Bullet's, `[body] size` and no database
  Sea    ///< for its sea alone: with or without a database
};

/// @param usual  the mean course unless the file names one. Where it is fixed, as of a sweep, a
///        free ship has no resistance unless the file asks for it: the frequency domain has none.
/// @throws HydroError naming file, field and value.
RunFile readRunFile(const std::string& path, Mean usual, RunUse use = RunUse::Run);

/// The run's database. If the run names a ship file, its supplementary terms, drag, engine and
/// rudder replace the database's, and its mass, centre of gravity and gyradii must be the
/// database's own. A database of another code is completed by that file's hull and gyradii, or by
/// [body]. Warns of waves that the panels do not resolve, and as warnOfSea.
/// @throws HydroError.
Coefficients readShipOfRun(RunFile& run);

/// Warns of waves steeper than waves are, of a height that is not hs, and of cut-offs that leave
/// out more than 2 % of m0.
void warnOfSea(const RunFile& run, double gravity);

}  // namespace cutwater::command
