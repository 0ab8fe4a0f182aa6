#include "hydro/geometry/repair/HoleFilling.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <queue>
#include <unordered_map>

#include "hydro/Errors.h"
#include "hydro/geometry/MeshEdges.h"
#include "hydro/geometry/PlaceText.h"

namespace cutwater {
namespace {

/// Vertices along the rim of a hole, in the sense of the faces around it.
using Rim = std::vector<int>;

struct Rims {
  std::vector<Rim> loops;   ///< the last vertex is joined to the first
  std::vector<Rim> chains;  ///< from calm water to calm water
};

Rims rimsOf(const SurfaceMesh& wet) {
  std::unordered_multimap<int, int> next;
  std::unordered_map<int, int> arriving;
  for (const OpenEdge& e : looseEdges(wet)) {
    const auto onWater = [&](int v) {
      return wet.vertices[static_cast<std::size_t>(v)].z() == 0.0;
    };
    if (onWater(e.from) && onWater(e.to)) continue;
    next.emplace(e.from, e.to);
    ++arriving[e.to];
  }
  std::vector<int> starts;  // ends of chains first
  for (const auto& [from, to] : next)
    if (!arriving.contains(from)) starts.push_back(from);
  const std::size_t ends = starts.size();
  for (const auto& [from, to] : next) starts.push_back(from);
  // The order must not depend on that of a hash table.
  std::sort(starts.begin(), starts.begin() + static_cast<std::ptrdiff_t>(ends));
  std::sort(starts.begin() + static_cast<std::ptrdiff_t>(ends), starts.end());
  Rims rims;
  for (const int start : starts) {
    Rim rim{start};
    for (auto it = next.find(start); it != next.end(); it = next.find(rim.back())) {
      rim.push_back(it->second);
      next.erase(it);
      // Where two holes touch in a vertex, the loop just closed is cut off.
      const auto before = std::find(rim.begin(), rim.end() - 1, rim.back());
      if (before == rim.end() - 1) continue;
      rims.loops.emplace_back(before, rim.end() - 1);
      rim.erase(before + 1, rim.end());
    }
    if (rim.size() > 1) rims.chains.push_back(rim);
  }
  return rims;
}

class RimFilling {
 public:
  RimFilling(SurfaceMesh& wet, Rim rim)
      : wet_(wet), rim_(std::move(rim)), filled_(wet.faces.size()) {
    const int n = static_cast<int>(rim_.size());
    for (int i = 0; i < n; ++i) {
      after_.push_back((i + 1) % n);
      before_.push_back((i + n - 1) % n);
      gone_.push_back(false);
    }
  }

  /// Cuts off the ear with the shortest new edge until three corners are left.
  FilledHole fill(double& area) {
    for (int i = 0; i < static_cast<int>(rim_.size()); ++i) offer(i);
    std::size_t left = rim_.size();
    while (left > 3 && !ears_.empty()) {
      const Ear ear = ears_.top();
      ears_.pop();
      if (gone_[at(ear.corner)] || before_[at(ear.corner)] != ear.before ||
          after_[at(ear.corner)] != ear.after)
        continue;
      cutOff(ear);
      --left;
    }
    const auto last =
        static_cast<int>(std::find(gone_.begin(), gone_.end(), false) - gone_.begin());
    add(before_[at(last)], last, after_[at(last)]);
    return hole(area);
  }

 private:
  struct Ear {
    double length;
    int corner, before, after;
    bool operator<(const Ear& other) const { return length > other.length; }
  };
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  const Vec3& point(int i) const { return wet_.vertices[at(rim_[at(i)])]; }
  void offer(int i) {
    const int b = before_[at(i)], a = after_[at(i)];
    ears_.push({(point(a) - point(b)).norm(), i, b, a});
  }
  void cutOff(const Ear& ear) {
    add(ear.before, ear.corner, ear.after);
    gone_[at(ear.corner)] = true;
    after_[at(ear.before)] = ear.after;
    before_[at(ear.after)] = ear.before;
    offer(ear.before);
    offer(ear.after);
  }
  /// Against the rim's sense, so that it agrees with the faces around.
  void add(int before, int corner, int after) {
    wet_.faces.push_back({{rim_[at(after)], rim_[at(corner)], rim_[at(before)], -1}});
  }
  FilledHole hole(double& area) const {
    FilledHole hole;
    double around = 0.0;
    area = 0.0;
    for (std::size_t f = filled_; f < wet_.faces.size(); ++f)
      area += vectorArea(wet_, wet_.faces[f]).norm();
    for (int i = 0; i < static_cast<int>(rim_.size()); ++i) {
      hole.place += point(i) / static_cast<double>(rim_.size());
      around += (point((i + 1) % static_cast<int>(rim_.size())) - point(i)).norm();
    }
    hole.width = around > 0 ? 4 * area / around : 0.0;
    return hole;
  }

  SurfaceMesh& wet_;
  Rim rim_;
  std::size_t filled_;  ///< faces before
  std::vector<int> after_, before_;
  std::vector<bool> gone_;
  std::priority_queue<Ear> ears_;
};

const Vec3& start(const SurfaceMesh& wet, const Rim& rim) {
  return wet.vertices[static_cast<std::size_t>(rim.front())];
}
const Vec3& end(const SurfaceMesh& wet, const Rim& rim) {
  return wet.vertices[static_cast<std::size_t>(rim.back())];
}

/// Chains closed across calm water: each alone where its ends are near, else with the chain whose
/// ends are near its own.
std::vector<std::pair<Rim, bool>> closedChains(const SurfaceMesh& wet, std::vector<Rim> chains,
                                               double widest) {
  std::vector<std::pair<Rim, bool>> rims;
  std::vector<bool> used(chains.size(), false);
  for (std::size_t i = 0; i < chains.size(); ++i) {
    if (used[i]) continue;
    Rim rim = chains[i];
    bool keel = false;
    if ((start(wet, rim) - end(wet, rim)).norm() > widest) {
      for (std::size_t j = i + 1; j < chains.size() && !keel; ++j) {
        if (used[j] || (start(wet, chains[j]) - end(wet, rim)).norm() > widest ||
            (end(wet, chains[j]) - start(wet, rim)).norm() > widest)
          continue;
        rim.insert(rim.end(), chains[j].begin(), chains[j].end());
        used[j] = keel = true;
      }
    }
    if (rim.front() == rim.back()) rim.pop_back();
    rim.erase(std::unique(rim.begin(), rim.end()), rim.end());
    rims.emplace_back(rim, keel);
  }
  return rims;
}

/// A slit ten times as long as a hole may be wide, near the centreplane.
bool isKeel(const SurfaceMesh& wet, const Rim& rim, double widest) {
  double first = 1e300, last = -1e300, off = 0.0;
  for (const int v : rim) {
    const Vec3& p = wet.vertices[static_cast<std::size_t>(v)];
    first = std::min(first, p.x());
    last = std::max(last, p.x());
    off = std::max(off, std::abs(p.y()));
  }
  return last - first > 10 * widest && off < widest;
}

}  // namespace

std::vector<FilledHole> fillNarrowHoles(SurfaceMesh& wet, double widest) {
  Rims found = rimsOf(wet);
  std::vector<std::pair<Rim, bool>> rims = closedChains(wet, std::move(found.chains), widest);
  for (Rim& loop : found.loops) rims.emplace_back(std::move(loop), false);
  std::vector<FilledHole> holes;
  for (const auto& [rim, keel] : rims) {
    if (rim.size() < 3) continue;
    const std::size_t faces = wet.faces.size();
    double area = 0.0;
    FilledHole hole = RimFilling(wet, rim).fill(area);
    hole.keel = keel || isKeel(wet, rim, widest);
    hole.open = hole.width > widest;
    if (hole.open) wet.faces.resize(faces);
    holes.push_back(hole);
  }
  return holes;
}

std::vector<FilledHole> fillHoles(SurfaceMesh& wet, double widest, const std::string& name) {
  std::vector<FilledHole> holes = fillNarrowHoles(wet, widest);
  for (const FilledHole& hole : holes) {
    if (!hole.open) continue;
    char text[160];
    std::snprintf(text, sizeof text,
                  ": hull has a hole %.3g m wide below water at %s; holes up to %.3g m are closed",
                  hole.width, placeText(hole.place).c_str(), widest);
    throw HydroError(Fault::HullNotClosed, name + text);
  }
  return holes;
}

}  // namespace cutwater
