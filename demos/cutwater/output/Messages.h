#pragma once
#include <functional>
#include <string>
#include <string_view>

#include "hydro/database/Coefficients.h"

namespace cutwater::command {

/// One line on stderr, in printable form and with nothing lost but what is longer than any sensible
/// line. That stderr is closed or full is no failure: messages are not the result.
void say(const std::string& line);
/// "cutwater: warning: line", the same line once; nothing if `line` is empty.
void warn(const std::string& line);
/// `text` for a terminal: control characters as \xNN, and if it has more than `most` bytes, its
/// beginning and its length.
std::string printable(std::string_view text, std::size_t most = 2000);
/// A value to be quoted in a message.
inline std::string shortened(std::string_view text) { return printable(text, 80); }
/// One warning that names `file` if waves up to `omega` [rad/s] are shorter than the panels
/// resolve.
void warnIfUnresolved(const std::string& file, const Coefficients& coefficients, double omega);
/// One warning that names `file` if A and B have resonances narrower than the grid's steps.
void warnOfResonances(const std::string& file, const Coefficients& coefficients);
/// Runs `work`; its HydroErrors get the file's name in front.
void naming(const std::string& file, const std::function<void()>& work);

}  // namespace cutwater::command
