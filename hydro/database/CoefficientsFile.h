#pragma once
#include <string>

#include "hydro/database/Coefficients.h"

namespace cutwater {

/// Writes a ship's database.
///     writeCoefficients(coefficients, "ship.h5", impulseResponse(coefficients));  // solve/Solve.h
///     const Coefficients ship = readCoefficients("ship.h5");
/// HDF5: the root groups have the layout of BEMIO, for WEC-Sim and SEA-Stack (HydroChrono); the
/// group /cutwater holds all of `coefficients` to the last bit, with a format version and a
/// checksum over every dataset. Behind the end of the HDF5 file stands a seal of 24 bytes, a
/// checksum of the whole file; HDF5 programs do not see it.
///
/// The file is made in memory, written under a temporary name in the same folder, synced and
/// renamed: at any instant `path` holds the old file or the new one, whole. On failure nothing is
/// left behind. One thread at a time, as everything that uses HDF5.
/// @param retardation K for the readers of BEMIO; Cutwater itself does not read it. Empty: left
///        out, and programs that need K (HydroChrono) refuse the file. Unfinished coefficients are
///        written without any impulse response.
/// @throws HydroError FileNotWritable; ValueOutOfRange (a number that is not finite, named),
///         FrequenciesNotIncreasing, DatabaseIncomplete (sizes do not match, a status that cannot
///         be).
void writeCoefficients(const Coefficients& coefficients, const std::string& path,
                       const ImpulseResponse& retardation = {});

/// Reads a database of this or an earlier version from 0.1.0 on, or a plain BEMIO file of another
/// code at U = 0 (deep water; body 1 of several).
///
/// A database of 0.1.0 does not say whether it is finished; it is if it holds the A(∞) that follows
/// from A(ω) and B(ω). A BEMIO file counts as given, because its author answers for its grid; it
/// lacks the hull, gyradii (left 0: not known), A(0) (taken at the lowest frequency), x-derivatives
/// and adjoint vectors, and its mass is taken as ρ × volume.
/// @param warning  receives one line that says what is missing, or "" for a database of our own.
/// @throws HydroError FileNotReadable; FileMalformed (not HDF5, truncated, changed since it was
///         written); VersionNotSupported (by a newer Cutwater, or older than 0.1.0);
///         DatabaseIncomplete; FormatNotSupported (BEMIO with scaled = 1); ValueOutOfRange (not
///         finite).
Coefficients readCoefficients(const std::string& path, std::string* warning = nullptr);

}  // namespace cutwater
