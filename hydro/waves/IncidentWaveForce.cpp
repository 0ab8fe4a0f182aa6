#include "hydro/waves/IncidentWaveForce.h"

#include <algorithm>
#include <cmath>

#include "hydro/waves/PanelWave.h"

namespace cutwater {
namespace {

Vec3 mirrored(const Vec3& x) { return {x.x(), -x.y(), x.z()}; }

Panel mirrored(Panel panel) {
  std::reverse(panel.corner.begin(), panel.corner.begin() + panel.corners);
  for (Vec3& corner : panel.corner) corner = mirrored(corner);
  panel.centroid = mirrored(panel.centroid);
  panel.normal = mirrored(panel.normal);
  return panel;
}

/// κ of the wave's e^{κ·x}.
Eigen::Vector3cd exponent(const AiryWave& wave) {
  const double k = wave.waveNumber();
  return {Complex(0.0, -k * std::cos(wave.heading)), Complex(0.0, k * std::sin(wave.heading)), k};
}

/// ∫ e^{κ·x} n_j dS over one panel, n_4..6 = (r − r_G) × n.
CVec6 overPanel(const Panel& panel, const Eigen::Vector3cd& kappa, const Vec3& cog) {
  const PanelWave integral = panelWave(panel, kappa, Vec3(cog.x(), cog.y(), 0.0));
  const Vec3& n = panel.normal;
  const Eigen::Vector3cd arm = integral.moment + integral.sum * (panel.centroid - cog);
  CVec6 sum;
  sum.head<3>() = integral.sum * n;
  sum.tail<3>().real() = arm.real().cross(n);  // Eigen's cross of complex vectors is conjugated
  sum.tail<3>().imag() = arm.imag().cross(n);
  return sum;
}

}  // namespace

CVec6 froudeKrylovForce(const PanelMesh& mesh, const AiryWave& wave, const Vec3& cog,
                        double density) {
  const Eigen::Vector3cd kappa = exponent(wave);
  CVec6 sum = CVec6::Zero();
  for (const Panel& panel : mesh.panels) {
    sum += overPanel(panel, kappa, cog);
    if (mesh.symmetric) sum += overPanel(mirrored(panel), kappa, cog);
  }
  return -density * wave.gravity * sum;
}

IncidentVelocity incidentNormalVelocity(const PanelMesh& mesh, const AiryWave& wave,
                                        const Vec3& cog) {
  const Eigen::Vector3cd kappa = exponent(wave);
  const Vec3 origin(cog.x(), cog.y(), 0.0);
  const Complex amplitude(0.0, -wave.gravity / wave.omega);  // −∇φ_I = that times κ e^{κ·x}
  const auto mean = [&](const Panel& panel) {
    const Complex across = (kappa.transpose() * panel.normal).value();
    return amplitude * across * panelWave(panel, kappa, origin).sum / panel.area;
  };
  const auto count = static_cast<Eigen::Index>(mesh.panels.size());
  IncidentVelocity v{Eigen::VectorXcd(count), Eigen::VectorXcd(mesh.symmetric ? count : 0)};
  for (Eigen::Index i = 0; i < count; ++i) {
    const Panel& panel = mesh.panels[static_cast<std::size_t>(i)];
    const Complex port = mean(panel);
    v.even[i] = port;
    if (!mesh.symmetric) continue;
    const Complex starboard = mean(mirrored(panel));
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
