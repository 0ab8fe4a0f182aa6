#include "hydro/forces/floats/FloatHull.h"

#include <algorithm>
#include <cmath>

#include "hydro/base/SymmetricEigen.h"
#include "hydro/forces/floats/FloatShapes.h"
#include "hydro/geometry/MeshIntegrals.h"
#include "hydro/geometry/wetted/PressureMesh.h"
#include "hydro/geometry/wetted/ThinnedHull.h"

namespace cutwater {

namespace {

constexpr std::size_t kEnoughTriangles = 40;  // a mesh of fewer is refined
constexpr double kFloatEdge = 1.0 / 3.0;      // of the longest side of the bounding box
constexpr double kThinnest = 1e-3;            // half axis over the longest one, at least

SurfaceMesh meshForFloat(const SurfaceMesh& given) {
  if (given.faces.empty()) return given;
  const Bounds box = bounds(given);
  const SurfaceMesh mesh = evenTriangles(welded(given, 1e-9 * box.diagonal()));
  if (!openEdges(mesh).empty()) return mesh;  // WettedTriangles says where
  if (mesh.faces.size() > FloatHull::kMostTriangles)
    return thinned(mesh, FloatHull::kMostTriangles).mesh;
  if (mesh.faces.size() >= kEnoughTriangles) return mesh;
  return refined(mesh, kFloatEdge * (box.high - box.low).maxCoeff(), 4 * kEnoughTriangles).mesh;
}

struct PrincipalAxes {
  Vec3 moments = Vec3::Zero();
  Mat3 axes = Mat3::Identity();
};

// In a 6×6 matrix with nothing else.
PrincipalAxes principalOf(const Mat3& moments) {
  Mat6 whole = Mat6::Zero();
  whole.topLeftCorner<3, 3>() = moments / moments.trace();
  whole.bottomRightCorner<3, 3>() = -Mat3::Identity();  // before all others, apart from them
  const SymmetricEigen eigen = symmetricEigen(whole);
  PrincipalAxes result;
  result.moments = eigen.values.tail<3>() * moments.trace();
  result.axes = eigen.vectors.block<3, 3>(0, 3);
  if (result.axes.determinant() < 0.0) result.axes.col(2) *= -1.0;
  return result;
}

}  // namespace

FloatHull::FloatHull(const SurfaceMesh& mesh)
    : triangles_(meshForFloat(mesh), Vec3::Zero()), volume_(triangles_.volume()) {
  size_ = std::cbrt(volume_);
  const auto& points = triangles_.points();
  for (std::size_t i = 0; i < points.size(); ++i)
    reach_ = std::max(reach_, Vec3(points.x[i], points.y[i], points.z[i]).norm());
  const VolumeIntegrals whole = volumeIntegrals(mesh);
  const Vec3 centre = whole.centroid();
  const Mat3 moments = secondMoments(mesh) - whole.volume * centre * centre.transpose();
  const PrincipalAxes principal = principalOf(moments);
  axes_ = principal.axes;
  const Vec3 given = principal.moments.cwiseMax(0.0).cwiseSqrt();
  semiAxes_ = given.cwiseMax(kThinnest * given.maxCoeff());
  semiAxes_ *= std::cbrt(volume_ / (4.0 / 3.0 * kPi * semiAxes_.prod()));
  const EllipsoidMass water = ellipsoidMass(semiAxes_, 1.0);
  linear_ = axes_ * water.linear.asDiagonal() * axes_.transpose();
  angular_ = axes_ * water.angular.asDiagonal() * axes_.transpose();
  straining_ = water.straining;
  spread_ = water.linear.maxCoeff() - water.linear.minCoeff();
}

Vec3 FloatHull::strained(const Mat3& gradient) const noexcept {
  const Mat3 e = axes_.transpose() * gradient * axes_;
  return axes_ * straining_.cwiseProduct(Vec3(e(1, 2), e(2, 0), e(0, 1)));
}

}  // namespace cutwater
