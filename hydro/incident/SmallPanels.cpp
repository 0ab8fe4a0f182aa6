#include "hydro/incident/SmallPanels.h"

#include <cmath>

#include "hydro/geometry/panels/PanelQuadrature.h"
#include "hydro/incident/PanelSums.h"

namespace cutwater {

namespace {

SmallPanel starboard(SmallPanel p) {
  for (Vec3* v : {&p.centre, &p.normal, &p.flux, &p.arm}) v->y() = -v->y();
  for (const int i : {0, 2}) p.spread(i, 1) = p.spread(1, i) = -p.spread(i, 1);
  return p;
}

/// The mean of e^{κ·x} over a panel, and of (x − c) e^{κ·x}.
struct PlaneWave {
  Eigen::Vector3cd kappa;
  Complex mean(const SmallPanel& p, Eigen::Vector3cd& moment) const {
    const double phase = kappa.x().imag() * p.centre.x() + kappa.y().imag() * p.centre.y();
    const Complex at =
        std::exp(kappa.z().real() * p.centre.z()) * Complex(std::cos(phase), std::sin(phase));
    const Eigen::Vector3cd bent = p.spread.cast<Complex>() * kappa;
    moment = at * bent;
    return at * (1.0 + 0.5 * (kappa.x() * bent.x() + kappa.y() * bent.y() + kappa.z() * bent.z()));
  }
};

}  // namespace

std::vector<SmallPanel> smallPanels(const PanelMesh& mesh, const Vec3& cog) {
  std::vector<SmallPanel> panels;
  for (std::size_t i = 0; i < mesh.panels.size(); ++i) {
    const Panel& p = mesh.panels[i];
    SmallPanel small{p.centroid - Vec3(cog.x(), cog.y(), 0.0),
                     p.normal,
                     mesh.vectorArea(i) / p.area,
                     p.area,
                     Eigen::Matrix3d::Zero(),
                     p.centroid - cog};
    for (const QuadraturePoint& point : panelQuadrature(p, 3)) {
      const Vec3 r = point.x - p.centroid;
      small.spread += point.weight / p.area * r * r.transpose();
    }
    panels.push_back(small);
  }
  return panels;
}

CVec6 froudeKrylovForce(const std::vector<SmallPanel>& panels, const AiryWave& wave, bool symmetric,
                        double density) {
  const PlaneWave e{wave.exponent()};
  const auto integral = [&](const SmallPanel& p) -> CVec6 {
    Eigen::Vector3cd arm;
    const Complex mean = e.mean(p, arm);
    return p.area * timesNormal(mean, arm + mean * p.arm, p.normal);
  };
  return froudeKrylovSum(panels.size(), symmetric, density, wave.gravity,
                         [&](std::size_t i, bool other) {
                           return integral(other ? starboard(panels[i]) : panels[i]);
                         });
}

IncidentVelocity incidentNormalVelocity(const std::vector<SmallPanel>& panels, const AiryWave& wave,
                                        bool symmetric) {
  const PlaneWave e{wave.exponent()};
  const Complex amplitude(0.0, -wave.gravity / wave.omega);
  const auto mean = [&](const SmallPanel& p) {
    Eigen::Vector3cd unused;
    const Complex across =
        e.kappa.x() * p.flux.x() + e.kappa.y() * p.flux.y() + e.kappa.z() * p.flux.z();
    return amplitude * across * e.mean(p, unused);
  };
  return normalVelocities(panels.size(), symmetric, [&](std::size_t i, bool other) {
    return mean(other ? starboard(panels[i]) : panels[i]);
  });
}

}  // namespace cutwater
