#pragma once
#include "hydro/forces/floats/Ellipsoid.h"
#include "hydro/geometry/wetted/WettedTriangles.h"

namespace cutwater {

/// The hull of a small floating body, made once of a closed mesh about its centre of gravity G.
/// What the water adds to it is taken from the ellipsoid that has its volume and, along the
/// principal axes of that volume, half axes in proportion to √∫x_i² dV: a ball is its own
/// ellipsoid. Immutable.
class FloatHull {
 public:
  static constexpr std::size_t kMostTriangles = 400;

  /// @param mesh  closed, normals out, r = 0 in G, body axes [m]. More than kMostTriangles are
  ///        thinned with their volume kept; few are made shorter, down to a sixth of the body.
  /// @throws HydroError as WettedTriangles.
  explicit FloatHull(const SurfaceMesh& mesh);

  const WettedTriangles& triangles() const noexcept { return triangles_; }
  double volume() const noexcept { return volume_; }  ///< [m³]
  double size() const noexcept { return size_; }      ///< V^{1/3} [m]
  double reach() const noexcept { return reach_; }    ///< of the vertex farthest from G [m]
  const Vec3& semiAxes() const noexcept { return semiAxes_; }
  /// Columns: axes of the ellipsoid in body axes.
  const Mat3& principalAxes() const noexcept { return axes_; }

  /// The whole body's in body axes, of water of 1 kg/m³: along it (of a force for an
  /// acceleration), about it, and of a strain (EllipsoidMass::straining).
  const Mat3& linear() const noexcept { return linear_; }
  const Mat3& angular() const noexcept { return angular_; }
  /// Moment of momentum of strained water, −S e of Ω_w, for a gradient in body axes.
  Vec3 strained(const Mat3& gradient) const noexcept;
  /// Largest difference of two of the linear ones.
  double linearSpread() const noexcept { return spread_; }

 private:
  WettedTriangles triangles_;
  double volume_ = 0.0, size_ = 0.0, reach_ = 0.0, spread_ = 0.0;
  Vec3 semiAxes_ = Vec3::Zero();
  Mat3 axes_ = Mat3::Identity(), linear_ = Mat3::Zero(), angular_ = Mat3::Zero();
  Vec3 straining_ = Vec3::Zero();
};

}  // namespace cutwater
