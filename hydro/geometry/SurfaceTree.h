#pragma once
#include <vector>

#include "hydro/geometry/SurfaceMesh.h"

namespace cutwater {

/// Answers what a ray meets on a surface, how far a point is from it, and which faces are near: a
/// tree of boxes around its triangles. Building costs O(n log n), a question O(log n) as a rule.
class SurfaceTree {
 public:
  /// @param mesh  quadrilaterals count as two triangles; must outlive this object.
  explicit SurfaceTree(const SurfaceMesh& mesh);
  /// Whether there is a face other than `except` on origin + t·direction, 0 < t < reach.
  bool meets(const Vec3& origin, const Vec3& direction, int except, double reach) const;
  /// Distance [m] from a point to the nearest face.
  double distance(const Vec3& point) const;
  /// The point of the surface nearest to a point; far away for a surface without faces.
  Vec3 nearest(const Vec3& point) const;
  /// Faces with a triangle whose box touches this box, each once, in rising order.
  std::vector<int> near(const Vec3& low, const Vec3& high) const;

 private:
  struct Triangle {
    Vec3 a, b, c;
    int face;
  };
  struct Node {
    Vec3 low, high;
    int first = 0, count = 0;  ///< triangles of a leaf; a branch has count 0
    int right = 0;             ///< second child; the first follows its parent
  };
  int build(int first, int count);
  std::vector<Triangle> triangles_;
  std::vector<Node> nodes_;
};

/// Whether the mirror images in y = 0 of all but a hundredth of the places lie on the surface. Of
/// many places some 4000 are looked at.
/// @param tolerance  [m].
bool holdsMirrorImages(const SurfaceTree& tree, const std::vector<Vec3>& places, double tolerance);

}  // namespace cutwater
