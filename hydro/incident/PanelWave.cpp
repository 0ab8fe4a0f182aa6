#include "hydro/incident/PanelWave.h"

#include <algorithm>
#include <cmath>

#include "hydro/base/SimdMath.h"
#include "hydro/geometry/panels/PanelQuadrature.h"

namespace cutwater {
namespace {

Complex dot(const Eigen::Vector3cd& a, const Vec3& b) {
  return a.x() * b.x() + a.y() * b.y() + a.z() * b.z();
}

PanelWave byPoints(const Panel& panel, const Eigen::Vector3cd& kappa, const Vec3& origin) {
  PanelWave wave{0.0, Eigen::Vector3cd::Zero()};
  for (const QuadraturePoint& point : panelQuadrature(panel, 3)) {
    const Complex e = point.weight * std::exp(dot(kappa, point.x - origin));
    wave.sum += e;
    wave.moment += e * (point.x - panel.centroid);
  }
  return wave;
}

/// e^{κ·(x − origin)} at the corners, a triangle's last one twice.
CUTWATER_VECTOR std::array<Complex, 4> atCorners(const Panel& panel, const Eigen::Vector3cd& kappa,
                                                 const Vec3& origin) {
  ComplexDouble4 z{};
  for (int i = 0; i < 4; ++i) {
    const Vec3 s = panel.corner[static_cast<std::size_t>(std::min(i, panel.corners - 1))] - origin;
    z.re[i] = kappa.x().real() * s.x() + kappa.y().real() * s.y() + kappa.z().real() * s.z();
    z.im[i] = kappa.x().imag() * s.x() + kappa.y().imag() * s.y() + kappa.z().imag() * s.z();
  }
  const ComplexDouble4 e = exponential(z);
  std::array<Complex, 4> value;
  for (int i = 0; i < 4; ++i) value[static_cast<std::size_t>(i)] = Complex(e.re[i], e.im[i]);
  return value;
}

/// ∫ e^{κ·x} dl along an edge and ∫ s e^{κ·x} dl, s from its middle along it; h = κ·(half the
/// edge), `from`, `to` and `middle` the values at its ends and half way.
struct EdgeWave {
  Complex sum, moment;
};
EdgeWave edgeWave(double length, Complex h, Complex from, Complex to, auto middle) {
  if (std::norm(h) > 1e-2) {
    const Complex perH = 0.5 * length / std::norm(h) * std::conj(h);
    const Complex sum = (to - from) * perH;
    return {sum, (0.5 * length * (to + from) - sum) * perH};
  }
  const Complex hh = h * h, at = length * middle();
  return {at * (1.0 + hh / 6.0 * (1.0 + hh / 20.0 * (1.0 + hh / 42.0))),
          0.5 * length * at * h / 3.0 * (1.0 + hh / 10.0 * (1.0 + hh / 28.0))};
}

}  // namespace

PanelWave panelWave(const Panel& panel, const Eigen::Vector3cd& kappa, const Vec3& origin) {
  const Eigen::Vector3cd inPlane = kappa - dot(kappa, panel.normal) * panel.normal.cast<Complex>();
  const double square = inPlane.squaredNorm();
  if (square * std::pow(diameter(panel), 2) < 0.05 * 0.05) return byPoints(panel, kappa, origin);

  const Eigen::Vector3cd a = inPlane.conjugate() / square;
  const auto n = static_cast<std::size_t>(panel.corners);
  const std::array<Complex, 4> at = atCorners(panel, kappa, origin);
  PanelWave wave{0.0, Eigen::Vector3cd::Zero()};
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3 &from = panel.corner[i], &to = panel.corner[(i + 1) % n];
    const double length = (to - from).norm();
    if (length == 0.0) continue;
    const Vec3 along = (to - from) / length, middle = 0.5 * (from + to);
    const Complex weight = dot(a, along.cross(panel.normal));
    const EdgeWave edge = edgeWave(length, 0.5 * length * dot(kappa, along), at[i], at[(i + 1) % n],
                                   [&] { return std::exp(dot(kappa, middle - origin)); });
    wave.sum += weight * edge.sum;
    wave.moment += weight * (edge.sum * (middle - panel.centroid) + edge.moment * along);
  }
  wave.moment -= a * wave.sum;
  return wave;
}

}  // namespace cutwater
