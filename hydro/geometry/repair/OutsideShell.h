#pragma once
#include <string>
#include <vector>

#include "hydro/geometry/SurfaceMesh.h"

namespace cutwater {

/// The part of a surface that the water touches, and what was done to find it, in words.
struct OutsideShell {
  SurfaceMesh mesh;  ///< normals towards the water
  std::vector<std::string> done;
};

/// Keeps the patches of a wet surface that are seen from the water on one side, turned towards it.
/// Patches that are not seen (decks, bulkheads, inner shells) and patches that are seen from both
/// sides (plates) are dropped. Shells that pass through one another are split there first.
/// @throws HydroError, naming the place: HullNotClosed if nothing is left; HullPartHidden if a
///   patch is partly hidden for another reason; HullInverted for a one-sided patch.
OutsideShell outsideShell(const SurfaceMesh& wet, const std::string& name);

}  // namespace cutwater
