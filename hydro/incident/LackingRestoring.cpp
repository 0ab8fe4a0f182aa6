#include "hydro/incident/LackingRestoring.h"

#include <Eigen/Cholesky>
#include <cmath>

#include "hydro/geometry/Hydrostatics.h"

namespace cutwater {

LackingRestoring::LackingRestoring(const SurfaceMesh& wet, const Hull& hull, const Mat6& restoring,
                                   const Vec3& cog, double density, double gravity) {
  constexpr double kRoundOff = 1e-9, kSameShip = 1e-6;
  if (hull.surface.faces.empty() || wet.faces.empty()) return;
  const Hydrostatics panels = hydrostatics(wet, cog, density, gravity);
  const double size = panels.restoring.norm();
  if ((restoring - panels.restoring).norm() <= kRoundOff * size) return;
  const Hydrostatics whole = hydrostatics(displacingSurface(hull), cog, density, gravity);
  if ((restoring - whole.restoring).norm() > kSameShip * size) return;

  // Heave, roll and pitch of the plane a + b x + c y about G: (a, c, −b).
  const Mat6 lacking = restoring - panels.restoring;
  Eigen::Matrix<double, 6, 3> difference;
  difference << lacking.col(Heave), -lacking.col(Pitch), lacking.col(Roll);
  const double weight = gravity * (whole.displacement - panels.displacement);
  difference(Surge, 1) -= weight;
  difference(Sway, 2) -= weight;
  // C46 and C56 are −ρgV(x_B − x_G) and −ρgV(y_B − y_G).
  difference(Yaw, 2) += lacking(Roll, Yaw);
  difference(Yaw, 1) -= lacking(Pitch, Yaw);

  // The waterplane is the hull seen from below: −n_z dS, one point a face.
  Eigen::Matrix3d gram = Eigen::Matrix3d::Zero();
  for (const Face& face : wet.faces) {
    const Vec3 middle = meanCorner(wet, face);
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
