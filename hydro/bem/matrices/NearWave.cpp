#include "hydro/bem/matrices/NearWave.h"

#include <array>
#include <cmath>

#include "hydro/base/SimdMath.h"
#include "hydro/green/WaveTerm.h"

namespace cutwater {
namespace {

constexpr Complex kTwoPiI(0.0, 2.0 * kPi);
constexpr double kEulerGamma = std::numbers::egamma;

/// ln ρ and e_h·∇_ξ ln ρ = e_h·(ξ − x)_h / (R₁ρ) at points, times their weights.
struct Points {
  const double *x, *y, *z, *weight;
  std::size_t count;  // a multiple of four
};
CUTWATER_VECTOR void addLogs(const Vec3& x, const Vec3& along, const Points& points,
                             NearImage& sum) {
  Double4 log{}, logAlong{};
  for (std::size_t i = 0; i < points.count; i += 4) {
    const Double4 dx = load4(points.x + i) - x.x(), dy = load4(points.y + i) - x.y();
    const Double4 depth = -(x.z() + load4(points.z + i)), weight = load4(points.weight + i);
    const Double4 R1 = squareRoot(dx * dx + dy * dy + depth * depth), rho = R1 + depth;
    log += weight * logarithm(rho);
    logAlong += weight * (along.x() * dx + along.y() * dy) / (R1 * rho);
  }
  sum.log += sumOf(log);
  sum.logAlong += sumOf(logAlong);
}

}  // namespace

QuarteredPanel::QuarteredPanel(const Panel& panel) : panel_(panel), radius_(0.0) {
  for (const Vec3& corner : panel.corner)
    radius_ = std::max(radius_, (corner - panel.centroid).norm());
}

void QuarteredPanel::makePoints() {
  for (const auto& [at, share] : panelQuadrature(panel_, 4)) {
    x_.push_back(at.x());
    y_.push_back(at.y());
    z_.push_back(at.z());
    weight_.push_back(share);
  }
}

void QuarteredPanel::addLog(const Vec3& x, const Vec3& along, int depth, NearImage& sum) {
  const Vec3 image(x.x(), x.y(), -x.z());
  if (depth > 0 && (image - panel_.centroid).norm() < 2.0 * radius_) {
    if (quarters_.empty())
      for (const Panel& part : cutwater::quarters(panel_)) quarters_.emplace_back(part);
    for (QuarteredPanel& part : quarters_) part.addLog(x, along, depth - 1, sum);
    return;
  }
  if (x_.empty()) makePoints();
  addLogs(x, along, {x_.data(), y_.data(), z_.data(), weight_.data(), x_.size()}, sum);
}

NearImage nearImage(const Vec3& x, QuarteredPanel& source, const RankinePanel& rankine,
                    const Vec3& along) {
  const Panel& panel = source.panel();
  NearImage sum;
  const Vec3 image(x.x(), x.y(), -x.z());
  const RankineIntegrals integrals = rankine.at(image);
  sum.inverse = integrals.potential;
  sum.inverseAlong = -along.dot(integrals.gradient);
  sum.distance = (panel.centroid - image).norm();
  const double tiny = 1e-9 * rankine.radius();
  if (std::abs(x.z()) < tiny && std::abs(panel.centroid.z()) < tiny &&
      panel.normal.z() > 1 - 1e-12) {
    sum.log = rankine.logarithmInPlane(x);
    return sum;
  }
  constexpr int kDeepest = 5;
  source.addLog(x, along, kDeepest, sum);
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

/// Pairs of points whose wave terms are worked out together. Filled up to a multiple of four with
/// pairs of no weight.
struct Seen {
  static constexpr std::size_t kMost = 64;
  using Column = Column4<kMost>;
  std::size_t count = 0;
  Column weight, X, Y, R;
  Column dx, dy;  // K times the distance
  Column F, FX, J0, J1, Y0, Y1;

  CUTWATER_INLINE void put(double area, double x, double y, double depth) {
    weight[count] = area;
    dx[count] = x;
    dy[count] = y;
    Y[count++] = depth;
  }
  CUTWATER_INLINE void evaluate() {
    while (count % 4 != 0) put(0.0, 1.0, 0.0, 1.0);
    for (std::size_t i = 0; i < count; i += 4) {
      const Double4 hh = dx.load(i) * dx.load(i) + dy.load(i) * dy.load(i);
      const Double4 r = squareRoot(hh + Y.load(i) * Y.load(i));
      X.store(i, squareRoot(hh));
      R.store(i, r);
      Y.store(i, r > 0.0 ? Y.load(i) : r + 1.0);  // where R = 0 the wave term is not used
    }
    waveTerms(X.data(), Y.data(), count,
              {F.data(), FX.data(), J0.data(), J1.data(), Y0.data(), Y1.data()});
  }
};

/// NearSums, four at a time.
struct Sums4 {
  Double4 weights{}, smooth{}, rest{}, oscillation{};
  Double4 smoothX{}, smoothY{}, restX{}, restY{}, oscillationX{}, oscillationY{}, restUp{};

  /// Four pairs from i on.
  CUTWATER_INLINE void add(const Seen& seen, std::size_t i) {
    const Double4 weight = seen.weight.load(i), X = seen.X.load(i), Y = seen.Y.load(i);
    const Double4 F = seen.F.load(i), FX = seen.FX.load(i), zero = {};
    const auto apart = seen.R.load(i) > 0.0, beside = X > 0.0;
    const Double4 R = apart ? seen.R.load(i) : zero + 1.0;
    const Double4 towards = beside ? weight / X : zero;
    const Double4 perR = 1.0 / R, cube = perR * perR * perR, FY = -F - 2.0 * perR;
    const Double4 x = towards * seen.dx.load(i), y = towards * seen.dy.load(i);
    weights += weight;
    smooth += weight * (apart ? F + 2.0 * logarithm(0.5 * (R + Y)) : zero - 2.0 * kEulerGamma);
    rest += apart ? weight * (F + 2.0 * perR) : zero;
    oscillation += weight * (apart ? seen.J0.load(i) : zero + 1.0);
    const Double4 smoothSlope = FX + 2.0 * X * perR / (R + Y), restSlope = FX - 2.0 * X * cube;
    const Double4 oscillationSlope = seen.J1.load(i);
    smoothX += x * smoothSlope;
    smoothY += y * smoothSlope;
    restX += x * restSlope;
    restY += y * restSlope;
    oscillationX += x * oscillationSlope;
    oscillationY += y * oscillationSlope;
    restUp += apart ? weight * (FY - 2.0 * Y * cube) : zero;
  }
  CUTWATER_INLINE void addAll(Seen& seen) {
    seen.evaluate();
    for (std::size_t i = 0; i < seen.count; i += 4) add(seen, i);
    seen.count = 0;
  }
};

CUTWATER_VECTOR void addPairs(std::span<const QuadraturePoint> field, bool mirrored,
                              std::span<const QuadraturePoint> source, double K, NearSums& to) {
  Seen seen;
  Sums4 sums;
  const double side = mirrored ? -1.0 : 1.0;
  for (const QuadraturePoint& a : field)
    for (const QuadraturePoint& b : source) {
      seen.put(a.weight * b.weight, K * (b.x.x() - a.x.x()), K * (b.x.y() - side * a.x.y()),
               -K * (a.x.z() + b.x.z()));
      if (seen.count == Seen::kMost) sums.addAll(seen);
    }
  if (seen.count > 0) sums.addAll(seen);
  to.weights = sumOf(sums.weights);
  to.smooth = sumOf(sums.smooth);
  to.rest = sumOf(sums.rest);
  to.oscillation = sumOf(sums.oscillation);
  to.smoothAlong = {sumOf(sums.smoothX), sumOf(sums.smoothY)};
  to.restAlong = {sumOf(sums.restX), sumOf(sums.restY)};
  to.oscillationAlong = {sumOf(sums.oscillationX), sumOf(sums.oscillationY)};
  to.restUp = sumOf(sums.restUp);
}

}  // namespace

NearSums::NearSums(std::span<const QuadraturePoint> field, bool mirrored,
                   std::span<const QuadraturePoint> source, double K) {
  addPairs(field, mirrored, source, K, *this);
}

NearSums NearSums::exchanged(bool mirrored) const {
  const auto turned = [mirrored](const Horizontal& along) {
    return Horizontal{-along.x, mirrored ? along.y : -along.y};
  };
  NearSums back = *this;
  back.smoothAlong = turned(smoothAlong);
  back.restAlong = turned(restAlong);
  back.oscillationAlong = turned(oscillationAlong);
  return back;
}

WaveIntegral nearWave(const NearSums& sums, double fieldArea, const NearImage& image,
                      const Vec3& along, double K) {
  const double share = inverseShare(1.0 / (K * image.distance)), per = 1.0 / fieldArea;
  const auto towards = [&](const NearSums::Horizontal& d) {
    return per * (along.x() * d.x + along.y() * d.y);
  };
  const double value =
      K * (per * sums.smooth - 2.0 * (image.log + std::log(0.5 * K) * per * sums.weights));
  const double vertical = K * value + 2.0 * K * image.inverse;
  const double horizontal = K * K * towards(sums.smoothAlong) - 2.0 * K * image.logAlong;
  const double shortValue = K * per * sums.rest - 2.0 * image.inverse;
  const double shortAlong =
      K * K * (towards(sums.restAlong) - along.z() * per * sums.restUp) - 2.0 * image.inverseAlong;
  const double oscillation = per * sums.oscillation;
  return {std::lerp(value, shortValue, share) - kTwoPiI * K * oscillation,
          std::lerp(horizontal + along.z() * vertical, shortAlong, share) +
              kTwoPiI * K * K * (towards(sums.oscillationAlong) - along.z() * oscillation)};
}

}  // namespace cutwater
