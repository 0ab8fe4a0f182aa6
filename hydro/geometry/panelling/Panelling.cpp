#include "hydro/geometry/panelling/Panelling.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "hydro/Errors.h"
#include "hydro/geometry/HullShells.h"
#include "hydro/geometry/MeshCut.h"
#include "hydro/geometry/MeshEdges.h"
#include "hydro/geometry/MeshIntegrals.h"
#include "hydro/geometry/PlaceText.h"
#include "hydro/geometry/panelling/PanelQuality.h"
#include "hydro/geometry/panelling/SectionPanels.h"
#include "hydro/geometry/panelling/StationField.h"

namespace cutwater {
namespace {

// Mean panel edges along and across the sections: longer where there would be fewer than
// kEnoughRows from calm water to the keel, as it is across that hulls are curved. The uppermost row
// is so much narrower that its panels are 2.4 times as long as deep amidships.
constexpr double kLeastRatio = 1.2, kUsualRatio = 1.6, kEnoughRows = 10.0, kUppermostRatio = 2.4;
// Longer still, step by step, where too much volume is lacking: as a fraction, times the panels a
// side. They may be kLongest times as long as deep; crowding towards calm water and the ends makes
// room.
constexpr double kMostRatio = 2.4, kLonger = 1.06, kMostLacking = 0.0045 * 1040, kLongest = 2.7;
// Shorter again where panels crowd at corners and too many would be stretched.
constexpr double kShortestRatio = 1.0;
constexpr double kLeastWaterCrowding = 0.05, kLeastEndCrowding = 0.1, kMostEndCrowding = 0.2;
constexpr double kMostStretched = 0.045;
constexpr int kTries = 12;    // to meet the count
constexpr int kMostGaps = 4;  // tries that end with a gap
constexpr double kMostExcess = 0.02;
constexpr double kCloseEnough = 0.01, kFarOff = 0.05;  // of the count

SurfaceMesh withoutSlivers(const SurfaceMesh& mesh) {
  SurfaceMesh out{mesh.vertices, {}};
  for (const Face& f : mesh.faces) {
    double size2 = 0.0;
    for (int i = 0; i < f.size(); ++i)
      size2 =
          std::max(size2, (mesh.corner(f, i) - mesh.corner(f, (i + 1) % f.size())).squaredNorm());
    if (vectorArea(mesh, f).norm() > 1e-6 * size2) out.faces.push_back(f);
  }
  return out;
}

class HullPanels {
 public:
  HullPanels(const Hull& hull, const std::string& name)
      : wet_(wetSurface(hull)),
        name_(name),
        symmetric_(hull.symmetric),
        area_(surfaceArea(wet_)),
        volume_(volumeIntegrals(wet_).volume) {}

  /// Panels longer and longer as long as the volume needs more rows, or there are gaps.
  SurfaceMesh about(int count) {
    const double wanted = symmetric_ ? count : 2.0 * count;
    double girthwise = std::sqrt(area_ / (wanted * kLeastRatio));
    cutter_.emplace(wet_, stationField(wet_, 4 * girthwise * girthwise));
    strands_ = sectionStrands(*cutter_, 0.25 * girthwise);
    ratio_ = lengthPerGirth(girthwise);
    girthwise *= std::sqrt(kLeastRatio / ratio_);
    SurfaceMesh best = nearest(wanted, girthwise);
    if (stretchedShare(best) > kMostStretched && !gapIn(best)) relieve(best, wanted, girthwise);
    int gaps = 0;  // where sections do not match, longer panels help at once or not at all
    while (ratio_ < kMostRatio && gaps < kMostGaps &&
           (lacking(best) > kMostLacking || gapIn(best))) {
      ratio_ *= kLonger;
      girthwise /= std::sqrt(kLonger);
      SurfaceMesh longer = nearest(wanted, girthwise);
      if (gapIn(longer)) {
        ++gaps;
        continue;
      }
      if (!gapIn(best) && lacking(longer) > lacking(best)) break;
      if (gapIn(best) || stretchedShare(longer) < kMostStretched) best = std::move(longer);
    }
    checkClosed(best);
    checkFollowed(best);
    return best;
  }

 private:
  /// Where corners alone make panels stretched: shorter and shorter ones, then less crowding.
  void relieve(SurfaceMesh& best, double wanted, double& girthwise) {
    corners_ = 0.0;
    const SurfaceMesh plain = nearest(wanted, girthwise);
    const bool ofCorners = stretchedShare(plain) <= kMostStretched;
    corners_ = 1.0;
    while (ofCorners && stretchedShare(best) > kMostStretched && corners_ > 0.1) {
      if (ratio_ > kShortestRatio) {
        ratio_ /= kLonger;
        girthwise *= std::sqrt(kLonger);
      } else {
        corners_ *= 0.7;
      }
      SurfaceMesh next = nearest(wanted, girthwise);
      const double off = static_cast<double>(next.faces.size()) / wanted - 1;
      const bool good = !gapIn(next) && std::abs(off) < kFarOff;
      if (good && stretchedShare(next) < stretchedShare(best)) best = std::move(next);
    }
  }

  /// Volume, as if that went with the number of panels exactly.
  double lacking(const SurfaceMesh& panels) const {
    const double aSide = static_cast<double>(panels.faces.size()) / (symmetric_ ? 1 : 2);
    return aSide * (1 - volumeIntegrals(panels).volume / volume_);
  }

  /// The division whose number of panels is nearest to the one wanted, of a few tries.
  SurfaceMesh nearest(double wanted, double girthwise) const {
    SurfaceMesh best;
    double least = 1e300, few = 0.0, many = 0.0;  // sizes that gave too few panels, and too many
    for (int i = 0; i < kTries && least > kCloseEnough; ++i) {
      SurfaceMesh now = with(girthwise);
      const double ratio = static_cast<double>(now.faces.size()) / wanted;
      if (std::abs(ratio - 1) < least) {
        least = std::abs(ratio - 1);
        best = std::move(now);
      }
      if (ratio < 1) {
        few = girthwise;
      } else {
        many = girthwise;
      }
      girthwise = few > 0 && many > 0 ? std::sqrt(few * many)
                                      : girthwise * std::pow(std::max(ratio, 0.1), 0.5);
    }
    return best;
  }

  SurfaceMesh with(double girthwise) const {
    SurfaceMesh all;
    for (const SectionStrand& strand : strands_)
      all = joined(all, panelsOn(strand, *cutter_, sizeOf(girthwise)));
    // An end that runs along calm water or along the centreline may be off by the roughness of the
    // mesh, and the tip of a waterline lies a little above where the stem's section begins.
    all = snapped(std::move(all), 2, 0.02 * girthwise);
    if (symmetric_) all = snapped(std::move(all), 1, 0.02 * girthwise);
    all = welded(all, 1e-3 * girthwise);
    return welded(withoutSlivers(withSplitWaterCorners(all)), 0.0);
  }

  PanelSize sizeOf(double girthwise) const {
    const double water = std::max(kLeastWaterCrowding, 1 - 1.2 * ratio_ / kUppermostRatio);
    const double ends = kLongest * (1 - water) / ratio_ - 1;
    return {girthwise, ratio_ * girthwise, water,
            std::clamp(ends, kLeastEndCrowding, kMostEndCrowding), corners_};
  }

  double lengthPerGirth(double girthwise) const {
    double girth = 0.0;  // from calm water to the keel
    for (const SectionStrand& strand : strands_)
      for (const SectionCurve& c : strand.curves)
        girth = std::max(girth, c.points.back().z() == 0.0 ? 0.5 * c.length() : c.length());
    const double missing = kEnoughRows * girthwise / girth;
    return std::clamp(kLeastRatio * missing * missing, kLeastRatio, kUsualRatio);
  }

  /// Where an edge of one panel only lies neither on calm water nor on the centreline.
  std::optional<Vec3> gapIn(const SurfaceMesh& panels) const {
    for (const OpenEdge& e : looseEdges(panels)) {
      const Vec3 &p = panels.vertices[static_cast<std::size_t>(e.from)],
                 &q = panels.vertices[static_cast<std::size_t>(e.to)];
      const bool onWater = p.z() == 0.0 && q.z() == 0.0;
      const bool onCentreline = symmetric_ && p.y() == 0.0 && q.y() == 0.0;
      if (!onWater && !onCentreline) return p;
    }
    return {};
  }

  void checkClosed(const SurfaceMesh& panels) const {
    if (panels.faces.empty())
      throw HydroError(Fault::SectionsNotFollowed, name_ + ": no section to put panels on");
    if (const std::optional<Vec3> gap = gapIn(panels))
      throw HydroError(Fault::SectionsNotFollowed,
                       name_ + ": the sections of the hull split or jump at " + placeText(*gap) +
                           ", where no panels can be laid; use panels = \"as-is\"");
  }

  /// Inscribed panels have less area than the hull; where rows cross, they have more.
  void checkFollowed(const SurfaceMesh& panels) const {
    const double excess = surfaceArea(panels) / area_ - 1;
    if (excess <= kMostExcess) return;
    throw HydroError(
        Fault::SectionsNotFollowed,
        name_ + ": panels would have " + std::to_string(std::lround(100 * excess)) +
            " % more area than the hull, whose sections cannot be followed (appendages?); "
            "use panels = \"as-is\"");
  }

  SurfaceMesh wet_;
  std::string name_;
  bool symmetric_;
  std::optional<SectionCutter> cutter_;
  double area_, volume_, ratio_ = kLeastRatio, corners_ = 1.0;
  std::vector<SectionStrand> strands_;
};

}  // namespace

SurfaceMesh panelled(const Hull& hull, int count, const std::string& name) {
  if (count < kFewestPanels || count > kMostPanels)
    throw HydroError(Fault::ValueOutOfRange, name + ": panels = " + std::to_string(count) +
                                                 " must be in " + std::to_string(kFewestPanels) +
                                                 " to " + std::to_string(kMostPanels));
  return HullPanels(hull, name).about(count);
}

}  // namespace cutwater
