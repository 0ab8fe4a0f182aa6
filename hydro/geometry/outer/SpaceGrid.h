#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "hydro/Conventions.h"

namespace cutwater {

/// Points where planes x = const, y = const and z = const meet. Node (i, j, k) has the number
/// (k·ny + j)·nx + i. The grid's edge (node, axis) leads from a node to the next plane of that
/// axis.
class SpaceGrid {
 public:
  using Planes = std::array<std::vector<double>, 3>;
  using Index = std::array<int, 3>;
  /// @param planes  [m], of each axis two or more, rising.
  explicit SpaceGrid(Planes planes);

  const std::vector<double>& planes(int axis) const {
    return planes_[static_cast<std::size_t>(axis)];
  }
  double plane(int axis, int i) const { return planes(axis)[static_cast<std::size_t>(i)]; }
  int count(int axis) const { return static_cast<int>(planes(axis).size()); }
  std::size_t nodes() const { return stride_[2] * planes_[2].size(); }
  std::size_t stride(int axis) const { return stride_[static_cast<std::size_t>(axis)]; }
  std::size_t node(const Index& at) const {
    return static_cast<std::size_t>(at[0]) + static_cast<std::size_t>(at[1]) * stride_[1] +
           static_cast<std::size_t>(at[2]) * stride_[2];
  }
  Index index(std::size_t node) const {
    return {static_cast<int>(node % stride_[1]), static_cast<int>(node % stride_[2] / stride_[1]),
            static_cast<int>(node / stride_[2])};
  }
  Vec3 place(const Index& at) const { return {plane(0, at[0]), plane(1, at[1]), plane(2, at[2])}; }
  /// Distance [m] from half-way to the plane before to half-way to the next.
  double width(int axis, int i) const;
  /// First plane at or above a coordinate; count(axis) if there is none.
  int above(int axis, double coordinate) const;

 private:
  Planes planes_;
  std::array<std::size_t, 3> stride_;
};

}  // namespace cutwater
