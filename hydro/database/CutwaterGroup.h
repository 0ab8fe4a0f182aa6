#pragma once
#include "hydro/database/Coefficients.h"
#include "hydro/database/Hdf5.h"

/// The group /cutwater of a database file: everything of `Coefficients`, dimensional, in our own
/// conventions, to the last bit. Internal to hydro/database.
namespace cutwater {

inline constexpr std::int64_t kFormatVersion = 2;

void writeCutwaterGroup(hdf5::Writer& writer, const Coefficients& coefficients);
/// @throws HydroError DatabaseIncomplete, FileMalformed.
Coefficients readCutwaterGroup(const hdf5::Reader& reader);

/// Refuses numbers that are not finite. @throws HydroError ValueOutOfRange.
void checkFinite(const Coefficients& coefficients, const std::string& where);

/// Refuses numbers that are not finite, a mask other than 0 and 1, sizes that do not match, frequencies that do not increase.
/// @param where begins the message: a function or a file.
/// @throws HydroError ValueOutOfRange, FrequenciesNotIncreasing, DatabaseIncomplete,
///         MeshIndexOutOfRange.
void checkCoefficients(const Coefficients& coefficients, const std::string& where);

}  // namespace cutwater
