#pragma once
#include <string>

#include "hydro/database/Coefficients.h"
#include "hydro/database/ImpulseResponse.h"

namespace cutwater {

/// Writes a ship's database, HDF5: root groups in the layout of BEMIO, for WEC-Sim and SEA-Stack
/// (HydroChrono); all of `coefficients`, to the last bit, in the group /cutwater, with a
/// format version and a checksum over every dataset. Behind the end of the HDF5 file stands a seal
/// of 24 bytes, a checksum of the file as a whole; HDF5 programs do not see it.
///
/// Written under a temporary name in the same folder, synced and renamed: at any instant `path`
/// holds the old file or the new one, whole. On failure nothing is left behind.
/// One thread at a time, as everything that touches HDF5.
/// @param retardation  K for the readers of BEMIO; Cutwater itself does not read it. Empty: left
/// out,
///                     and programs that need K (HydroChrono) will not take the file.
/// @throws HydroError FileNotWritable; ValueOutOfRange (a number that is not finite, named),
///         FrequenciesNotIncreasing, DatabaseIncomplete (sizes do not match).
void writeCoefficients(const Coefficients& coefficients, const std::string& path,
                       const ImpulseResponse& retardation = {});

/// Reads a database, or a plain BEMIO file of another code at U = 0 (deep water; body 1 of
/// several). Of the latter the hull, its gyradii (left 0: not known), A(0) (taken at the lowest
/// frequency), x-derivatives and adjoint vectors are missing; its mass is ρ × volume.
/// @param warning  receives one line that says what is missing, or "" for a database of our own.
/// @throws HydroError FileNotReadable; FileMalformed (not HDF5, truncated, changed since it was
///         written); VersionNotSupported (by a newer Cutwater, or version 1); DatabaseIncomplete;
///         FormatNotSupported (BEMIO with scaled = 1); ValueOutOfRange (not finite).
Coefficients readCoefficients(const std::string& path, std::string* warning = nullptr);

}  // namespace cutwater
