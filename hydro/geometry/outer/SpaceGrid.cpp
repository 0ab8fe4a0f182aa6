#include "hydro/geometry/outer/SpaceGrid.h"

#include <algorithm>

namespace cutwater {

SpaceGrid::SpaceGrid(Planes planes)
    : planes_(std::move(planes)),
      stride_{1, planes_[0].size(), planes_[0].size() * planes_[1].size()} {}

double SpaceGrid::width(int axis, int i) const {
  const int last = count(axis) - 1;
  return 0.5 * (plane(axis, std::min(i + 1, last)) - plane(axis, std::max(i - 1, 0)));
}

int SpaceGrid::above(int axis, double coordinate) const {
  const std::vector<double>& p = planes(axis);
  return static_cast<int>(std::lower_bound(p.begin(), p.end(), coordinate) - p.begin());
}

}  // namespace cutwater
