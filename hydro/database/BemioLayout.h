#pragma once
#include <string>
#include <vector>

#include "hydro/database/Coefficients.h"
#include "hydro/database/Hdf5.h"

/// The root groups of a database file, in the layout that WEC-Sim's BEMIO defines and SEA-Stack
/// (HydroChrono) reads.
///
/// Stored × factor = dimensional: added mass ρ; damping ρω; K ρ; excitation and its impulse
/// response ρg; restoring ρg. Waves travel towards wave_dir, counter-clockwise from +x:
/// wave_dir = −β. Phases are for a crest over the origin of the hull axes, ours for one over G:
///     X_origin = X_G e^{−ik(x_G cos β − y_G sin β)}
namespace cutwater {

/// Group of the body's coefficients.
inline constexpr const char* kBemioCoefficients = "body1/hydro_coeffs/";

void writeBemio(hdf5::Writer& writer, const Coefficients& coefficients,
                const ImpulseResponse& retardation);

/// Numbers that contradict make the result `Unfinished`: for the frequency domain only.
/// @param missing  receives what the file does not have and what was taken instead.
/// @throws HydroError DatabaseIncomplete, FileMalformed, FormatNotSupported.
Coefficients readBemio(const hdf5::Reader& reader, std::vector<std::string>& missing);

}  // namespace cutwater
