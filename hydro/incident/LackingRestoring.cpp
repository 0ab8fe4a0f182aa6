#include "hydro/incident/LackingRestoring.h"

#include <Eigen/Cholesky>
#include <cmath>

#include "hydro/base/SimdMath.h"
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
  std::size_t count = 0;
  for (const Face& face : wet.faces) {
    const double area = -vectorArea(wet, face).z();
    if (area == 0.0) continue;
    const Vec3 middle = meanCorner(wet, face);
    const Vec3 terms(1.0, middle.x() - cog.x(), middle.y() - cog.y());
    gram += area * terms * terms.transpose();
    if (count % 4 == 0) points_.emplace_back();
    Four& four = points_.back();
    four.x[count % 4] = terms.y();
    four.y[count % 4] = terms.z();
    four.area[count++ % 4] = area;
  }
  difference_ = gram.ldlt().solve(difference.transpose()).transpose();
}

CUTWATER_VECTOR std::array<double, 6> LackingRestoring::sums(const std::vector<Four>& points,
                                                             double kx, double ky) {
  Double4 re[3] = {}, im[3] = {};
  for (const Four& four : points) {
    const Double4 x = load4(four.x), y = load4(four.y), area = load4(four.area);
    const SineCosine turn = sineCosine(ky * y - kx * x);
    const Double4 c = area * turn.cosine, s = area * turn.sine;
    re[0] += c;
    re[1] += c * x;
    re[2] += c * y;
    im[0] += s;
    im[1] += s * x;
    im[2] += s * y;
  }
  return {sumOf(re[0]), sumOf(re[1]), sumOf(re[2]), sumOf(im[0]), sumOf(im[1]), sumOf(im[2])};
}

CVec6 LackingRestoring::force(const AiryWave& wave) const {
  const double k = wave.waveNumber();
  const double kx = k * std::cos(wave.heading), ky = k * std::sin(wave.heading);
  const std::array<double, 6> parts = sums(points_, kx, ky);
  Eigen::Vector3cd fit;
  for (std::size_t i = 0; i < 3; ++i) fit[static_cast<int>(i)] = Complex(parts[i], parts[3 + i]);
  return difference_ * fit;
}

}  // namespace cutwater
