#include "hydro/bem/NearWave.h"

#include <array>
#include <cmath>

#include "hydro/VectorMath.h"
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

/// Where the points of the panel lie as seen from x, and the wave term there. Filled up to a multiple
/// of four with points of no weight.
struct Seen {
  struct alignas(32) Column : std::array<double, kMost> {
    CUTWATER_INLINE Four four(std::size_t i) const { return loadFour(data() + i); }
  };
  std::size_t count = 0;
  Column weight, X, Y, R;
  Column along;  // e_h·d, d the horizontal distance
  Column F, FX, J0, J1, Y0, Y1;

  CUTWATER_INLINE Seen(const Vec3& x, const Vec3& e, std::span<const QuadraturePoint> points,
                       double K) {
    for (const QuadraturePoint& point : points) {
      const double dx = point.x.x() - x.x(), dy = point.x.y() - x.y();
      put(point.weight, K * std::sqrt(dx * dx + dy * dy), -K * (x.z() + point.x.z()),
          e.x() * dx + e.y() * dy);
    }
    while (count % 4 != 0) put(0.0, 1.0, 1.0, 0.0);
    for (std::size_t i = 0; i < count; i += 4) {
      const Four r = squareRoot(X.four(i) * X.four(i) + Y.four(i) * Y.four(i));
      storeFour(&R[i], r);
      storeFour(&Y[i], r > 0.0 ? Y.four(i) : r + 1.0);  // where R = 0 the wave term is not used
    }
    waveTerms(X.data(), Y.data(), count,
              {F.data(), FX.data(), J0.data(), J1.data(), Y0.data(), Y1.data()});
  }

 private:
  CUTWATER_INLINE void put(double area, double horizontal, double depth, double towards) {
    weight[count] = area;
    X[count] = horizontal;
    Y[count] = depth;
    along[count++] = towards;
  }
};

/// Sums over the points, weight w.
struct Sums {
  Four area{}, smooth{}, smoothHorizontal{}, oscillation{}, oscillationX{}, rest{}, restAlong{};

  /// Four points from i on.  @param up  of the direction of the derivative.
  CUTWATER_INLINE void add(const Seen& seen, std::size_t i, double K, double up) {
    const Four weight = seen.weight.four(i), X = seen.X.four(i), Y = seen.Y.four(i);
    const Four F = seen.F.four(i), FX = seen.FX.four(i), zero = {};
    const auto apart = seen.R.four(i) > 0.0, beside = X > 0.0;
    const Four R = apart ? seen.R.four(i) : zero + 1.0;
    const Four towards = beside ? weight * K * seen.along.four(i) / X : zero;
    const Four perR = 1.0 / R, cube = perR * perR * perR, FY = -F - 2.0 * perR;
    area += weight;
    smooth += weight * (apart ? F + 2.0 * logarithm(0.5 * (R + Y)) : zero - 2.0 * kEulerGamma);
    smoothHorizontal += towards * (FX + 2.0 * X * perR / (R + Y));
    rest += apart ? weight * (F + 2.0 * perR) : zero;
    restAlong +=
        towards * (FX - 2.0 * X * cube) - (apart ? weight * up * (FY - 2.0 * Y * cube) : zero);
    oscillation += weight * (apart ? seen.J0.four(i) : zero + 1.0);
    oscillationX += towards * seen.J1.four(i);
  }
};

CUTWATER_INLINE double sum(Four x) { return (x[0] + x[1]) + (x[2] + x[3]); }

}  // namespace

CUTWATER_VECTOR WaveIntegral nearWave(const Vec3& x, const NearImage& image, const Vec3& along,
                                      std::span<const QuadraturePoint> points, double K) {
  const double share = inverseShare(1.0 / (K * image.distance));
  const Seen seen(x, along, points, K);
  Sums sums;
  for (std::size_t i = 0; i < seen.count; i += 4) sums.add(seen, i, K, along.z());
  const double value =
      K * (sum(sums.smooth) - 2.0 * (image.log + std::log(0.5 * K) * sum(sums.area)));
  const double vertical = K * value + 2.0 * K * image.inverse;
  const double horizontal = K * K * sum(sums.smoothHorizontal) - 2.0 * K * image.logAlong;
  const double shortValue = K * sum(sums.rest) - 2.0 * image.inverse;
  const double shortAlong = K * K * sum(sums.restAlong) - 2.0 * image.inverseAlong;
  const double oscillation = sum(sums.oscillation), oscillationX = sum(sums.oscillationX);
  return {std::lerp(value, shortValue, share) - kTwoPiI * K * oscillation,
          std::lerp(horizontal + along.z() * vertical, shortAlong, share) +
              kTwoPiI * K * K * (oscillationX - along.z() * oscillation)};
}

}  // namespace cutwater
