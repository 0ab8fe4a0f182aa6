#include "hydro/incident/LackingRestoring.h"

#include <Eigen/Cholesky>
#include <cmath>

#include "hydro/geometry/Hydrostatics.h"
#include "hydro/geometry/MeshCut.h"

namespace cutwater {

LackingRestoring::LackingRestoring(const SurfaceMesh& wet, const SurfaceMesh& hull,
                                   const Mat6& restoring, const Vec3& cog, double density,
                                   double gravity) {
  constexpr double kRoundOff = 1e-9, kSameShip = 1e-6;
  if (hull.faces.empty() || wet.faces.empty()) return;
  const auto stiffness = [&](const SurfaceMesh& mesh) {
    return hydrostatics(mesh, cog, density, gravity).restoring;
  };
  const Mat6 own = stiffness(wet);
  if ((restoring - stiffness(cutBelow(hull))).norm() > kSameShip * own.norm()) return;
  // Heave, roll and pitch of the plane a + b x + c y about G: (a, c, −b).
  Eigen::Matrix<double, 6, 3> difference;
  difference << (restoring - own).col(Heave), -(restoring - own).col(Pitch),
      (restoring - own).col(Roll);
  if (difference.norm() <= kRoundOff * own.norm()) return;

  // The waterplane is the hull seen from below: −n_z dS, one point a face.
  Eigen::Matrix3d gram = Eigen::Matrix3d::Zero();
  for (const Face& face : wet.faces) {
    Vec3 middle = Vec3::Zero();
    for (int i = 0; i < face.size(); ++i) middle += wet.corner(face, i) / face.size();
    const Point point{middle.x() - cog.x(), middle.y() - cog.y(), -vectorArea(wet, face).z()};
    if (point.area == 0.0) continue;
    const Vec3 terms(1.0, point.x, point.y);
    gram += point.area * terms * terms.transpose();
    points_.push_back(point);
  }
  difference_ = gram.ldlt().solve(difference.transpose()).transpose();
}

CVec6 LackingRestoring::force(const AiryWave& wave) const {
  const double k = wave.waveNumber();
  const double kx = k * std::cos(wave.heading), ky = k * std::sin(wave.heading);
  Eigen::Vector3cd fit = Eigen::Vector3cd::Zero();
  for (const Point& point : points_) {
    const double phase = ky * point.y - kx * point.x;
    const Complex water = point.area * Complex(std::cos(phase), std::sin(phase));
    fit += water * Eigen::Vector3d(1.0, point.x, point.y);
  }
  return difference_ * fit;
}

}  // namespace cutwater
