#pragma once
#include <string>

#include "hydro/database/Coefficients.h"

namespace cutwater::command {

/// What a run adds to a database of another code (a plain BEMIO file), which holds neither gyradii
/// nor a hull. Lengths in metres.
struct ForeignBody {
  Vec3 gyradii = Vec3::Zero();  ///< of roll, pitch, yaw about G; 0: not given
  Vec3 size = Vec3::Zero();     ///< length, beam, height of a box; 0: not given
};

/// The coefficients are those of a plain BEMIO file.
bool isForeign(const Coefficients& coefficients);

/// Gives gyradii, and as hull a box about the centre of buoyancy, its bottom twice as deep as that.
void giveBody(Coefficients& coefficients, const ForeignBody& body);

/// Makes sure that A(ω), B(ω) and A(∞) of a foreign database belong together, as the time domain
/// needs them all: an A(∞) that was not computed is taken from A and B, with a warning; anything
/// else that contradicts is refused; a grid coarser or shorter than usual ships need is warned of.
/// @param file  begins the messages, which name dataset, modes and frequency.
/// @throws HydroError DatabaseIncomplete.
void makeConsistent(Coefficients& coefficients, const std::string& file);

}  // namespace cutwater::command
