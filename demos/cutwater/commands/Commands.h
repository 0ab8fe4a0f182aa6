#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "demos/cutwater/input/NewShip.h"
#include "demos/cutwater/output/Messages.h"
#include "hydro/Errors.h"
#include "hydro/database/Coefficients.h"
#include "hydro/files/MeshIO.h"

/// The subcommands of `cutwater`, one file each. Every one throws HydroError with the line to
/// print; `out` is the file to write, or empty for stdout.
namespace cutwater::command {

/// An option's value that no file could make right: the command exits 2 instead of 1.
class UsageError : public HydroError {
 public:
  explicit UsageError(const std::string& what) : HydroError(Fault::BadArgument, what) {}
};

void hydrostatics(const std::string& ship, const std::string& out);
/// Levers at the heels A:B:N [deg]; `trim` is one of kRightingTrimNames.
void righting(const std::string& ship, const std::string& heels, const std::string& trim,
              const std::string& out);
/// One of the three is given: A:B:N [m, deg, deg].
struct PoseOptions {
  std::string heave, roll, pitch;
};
void buoyancy(const std::string& ship, const PoseOptions& poses, const std::string& out);
/// Panels for `hull`, a mesh (read with `options`) or a SHIP.toml, written as OBJ in hull axes.
void panel(const std::string& hull, int count, const MeshReadOptions& options, PanelsBy by,
           const std::string& out);
/// A ship.toml for the mesh `hull`, guessed as far as it is not said, and a picture of it beside.
/// @param out  the ship.toml; of a name in .toml.  @param force  writes over files that are there.
void newShipFile(const std::string& hull, const NewOptions& options, bool force,
                 const std::string& out);
void solve(const std::string& ship, const std::string& database, int threads);
void info(const std::string& database, const std::string& out);

/// Forward speed U [m/s] and the form of its terms: one of kForwardSpeedNames, or "" for the
/// database's own.
struct SpeedOptions {
  double speed = 0.0;
  std::string formName;
  /// What was asked for, or the database's own.
  ForwardSpeedForm form(const CoefficientTables& coefficients) const;
};
/// One heading, wave frequencies A:B:N ("" for the solve's).
struct WaveOptions {
  SpeedOptions moving;
  double headingDeg = 180.0;
  std::string omegaRange;
};
/// Another loading of the hull; what is absent stays the database's.
struct LoadingOptions {
  std::optional<double> mass;  ///< [kg]
  std::string cog, gyradii;    ///< "X,Y,Z" [m]
};
void coefficients(const std::string& database, const SpeedOptions& moving, const std::string& out);
void excitation(const std::string& database, const WaveOptions& waves, const std::string& out);
void rao(const std::string& database, const WaveOptions& waves, const LoadingOptions& loading,
         bool free, const std::string& out);
void retardation(const std::string& database, double step, double duration, const std::string& out);
/// What `simulate` writes besides motions.
struct RunColumns {
  bool forces = false;  ///< the parts of the load
  bool wetted = false;  ///< what of the hull is wet; nonlinear mode only
};
void simulate(const std::string& run, const RunColumns& columns, const std::string& out);
/// The components of a run's sea, or what they amount to.
void sea(const std::string& run, bool moments, const std::string& out);
void sweep(const std::string& run, int threads, const std::string& out);
/// One page of a database and of runs, RUN.toml each, written to `out`; its data alone, as JSON, if
/// `out` ends in ".json".
void report(const std::string& database, const std::vector<std::string>& runs,
            const std::string& out);

/// "A:B:N", N values with both ends; empty: `fallback`.
/// @throws UsageError.
std::vector<double> omegaList(const std::string& range, const std::vector<double>& fallback);
/// "A:B:N" of an option, within ±`largest`. @param example  of it, for the message.
/// @throws UsageError.
std::vector<double> rangeOption(const std::string& option, const std::string& text, double largest,
                                const std::string& example);
/// The database; prints the warning of a foreign file.
/// @throws HydroError; UsageError for a speed outside 0..100 m/s.
Coefficients readDatabase(const std::string& path, const SpeedOptions& moving);
/// "X,Y,Z" of an option. @throws UsageError naming option and text.
Vec3 vectorOption(const std::string& option, const std::string& text);
/// Refuses work whose results do not fit into three quarters of this machine's memory.
/// @param what  begins the message, naming fields and values.  @throws HydroError ValueOutOfRange.
void requireMemory(const std::string& what, double bytes);
/// β [rad] of a --heading in degrees. @throws UsageError beyond two turns.
double headingRadians(double degrees);

}  // namespace cutwater::command
