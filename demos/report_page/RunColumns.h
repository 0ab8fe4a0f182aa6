#pragma once
#include <string>

#include "demos/report_page/Json.h"

/// The rows that `simulate` and `sweep` write.
namespace cutwater::page {

enum class RunKind { Simulate, Sweep };

/// Which of the two wrote this CSV, by its first line.
/// @throws HydroError FileMalformed naming the first column that fits neither.
RunKind kindOf(const std::string& csv);

/// "columns" and "parts" of a CSV of `simulate`. It is read twice, line by line, so that a run of
/// ten hours needs no memory but what is written.
/// @throws HydroError naming file, line, column and value: no rows, times that do not rise.
void columnsJson(Json& json, const std::string& csv);

/// "sweep" of a CSV of `sweep`.
void sweepJson(Json& json, const std::string& csv);

}  // namespace cutwater::page
