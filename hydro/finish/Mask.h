#pragma once
#include "hydro/database/Coefficients.h"

namespace cutwater {

/// Sets `masked` by irregularFrequencies (database/IrregularFrequencies.h) and replaces everything
/// at the masked frequencies, and at those that the panels do not resolve (resolvedCount), by what
/// follows from the others: A, B, ∂A, ∂B and adjoint vectors as in Interpolation.h, through their
/// limits at ω = 0 and towards those at ω = ∞ (adjoint vectors without such limits are held).
/// Diffraction forces at the headings of the table follow from the adjoint vectors; without any
/// they are interpolated themselves, held at the ends. F_I and a DiffractionTable stay: F_I has no
/// resonance, the table has frequencies of its own. A second time changes nothing.
/// @throws HydroError DatabaseIncomplete if fewer than two frequencies remain; ValueOutOfRange,
///         FrequenciesNotIncreasing for a bad envelope.
void applyMask(Coefficients& coefficients);

}  // namespace cutwater
