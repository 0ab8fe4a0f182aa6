#pragma once
#include <string>
#include <vector>

#include "hydro/database/Coefficients.h"

/// The subcommands of `cutwater`, one file each. Every one throws HydroError with the line to
/// print; `out` is the file to write, or empty for stdout.
namespace cutwater::command {

void hydrostatics(const std::string& ship, const std::string& out);
void solve(const std::string& ship, const std::string& database, int threads);
void info(const std::string& database, const std::string& out);
void coefficients(const std::string& database, double speed, const std::string& out);
void excitation(const std::string& database, double speed, double headingDeg,
                const std::string& omegaRange, const std::string& out);
void rao(const std::string& database, double speed, double headingDeg,
         const std::string& omegaRange, const std::string& out);
void retardation(const std::string& database, double step, double duration, const std::string& out);
void simulate(const std::string& run, bool forces, const std::string& out);
void sweep(const std::string& run, int threads, const std::string& out);

/// "A:B:N", N values with both ends; empty: `fallback`.
/// @throws HydroError BadArgument.
std::vector<double> omegaList(const std::string& range, const std::vector<double>& fallback);
/// The wave frequencies at which tables are written by default.
const std::vector<double>& defaultWaveOmega(const Coefficients& coefficients);
/// Refuses any speed but 0, which is all this version computes.
void requireZeroSpeed(double speed);
/// β [rad] of a --heading in degrees. @throws HydroError BadArgument beyond two turns.
double headingRadians(double degrees);
/// One line on stderr, nothing if empty.
void warn(const std::string& line);

}  // namespace cutwater::command
