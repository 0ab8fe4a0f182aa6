#include "hydro/geometry/panelling/PanelRows.h"

#include <algorithm>
#include <cmath>

namespace cutwater {
namespace {

/// Fraction of the length at fraction u of the count.
double lengthFraction(double u, const Crowding& crowding) {
  const double c = crowding.c;
  if (crowding.start && crowding.end) return u - c * std::sin(2 * kPi * u) / (2 * kPi);
  if (crowding.start) return u - c * std::sin(kPi * u) / kPi;
  if (crowding.end) return u + c * std::sin(kPi * (1 - u)) / kPi;
  return u;
}

/// Its inverse, by bisection to round-off: the function rises.
double countFraction(double f, const Crowding& crowding) {
  double low = 0.0, high = 1.0;
  for (int i = 0; i < 50; ++i) {
    const double u = 0.5 * (low + high);
    if (lengthFraction(u, crowding) < f) {
      low = u;
    } else {
      high = u;
    }
  }
  return 0.5 * (low + high);
}

std::vector<double> evenly(int first, int last) {
  std::vector<double> t;
  const int n = std::max(1, last - first);
  for (int i = first; i <= last; ++i) t.push_back(static_cast<double>(i - first) / n);
  return t;
}

std::vector<int> part(const std::vector<int>& all, int first, int last) {
  return {all.begin() + first, all.begin() + last + 1};
}

/// Two panels' corners may coincide.
void addFace(SurfaceMesh& mesh, const std::vector<int>& corners) {
  std::vector<int> distinct;
  for (const int v : corners)
    if (std::find(distinct.begin(), distinct.end(), v) == distinct.end()) distinct.push_back(v);
  if (distinct.size() < 3) return;
  Face face;
  std::copy(distinct.begin(), distinct.end(), face.v.begin());
  mesh.faces.push_back(face);
}

}  // namespace

Division divided(double length, const std::vector<double>& corners, double count,
                 const Crowding& crowding) {
  std::vector<double> ends{0.0};
  ends.insert(ends.end(), corners.begin(), corners.end());
  ends.push_back(length);
  Division division{{0.0}, {0}};
  double before = 0.0;
  for (std::size_t i = 1; i < ends.size(); ++i) {
    const bool last = i + 1 == ends.size();
    const double here = last || length == 0.0 ? 1.0 : countFraction(ends[i] / length, crowding);
    // A half is rounded down on either side of a symmetric section.
    const int parts = std::max(1, static_cast<int>(std::ceil(count * (here - before) - 0.501)));
    for (int k = 1; k < parts; ++k)
      division.place.push_back(length *
                               lengthFraction(before + (here - before) * k / parts, crowding));
    division.place.push_back(ends[i]);
    division.breaks.push_back(static_cast<int>(division.place.size()) - 1);
    before = here;
  }
  return division;
}

void addPanelsBetween(const std::vector<int>& a, const std::vector<double>& parameterA,
                      const std::vector<int>& b, const std::vector<double>& parameterB,
                      SurfaceMesh& mesh) {
  std::size_t i = 0, j = 0;
  while (i + 1 < a.size() || j + 1 < b.size()) {
    const bool moreA = i + 1 < a.size(), moreB = j + 1 < b.size();
    bool stepA = moreA, stepB = moreB;
    if (moreA && moreB) {
      const double nextA = parameterA[i + 1], nextB = parameterB[j + 1];
      const double wider = std::max(nextA - parameterA[i], nextB - parameterB[j]);
      if (std::abs(nextA - nextB) > 0.5 * wider + 1e-9) {
        stepA = nextA < nextB;
        stepB = !stepA;
      }
      // One side must not run out long before the other.
      const std::size_t leftA = a.size() - 1 - i, leftB = b.size() - 1 - j;
      if (stepA && stepB && std::min(leftA, leftB) == 1 && std::max(leftA, leftB) > 1) {
        stepA = leftA > leftB;
        stepB = !stepA;
      }
    }
    if (stepA && stepB)
      addFace(mesh, {a[i], b[j], b[j + 1], a[i + 1]});
    else if (stepA)
      addFace(mesh, {a[i], b[j], a[i + 1]});
    else
      addFace(mesh, {a[i], b[j], b[j + 1]});
    i += stepA ? 1 : 0;
    j += stepB ? 1 : 0;
  }
}

void addPanelsBetween(const PanelRow& a, const PanelRow& b, SurfaceMesh& mesh) {
  const auto whole = [&](const PanelRow& r) { return std::vector<int>{0, r.breaks.back()}; };
  const bool alike = a.breaks.size() == b.breaks.size();
  const std::vector<int> breaksA = alike ? a.breaks : whole(a),
                         breaksB = alike ? b.breaks : whole(b);
  for (std::size_t s = 0; s + 1 < breaksA.size(); ++s)
    addPanelsBetween(part(a.vertex, breaksA[s], breaksA[s + 1]), evenly(breaksA[s], breaksA[s + 1]),
                     part(b.vertex, breaksB[s], breaksB[s + 1]), evenly(breaksB[s], breaksB[s + 1]),
                     mesh);
}

}  // namespace cutwater
