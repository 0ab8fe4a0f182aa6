#include "hydro/bem/NearWave.h"

#include <array>
#include <cmath>

#include "hydro/green/WaveTerm.h"

namespace cutwater {
namespace {

constexpr Complex kTwoPiI(0.0, 2.0 * kPi);
constexpr double kEulerGamma = std::numbers::egamma;

/// ρ and e_h·∇_ξ ln ρ = e_h·(ξ − x)_h / (R₁ρ) at one point, times its weight.
void addLog(const Vec3& x, const Vec3& along, const QuadraturePoint& point, NearImage& sum) {
  const double dx = point.x.x() - x.x(), dy = point.x.y() - x.y();
  const double depth = -(x.z() + point.x.z());
  const double R1 = std::sqrt(dx * dx + dy * dy + depth * depth);
  const double rho = R1 + depth;
  sum.log += point.weight * std::log(rho);
  sum.logAlong += point.weight * (along.x() * dx + along.y() * dy) / (R1 * rho);
}

/// Quarters the panel until it is smaller than its distance from the image of x; the 4 × 4 rule
/// then leaves less than 1e-5 of a logarithm.
void addSubdivided(const Vec3& x, const Vec3& along, const Panel& source, int depth,
                   NearImage& sum) {
  const Vec3 image(x.x(), x.y(), -x.z());
  double radius = 0.0;
  for (const Vec3& corner : source.corner)
    radius = std::max(radius, (corner - source.centroid).norm());
  if (depth > 0 && (image - source.centroid).norm() < 2.0 * radius) {
    for (const Panel& part : quarters(source)) addSubdivided(x, along, part, depth - 1, sum);
    return;
  }
  for (const QuadraturePoint& point : panelQuadrature(source, 4)) addLog(x, along, point, sum);
}

}  // namespace

NearImage nearImage(const Vec3& x, const Panel& source, const RankinePanel& rankine,
                    const Vec3& along) {
  NearImage sum;
  const Vec3 image(x.x(), x.y(), -x.z());
  const RankineIntegrals integrals = rankine.at(image);
  sum.inverse = integrals.potential;
  sum.inverseAlong = -along.dot(integrals.gradient);
  sum.distance = (source.centroid - image).norm();
  const double tiny = 1e-9 * rankine.radius();
  if (std::abs(x.z()) < tiny && std::abs(source.centroid.z()) < tiny &&
      source.normal.z() > 1 - 1e-12) {
    sum.log = rankine.logarithmInPlane(x);
    return sum;
  }
  constexpr int kDeepest = 5;
  addSubdivided(x, along, source, kDeepest, sum);
  return sum;
}

WavePoint::WavePoint(double K, double X, double Y) {
  const WaveTerm w = waveTerm(X, Y);
  value = K * Complex(w.F, -2.0 * kPi * w.J0);
  slope = K * K * Complex(w.FX, 2.0 * kPi * w.J1);
  rise = K * K * Complex(w.FY, 2.0 * kPi * w.J0);
}

// With L = ln((R + Y)/2) = ln ρ + ln(K/2):  F = (F + 2L) − 2L and F_Y = −F − 2/R, so that
//   ∫ K F dS              = K Σ w (F + 2L) − 2K [∫ ln ρ dS + ln(K/2) ΔS]
//   ∫ ∂(K F)/∂ζ dS        = −K² ∫ F_Y dS = K ∫ K F dS + 2K ∫ 1/R₁ dS
//   ∫ e_h·∇(K F) dS       = K² Σ w (F_X + 2 L_X) e_h·d/|d| − 2K ∫ e_h·∇ ln ρ dS
// F + 2L is continuous with value −2γ at R = 0; F_X + 2L_X is bounded. Where R is large,
// F = −2/R − 2Y/R³ … and the logarithm would have to cancel; there
//   ∫ K F dS              = K Σ w (F + 2/R) − 2 ∫ 1/R₁ dS
//   ∫ e·∇(K F) dS         = Σ w e·∇(K F + 2/R₁) − 2 ∫ e·∇(1/R₁) dS,
// whose limit K → ∞ is the rest system with φ = 0 on z = 0, panel by panel.
namespace {

constexpr std::size_t kMost = 48;  // points of a triangle by three 4 × 4 rules

/// Where the points of the panel lie as seen from x, and the wave term there.
struct Seen {
  std::array<double, kMost> X{}, Y{}, R{}, towards{};
  std::array<double, kMost> F{}, FX{}, J0{}, J1{}, Y0{}, Y1{};

  Seen(const Vec3& x, const Vec3& along, std::span<const QuadraturePoint> points, double K) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vec3& at = points[i].x;
      const double dx = at.x() - x.x(), dy = at.y() - x.y(), depth = -(x.z() + at.z());
      const double hh = dx * dx + dy * dy, h = std::sqrt(hh);
      R[i] = K * std::sqrt(hh + depth * depth);
      X[i] = K * h;
      Y[i] = R[i] > 0.0 ? K * depth : 1.0;  // where R = 0 the wave term is not used
      towards[i] = h > 0.0 ? points[i].weight * (along.x() * dx + along.y() * dy) / h : 0.0;
    }
    waveTerms(X.data(), Y.data(), points.size(),
              {F.data(), FX.data(), J0.data(), J1.data(), Y0.data(), Y1.data()});
  }
};

}  // namespace

WaveIntegral nearWave(const Vec3& x, const NearImage& image, const Vec3& along,
                      std::span<const QuadraturePoint> points, double K) {
  double area = 0.0, smooth = 0.0, smoothHorizontal = 0.0, oscillation = 0.0, oscillationX = 0.0;
  double rest = 0.0, restAlong = 0.0;
  const double share = inverseShare(K * image.distance);
  const Seen seen(x, along, points, K);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double weight = points[i].weight, R = seen.R[i], X = seen.X[i], Y = seen.Y[i];
    area += weight;
    if (R == 0.0) {
      smooth += weight * -2.0 * kEulerGamma;
      oscillation += weight;
      continue;
    }
    const double perR = 1.0 / R, cube = perR * perR * perR;
    const double F = seen.F[i], FX = seen.FX[i], FY = -F - 2.0 * perR, towards = seen.towards[i];
    smooth += weight * (F + 2.0 * std::log(0.5 * (R + Y)));
    smoothHorizontal += towards * (FX + 2.0 * X * perR / (R + Y));
    rest += weight * (F + 2.0 * perR);
    restAlong += towards * (FX - 2.0 * X * cube) - weight * along.z() * (FY - 2.0 * Y * cube);
    oscillation += weight * seen.J0[i];
    oscillationX += towards * seen.J1[i];
  }
  const double value = K * (smooth - 2.0 * (image.log + std::log(0.5 * K) * area));
  const double vertical = K * value + 2.0 * K * image.inverse;
  const double horizontal = K * K * smoothHorizontal - 2.0 * K * image.logAlong;
  const double shortValue = K * rest - 2.0 * image.inverse;
  const double shortAlong = K * K * restAlong - 2.0 * image.inverseAlong;
  return {std::lerp(value, shortValue, share) - kTwoPiI * K * oscillation,
          std::lerp(horizontal + along.z() * vertical, shortAlong, share) +
              kTwoPiI * K * K * (oscillationX - along.z() * oscillation)};
}

}  // namespace cutwater
