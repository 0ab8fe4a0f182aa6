#include <algorithm>
#include <cmath>

#include "hydro/Errors.h"
#include "hydro/geometry/MeshCut.h"
#include "hydro/geometry/shapes/ShapeGrid.h"
#include "hydro/geometry/shapes/Shapes.h"
#include "hydro/geometry/shapes/Spacing.h"

namespace cutwater {
namespace {

constexpr double kLength = 124.5, kBreadth = 14.8, kDraft = 4.97;
constexpr double kFullest = 66.7959;       // s of the broadest waterline station
constexpr double kBowEnd = 6.225;          // s where the keel line reaches the draft
constexpr double kSternStart = 81.8271;    // s where the keel line begins to rise
constexpr double kDeckFullest = 64.74;     // s of the broadest deck station
constexpr double kStationCrowding = 0.42;  // stations closer together at the ends, spacedAtEnds
// Rows closer together towards calm water, spacedAtStart: the pressure of short waves goes as z ln
// z there, and half the depth of the uppermost panels halves the error of A(∞).
constexpr double kWaterlineCrowding = 0.6;

/// One transverse section; s [m] aft of the forward perpendicular.
///     below water  y = b (1 − ζⁿ), ζ = −z/d;      above  y = b + (b_d − b)(z/F)^1.6
struct Section {
  double b;          ///< half breadth at the waterline [m]
  double d;          ///< depth of the keel line [m]
  double n;          ///< fullness
  double deckB;      ///< half breadth of the deck b_d [m]
  double freeboard;  ///< F [m]
};

Section sectionAt(double s) {
  Section q{};
  const double fore = 1 - s / kFullest, aft = (s - kFullest) / (kLength - kFullest);
  const bool forward = s <= kFullest;
  q.b = 0.5 * kBreadth * (1 - (forward ? std::pow(fore, 1.55) : (1 - 0.6181) * std::pow(aft, 3.2)));
  q.n = 3.8175 + (forward ? (2.1 - 3.8175) * fore * fore : (1.9 - 3.8175) * aft * aft);
  q.d = kDraft;
  if (s < kBowEnd) q.d *= std::sqrt(1 - std::pow(1 - s / kBowEnd, 2));
  if (s > kSternStart) q.d *= 1 - std::pow((s - kSternStart) / (kLength - kSternStart), 1.45);
  q.deckB = 7.8 * (s <= kDeckFullest
                       ? 1 - std::pow(1 - s / kDeckFullest, 3.2)
                       : 1 - 0.2 * std::pow((s - kDeckFullest) / (kLength - kDeckFullest), 2));
  q.freeboard = 5.5 + 2.6 * std::pow(std::max(0.0, 1 - 2 * s / kLength), 2);
  return q;
}

/// Stern → bow as u = 0 → 1.
double aftOfBow(double u) { return kLength * (1 - u); }

Vec3 wetPoint(double u, double zeta) {
  const double s = aftOfBow(u);
  const Section q = sectionAt(s);
  return {0.5 * kLength - s, q.b * (1 - std::pow(zeta, q.n)), -q.d * zeta};
}

/// Point of the dry side at height fraction t = z/F.
Vec3 dryPoint(double u, double t) {
  const double s = aftOfBow(u);
  const Section q = sectionAt(s);
  const double z = t * q.freeboard, flare = std::pow(t, 1.6);
  const double rake = z * std::tan(35 * kPi / 180) * std::pow(1 - s / kLength, 6);
  return {0.5 * kLength - s + rake, q.b + (q.deckB - q.b) * flare, z};
}

}  // namespace

SurfaceMesh wetFrigate(int along, int girth, double crowding) {
  // The corner between waterline and transom.
  return withSplitWaterCorners(gridOfCurves(spacedAtEnds(along, kStationCrowding),
                                            spacedAtStart(girth, crowding), wetPoint));
}

SurfaceMesh closedFrigate(int along, int girth) {
  const std::vector<double> u = spacedAtEnds(along, kStationCrowding);
  // From the centreline outwards, to meet the wet sections at the transom.
  std::vector<double> across = spacedAtStart(girth, kWaterlineCrowding);
  std::reverse(across.begin(), across.end());
  for (double& v : across) v = 1 - v;
  const int up = std::max(2, (girth + 1) / 2);  // freeboard is about half of the wet girth
  const auto downwards = [](double v) { return v == 1.0 ? 0.0 : 1 - v; };
  SurfaceMesh dry =
      gridSurface(u, uniform(up), [&](double s, double v) { return dryPoint(s, downwards(v)); });
  dry = joined(dry, gridSurface(u, across, [](double s, double v) -> Vec3 {
                 const Vec3 edge = dryPoint(s, 1.0);
                 return {edge.x(), v * edge.y(), edge.z()};
               }));
  dry = joined(dry, gridSurface(uniform(up), across, [](double h, double v) -> Vec3 {
                 const Vec3 edge = dryPoint(0.0, h);
                 return {edge.x(), v * edge.y(), edge.z()};
               }));
  return closedFromHalves(wetFrigate(along, girth, kWaterlineCrowding), dry);
}

FrigateDivision frigateDivision(int panelsPerSide) {
  if (panelsPerSide < 8)
    throw HydroError(Fault::BadArgument,
                     "frigateDivision: " + std::to_string(panelsPerSide) + " panels a side");
  if (std::abs(panelsPerSide - 224) <= 2) return {32, 7};
  if (std::abs(panelsPerSide - 433) <= 2) return {48, 9};
  if (std::abs(panelsPerSide - 1040) <= 2) return {80, 13};
  // 124.5 m along, about 9.6 m girth: panels twice as long as wide.
  const int girth = std::max(1, static_cast<int>(std::lround(std::sqrt(panelsPerSide * 0.154))));
  return {std::max(1, static_cast<int>(std::lround(1.0 * panelsPerSide / girth))), girth};
}

}  // namespace cutwater
