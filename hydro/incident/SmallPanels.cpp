#include "hydro/incident/SmallPanels.h"

#include "hydro/base/SimdMath.h"
#include "hydro/geometry/panels/PanelQuadrature.h"

namespace cutwater {

namespace {

void set(double (&of)[3][4], std::size_t lane, const Vec3& v) {
  for (int i = 0; i < 3; ++i) of[i][lane] = v[i];
}

Eigen::Matrix3d spreadOf(const Panel& panel) {
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const QuadraturePoint& point : panelQuadrature(panel, 3)) {
    const Vec3 r = point.x - panel.centroid;
    spread += point.weight / panel.area * r * r.transpose();
  }
  return spread;
}

}  // namespace

SmallPanels::SmallPanels(const PanelMesh& mesh, const Vec3& cog)
    : fours_((mesh.panels.size() + 3) / 4), count_(mesh.panels.size()), symmetric_(mesh.symmetric) {
  for (std::size_t i = 0; i < count_; ++i) {
    const Panel& p = mesh.panels[i];
    Four& four = fours_[i / 4];
    const std::size_t lane = i % 4;
    set(four.centre, lane, p.centroid - Vec3(cog.x(), cog.y(), 0.0));
    set(four.normal, lane, p.normal);
    set(four.flux, lane, mesh.vectorArea(i) / p.area);
    set(four.arm, lane, p.centroid - cog);
    four.area[lane] = p.area;
    const Eigen::Matrix3d s = spreadOf(p);
    const double parts[6] = {s(0, 0), s(1, 1), s(2, 2), s(0, 1), s(0, 2), s(1, 2)};
    for (std::size_t j = 0; j < 6; ++j) four.spread[j][lane] = parts[j];
  }
}

SmallPanels::Wave SmallPanels::waveOf(const AiryWave& wave) {
  const Eigen::Vector3cd kappa = wave.exponent();
  return {kappa.x().imag(), kappa.y().imag(), kappa.z().real()};
}

/// The means of e^{κ·x} over four panels, and of (x − c) e^{κ·x}.
struct SmallPanels::Means {
  ComplexDouble4 mean, moment[3];
};

// With s = spread·κ:  mean = e^{κ·c}(1 + ½ κ·s),  moment = e^{κ·c} s.
CUTWATER_INLINE SmallPanels::Means SmallPanels::meansOf(const Four& p, const Wave& w) {
  const Double4 xx = load4(p.spread[0]), yy = load4(p.spread[1]), zz = load4(p.spread[2]);
  const Double4 xy = load4(p.spread[3]), xz = load4(p.spread[4]), yz = load4(p.spread[5]);
  const ComplexDouble4 exponent{w.kz * load4(p.centre[2]),
                                w.kx * load4(p.centre[0]) + w.ky * load4(p.centre[1])};
  const ComplexDouble4 at = exponential(exponent);
  const ComplexDouble4 s[3] = {{w.kz * xz, w.kx * xx + w.ky * xy},
                               {w.kz * yz, w.kx * xy + w.ky * yy},
                               {w.kz * zz, w.kx * xz + w.ky * yz}};
  const ComplexDouble4 bent{1.0 + 0.5 * (w.kz * s[2].re - w.kx * s[0].im - w.ky * s[1].im),
                            0.5 * (w.kx * s[0].re + w.ky * s[1].re + w.kz * s[2].im)};
  return {at * bent, {at * s[0], at * s[1], at * s[2]}};
}

CUTWATER_VECTOR std::array<double, 12> SmallPanels::forces(const std::vector<Four>& panels,
                                                           const Wave& wave) {
  Double4 re[6] = {}, im[6] = {};
  for (const Four& p : panels) {
    const Means m = meansOf(p, wave);
    const Double4 area = load4(p.area);
    const Double4 n[3] = {area * load4(p.normal[0]), area * load4(p.normal[1]),
                          area * load4(p.normal[2])};
    Double4 armRe[3], armIm[3];
    for (std::size_t i = 0; i < 3; ++i) {
      const Double4 arm = load4(p.arm[i]);
      armRe[i] = m.moment[i].re + m.mean.re * arm;
      armIm[i] = m.moment[i].im + m.mean.im * arm;
      re[i] += m.mean.re * n[i];
      im[i] += m.mean.im * n[i];
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      re[3 + i] += armRe[j] * n[k] - armRe[k] * n[j];
      im[3 + i] += armIm[j] * n[k] - armIm[k] * n[j];
    }
  }
  std::array<double, 12> sums;
  for (std::size_t j = 0; j < 6; ++j) {
    sums[j] = sumOf(re[j]);
    sums[6 + j] = sumOf(im[j]);
  }
  return sums;
}

CUTWATER_VECTOR void SmallPanels::velocities(const std::vector<Four>& panels, const Wave& wave,
                                             double* re, double* im) {
  for (const Four& p : panels) {
    const ComplexDouble4 across{wave.kz * load4(p.flux[2]),
                                wave.kx * load4(p.flux[0]) + wave.ky * load4(p.flux[1])};
    const ComplexDouble4 v = across * meansOf(p, wave).mean;
    store4(re, v.re);
    store4(im, v.im);
    re += 4;
    im += 4;
  }
}

// The starboard half in a wave is the image of the port half in the wave's image: k_y changes sign,
// and so do the modes 2, 4, 6 of its force.
CVec6 SmallPanels::froudeKrylovForce(const AiryWave& airy, double density) const {
  const Wave wave = waveOf(airy);
  const std::array<double, 12> port = forces(fours_, wave);
  std::array<double, 12> starboard{};
  if (symmetric_) starboard = forces(fours_, {wave.kx, -wave.ky, wave.kz});
  CVec6 force;
  for (std::size_t j = 0; j < 6; ++j) {
    const double sign = j % 2 == 0 ? 1.0 : -1.0;
    force[static_cast<int>(j)] =
        Complex(port[j] + sign * starboard[j], port[6 + j] + sign * starboard[6 + j]);
  }
  return -density * airy.gravity * force;
}

IncidentVelocity SmallPanels::incidentNormalVelocity(const AiryWave& airy) const {
  const Wave wave = waveOf(airy);
  const Complex amplitude(0.0, -airy.gravity / airy.omega);
  const auto padded = static_cast<Eigen::Index>(4 * fours_.size());
  const auto count = static_cast<Eigen::Index>(count_);
  const auto side = [&](double ky) {
    Eigen::VectorXd re(padded), im(padded);
    velocities(fours_, {wave.kx, ky, wave.kz}, re.data(), im.data());
    Eigen::VectorXcd v(count);
    v.real() = re.head(count);
    v.imag() = im.head(count);
    return Eigen::VectorXcd(amplitude * v);
  };
  const Eigen::VectorXcd port = side(wave.ky);
  if (!symmetric_) return {port, {}};
  const Eigen::VectorXcd starboard = side(-wave.ky);
  return {0.5 * (port + starboard), 0.5 * (port - starboard)};
}

}  // namespace cutwater
