#include "hydro/geometry/outer/GridPlanes.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace cutwater {
namespace {

// Off round numbers, in lengths; another one for each use.
constexpr double kOff = 1e-5, kOffX = 0.37 * kOff, kOffY = 0.53 * kOff, kOffZ = 0.29 * kOff,
                 kOffWater = 0.41 * kOff, kOffCentre = 0.23 * kOff;
// The first planes below calm water, in lengths: rows of panels 0.6, 0.8, 1, 1 ... high.
constexpr double kBelowWater[] = {0.3, 0.9, 1.9};
// Of planes nearer to a thin part's than this many lengths there is no need.
constexpr double kNear = 0.55;
constexpr double kThinApart = 0.2;  // lengths between two planes of thin parts
constexpr double kMargin = 1.4;     // lengths beyond the body

/// Extra planes take the place of those near them; the first and the last may have to stay.
void insert(std::vector<double>& planes, const std::vector<double>& extra, double length,
            bool keepFirst, bool keepLast) {
  std::vector<double> kept = extra;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const bool stays = (i == 0 && keepFirst) || (i + 1 == planes.size() && keepLast);
    if (stays || std::all_of(extra.begin(), extra.end(),
                             [&](double e) { return std::abs(planes[i] - e) > kNear * length; }))
      kept.push_back(planes[i]);
  }
  std::sort(kept.begin(), kept.end());
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

/// Number of the first node of a line, the same for all its nodes.
std::size_t lineOf(const SpaceGrid& grid, std::size_t node, int axis) {
  return node - static_cast<std::size_t>(grid.index(node)[static_cast<std::size_t>(axis)]) *
                    grid.stride(axis);
}

/// The runs between neighbouring crossings of one line that are no longer than `longest` and that
/// `counts`.
template <class Crossing, class Counts>
void addRuns(std::vector<Run>& runs, const SpaceGrid& grid, const std::vector<Crossing>& list,
             int axis, double longest, const Counts& counts) {
  std::vector<std::pair<std::size_t, Crossing>> lines;
  for (const Crossing& c : list) lines.emplace_back(lineOf(grid, c.node, axis), c);
  std::sort(lines.begin(), lines.end(), [](const auto& l, const auto& r) {
    return l.first != r.first ? l.first < r.first : l.second.at < r.second.at;
  });
  for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
    const Crossing &from = lines[i].second, &to = lines[i + 1].second;
    const double length = to.at - from.at;
    if (lines[i].first != lines[i + 1].first || length > longest || length < 1e-3 * longest ||
        !counts(from.node, to.node))
      continue;
    const SpaceGrid::Index at = grid.index(from.node);
    const double area = grid.width((axis + 1) % 3, at[static_cast<std::size_t>((axis + 1) % 3)]) *
                        grid.width((axis + 2) % 3, at[static_cast<std::size_t>((axis + 2) % 3)]);
    runs.push_back({0.5 * (from.at + to.at), length, area});
  }
}

/// Thin parts with water on both sides, and thin gaps that water has reached.
std::vector<Run> thinRuns(const WaterGrid& water, const GridCrossings& crossings, int axis,
                          double longest) {
  const SpaceGrid& grid = water.grid();
  const std::size_t stride = grid.stride(axis);
  std::vector<Run> runs;
  addRuns(runs, grid, crossings.along(axis), axis, longest, [&](std::size_t from, std::size_t to) {
    return water.wet(from) && water.wet(to + stride);
  });
  addRuns(runs, grid, water.along(axis), axis, longest, [&](std::size_t from, std::size_t to) {
    return water.wet(from + stride) && water.wet(to);
  });
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

double areaNear(const std::vector<Run>& runs, double middle, double reach) {
  double area = 0.0;
  for (const Run& run : runs)
    if (std::abs(run.middle - middle) < reach) area += run.area;
  return area;
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
    insert(planes[axis], plan.extra[axis], h, axis == 1 && plan.half, axis == 2);
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
  while (z.back() < highest + length || z.size() % 2 == 0) z.push_back(z.back() + length);
  return fine;
}

SpaceGrid::Planes planesOfThinParts(const WaterGrid& water, const GridCrossings& crossings,
                                    double length, bool half) {
  // An oblique plate has its middles all over the place: planes do not help it.
  constexpr double kLongest = 1.02, kWindow = 0.08, kLeastArea = 2.0, kDense = 0.3;
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
      const bool alongAxis = area > kDense * areaNear(runs, part.middle, kNear * length);
      const bool onCentreplane = mirrored && part.middle < 0.2 * length;
      if (alongAxis) planes.push_back(onCentreplane ? 0.25 * part.length : part.middle);
      std::erase_if(runs, [&, middle = part.middle](const Run& run) {
        return std::abs(run.middle - middle) < kThinApart * length;
      });
    }
  }
  return found;
}

}  // namespace cutwater
