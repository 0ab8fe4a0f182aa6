#include "hydro/geometry/guess/SurfaceSamples.h"

#include <algorithm>
#include <cmath>

namespace cutwater {

namespace {

constexpr int kCells = Occupied::kCells;
constexpr double kStep = 0.45 / kCells;
constexpr double kSame = 1e-9;  // of the height: round-off
const double kLevel = std::cos(10.0 * kPi / 180.0);

int cellOf(double place) { return std::clamp(static_cast<int>(place * kCells), 0, kCells - 1); }

std::size_t cellIndex(int i, int j, int k) {
  return (static_cast<std::size_t>(k) * kCells + static_cast<std::size_t>(j)) * kCells +
         static_cast<std::size_t>(i);
}

// A lattice over the triangle, its edges included.
void addTriangle(const std::array<Vec3, 3>& corners, const Vec3& normal,
                 std::vector<SurfaceSample>& samples) {
  const Vec3 u = corners[1] - corners[0], v = corners[2] - corners[0];
  const double longest = std::max({u.norm(), v.norm(), (u - v).norm()});
  const int n = std::max(1, static_cast<int>(std::ceil(longest / kStep)));
  for (int i = 0; i <= n; ++i) {
    // A sliver needs no lattice, one row along it will do.
    const double width = u.cross(v).norm() / std::max(longest, 1e-12);
    const int rows = std::max(1, static_cast<int>(std::ceil(width / kStep)));
    const int m = std::max(1, rows * (n - i) / n);
    for (int j = 0; j <= m; ++j) {
      const double a = static_cast<double>(i) / n, b = (1.0 - a) * j / m;
      samples.push_back({corners[0] + a * u + b * v, normal});
    }
  }
}

}  // namespace

std::vector<SurfaceSample> surfaceSamples(const SurfaceMesh& mesh) {
  const Bounds box = bounds(mesh);
  const Vec3 size = (box.high - box.low).cwiseMax(1e-9 * box.diagonal());
  std::vector<SurfaceSample> samples;
  for (const Face& face : mesh.faces) {
    const Vec3 area = vectorArea(mesh, face);
    if (!(area.norm() > 0.0)) continue;
    for (int second = 1; second + 1 < face.size(); ++second) {
      std::array<Vec3, 3> corners;
      const int index[] = {0, second, second + 1};
      for (std::size_t i = 0; i < 3; ++i)
        corners[i] = (mesh.corner(face, index[i]) - box.low).cwiseQuotient(size);
      // The longest edge is opposite the last corner, so that rows run along it.
      const double a = (corners[1] - corners[0]).norm(), b = (corners[2] - corners[1]).norm(),
                   c = (corners[0] - corners[2]).norm();
      if (b >= a && b >= c) std::rotate(corners.begin(), corners.begin() + 1, corners.end());
      if (c > a && c > b) std::rotate(corners.begin(), corners.begin() + 2, corners.end());
      addTriangle(corners, area.normalized(), samples);
    }
  }
  return samples;
}

Occupied::Occupied(const std::vector<SurfaceSample>& samples)
    : cells_(static_cast<std::size_t>(kCells) * kCells * kCells) {
  std::vector<bool> hit(cells_.size());
  for (const SurfaceSample& s : samples)
    hit[cellIndex(cellOf(s.place.x()), cellOf(s.place.y()), cellOf(s.place.z()))] = true;
  const auto around = [](int i) {
    return std::pair{std::max(i - 1, 0), std::min(i + 1, kCells - 1)};
  };
  for (int k = 0; k < kCells; ++k)
    for (int j = 0; j < kCells; ++j)
      for (int i = 0; i < kCells; ++i) {
        if (!hit[cellIndex(i, j, k)]) continue;
        for (int c = around(k).first; c <= around(k).second; ++c)
          for (int b = around(j).first; b <= around(j).second; ++b)
            for (int a = around(i).first; a <= around(i).second; ++a)
              cells_[cellIndex(a, b, c)] = true;
      }
}

bool Occupied::at(const Vec3& place) const {
  return cells_[cellIndex(cellOf(place.x()), cellOf(place.y()), cellOf(place.z()))];
}

namespace {

template <typename Image>
double shareOnSurface(const std::vector<SurfaceSample>& samples, const Occupied& occupied,
                      const Image& image) {
  std::size_t on = 0;
  for (const SurfaceSample& s : samples) on += occupied.at(image(s.place)) ? 1 : 0;
  return samples.empty() ? 0.0 : static_cast<double>(on) / static_cast<double>(samples.size());
}

}  // namespace

double mirrorShare(const std::vector<SurfaceSample>& samples, const Occupied& occupied, int axis) {
  return shareOnSurface(samples, occupied, [axis](Vec3 place) {
    place[axis] = 1.0 - place[axis];
    return place;
  });
}

double quarterTurnShare(const std::vector<SurfaceSample>& samples, const Occupied& occupied,
                        int axis) {
  const int a = (axis + 1) % 3, b = (axis + 2) % 3;
  return shareOnSurface(samples, occupied, [a, b](const Vec3& place) {
    Vec3 turned = place;
    turned[a] = 1.0 - place[b];
    turned[b] = place[a];
    return turned;
  });
}

TwoSidedView viewAlong(const std::vector<SurfaceSample>& samples, int axis) {
  TwoSidedView view;
  view.along = (axis + 1) % 3;
  view.across = (axis + 2) % 3;
  view.cells.resize(static_cast<std::size_t>(kCells) * kCells);
  for (const SurfaceSample& s : samples) {
    const std::size_t index = static_cast<std::size_t>(cellOf(s.place[view.across])) * kCells +
                              static_cast<std::size_t>(cellOf(s.place[view.along]));
    TwoSidedView::Cell& cell = view.cells[index];
    const bool level = std::abs(s.normal[axis]) > kLevel;
    // At an edge two faces are as high: what is level there covers the cell.
    const double height = s.place[axis];
    cell.lowLevel =
        (level && height < cell.low + kSame) || (cell.lowLevel && height > cell.low - kSame);
    cell.highLevel =
        (level && height > cell.high - kSame) || (cell.highLevel && height < cell.high + kSame);
    cell.low = std::min(cell.low, height);
    cell.high = std::max(cell.high, height);
  }
  return view;
}

}  // namespace cutwater
