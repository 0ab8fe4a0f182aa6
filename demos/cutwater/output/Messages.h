#pragma once
#include <functional>
#include <string>

#include "hydro/database/Coefficients.h"

namespace cutwater::command {

/// One line on stderr, nothing if empty.
void warn(const std::string& line);
/// One warning that names `file` if waves up to `omega` [rad/s] are shorter than the panels
/// resolve.
void warnIfUnresolved(const std::string& file, const Coefficients& coefficients, double omega);
/// One warning that names `file` if A and B have resonances narrower than the grid's steps.
void warnOfResonances(const std::string& file, const Coefficients& coefficients);
/// Runs `work`; its HydroErrors get the file's name in front.
void naming(const std::string& file, const std::function<void()>& work);

}  // namespace cutwater::command
