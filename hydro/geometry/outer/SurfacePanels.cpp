#include "hydro/geometry/outer/SurfacePanels.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "hydro/geometry/MeshCut.h"
#include "hydro/geometry/MeshIntegrals.h"
#include "hydro/geometry/PlaceText.h"
#include "hydro/geometry/outer/DualSurface.h"
#include "hydro/geometry/outer/PanelTidying.h"
#include "hydro/geometry/outer/SurfaceFitting.h"

namespace cutwater {
namespace {

constexpr int kFine = 8;                      // planes of the fine grid in one length of the panels
constexpr std::size_t kMostNodes = 40000000;  // of the fine grid
constexpr double kMirrorTolerance = 1e-3;     // of the size
constexpr double kShortest = 0.3;             // of the panels' length: shorter edges are merged
constexpr int kSmoothings = 8;                // of smoothing
constexpr double kTogether = 1e-3;  // of the panels' length: corners of two cells that met
constexpr double kReach = 0.15;     // of it, around a vertex: an edge is looked for there
constexpr double kOnEdge = 0.02;    // of the panels' length: a vertex on an edge is so near
// Of the panels' length; moves follow the height of the surface there and hide no lost part.
constexpr double kMostMove = 0.08;
constexpr int kTries = 8, kTryStep = 2;
constexpr double kCloseEnough = 0.05;  // of the count
constexpr double kVolumeOff = 0.004, kFiner = 0.9, kMostPanels = 1.5;
constexpr double kLightOff = 5e-4, kGridsOff = 2e-3;  // of the volume
constexpr double kKnownOff = 4e-3;      // of a volume that is known otherwise: twice kGridsOff
constexpr double kLeastReserve = 0.05;  // of the volume below water
constexpr double kWorthSaying = 1e-3;   // of the volume, or of the area

std::vector<Vec3> unitNormals(const SurfaceMesh& triangles) {
  std::vector<Vec3> normals;
  for (const Face& f : triangles.faces) normals.push_back(vectorArea(triangles, f).normalized());
  return normals;
}

class SurfacePanels {
 public:
  SurfacePanels(const TightSurface& tight, Symmetry symmetry)
      : mesh_(tight.mesh),
        survey_(tight.survey),
        done_(tight.done),
        box_(bounds(mesh_)),
        normals_(unitNormals(mesh_)),
        half_(symmetry != Symmetry::None &&
              isMirrorImage(mesh_, survey_, kMirrorTolerance * box_.diagonal())) {}

  /// Finer where the panels would lack volume, up to kMostPanels of the count.
  OuterSurface about(int count, double knownVolume) {
    known_ = knownVolume;
    double length = lengthFor(count);
    OuterSurface best = made(length);
    for (int i = 0; i < kTries && off(best) > kVolumeOff; ++i) {
      length *= kFiner;
      OuterSurface finer = made(length);
      if (aSide(finer) > kMostPanels * count) break;
      if (off(finer) < off(best)) best = std::move(finer);
    }
    say(best, count);
    return best;
  }

 private:
  double aSide(const OuterSurface& s) const {
    return static_cast<double>(s.panels.faces.size()) / (half_ ? 1 : 2);
  }
  static double off(const OuterSurface& s) { return std::abs(s.panelVolume / s.volume - 1); }

  /// That gives about the number wanted, of a few tries.
  double lengthFor(int count) const {
    const double wanted = half_ ? count : 2.0 * count;
    double length = std::sqrt(1.2 * survey_.area / (2.0 * count)), best = length, least = 1e300;
    double few = 0.0, many = 0.0;  // lengths that gave too few panels, and too many
    for (int i = 0; i < kTries && least > kCloseEnough; ++i) {
      const FinePlanes fine = finePlanes(planes(length), kTryStep, survey_.wet.high.z());
      const SpaceGrid grid(fine.planes);
      const WaterGrid water = flooded(grid, crossingsOf(grid));
      const double n =
          static_cast<double>(panelsOf(water, kTryStep, fine.top, length).mesh.faces.size());
      if (std::abs(n / wanted - 1) < least) {
        least = std::abs(n / wanted - 1);
        best = length;
      }
      (n < wanted ? few : many) = length;
      length = few > 0 && many > 0 ? std::sqrt(few * many)
                                   : length * std::sqrt(std::clamp(n / wanted, 0.3, 3.0));
    }
    return best;
  }

  SpaceGrid::Planes planes(double length) const {
    GridPlan plan{box_, length, half_, {}};
    plan.extra = planesOfThinParts(survey_.water, survey_.crossings, length, half_);
    return coarsePlanes(plan);
  }

  GridCrossings crossingsOf(const SpaceGrid& grid) const {
    return {mesh_, grid, slitTolerance(mesh_)};
  }
  WaterGrid flooded(const SpaceGrid& grid, const GridCrossings& crossings) const {
    return {grid, crossings, half_};
  }

  DualSurface panelsOf(const WaterGrid& fineWater, int step, int top, double length) const {
    DualSurface s = dualSurface(fineWater.coarser(step, top), normals_, true);
    mergeShortEdges(s, kShortest * length);
    mergeShortEdges(s, kShortest * length);
    return s;
  }

  OuterSurface made(double length) {
    const SpaceGrid::Planes coarsePlanes = planes(length);
    int step = kFine;
    FinePlanes fine = finePlanes(coarsePlanes, step, box_.high.z());
    while (step > 2 && SpaceGrid(fine.planes).nodes() > kMostNodes)
      fine = finePlanes(coarsePlanes, step -= 2, box_.high.z());
    const SpaceGrid grid(fine.planes);
    const GridCrossings crossings = crossingsOf(grid);
    const WaterGrid water = flooded(grid, crossings);
    const int sides = half_ ? 2 : 1;
    OuterSurface out;
    const SurfaceMesh hull = hullOf(water, out.volumeOff);
    const SurfaceMesh wet = cutBelow(hull);
    out.volume = knownOr(sides * volumeIntegrals(wet).volume);
    setHull(out, hull, wet);
    DualSurface panels = panelsOf(water, step, fine.top, length);
    const SurfaceTree surface(wet);
    releaseRoundEdges(panels, wet, surface, kOnEdge * length, kReach * length);
    smooth(panels, surface, kSmoothings);
    panels.mesh.faces = tidied(panels.mesh);
    fillOut(panels, surface, out.volume / sides, kMostMove * length);
    out.panels = welded(withSplitWaterCorners(panels.mesh), kTogether * length);
    out.panelVolume = sides * volumeIntegrals(out.panels).volume;
    out.betweenPanels = partsBetweenNodes(water, step, fine.top);
    out.betweenPanels.volume *= sides;
    out.thin = partsBetweenCrossings(water, crossings, fine.top);
    out.thin.volume *= sides;
    return out;
  }

  /// A mesh that ends at calm water has nothing to float higher with: its hull ends there too.
  void setHull(OuterSurface& out, const SurfaceMesh& closed, const SurfaceMesh& wet) const {
    const double below = volumeIntegrals(wet).volume, whole = volumeIntegrals(closed).volume;
    const SurfaceMesh& hull = whole - below > kLeastReserve * below ? closed : wet;
    out.hull = {half_ ? bothHalves(hull) : hull, half_, false};
    out.hull.closed = openEdges(out.hull.surface).empty();
  }

  double knownOr(double found) const {
    return std::abs(known_ / found - 1) < kKnownOff ? known_ : found;
  }

  /// Of every other plane, unless that changes the volume.
  SurfaceMesh hullOf(const WaterGrid& water, double& volumeOff) const {
    SurfaceMesh fine = dualSurface(water, normals_, false).mesh;
    SurfaceMesh light =
        dualSurface(water.coarser(2, water.grid().count(2) - 1), normals_, false).mesh;
    const auto wetVolume = [](const SurfaceMesh& m) { return volumeIntegrals(cutBelow(m)).volume; };
    volumeOff = std::abs(wetVolume(light) / wetVolume(fine) - 1);
    return volumeOff < kLightOff ? light : fine;
  }

  void say(OuterSurface& s, int count) {
    s.done = done_;
    if (survey_.plateArea > kWorthSaying * survey_.area)
      s.done.push_back(
          fmt::format("left out plates that the water touches on both sides, {:.3g} m2, one at {}",
                      survey_.plateArea, placeText(survey_.platePlace)));
    for (const auto& [lost, what] :
         {std::pair(s.betweenPanels, "panels"), std::pair(s.thin, "hull")})
      if (lost.volume > kWorthSaying * s.volume)
        s.done.push_back(fmt::format(
            "left out of the {} parts too thin for so many panels, {:.3g} m3 ({:.2g} %), one at {}",
            what, lost.volume, 100 * lost.volume / s.volume, placeText(lost.place)));
    if (s.volumeOff > kGridsOff)
      s.done.push_back(
          fmt::format("two grids differ by {:.2g} % of the volume; its shape is finer "
                      "than they are",
                      100 * s.volumeOff));
    if (aSide(s) > (1 + 2 * kCloseEnough) * count)
      s.done.push_back(
          fmt::format("took {:.0f} panels a side instead of {}, for its volume", aSide(s), count));
  }

  const SurfaceMesh& mesh_;
  const WaterSurvey& survey_;
  const std::vector<std::string>& done_;
  Bounds box_;
  std::vector<Vec3> normals_;
  bool half_;
  double known_ = 0.0;
};

}  // namespace

OuterSurface outerSurface(const TightSurface& tight, int count, Symmetry symmetry,
                          double knownVolume) {
  return SurfacePanels(tight, symmetry).about(count, knownVolume);
}

double outerVolume(const TightSurface& tight) {
  const WaterSurvey& survey = tight.survey;
  const int top = survey.water.grid().count(2) - 1;
  return volumeIntegrals(dualSurface(survey.water, unitNormals(tight.mesh), true).mesh).volume +
         partsBetweenCrossings(survey.water, survey.crossings, top).volume;
}

}  // namespace cutwater
