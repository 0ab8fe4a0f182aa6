#pragma once
#include <array>
#include <vector>

#include "hydro/geometry/Hull.h"
#include "hydro/waves/Wave.h"

namespace cutwater {

/// The part of F_I that panels inscribed in a hull lack. C is that of the hull, and a wave much
/// longer than the ship must lift and tilt it as the water itself: F_I → C η_w, η_w the heave, roll
/// and pitch of the water. Panels give their own C instead, off by the second order of their size
/// (GM of a frigate of 433: 3 %). What is missing goes with the plane that fits the water over the
/// waterplane best, by least squares:
///     ΔF_I = (C − C_panels) η_w
/// and what the slope of the water pushes on the volume that is missing, by Archimedes: −ρgΔV b in
/// surge and −ρgΔV c in sway, with their moments in yaw. In shorter waves all of it vanishes as the
/// fit does.
///     const LackingRestoring lacking(wet, {ship.hull, ship.symmetric}, ship.restoring, ship.cog,
///                                    density, gravity);
///     const CVec6 force = froudeKrylovForce(…) + lacking.force(wave);
/// THEORY.md, chapter 3.
class LackingRestoring {
 public:
  /// Nothing is lacking.
  LackingRestoring() = default;
  /// Nothing, too, without a hull, or if `restoring` is not the hull's (a database made otherwise).
  /// @param wet        the surface over which F_I is integrated, both sides, hull axes [m].
  /// @param hull       what it stands for.
  /// @param restoring  C of the ship about `cog`.
  LackingRestoring(const SurfaceMesh& wet, const Hull& hull, const Mat6& restoring, const Vec3& cog,
                   double density, double gravity);

  /// ΔF_I per metre of amplitude, crest over G.  O(faces of `wet`), no allocation.
  CVec6 force(const AiryWave& wave) const;

 private:
  /// Four points of the waterplane: their places from G [m] and the areas for which they stand
  /// [m²]; what there are too few of has no area.
  struct alignas(32) Four {
    double x[4]{}, y[4]{}, area[4]{};
  };
  /// Σ area e^{i(k_y y − k_x x)} times 1, x and y; Re of the three, then Im.
  static std::array<double, 6> sums(const std::vector<Four>& points, double kx, double ky);

  std::vector<Four> points_;
  Eigen::Matrix<double, 6, 3> difference_ = Eigen::Matrix<double, 6, 3>::Zero();  ///< by a, b, c
};

}  // namespace cutwater
