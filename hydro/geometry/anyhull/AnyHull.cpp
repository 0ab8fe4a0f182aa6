#include "hydro/geometry/anyhull/AnyHull.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "hydro/Errors.h"
#include "hydro/geometry/MeshIntegrals.h"
#include "hydro/geometry/outer/SurfacePanels.h"
#include "hydro/geometry/panelling/PanelQuality.h"
#include "hydro/geometry/panelling/Panelling.h"
#include "hydro/geometry/repair/MeshRepair.h"

namespace cutwater {
namespace {

// What a repaired hull may differ from the volume that water is kept out of: twice what two grids
// differ by.
constexpr double kHullOff = 0.004;
// What panels may differ from it: 1 % at 433 a side, which inscribed ones go beyond with fewer, and
// 0.5 % from 860 on.
constexpr double kLacking = 4.3, kLeastLacking = 0.005;

double volumeOf(const SurfaceMesh& wet) { return volumeIntegrals(wet).volume; }

constexpr double kMostStretched = 0.15;  // of the panels; of ships 0 to 5 % are
constexpr std::size_t kMostLines = 3;    // with what the command itself says, five

/// The first lines together in one, if there are too many.
std::vector<std::string> condensed(std::vector<std::string> lines) {
  while (lines.size() > kMostLines) {
    lines[0] += "; " + lines[1];
    lines.erase(lines.begin() + 1);
  }
  return lines;
}

class AnyHullMaking {
 public:
  AnyHullMaking(const CleanSurface& clean, int count, const std::string& name, Symmetry symmetry)
      : clean_(clean), count_(count), name_(name), symmetry_(symmetry) {}

  AnyHull bySections() {
    repaired_ = repairedHull(clean_, name_, symmetry_);
    AnyHull made;
    made.panels = panelled(repaired_->hull, count_, name_);
    made.by = PanelsBy::Sections;
    made.volume = volumeOf(wholeWetSurface(repaired_->hull));
    made.panelVolume = (repaired_->hull.symmetric ? 2 : 1) * volumeOf(made.panels);
    made.hull = repaired_->hull;
    made.done = repaired_->done;
    if (!made.hull.closed) close(made);
    return made;
  }

  /// A repaired hull of that volume is the better hull: it has the faces that were drawn.
  AnyHull bySurface() {
    const double drawnVolume = repaired_ ? volumeOf(wholeWetSurface(repaired_->hull)) : 0.0;
    OuterSurface outer = outerSurface(tight(), count_, symmetry_, drawnVolume);
    AnyHull made;
    made.panels = std::move(outer.panels);
    made.by = PanelsBy::Surface;
    made.volume = outer.volume;
    made.panelVolume = outer.panelVolume;
    const bool drawn = repaired_ && repaired_->hull.symmetric == outer.hull.symmetric &&
                       repaired_->hull.closed && isNear(drawnVolume, outer.volume);
    made.hull = drawn ? std::move(repaired_->hull) : std::move(outer.hull);
    made.done = drawn ? repaired_->done : clean_.done;
    made.done.insert(made.done.end(), outer.done.begin(), outer.done.end());
    return made;
  }

  AnyHull either() {
    std::string why;
    try {
      AnyHull made = bySections();
      if (follows(made, outerVolume(tight()), why)) return made;
    } catch (const HydroError& error) {
      why = error.what();
      if (why.starts_with(name_ + ": ")) why.erase(0, name_.size() + 2);
      why.erase(std::min(why.find("; use panels"), why.size()));
    }
    AnyHull made = bySurface();
    made.done.push_back("laid panels over the surface; by sections, " + why);
    return made;
  }

 private:
  /// The surface that the water flows around; found once.
  const TightSurface& tight() {
    if (!tight_) tight_ = withoutLeaks(clean_.mesh, name_);
    return *tight_;
  }

  /// A hull that is open above water as a bowl that is filled, if there is enough of it.
  void close(AnyHull& made) {
    OuterSurface outer = outerSurface(tight(), count_, symmetry_, made.volume);
    if (!outer.hull.closed || outer.hull.symmetric != made.hull.symmetric ||
        !isNear(made.volume, outer.volume))
      return;
    made.hull = std::move(outer.hull);
    made.done.push_back(fmt::format("closed the hull above water, up to {:.3g} m",
                                    bounds(made.hull.surface).high.z()));
  }

  static bool isNear(double hull, double outer) { return std::abs(hull / outer - 1) <= kHullOff; }

  bool follows(const AnyHull& made, double outer, std::string& why) const {
    if (!isNear(made.volume, outer)) {
      why = fmt::format("the hull would have {:.6g} m3 instead of {:.6g} m3", made.volume, outer);
      return false;
    }
    if (std::abs(made.panelVolume / outer - 1) > std::max(kLeastLacking, kLacking / count_)) {
      why =
          fmt::format("panels would have {:.6g} m3 instead of {:.6g} m3", made.panelVolume, outer);
      return false;
    }
    if (const double stretched = stretchedShare(made.panels); stretched > kMostStretched) {
      why = fmt::format("{:.0f} % of the panels would be more than 3 times as long as wide",
                        100 * stretched);
      return false;
    }
    return true;
  }

  const CleanSurface& clean_;
  int count_;
  const std::string& name_;
  Symmetry symmetry_;
  std::optional<RepairedHull> repaired_;
  std::optional<TightSurface> tight_;
};

}  // namespace

AnyHull anyHull(const SurfaceMesh& raw, int count, const std::string& name, Symmetry symmetry,
                PanelsBy by) {
  if (count < kFewestPanels || count > kMostPanels)
    throw HydroError(Fault::ValueOutOfRange, fmt::format("{}: panels = {} must be in {} to {}",
                                                         name, count, kFewestPanels, kMostPanels));
  const CleanSurface clean = cleanSurface(raw, name, symmetry);
  AnyHullMaking making(clean, count, name, symmetry);
  AnyHull made = by == PanelsBy::Sections  ? making.bySections()
                 : by == PanelsBy::Surface ? making.bySurface()
                                           : making.either();
  made.done = condensed(std::move(made.done));
  return made;
}

}  // namespace cutwater
