#pragma once
#include "hydro/geometry/SurfacePatches.h"
#include "hydro/geometry/SurfaceTree.h"

namespace cutwater {

/// How much of a face below calm water can be seen from the water around the hull.
///
/// Rays leave a face on one side. A ray that goes down or sideways sees the water if it meets
/// nothing. A ray that goes up is followed to calm water and from there to all sides, since what is
/// under the hull's own waterplane is inside the hull. Inside a hull every ray meets it, but for
/// those through holes.
class OutsideView {
 public:
  /// @param wet  the surface below z = 0, open there; must outlive this object.
  explicit OutsideView(const SurfaceMesh& wet);
  /// Share of the rays that see the water, on the side of the normal and on the other.
  struct Shares {
    double normal = 0.0, other = 0.0;
  };
  /// @param rays  over the whole sphere.
  Shares of(int face, int rays) const;

  /// What is seen of a patch, from some of its faces, weighted by area.
  struct PatchView {
    Shares shares;            ///< normals as turned by the patch
    double hiddenArea = 0.0;  ///< share of the area that is not seen from either side
    int hiddenFace = -1;      ///< the first such face
  };
  /// A patch of few faces gets more rays, as it may lie deep in a narrow corner.
  PatchView of(const SurfacePatch& patch) const;

 private:
  double share(const Vec3& from, const Vec3& normal, int face, int rays) const;
  double seen(const Vec3& from, const Vec3& direction, int face) const;
  const SurfaceMesh& wet_;
  SurfaceTree tree_;
  double reach_;
};

}  // namespace cutwater
