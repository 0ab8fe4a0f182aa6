#include "hydro/geometry/outer/SurfacePanels.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "hydro/Errors.h"
#include "hydro/geometry/MeshCut.h"
#include "hydro/geometry/MeshIntegrals.h"
#include "hydro/geometry/PlaceText.h"
#include "hydro/geometry/outer/DualSurface.h"
#include "hydro/geometry/outer/SurfaceFitting.h"
#include "hydro/geometry/outer/WaterSurvey.h"

namespace cutwater {
namespace {

constexpr int kFine = 8;              // planes of the fine grid in one length of the panels
constexpr std::size_t kMostNodes = 40000000;   // of the fine grid
constexpr double kOpenTolerance = 1e-3;  // of the length: slits of twice that hold water back
constexpr double kMirrorTolerance = 2e-4;  // of the size
constexpr double kShortest = 0.3;     // of the panels' length: shorter edges are merged
constexpr int kRounds = 8;            // of smoothing
constexpr double kMostMove = 0.03;    // of the panels' length
constexpr int kTries = 6;
constexpr double kCloseEnough = 0.05;

std::vector<Vec3> unitNormals(const SurfaceMesh& triangles) {
  std::vector<Vec3> normals;
  for (const Face& f : triangles.faces) normals.push_back(vectorArea(triangles, f).normalized());
  return normals;
}

class SurfacePanels {
 public:
  SurfacePanels(SurfaceMesh triangles, std::string name, Symmetry symmetry)
      : mesh_(std::move(triangles)),
        name_(std::move(name)),
        box_(bounds(mesh_)),
        normals_(unitNormals(mesh_)),
        survey_(surveyWater(mesh_, openTolerance(), kMirrorTolerance * box_.diagonal())) {
    half_ = symmetry != Symmetry::None && survey_.symmetric;
  }

  OuterSurface about(int count) {
    const double wanted = half_ ? count : 2.0 * count;
    double length = std::sqrt(1.2 * survey_.area / (2.0 * count));
    for (int i = 0; i < kTries; ++i) {
      const double n = static_cast<double>(coarse(length, 2).mesh.faces.size());
      if (std::abs(n / wanted - 1) < kCloseEnough) break;
      length *= std::sqrt(std::clamp(n / wanted, 0.3, 3.0));
    }
    return made(length);
  }

 private:
  double openTolerance() const { return kOpenTolerance * (box_.high.x() - box_.low.x()); }

  SpaceGrid::Planes planes(double length) const {
    GridPlan plan{box_, length, half_, {}};
    plan.extra = planesOfThinParts(survey_.water, survey_.crossings, length, half_);
    return coarsePlanes(plan);
  }

  WaterGrid flooded(const FinePlanes& fine) const {
    const SpaceGrid grid(fine.planes);
    return {grid, GridCrossings(mesh_, grid, openTolerance()), half_};
  }

  DualSurface panelsOf(const WaterGrid& fineWater, int step, int top, double length) const {
    DualSurface s = dualSurface(fineWater.coarser(step, top), normals_, true);
    mergeShortEdges(s, kShortest * length);
    mergeShortEdges(s, kShortest * length);
    return s;
  }

  DualSurface coarse(double length, int step) const {
    const FinePlanes fine = finePlanes(planes(length), step, survey_.wet.high.z());
    return panelsOf(flooded(fine), step, fine.top, length);
  }

  OuterSurface made(double length) const {
    const SpaceGrid::Planes coarsePlanes = planes(length);
    int step = kFine;
    FinePlanes fine = finePlanes(coarsePlanes, step, box_.high.z());
    while (step > 2 && SpaceGrid(fine.planes).nodes() > kMostNodes)
      fine = finePlanes(coarsePlanes, --step, box_.high.z());
    const WaterGrid water = flooded(fine);
    const DualSurface hull = dualSurface(water, normals_, false);
    OuterSurface out;
    const SurfaceMesh wet = cutBelow(hull.mesh);
    out.volume = (half_ ? 2 : 1) * volumeIntegrals(wet).volume;
    out.hull.surface = half_ ? bothHalves(hull.mesh) : hull.mesh;
    out.hull.symmetric = half_;
    out.hull.closed = openEdges(out.hull.surface).empty();
    DualSurface panels = panelsOf(water, step, fine.top, length);
    smooth(panels, SurfaceTree(wet), kRounds);
    fillOut(panels, out.volume / (half_ ? 2 : 1), kMostMove * length);
    out.panels = withSplitWaterCorners(panels.mesh);
    out.panelVolume = (half_ ? 2 : 1) * volumeIntegrals(out.panels).volume;
    return out;
  }

  SurfaceMesh mesh_;
  std::string name_;
  Bounds box_;
  std::vector<Vec3> normals_;
  WaterSurvey survey_;
  bool half_ = false;
};

}  // namespace

OuterSurface outerSurface(const SurfaceMesh& raw, int count, const std::string& name,
                          Symmetry symmetry) {
  return SurfacePanels(triangulated(welded(raw, 0.0)), name, symmetry).about(count);
}

}  // namespace cutwater
