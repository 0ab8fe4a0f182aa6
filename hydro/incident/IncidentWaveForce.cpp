#include "hydro/incident/IncidentWaveForce.h"

#include <algorithm>
#include <cmath>

#include "hydro/incident/PanelWave.h"

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

/// Panel i or its mirror image.
Panel panelOf(const PanelMesh& mesh, std::size_t i, bool starboard) {
  return starboard ? mirrored(mesh.panels[i]) : mesh.panels[i];
}

/// n_1..6 times a function on one panel.
/// @param sum  its integral (or mean).  @param arm  that of (x − G) times it.
CVec6 timesNormal(Complex sum, const Eigen::Vector3cd& arm, const Vec3& n) {
  CVec6 result;
  result.head<3>() = sum * n;
  result.tail<3>().real() = arm.real().cross(n);  // Eigen's cross of complex vectors is conjugated
  result.tail<3>().imag() = arm.imag().cross(n);
  return result;
}

/// ∫ e^{κ·x} n_j dS over one panel, n_4..6 = (r − r_G) × n.
CVec6 overPanel(const Panel& panel, const Eigen::Vector3cd& kappa, const Vec3& cog) {
  const PanelWave integral = panelWave(panel, kappa, Vec3(cog.x(), cog.y(), 0.0));
  return timesNormal(integral.sum, integral.moment + integral.sum * (panel.centroid - cog),
                     panel.normal);
}

}  // namespace

// F_I = −ρg Σ ∫ e^{κ·x} n_j dS.
CVec6 froudeKrylovForce(const PanelMesh& mesh, const AiryWave& wave, const Vec3& cog,
                        double density) {
  const Eigen::Vector3cd kappa = wave.exponent();
  CVec6 sum = CVec6::Zero();
  for (std::size_t i = 0; i < mesh.panels.size(); ++i) {
    sum += overPanel(panelOf(mesh, i, false), kappa, cog);
    if (mesh.symmetric) sum += overPanel(panelOf(mesh, i, true), kappa, cog);
  }
  return -density * wave.gravity * sum;
}

IncidentVelocity incidentNormalVelocity(const PanelMesh& mesh, const AiryWave& wave,
                                        const Vec3& cog) {
  const Eigen::Vector3cd kappa = wave.exponent();
  const Vec3 origin(cog.x(), cog.y(), 0.0);
  const Complex amplitude(0.0, -wave.gravity / wave.omega);  // −∇φ_I = that times κ e^{κ·x}
  const auto mean = [&](std::size_t i, bool starboard) {
    const Panel panel = panelOf(mesh, i, starboard);
    const Vec3 area = starboard ? mirrored(mesh.vectorArea(i)) : mesh.vectorArea(i);
    const Complex across = (kappa.transpose() * area).value() / panel.area;
    return amplitude * across * panelWave(panel, kappa, origin).sum / panel.area;
  };
  const auto count = static_cast<Eigen::Index>(mesh.panels.size());
  IncidentVelocity v{Eigen::VectorXcd(count), Eigen::VectorXcd(mesh.symmetric ? count : 0)};
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto at = static_cast<std::size_t>(i);
    v.even[i] = mean(at, false);
    if (!mesh.symmetric) continue;
    const Complex port = v.even[i], starboard = mean(at, true);
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
