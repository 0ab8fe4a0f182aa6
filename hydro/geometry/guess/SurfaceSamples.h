#pragma once
#include <vector>

#include "hydro/geometry/SurfaceMesh.h"

/// What a surface shows of its shape when it is looked at from outside, along the axes of its file.
/// Holes, doubled plates, decks and faces turned either way make no difference.
namespace cutwater {

/// One place on the surface, in the box of the mesh: 0 to 1 along each axis.
struct SurfaceSample {
  Vec3 place;
  Vec3 normal;  ///< of the face, unit, in the file's axes; either way
};

/// Places all over the surface, closer together than half a cell of the grid below.
/// O(faces + 1e5); one thread.
std::vector<SurfaceSample> surfaceSamples(const SurfaceMesh& mesh);

/// The cells of a grid of kCells along each axis that the surface passes through, or that touch
/// such a cell.
class Occupied {
 public:
  static constexpr int kCells = 80;
  explicit Occupied(const std::vector<SurfaceSample>& samples);
  bool at(const Vec3& place) const;

 private:
  std::vector<bool> cells_;
};

/// Share of the surface whose mirror image in the middle of the box, across `axis`, lies on the
/// surface, within 1 to 2 % of the box. 1 for a mirror image.
double mirrorShare(const std::vector<SurfaceSample>& samples, const Occupied& occupied, int axis);
/// The same after a quarter turn about `axis`.
double quarterTurnShare(const std::vector<SurfaceSample>& samples, const Occupied& occupied,
                        int axis);

/// The surface seen along an axis, from above and from below.
struct TwoSidedView {
  static constexpr int kCells = Occupied::kCells;
  /// One cell of the plan; heights 0 to 1 along the axis.
  struct Cell {
    double low = 2.0, high = -1.0;
    bool lowLevel = false, highLevel = false;  ///< the face there lies across the axis, within 10°
    bool seen() const noexcept { return high >= low; }
  };
  int across = 1, along = 0;  ///< the two other axes, rows and columns of the cells
  std::vector<Cell> cells;
  const Cell& at(int i, int j) const {
    return cells[static_cast<std::size_t>(j) * kCells + static_cast<std::size_t>(i)];
  }
};
TwoSidedView viewAlong(const std::vector<SurfaceSample>& samples, int axis);

}  // namespace cutwater
