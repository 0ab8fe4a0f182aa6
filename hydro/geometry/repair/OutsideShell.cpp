#include "hydro/geometry/repair/OutsideShell.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <limits>

#include "hydro/Errors.h"
#include "hydro/base/ParallelFor.h"
#include "hydro/geometry/PlaceText.h"
#include "hydro/geometry/repair/CrackClosing.h"
#include "hydro/geometry/repair/OutsideView.h"
#include "hydro/geometry/repair/ShellSplit.h"

namespace cutwater {
namespace {

constexpr double kSeen = 0.1;  // share of rays: less comes through holes
constexpr double kSeenCorner =
    0.003;                         // of a small patch, which may lie in a narrow corner: one ray
constexpr std::size_t kSmall = 8;  // faces
constexpr double kPlate = 0.3;     // a side seen this much of the other is no inside
constexpr double kHidden = 0.03;   // of a patch's area that may be hidden in folds

struct SeenPatch {
  SurfacePatch patch;
  OutsideView::PatchView view;
  bool afterSplit = false;
  bool isInside() const {
    return std::max(view.shares.normal, view.shares.other) <
           (afterSplit && patch.faces.size() <= kSmall ? kSeenCorner : kSeen);
  }
  bool isPlate() const {
    const auto [least, most] = std::minmax(view.shares.normal, view.shares.other);
    return least > kPlate * most;
  }
  bool isPartlyHidden() const { return !isInside() && !isPlate() && view.hiddenArea > kHidden; }
};

class ShellFinder {
 public:
  ShellFinder(const SurfaceMesh& wet, std::string name) : name_(std::move(name)), wet_(wet) {}

  OutsideShell find() {
    look();
    if (firstHidden() != nullptr) {
      SplitSurface split = splitWhereCrossing(wet_);
      if (split.gaveUp)
        throw HydroError(Fault::ShellsNotJoined,
                         name_ + ": too many shells pass through one another, first at " +
                             placeText(split.first));
      if (split.split > 0) {
        say(fmt::format("joined shells that pass through one another, split {}, the first at {}",
                        counted(split.split, "face"), placeText(split.first)));
        wet_ = std::move(split.mesh);
        split_ = true;
        firstCut_ = split.firstCut;
        look();
      }
    }
    refuseHidden();
    keep();
    return std::move(out_);
  }

 private:
  void say(std::string line) { out_.done.push_back(std::move(line)); }
  const Vec3& placeOf(int face) const {
    return wet_.corner(wet_.faces[static_cast<std::size_t>(face)], 0);
  }

  void look() {
    const OutsideView view(wet_);
    std::vector<SurfacePatch> patches = surfacePatches(wet_, name_, firstCut_);
    patches_.assign(patches.size(), {});
    parallelFor(patches.size(), 0, [&](std::size_t i) {
      const OutsideView::PatchView seen = view.of(patches[i]);
      patches_[i] = {std::move(patches[i]), seen, split_};
    });
  }

  const SeenPatch* firstHidden() const {
    const auto hidden = std::find_if(patches_.begin(), patches_.end(),
                                     [](const SeenPatch& p) { return p.isPartlyHidden(); });
    return hidden == patches_.end() ? nullptr : &*hidden;
  }

  void refuseHidden() const {
    const SeenPatch* hidden = firstHidden();
    if (hidden == nullptr) return;
    throw HydroError(
        Fault::HullPartHidden,
        fmt::format("{}: {:.0f} % of a shell is hidden from the water by another below "
                    "water, first at {}; give the outer surface alone",
                    name_, 100 * hidden->view.hiddenArea,
                    placeText(placeOf(hidden->view.hiddenFace))));
  }

  void keep() {
    SurfaceMesh kept{wet_.vertices, {}};
    std::size_t turned = 0;
    for (const SeenPatch& seen : patches_) {
      if (seen.isInside() || seen.isPlate()) continue;
      const bool back = seen.view.shares.other > seen.view.shares.normal;
      for (std::size_t i = 0; i < seen.patch.faces.size(); ++i) {
        Face f = wet_.faces[static_cast<std::size_t>(seen.patch.faces[i])];
        const bool turn = seen.patch.turned[i] != back;
        if (turn) std::reverse(f.v.begin(), f.v.begin() + f.size());
        turned += turn ? 1 : 0;
        kept.faces.push_back(f);
      }
    }
    reportLeft("inside the hull (decks, bulkheads, inner shells)", &SeenPatch::isInside);
    reportLeft("of plates that the water touches on both sides",
               [](const SeenPatch& p) { return !p.isInside() && p.isPlate(); });
    if (turned > 0) say(fmt::format("turned {} outwards", counted(turned, "face")));
    if (kept.faces.empty())
      throw HydroError(Fault::HullNotClosed,
                       name_ + ": no face below water has an inside; the hull is open, at " +
                           placeText(placeOf(0)));
    out_.mesh = welded(kept, split_ ? together() : 0.0);
    if (split_) out_.mesh = agreeing(withoutCracks(out_.mesh, together(), 0), name_);
  }

  double together() const { return kTogether * bounds(wet_).diagonal(); }

  template <class Test>
  void reportLeft(const std::string& what, Test isLeft) {
    std::size_t faces = 0, count = 0;
    int first = -1;
    for (const SeenPatch& seen : patches_) {
      if (!std::invoke(isLeft, seen)) continue;
      faces += seen.patch.faces.size();
      ++count;
      if (first < 0) first = seen.patch.faces[0];
    }
    if (faces > 0)
      say(fmt::format("left out {} in {} {}, the first at {}", counted(faces, "face"),
                      counted(count, "piece"), what, placeText(placeOf(first))));
  }

  std::string name_;
  SurfaceMesh wet_;
  bool split_ = false;
  int firstCut_ = std::numeric_limits<int>::max();
  std::vector<SeenPatch> patches_;
  OutsideShell out_;
};

}  // namespace

OutsideShell outsideShell(const SurfaceMesh& wet, const std::string& name) {
  return ShellFinder(wet, name).find();
}

}  // namespace cutwater
