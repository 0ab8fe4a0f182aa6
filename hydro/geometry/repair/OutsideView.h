#pragma once
#include "hydro/geometry/SurfaceTree.h"
#include "hydro/geometry/repair/SurfacePatches.h"

namespace cutwater {

/// How well the faces of a surface below calm water are seen from the water around it. Not installed.
///
/// Rays leave a face on one side: those that go down or sideways see the water if they meet nothing;
/// those that go up are followed to calm water and from there to all sides, as what is under the hull's
/// own waterplane is inside her. Inside a hull every ray meets her, but for those through holes.
class OutsideView {
 public:
  /// @param wet  the surface below z = 0, open there; must outlive this object.
  explicit OutsideView(const SurfaceMesh& wet);
  /// Share of the rays on the side of the normal, and on the other, that see the water.
  struct Shares {
    double normal = 0.0, other = 0.0;
  };
  /// @param rays  over the whole sphere.
  Shares of(int face, int rays) const;

  /// A patch's mean over some of its faces, weighted by area, and a face that neither side of which
  /// is seen.
  struct PatchView {
    Shares shares;            ///< normals as turned by the patch
    double hiddenArea = 0.0;  ///< share of the area that is not seen from either side
    int hiddenFace = -1;      ///< the first such face
  };
  /// Of a patch of few faces more rays are asked, as it may lie deep in a narrow corner.
  PatchView of(const SurfacePatch& patch) const;

 private:
  double share(const Vec3& from, const Vec3& normal, int face, int rays) const;
  double seen(const Vec3& from, const Vec3& direction, int face) const;
  const SurfaceMesh& wet_;
  SurfaceTree tree_;
  double reach_;
};

}  // namespace cutwater
