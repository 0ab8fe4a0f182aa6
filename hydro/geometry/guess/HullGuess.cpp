#include "hydro/geometry/guess/HullGuess.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "hydro/Errors.h"
#include "hydro/geometry/guess/AxisEvidence.h"

namespace cutwater {

namespace {

struct Direction {
  int axis = 2, sign = 1;
  std::string name() const { return (sign < 0 ? "-" : "") + std::string(1, "xyz"[axis]); }
};

Direction directionOf(const std::string& name) {
  return {name.back() - 'x', name.front() == '-' ? -1 : 1};
}

// Habits of those who draw, where the shape says nothing.
std::vector<Evidence> habitsOfUp(const Direction& up, const AxisConvention& usual) {
  std::vector<Evidence> list;
  if (!usual.up.empty() && up.name() == usual.up)
    list.push_back({3.0, usual.format + " has it so"});
  if (usual.up.empty() && up.axis == 2) list.push_back({1.0, "most files of ships have z up"});
  if (usual.up.empty() && up.axis == 1) list.push_back({0.5, "models for games have y up"});
  if (up.sign > 0) list.push_back({1.5, "axes mostly point up"});
  return list;
}

std::vector<Evidence> habitsOfForward(const Direction& forward, const AxisConvention& usual) {
  std::vector<Evidence> list;
  if (!usual.forward.empty() && forward.name() == usual.forward)
    list.push_back({0.8, usual.format + " has it so"});
  if (usual.forward.empty() && forward.axis == 0 && forward.sign > 0)
    list.push_back({0.8, "most files of ships have x forward"});
  if (forward.sign > 0) list.push_back({0.3, "axes mostly point forward"});
  return list;
}

double sum(const std::vector<Evidence>& list) {
  double total = 0.0;
  for (const Evidence& one : list) total += one.weight;
  return total;
}

// The two strongest things that speak for it.
std::string reasons(std::vector<Evidence> list) {
  std::stable_sort(list.begin(), list.end(),
                   [](const Evidence& a, const Evidence& b) { return a.weight > b.weight; });
  std::string text;
  for (std::size_t i = 0; i < std::min<std::size_t>(2, list.size()); ++i)
    if (list[i].weight > 0.25) text += (text.empty() ? "" : "; ") + list[i].reason;
  return text.empty() ? "nothing in the shape tells" : text;
}

struct Reading {
  Direction up, forward;
  std::vector<Evidence> upReasons, forwardReasons;
  double score = 0.0;
};

std::vector<Reading> readings(const AxisEvidence& evidence, const AxesHints& hints) {
  std::vector<Reading> all;
  const auto take = [](std::vector<Evidence> a, const std::vector<Evidence>& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
  };
  for (int u = 0; u < 6; ++u)
    for (int f = 0; f < 6; ++f) {
      Reading one{{u / 2, u % 2 ? -1 : 1}, {f / 2, f % 2 ? -1 : 1}, {}, {}, 0.0};
      if (one.up.axis == one.forward.axis) continue;
      if (hints.up && one.up.name() != *hints.up) continue;
      if (hints.forward && one.forward.name() != *hints.forward) continue;
      one.upReasons =
          take(evidence.up(one.up.axis, one.up.sign), habitsOfUp(one.up, hints.conventional));
      one.forwardReasons = take(evidence.forward(one.forward.axis, one.forward.sign, one.up.axis),
                                habitsOfForward(one.forward, hints.conventional));
      one.score = sum(one.upReasons) + sum(one.forwardReasons);
      all.push_back(std::move(one));
    }
  std::stable_sort(all.begin(), all.end(),
                   [](const Reading& a, const Reading& b) { return a.score > b.score; });
  return all;
}

// How likely the first reading is beside the best one that differs.
template <typename Differs>
double confidence(const std::vector<Reading>& all, const Differs& differs) {
  const auto other = std::find_if(all.begin(), all.end(), differs);
  return other == all.end() ? 1.0 : 1.0 / (1.0 + std::exp(other->score - all.front().score));
}

// The lesser of the two extents across an axis.
double breadthOf(const SurfaceMesh& mesh, const std::string& up) {
  const Bounds box = bounds(mesh);
  const int axis = directionOf(up).axis;
  const Vec3 size = box.high - box.low;
  return std::min(size[(axis + 1) % 3], size[(axis + 2) % 3]);
}

double extent(const SurfaceMesh& mesh, int axis) {
  const Bounds box = bounds(mesh);
  return box.high[axis] - box.low[axis];
}

}  // namespace

AxesGuess guessAxes(const SurfaceMesh& mesh, const AxesHints& hints) {
  const AxisEvidence evidence(mesh);
  const std::vector<Reading> all = readings(evidence, hints);
  if (all.empty()) throw HydroError(Fault::BadArgument, "up and forward are the same axis");
  const Reading& best = all.front();
  AxesGuess guess;
  guess.up = {best.up.name(),
              confidence(all, [&](const Reading& r) { return r.up.name() != best.up.name(); }),
              reasons(best.upReasons)};
  guess.forward = {best.forward.name(),
                   confidence(all,
                              [&](const Reading& r) {
                                return r.up.name() == best.up.name() &&
                                       r.forward.name() != best.forward.name();
                              }),
                   reasons(best.forwardReasons)};
  const double length = extent(mesh, best.forward.axis);
  const double breadth = extent(mesh, 3 - best.up.axis - best.forward.axis);
  guess.ship = length > 1.6 * breadth && length > extent(mesh, best.up.axis);
  if (!guess.ship && !hints.forward) {
    guess.forward.confidence = 0.5;
    guess.forward.reason = "it is about as long as broad or stands on end, so any axis will do";
  }
  if (hints.up) guess.up.reason = "as given";
  if (hints.forward) guess.forward.reason = "as given";
  return guess;
}

Guess<std::string> guessUnit(double length, bool game) {
  constexpr double kLarge = 300.0;                   // [m]
  constexpr double shortest = 0.8, longest = 450.0;  // [m]: a model in a tank, a large ship
  const auto fits = [&](double unit) { return length * unit >= 3.0 && length * unit <= longest; };
  if (length >= shortest && length <= longest)
    return {"m", length < 3.0 || length > kLarge ? 0.8 : 0.98,
            length > kLarge ? "metres make a very large ship of it, feet a large one"
                            : "metres make a length that ships have"};
  if (length < shortest) return {"", 0.5, "it is shorter than a model in a tank in every unit"};
  const bool cm = fits(0.01), mm = fits(0.001);
  if (cm && (!mm || game)) return {"cm", 0.7, "metres would make it longer than any ship"};
  if (mm) return {"mm", cm ? 0.55 : 0.8, "metres would make it longer than any ship"};
  return {"", 0.5, "it is longer than any ship in every unit"};
}

namespace {

struct Columns {
  std::vector<double> low;  // heights of the lowest skin [unit]
  double rim = 0.0;         // median height of the plan's outline, seen from above
  double cellArea = 0.0, bottom = 0.0, top = 0.0;
};

// Median height, 0 to 1, of the cells at the outline of the plan.
double rimHeight(const TwoSidedView& view) {
  constexpr int n = TwoSidedView::kCells;
  const auto seen = [&](int i, int j) {
    return i >= 0 && j >= 0 && i < n && j < n && view.at(i, j).seen();
  };
  std::vector<double> heights;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i)
      if (seen(i, j) && !(seen(i - 1, j) && seen(i + 1, j) && seen(i, j - 1) && seen(i, j + 1)))
        heights.push_back(view.at(i, j).high);
  if (heights.empty()) return 1.0;
  const auto middle = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 2);
  std::nth_element(heights.begin(), middle, heights.end());
  return *middle;
}

Columns columnsOf(const SurfaceMesh& mesh, const std::string& name) {
  const Direction up = directionOf(name);
  SurfaceMesh upright = mesh;
  if (up.sign < 0)
    for (Vec3& p : upright.vertices) p = -p;
  const Bounds box = bounds(upright);
  const Vec3 size = box.high - box.low;
  const TwoSidedView view = viewAlong(surfaceSamples(upright), up.axis);
  Columns columns;
  columns.bottom = box.low[up.axis];
  columns.top = box.high[up.axis];
  columns.cellArea =
      size[view.along] * size[view.across] / (TwoSidedView::kCells * TwoSidedView::kCells);
  for (const TwoSidedView::Cell& cell : view.cells)
    if (cell.seen()) columns.low.push_back(columns.bottom + cell.low * size[up.axis]);
  columns.rim = columns.bottom + size[up.axis] * rimHeight(view);
  return columns;
}

// The file's 0 lies in the hull, that share of its depth above the lowest point.
Guess<double> zeroInside(bool halfWay, double share) {
  if (halfWay) return {0.0, 0.8, "the file's 0 lies in it (just half way up, which may be chance)"};
  if (share < 0.1) return {0.0, 0.7, "the file's 0 lies in it, though low"};
  if (share > 0.9) return {0.0, 0.7, "the file's 0 lies in it, though high"};
  return {0.0, 0.97, "the file's 0 lies in it"};
}

}  // namespace

WaterlineGuess guessWaterline(const SurfaceMesh& mesh, const std::string& up) {
  const Columns columns = columnsOf(mesh, up);
  WaterlineGuess guess;
  guess.low = columns.bottom;
  guess.high = columns.top;
  guess.deck = columns.rim;
  const double height = columns.top - columns.bottom, near = 2e-3 * height;
  // A keel, a plate or pontoons may be wider than what stands on them: then that is the top.
  if (guess.deck - guess.low < 0.3 * height && guess.deck - guess.low < 0.3 * breadthOf(mesh, up))
    guess.deck = guess.high;
  const double depth = guess.deck - guess.low;
  const double under = -guess.low / depth;
  if (std::abs(guess.high) < near) {
    guess.height = {0.0, 0.97, "the mesh ends at the file's 0"};
  } else if (under > 0.02 && under < 0.98 && guess.high > 0.0) {
    guess.height = zeroInside(std::abs(guess.low + guess.high) < near, under);
  } else {
    guess.height = {guess.low + 0.45 * depth, 0.5,
                    "the file's 0 is not in the hull; 45 % of its depth is made up"};
    guess.inFile = false;
  }
  return guess;
}

double volumeFromBelow(const SurfaceMesh& mesh, const std::string& up, double height) {
  const Columns columns = columnsOf(mesh, up);
  double volume = 0.0;
  for (const double low : columns.low) volume += std::max(0.0, height - low) * columns.cellArea;
  return volume;
}

}  // namespace cutwater
