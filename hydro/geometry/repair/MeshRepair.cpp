#include "hydro/geometry/repair/MeshRepair.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "hydro/Errors.h"
#include "hydro/geometry/HullShells.h"
#include "hydro/geometry/MeshCut.h"
#include "hydro/geometry/MeshEdges.h"
#include "hydro/geometry/MeshIntegrals.h"
#include "hydro/geometry/PlaceText.h"
#include "hydro/geometry/SurfacePatches.h"
#include "hydro/geometry/SurfaceTree.h"
#include "hydro/geometry/repair/CleanSurface.h"
#include "hydro/geometry/repair/CrackClosing.h"
#include "hydro/geometry/repair/HoleFilling.h"
#include "hydro/geometry/repair/OutsideShell.h"

namespace cutwater {
namespace {

constexpr double kOff = 2e-4;  // of the size: how near a mirror image must lie

class Repair {
 public:
  Repair(const CleanSurface& clean, std::string name, Symmetry symmetry)
      : name_(std::move(name)), symmetry_(symmetry), size_(clean.size), done_(clean.done) {
    checkInWater(bounds(clean.mesh), name_);
    dry_ = cutAbove(clean.mesh);
    wet_ = cutBelow(clean.mesh);
  }

  RepairedHull hull() {
    OutsideShell outside = outsideShell(wet_, name_);
    wet_ = withoutCracks(outside.mesh, 0.1 * kWeld * size_, outside.mesh.faces.size());
    done_.insert(done_.end(), outside.done.begin(), outside.done.end());
    closeHoles();
    if (firstOpen() >= 0) wet_ = agreeing(std::move(wet_), name_);
    check();
    return finished();
  }

 private:
  void say(std::string line) { done_.push_back(std::move(line)); }

  void closeHoles() {
    const Bounds box = bounds(wet_);
    const double widest = kWidestHole * (box.high.x() - box.low.x());
    std::size_t count = 0;
    FilledHole largest;
    for (const FilledHole& hole : fillHoles(wet_, widest, name_)) {
      if (hole.keel) {
        say(fmt::format("closed the keel line, a slit about {:.3g} m wide", 0.5 * hole.width));
        continue;
      }
      ++count;
      if (hole.width >= largest.width) largest = hole;
    }
    if (count > 0)
      say(fmt::format("closed {}, the widest of {:.3g} m at {}", counted(count, "hole"),
                      largest.width, placeText(largest.place)));
  }

  /// A vertex at an open edge other than on calm water, or −1.
  int firstOpen() const {
    const auto onWater = [&](int v) {
      return wet_.vertices[static_cast<std::size_t>(v)].z() == 0.0;
    };
    for (const OpenEdge& e : openEdges(wet_))
      if (!onWater(e.from) || !onWater(e.to)) return e.from;
    return -1;
  }

  void check() const {
    if (const int open = firstOpen(); open >= 0)
      throw HydroError(Fault::ShellsNotJoined,
                       name_ + ": hull cannot be closed below water at " +
                           placeText(wet_.vertices[static_cast<std::size_t>(open)]) +
                           ", where shells meet");
    if (!(waterplaneIntegrals(wet_).area > 0))
      throw HydroError(Fault::HullNotInWater, name_ + ": hull has no waterplane at z = 0");
  }

  bool isSymmetric() const {
    const VolumeIntegrals v = volumeIntegrals(wet_);
    if (std::abs(v.moment.y()) > 1e-3 * v.volume * bounds(wet_).high.y()) return false;
    return holdsMirrorImages(SurfaceTree(wet_), wet_.vertices, kOff * size_);
  }

  /// Wet and dry part together, the dry part's faces turned to agree with the wet.
  RepairedHull finished() {
    RepairedHull result;
    result.hull.symmetric = symmetry_ != Symmetry::None && isSymmetric();
    if (result.hull.symmetric)
      for (SurfaceMesh* part : {&wet_, &dry_})
        *part = snapped(std::move(*part), 1, 0.1 * kWeld * size_);
    const int below = static_cast<int>(wet_.faces.size());
    SurfaceMesh all = welded(joined(wet_, dry_), 0.0);
    try {
      for (const SurfacePatch& patch : surfacePatches(all, name_)) {
        // The patch begins with its first face, one of the wet ones if it has any.
        if (patch.faces[0] >= below) continue;
        for (std::size_t i = 0; i < patch.faces.size(); ++i) {
          Face& f = all.faces[static_cast<std::size_t>(patch.faces[i])];
          if (patch.faces[i] >= below && patch.turned[i])
            std::reverse(f.v.begin(), f.v.begin() + f.size());
        }
      }
    } catch (const HydroError&) {
      // One-sided above water: it stays as it is, and the hull open.
    }
    result.hull.surface = std::move(all);
    result.hull.closed = openEdges(result.hull.surface).empty();
    result.done = std::move(done_);
    return result;
  }

  std::string name_;
  Symmetry symmetry_;
  double size_;
  std::vector<std::string> done_;
  SurfaceMesh dry_, wet_;
};

}  // namespace

RepairedHull repairedHull(const SurfaceMesh& raw, const std::string& name, Symmetry symmetry) {
  return repairedHull(cleanSurface(raw, name, symmetry), name, symmetry);
}

RepairedHull repairedHull(const CleanSurface& clean, const std::string& name, Symmetry symmetry) {
  return Repair(clean, name, symmetry).hull();
}

}  // namespace cutwater
