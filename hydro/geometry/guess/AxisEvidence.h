#pragma once
#include <array>
#include <string>
#include <vector>

#include "hydro/geometry/guess/SurfaceSamples.h"

namespace cutwater {

/// One thing that speaks for an axis: weight in nats (e-fold odds), a reason in words.
struct Evidence {
  double weight;
  std::string reason;
};

/// What speaks for reading a mesh one way or another, measured once.
class AxisEvidence {
 public:
  explicit AxisEvidence(const SurfaceMesh& mesh);
  /// For the axis 0..2 of the file, pointing up its own way or (sign < 0) the other.
  std::vector<Evidence> up(int axis, int sign) const;
  /// For the direction to the bow where `up` is up.
  std::vector<Evidence> forward(int axis, int sign, int up) const;
  /// A body of no direction about this axis: as long as broad and alike after a quarter turn.
  bool turnsAbout(int axis) const { return quarter_[index(axis)] > 0.93; }
  /// The share of the surface that is its own mirror image across this axis; of one half of a hull
  /// that ends in the plane 0, near 1.
  double mirror(int axis) const { return mirror_[index(axis)]; }

 private:
  static std::size_t index(int axis) { return static_cast<std::size_t>(axis); }
  double levelTop(int axis) const;
  double bowl(int axis) const;
  bool closedAtEnd(int axis, bool high) const;
  double endShare(int up, int axis, bool high) const;

  Vec3 size_, low_, high_;
  std::array<double, 3> mirror_{}, quarter_{};
  std::array<bool, 3> endsAtZero_{};  ///< lies on one side of the plane 0, and is open there
  std::array<TwoSidedView, 3> views_;
  std::array<double, 3> openHeight_{};  ///< mean place of its open edges, −1 without any
};

}  // namespace cutwater
