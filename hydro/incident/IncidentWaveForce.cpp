#include "hydro/incident/IncidentWaveForce.h"

#include <algorithm>
#include <cmath>

#include "hydro/incident/PanelSums.h"
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

/// ∫ e^{κ·x} n_j dS over one panel, n_4..6 = (r − r_G) × n.
CVec6 overPanel(const Panel& panel, const Eigen::Vector3cd& kappa, const Vec3& cog) {
  const PanelWave integral = panelWave(panel, kappa, Vec3(cog.x(), cog.y(), 0.0));
  return timesNormal(integral.sum, integral.moment + integral.sum * (panel.centroid - cog),
                     panel.normal);
}

}  // namespace

CVec6 froudeKrylovForce(const PanelMesh& mesh, const AiryWave& wave, const Vec3& cog,
                        double density) {
  const Eigen::Vector3cd kappa = wave.exponent();
  return froudeKrylovSum(mesh.panels.size(), mesh.symmetric, density, wave.gravity,
                         [&](std::size_t i, bool starboard) {
                           return overPanel(panelOf(mesh, i, starboard), kappa, cog);
                         });
}

IncidentVelocity incidentNormalVelocity(const PanelMesh& mesh, const AiryWave& wave,
                                        const Vec3& cog) {
  const Eigen::Vector3cd kappa = wave.exponent();
  const Vec3 origin(cog.x(), cog.y(), 0.0);
  const Complex amplitude(0.0, -wave.gravity / wave.omega);  // −∇φ_I = that times κ e^{κ·x}
  return normalVelocities(mesh.panels.size(), mesh.symmetric, [&](std::size_t i, bool starboard) {
    const Panel panel = panelOf(mesh, i, starboard);
    const Vec3 area = starboard ? mirrored(mesh.vectorArea(i)) : mesh.vectorArea(i);
    const Complex across = (kappa.transpose() * area).value() / panel.area;
    return amplitude * across * panelWave(panel, kappa, origin).sum / panel.area;
  });
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
