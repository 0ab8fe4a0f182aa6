#pragma once
#include "hydro/geometry/panelling/SectionRow.h"
#include "hydro/geometry/panelling/SectionStrands.h"

namespace cutwater {

/// Panels on one strand of a wet hull, corners on its surface. Stations are closer together at the
/// ends and at equal steps of how far the section moves, so that they follow a blunt bow. Each
/// section is divided from end to end, closer towards calm water, with corners at knuckles, in
/// fewer parts where it is short. A section that shrinks to nothing ends in one point. Where the
/// strand ends in a flat face (transom) of the surface, that is divided too.
SurfaceMesh panelsOn(const SectionStrand& strand, const SectionCutter& cutter,
                     const PanelSize& size);

}  // namespace cutwater
