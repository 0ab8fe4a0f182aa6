#include "hydro/forces/SmallPanels.h"

#include <cmath>

#include "hydro/geometry/PanelQuadrature.h"

namespace cutwater {

namespace {

SmallPanel starboard(SmallPanel p) {
  for (Vec3* v : {&p.centre, &p.normal, &p.arm}) v->y() = -v->y();
  for (const int i : {0, 2}) p.spread(i, 1) = p.spread(1, i) = -p.spread(i, 1);
  return p;
}

/// κ = k(−i cos β, i sin β, 1) and the mean of e^{κ·x} over a panel, and of (x − c) e^{κ·x}.
struct PlaneWave {
  Eigen::Vector3cd kappa;
  explicit PlaneWave(const AiryWave& wave) {
    const double k = wave.omega * wave.omega / wave.gravity;
    kappa = k * Eigen::Vector3cd(Complex(0.0, -std::cos(wave.heading)),
                                 Complex(0.0, std::sin(wave.heading)), 1.0);
  }
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
  for (const Panel& p : mesh.panels) {
    SmallPanel small{p.centroid - Vec3(cog.x(), cog.y(), 0.0), p.normal, p.area,
                     Eigen::Matrix3d::Zero(), p.centroid - cog};
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
  const PlaneWave e(wave);
  CVec6 sum = CVec6::Zero();
  const auto add = [&](const SmallPanel& p) {
    Eigen::Vector3cd arm;
    const Complex mean = e.mean(p, arm);
    arm += mean * p.arm;
    const Vec3& n = p.normal;
    sum.head<3>() += p.area * mean * n;
    sum[3] += p.area * (arm.y() * n.z() - arm.z() * n.y());
    sum[4] += p.area * (arm.z() * n.x() - arm.x() * n.z());
    sum[5] += p.area * (arm.x() * n.y() - arm.y() * n.x());
  };
  for (const SmallPanel& p : panels) {
    add(p);
    if (symmetric) add(starboard(p));
  }
  return -density * wave.gravity * sum;
}

IncidentVelocity incidentNormalVelocity(const std::vector<SmallPanel>& panels, const AiryWave& wave,
                                        bool symmetric) {
  const PlaneWave e(wave);
  const Complex amplitude(0.0, -wave.gravity / wave.omega);
  const auto count = static_cast<Eigen::Index>(panels.size());
  IncidentVelocity v{Eigen::VectorXcd(count), Eigen::VectorXcd(symmetric ? count : 0)};
  const auto mean = [&](const SmallPanel& p) {
    Eigen::Vector3cd unused;
    const Complex across =
        e.kappa.x() * p.normal.x() + e.kappa.y() * p.normal.y() + e.kappa.z() * p.normal.z();
    return amplitude * across * e.mean(p, unused);
  };
  for (Eigen::Index i = 0; i < count; ++i) {
    const SmallPanel& p = panels[static_cast<std::size_t>(i)];
    const Complex port = mean(p);
    v.even[i] = port;
    if (!symmetric) continue;
    const Complex other = mean(starboard(p));
    v.even[i] = 0.5 * (port + other);
    v.odd[i] = 0.5 * (port - other);
  }
  return v;
}

}  // namespace cutwater
