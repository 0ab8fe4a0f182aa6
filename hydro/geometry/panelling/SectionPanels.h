#pragma once
#include "hydro/geometry/panelling/SectionRow.h"
#include "hydro/geometry/panelling/SectionStrands.h"

/// Panels on the strands of a wet hull; not installed.
namespace cutwater {

/// Panels on one strand, corners on its surface: stations closer together at the ends and at equal
/// steps of how far the section moves, so that they follow a blunt bow; each section divided from
/// end to end, closer towards calm water, with corners at knuckles; fewer parts where it is short. A
/// section that shrinks to nothing ends in one point. Where the strand ends in a flat face (transom)
/// of the surface, that is divided too.
SurfaceMesh panelsOn(const SectionStrand& strand, const SectionCutter& cutter,
                     const PanelSize& size);

}  // namespace cutwater
