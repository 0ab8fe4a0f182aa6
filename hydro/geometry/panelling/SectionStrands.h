#pragma once
#include "hydro/geometry/panelling/SectionCurves.h"

namespace cutwater {

/// What happens at one end of a strand.
struct StrandEnd {
  /// Sections of other strands that go on along parts of its last.
  std::vector<SectionCurve> guests;
  /// Its last section is a part of another strand's.
  bool hosted = false;
  bool alone() const { return guests.empty() && !hosted; }
};

/// One section curve followed along the axis from where it appears to where it vanishes, splits,
/// jumps or leaves calm water: the side and bottom of a hull, or of one hull of several.
struct SectionStrand {
  std::vector<double> place;         ///< along the axis, rising [m]
  std::vector<SectionCurve> curves;  ///< there
  StrandEnd start, end;
};

/// All strands of a surface, in samples so dense that from one to the next no point at a fixed
/// fraction of the girth moves by more than `reach` [m], except where the section really jumps.
/// Curves shorter than a third of that are left out where they are alone.
std::vector<SectionStrand> sectionStrands(const SectionCutter& cutter, double reach);

}  // namespace cutwater
