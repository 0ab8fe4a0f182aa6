#include "hydro/waves/IncidentWaveForce.h"

#include <algorithm>
#include <cmath>

#include "hydro/geometry/PanelQuadrature.h"

namespace cutwater {
namespace {

Vec3 mirrored(const Vec3& x) { return {x.x(), -x.y(), x.z()}; }

/// n Gauss points leave 2^{2n}(n!)⁴κ^{2n}/((2n+1)(2n)!³) of the mean of e^{iκt} over [−1, 1]; at
/// each limit that is below 1e-7. Longer panels are quartered first.
int pointsFor(double halfPhase) {
  constexpr double kLimits[] = {0.0, 0.0, 0.05, 0.25, 0.6, 1.1, 1.8, 2.5, 3.2};
  int n = 2;
  while (n < 8 && halfPhase > kLimits[n]) ++n;
  return n;
}

/// Gauss points for a wave on a panel, quarters of it first where the wave is short; the weights add up
/// to the area.
void addPoints(const Panel& panel, double waveNumber, std::vector<QuadraturePoint>& points) {
  const double halfPhase = 0.5 * waveNumber * diameter(panel);
  if (halfPhase > 3.2) {
    for (const Panel& part : quarters(panel)) addPoints(part, waveNumber, points);
    return;
  }
  const auto own = panelQuadrature(panel, pointsFor(halfPhase));
  points.insert(points.end(), own.begin(), own.end());
}

std::vector<QuadraturePoint> pointsOn(const Panel& panel, double waveNumber) {
  std::vector<QuadraturePoint> points;
  addPoints(panel, waveNumber, points);
  return points;
}

/// ∫ e^{...} n_j dS over one panel and, if `both`, over its starboard image; r from G.
void addPanel(const Panel& panel, const AiryWave& wave, const Vec3& cog, bool both, CVec6& sum) {
  const Vec3 origin(cog.x(), cog.y(), 0.0);
  const auto add = [&](const Vec3& x, const Vec3& n, double weight) {
    const Complex e = weight * wave.shape(x - origin);
    sum.head<3>() += e * n;
    sum.tail<3>() += e * (x - cog).cross(n);
  };
  for (const QuadraturePoint& point : pointsOn(panel, wave.waveNumber())) {
    add(point.x, panel.normal, point.weight);
    if (both) add(mirrored(point.x), mirrored(panel.normal), point.weight);
  }
}

}  // namespace

CVec6 froudeKrylovForce(const PanelMesh& mesh, const AiryWave& wave, const Vec3& cog,
                        double density) {
  CVec6 sum = CVec6::Zero();
  for (const Panel& panel : mesh.panels) addPanel(panel, wave, cog, mesh.symmetric, sum);
  return -density * wave.gravity * sum;
}

IncidentVelocity incidentNormalVelocity(const PanelMesh& mesh, const AiryWave& wave,
                                        const Vec3& cog) {
  const Vec3 origin(cog.x(), cog.y(), 0.0);
  const auto velocity = [&](const Vec3& x, const Vec3& n) -> Complex {
    return -(wave.velocity(x - origin).transpose() * n).value();
  };
  const auto mean = [&](const Panel& panel, const std::vector<QuadraturePoint>& points, auto side) {
    Complex sum = 0.0;
    for (const QuadraturePoint& point : points)
      sum += point.weight / panel.area * velocity(side(point.x), side(panel.normal));
    return sum;
  };
  const auto itself = [](const Vec3& x) { return x; };
  const auto count = static_cast<Eigen::Index>(mesh.panels.size());
  IncidentVelocity v{Eigen::VectorXcd(count), Eigen::VectorXcd(mesh.symmetric ? count : 0)};
  for (Eigen::Index i = 0; i < count; ++i) {
    const Panel& panel = mesh.panels[static_cast<std::size_t>(i)];
    const auto points = pointsOn(panel, wave.waveNumber());
    const Complex port = mean(panel, points, itself);
    v.even[i] = port;
    if (!mesh.symmetric) continue;
    const Complex starboard = mean(panel, points, mirrored);
    v.even[i] = 0.5 * (port + starboard);
    v.odd[i] = 0.5 * (port - starboard);
  }
  return v;
}

CVec6 diffractionForce(const Eigen::Matrix<Complex, 6, Eigen::Dynamic>& adjoint,
                       const IncidentVelocity& v) {
  if (v.odd.size() == 0) return adjoint * v.even;
  CVec6 force;
  for (int mode = 0; mode < 6; ++mode)
    force[mode] = (2.0 * adjoint.row(mode) * (mode % 2 == 0 ? v.even : v.odd)).value();
  return force;
}

CVec6 diffractionForce(const Eigen::Matrix<Complex, 6, Eigen::Dynamic>& adjoint,
                       const PanelMesh& mesh, const AiryWave& wave, const Vec3& cog) {
  return diffractionForce(adjoint, incidentNormalVelocity(mesh, wave, cog));
}

}  // namespace cutwater
