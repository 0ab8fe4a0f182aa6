#include "hydro/geometry/outer/LeakStopping.h"

#include <fmt/format.h>

#include <algorithm>

#include "hydro/Errors.h"
#include "hydro/geometry/MeshCut.h"
#include "hydro/geometry/MeshEdges.h"
#include "hydro/geometry/PlaceText.h"
#include "hydro/geometry/SurfacePatches.h"
#include "hydro/geometry/repair/HoleFilling.h"

namespace cutwater {
namespace {

constexpr double kSlit = 1e-3;      // of the length
constexpr double kLeaked = 2e-3;    // of the volume, lost through holes
constexpr double kMostlyWet = 0.5;  // share of the area with water on both sides

double lengthOf(const SurfaceMesh& mesh) {
  const Bounds box = bounds(mesh);
  return box.high.x() - box.low.x();
}

bool hasLooseEdge(const SurfaceMesh& wet) {
  const std::vector<OpenEdge> edges = looseEdges(wet);
  return std::any_of(edges.begin(), edges.end(), [&](const OpenEdge& e) {
    return wet.vertices[static_cast<std::size_t>(e.from)].z() != 0.0 ||
           wet.vertices[static_cast<std::size_t>(e.to)].z() != 0.0;
  });
}

/// The wet part's holes, filled or not. None of a one-sided surface, whose rims have no sense.
std::vector<FilledHole> fill(SurfaceMesh& wet, const std::string& name) {
  try {
    wet = agreeing(wet, name);
  } catch (const HydroError&) {
    return {};
  }
  return fillNarrowHoles(wet, kWidestHole * lengthOf(wet));
}

void checkOutside(const WaterSurvey& s, const std::vector<FilledHole>& holes,
                  const std::string& name) {
  if (s.plateArea <= kMostlyWet * (s.plateArea + s.area) && s.volume > 0) return;
  std::string where = ", for instance at " + placeText(s.platePlace);
  double widest = 0.0;
  for (const FilledHole& hole : holes) {
    if (!hole.open || hole.width < widest) continue;
    widest = hole.width;
    where = fmt::format(" through a hole {:.3g} m wide at {}; holes up to {:.3g} m are closed",
                        hole.width, placeText(hole.place),
                        kWidestHole * (s.wet.high.x() - s.wet.low.x()));
  }
  throw HydroError(Fault::HullNotClosed,
                   name + ": water gets to both sides of most of the hull" + where);
}

}  // namespace

double slitTolerance(const SurfaceMesh& mesh) { return kSlit * lengthOf(mesh); }

TightSurface withoutLeaks(const SurfaceMesh& clean, const std::string& name) {
  const double slit = slitTolerance(clean);
  TightSurface tight{clean, surveyWater(clean, slit), {}};
  WaterSurvey& survey = tight.survey;
  SurfaceMesh wet = cutBelow(clean);
  std::vector<FilledHole> holes;
  if (hasLooseEdge(wet)) {
    holes = fill(wet, name);
    SurfaceMesh filled = triangulated(welded(joined(wet, cutAbove(clean)), 0.0));
    WaterSurvey after = surveyWater(filled, slit);
    if (survey.volume < (1 - kLeaked) * after.volume) {
      tight.mesh = std::move(filled);
      const auto closed = std::count_if(holes.begin(), holes.end(),
                                        [](const FilledHole& hole) { return !hole.open; });
      tight.done.push_back(fmt::format("closed {}, without which {:.3g} m3 of {:.3g} m3 would fill",
                                       counted(static_cast<std::size_t>(closed), "hole"),
                                       after.volume - survey.volume, after.volume));
      survey = std::move(after);
    }
    const double open = surveyWater(tight.mesh, 0.0).volume;
    if (open < (1 - kLeaked) * survey.volume)
      tight.done.push_back(
          fmt::format("closed slits up to {:.2g} m wide, through which {:.3g} m3 "
                      "of {:.3g} m3 would fill",
                      2 * slit, survey.volume - open, survey.volume));
  }
  checkOutside(survey, holes, name);
  return tight;
}

}  // namespace cutwater
