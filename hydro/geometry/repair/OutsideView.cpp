#include "hydro/geometry/repair/OutsideView.h"

#include <algorithm>
#include <cmath>

namespace cutwater {
namespace {

constexpr int kRays = 48, kManyRays = 400;  // over the whole sphere
constexpr std::size_t kFew = 8;             // faces of a patch for which many rays are asked
constexpr int kSideways = 8;                // rays along calm water
constexpr std::size_t kFaces = 200;         // examined in one patch
constexpr int kNoFace = -1;                 // at calm water a ray may meet the face it left
constexpr double kGrazing = 0.1;            // a ray nearer to the face's plane says little

/// Directions spread evenly over the sphere, by the golden angle.
Vec3 direction(int i, int rays) {
  const double z = 1 - (2 * i + 1.0) / rays, r = std::sqrt(1 - z * z);
  const double angle = i * kPi * (3 - std::sqrt(5.0));
  return {r * std::cos(angle), r * std::sin(angle), z};
}

}  // namespace

OutsideView::OutsideView(const SurfaceMesh& wet)
    : wet_(wet), tree_(wet), reach_(2 * bounds(wet).diagonal()) {}

double OutsideView::seen(const Vec3& from, const Vec3& direction, int face) const {
  if (direction.z() <= 0) return tree_.meets(from, direction, face, reach_) ? 0.0 : 1.0;
  const double toWater = (-from.z() - 1e-7 * reach_) / direction.z();
  if (toWater > 0 && tree_.meets(from, direction, face, toWater)) return 0.0;
  const Vec3 surface = from + std::max(toWater, 0.0) * direction;
  double free = 0.0;
  for (int i = 0; i < kSideways; ++i) {
    const double angle = 2 * kPi * (i + 0.37) / kSideways;
    const Vec3 sideways(std::cos(angle), std::sin(angle), 0.0);
    if (!tree_.meets(surface, sideways, kNoFace, reach_)) free += 1.0 / kSideways;
  }
  return free;
}

double OutsideView::share(const Vec3& from, const Vec3& normal, int face, int rays) const {
  double sum = 0.0;
  int asked = 0;
  for (int i = 0; i < rays; ++i) {
    const Vec3 d = direction(i, rays);
    if (normal.dot(d) < kGrazing) continue;
    sum += seen(from, d, face);
    ++asked;
  }
  return sum / std::max(1, asked);
}

OutsideView::Shares OutsideView::of(int face, int rays) const {
  const Face& f = wet_.faces[static_cast<std::size_t>(face)];
  const Vec3 centre = meanCorner(wet_, f);
  const Vec3 normal = vectorArea(wet_, f).normalized();
  const double off = 1e-7 * reach_;
  return {share(centre + off * normal, normal, face, rays),
          share(centre - off * normal, -normal, face, rays)};
}

OutsideView::PatchView OutsideView::of(const SurfacePatch& patch) const {
  // Every so many square metres one face.
  std::vector<double> area{0.0};
  for (const int f : patch.faces)
    area.push_back(area.back() + vectorArea(wet_, wet_.faces[static_cast<std::size_t>(f)]).norm());
  const std::size_t count = std::min(kFaces, patch.faces.size());
  const int rays = patch.faces.size() <= kFew ? kManyRays : kRays;
  PatchView view;
  for (std::size_t i = 0; i < count; ++i) {
    const double target = area.back() * (static_cast<double>(i) + 0.5) / static_cast<double>(count);
    const auto k = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(
        std::lower_bound(area.begin(), area.end(), target) - area.begin() - 1, 0,
        std::ssize(patch.faces) - 1));
    Shares one = of(patch.faces[k], rays);
    if (patch.turned[k]) std::swap(one.normal, one.other);
    view.shares.normal += one.normal / static_cast<double>(count);
    view.shares.other += one.other / static_cast<double>(count);
    if (one.normal + one.other > 0.0) continue;
    view.hiddenArea += 1.0 / static_cast<double>(count);
    if (view.hiddenFace < 0) view.hiddenFace = patch.faces[k];
  }
  return view;
}

}  // namespace cutwater
