#include "hydro/geometry/panelling/PanelQuality.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace cutwater {

double aspectRatio(const SurfaceMesh& mesh, const Face& face) {
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  Vec3 first = Vec3::Zero();
  double area = 0.0;
  for (int i = 1; i + 1 < face.size(); ++i) {
    const Vec3 &a = mesh.corner(face, 0), &b = mesh.corner(face, i), &c = mesh.corner(face, i + 1);
    const double part = 0.5 * (b - a).cross(c - a).norm();
    area += part;
    for (const Vec3& middle : {Vec3(0.5 * (a + b)), Vec3(0.5 * (b + c)), Vec3(0.5 * (c + a))}) {
      first += part / 3 * middle;
      second += part / 3 * middle * middle.transpose();
    }
  }
  const Vec3 centre = first / area;
  second = second / area - centre * centre.transpose();
  const Vec3 moments = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(second).eigenvalues();
  return std::sqrt(moments[2] / std::max(moments[1], 1e-300));
}

double stretchedShare(const SurfaceMesh& panels) {
  const auto stretched =
      std::count_if(panels.faces.begin(), panels.faces.end(),
                    [&](const Face& f) { return aspectRatio(panels, f) > kStretched; });
  return static_cast<double>(stretched) / static_cast<double>(panels.faces.size());
}

}  // namespace cutwater
