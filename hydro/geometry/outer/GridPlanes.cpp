#include "hydro/geometry/outer/GridPlanes.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace cutwater {
namespace {

// Off round numbers, in lengths; another one for each use.
constexpr double kOff = 1e-5, kOffX = 0.37 * kOff, kOffY = 0.53 * kOff, kOffZ = 0.29 * kOff,
                 kOffWater = 0.41 * kOff, kOffCentre = 0.23 * kOff;
// The first planes below calm water, in lengths: rows of panels 0.6, 0.8, 1, 1 ... high.
constexpr double kBelowWater[] = {0.3, 0.9, 1.9};
// Of planes nearer to a thin part's than this many lengths there is no need.
constexpr double kNear = 0.55;
constexpr double kMargin = 1.4;  // lengths beyond the body

void insert(std::vector<double>& planes, double extra, double length, int keepFirst, int keepLast) {
  std::vector<double> kept;
  const int n = static_cast<int>(planes.size());
  for (int i = 0; i < n; ++i) {
    const double p = planes[static_cast<std::size_t>(i)];
    if (i < keepFirst || i >= n - keepLast || std::abs(p - extra) > kNear * length)
      kept.push_back(p);
  }
  kept.insert(std::lower_bound(kept.begin(), kept.end(), extra), extra);
  planes = std::move(kept);
}

/// Planes about the middle, alike on both sides.
std::vector<double> about(double middle, double halfWidth, double length, double off) {
  std::vector<double> planes;
  const int n = static_cast<int>(std::ceil(halfWidth / length + kMargin));
  for (int i = -n; i < n; ++i) planes.push_back(middle + (i + 0.5) * length + (i < 0 ? -off : off));
  return planes;
}

struct Run {
  double middle, length, area;
};

/// The runs between neighbouring crossings of one line that are thin, with water on both sides.
std::vector<Run> thinRuns(const WaterGrid& water, const GridCrossings& crossings, int axis,
                          double longest) {
  const SpaceGrid& grid = water.grid();
  std::vector<GridCrossing> list = crossings.along(axis);
  const auto lineOf = [&](const GridCrossing& c) {
    return c.node - static_cast<std::size_t>(grid.index(c.node)[static_cast<std::size_t>(axis)]) *
                        grid.stride(axis);
  };
  std::stable_sort(list.begin(), list.end(), [&](const GridCrossing& l, const GridCrossing& r) {
    const std::size_t a = lineOf(l), b = lineOf(r);
    return a != b ? a < b : l.at < r.at;
  });
  std::vector<Run> runs;
  for (std::size_t i = 0; i + 1 < list.size(); ++i) {
    const GridCrossing &in = list[i], &out = list[i + 1];
    const double length = out.at - in.at;
    if (length > longest || length < 1e-3 * longest || lineOf(in) != lineOf(out)) continue;
    if (!water.wet(in.node) || !water.wet(out.node + grid.stride(axis))) continue;
    const SpaceGrid::Index at = grid.index(in.node);
    const double area = grid.width((axis + 1) % 3, at[static_cast<std::size_t>((axis + 1) % 3)]) *
                        grid.width((axis + 2) % 3, at[static_cast<std::size_t>((axis + 2) % 3)]);
    runs.push_back({0.5 * (in.at + out.at), length, area});
  }
  return runs;
}

/// The middle of the window with most of the runs' area, and that area.
std::pair<Run, double> densest(const std::vector<Run>& runs, double window) {
  double most = 0.0, sum = 0.0;
  std::size_t first = 0, bestFirst = 0, bestLast = 0;
  for (std::size_t last = 0; last < runs.size(); ++last) {
    sum += runs[last].area;
    while (runs[last].middle - runs[first].middle > window) sum -= runs[first++].area;
    if (sum <= most) continue;
    most = sum;
    bestFirst = first;
    bestLast = last;
  }
  return {runs.empty() ? Run{} : runs[(bestFirst + bestLast) / 2], most};
}

}  // namespace

SpaceGrid::Planes coarsePlanes(const GridPlan& plan) {
  const double h = plan.length;
  const Bounds& box = plan.body;
  SpaceGrid::Planes planes;
  planes[0] = about(0.5 * (box.low.x() + box.high.x()), 0.5 * (box.high.x() - box.low.x()), h, 0.0);
  for (double& x : planes[0]) x += kOffX * h;
  const double side = std::max(std::abs(box.low.y()), std::abs(box.high.y()));
  planes[1] = about(0.0, side, h, kOffY * h);
  if (plan.half) {
    std::erase_if(planes[1], [](double y) { return y < 0; });
    planes[1].insert(planes[1].begin(), kOffCentre * h);
  }
  planes[2] = {-kOffWater * h};
  for (const double z : kBelowWater) planes[2].push_back(-z * h + kOffZ * h);
  while (planes[2].back() > box.low.z() - kMargin * h) planes[2].push_back(planes[2].back() - h);
  std::reverse(planes[2].begin(), planes[2].end());
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const double extra : plan.extra[axis])
      insert(planes[axis], extra, h, axis == 1 && plan.half ? 1 : 0, axis == 2 ? 1 : 0);
  return planes;
}

FinePlanes finePlanes(const SpaceGrid::Planes& coarse, int step, double highest) {
  FinePlanes fine;
  double length = 1e300;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::vector<double>& planes = coarse[axis];
    for (std::size_t i = 0; i + 1 < planes.size(); ++i) {
      for (int k = 0; k < step; ++k)
        fine.planes[axis].push_back(planes[i] + (planes[i + 1] - planes[i]) * k / step);
      if (axis == 0) length = std::min(length, (planes[i + 1] - planes[i]) / step);
    }
    fine.planes[axis].push_back(planes.back());
  }
  std::vector<double>& z = fine.planes[2];
  fine.top = static_cast<int>(z.size()) - 1;
  while (z.back() < highest + length) z.push_back(z.back() + length);
  return fine;
}

SpaceGrid::Planes planesOfThinParts(const WaterGrid& water, const GridCrossings& crossings,
                                    double length, bool half) {
  constexpr double kLongest = 1.02, kWindow = 0.08, kLeastArea = 2.0;
  constexpr std::size_t kMost = 12;
  SpaceGrid::Planes found;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<Run> runs = thinRuns(water, crossings, axis, kLongest * length);
    const bool mirrored = axis == 1 && half;
    if (mirrored)
      for (Run& run : runs) run.middle = std::abs(run.middle);
    std::sort(runs.begin(), runs.end(),
              [](const Run& l, const Run& r) { return l.middle < r.middle; });
    std::vector<double>& planes = found[static_cast<std::size_t>(axis)];
    while (planes.size() < kMost) {
      const auto [part, area] = densest(runs, kWindow * length);
      if (area < kLeastArea * length * length) break;
      const bool onCentreplane = mirrored && part.middle < 0.2 * length;
      planes.push_back(onCentreplane ? 0.25 * part.length : part.middle);
      std::erase_if(runs, [&, middle = part.middle](const Run& run) {
        return std::abs(run.middle - middle) < kNear * length;
      });
    }
  }
  return found;
}

}  // namespace cutwater
