#pragma once
#include "hydro/database/Coefficients.h"
#include "hydro/database/Hdf5.h"

/// The group /cutwater of a database file: all of `Coefficients`, dimensional, in our own
/// conventions, to the last bit.
namespace cutwater {

/// Every change of the group's datasets raises the version
/// (tests/database/cutwater_group_test.cpp). 2: version 0.1.0 of Cutwater. 3: status and
/// unfinished_because. 4: stability; without x-derivatives unless the report's form needs them. 5:
/// curved_panels is a PanelShape, no longer 0 or 1; 0 and 1 mean what they meant. 6: axes, unit and
/// origin of the hull's file. 7: drag of the hull, engine and rudder.
inline constexpr std::int64_t kFormatVersion = 7, kOldestFormatVersion = 2;

void writeCutwaterGroup(hdf5::Writer& writer, const Coefficients& coefficients);
/// Version 2 has no status: coefficients without a consistent A(∞) are then unfinished.
/// @param version of the file, kOldestFormatVersion to kFormatVersion.
/// @throws HydroError DatabaseIncomplete, FileMalformed.
Coefficients readCutwaterGroup(const hdf5::Reader& reader, std::int64_t version);

/// Refuses numbers that are not finite, naming modes and frequency.
/// @throws HydroError ValueOutOfRange.
void checkFinite(const Coefficients& coefficients, const std::string& where);

/// Refuses `values` [rad/s] unless each is above the one before, the first above `above`.
/// @throws HydroError FrequenciesNotIncreasing, naming the number and the rule.
void checkIncreasing(const std::string& where, const std::string& name,
                     const std::vector<double>& values, double above);

/// Refuses numbers that are not finite, a mask other than 0 and 1, sizes that do not match,
/// frequencies that do not increase, a status that the numbers contradict.
/// @param where begins the message: a function or a file.
/// @throws HydroError ValueOutOfRange, FrequenciesNotIncreasing, DatabaseIncomplete,
///         MeshIndexOutOfRange.
void checkCoefficients(const Coefficients& coefficients, const std::string& where);

}  // namespace cutwater
