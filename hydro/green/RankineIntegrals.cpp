#include "hydro/green/RankineIntegrals.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <complex>
#include <string>

#include "hydro/Errors.h"
#include "hydro/base/SimdMath.h"

namespace cutwater {
namespace {

// Below this height, in radii, a point is in the plane: far above the round-off of a centroid
// computed by someone else, far below any distance that matters.
constexpr double kInPlane = 1e-10;

// The edges of a panel, one a lane. Coordinates s1 < s2 of their ends along the edge relative to
// the foot of x, distances r1, r2 of the ends from x, distance d of the foot from the edge's line.
struct Edges {
  Double4 s1, s2, r1, r2, d;
};

// ∫ dl/r along each edge, h² = the squared distance of x from its line. Each branch adds numbers of
// one sign, so nothing cancels near the edge or its extension.
CUTWATER_INLINE Double4 edgeIntegrals(const Edges& e, Double4 h2) {
  const auto ahead = e.s1 >= 0.0, behind = e.s2 <= 0.0;
  const Double4 above = ahead ? e.r2 + e.s2 : behind ? e.r1 - e.s1 : (e.r2 + e.s2) * (e.r1 - e.s1);
  const Double4 below = ahead ? e.r1 + e.s1 : behind ? e.r2 - e.s2 : h2;
  // A ratio of 1e26 makes L = 60; only points on the edge get there.
  const Double4 least = 1e-26 * above;
  return logarithm(above / (below > least ? below : least));
}

// std::complex's operator* looks for infinities; these numbers have none.
std::complex<double> product(std::complex<double> a, std::complex<double> b) {
  return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

// The product over all edges of (q2 + i d s2)(q1 − i d s1), q = h² + |z| r, whose argument is the
// solid angle [Wilton84]. Every q is positive, so it is smooth wherever the foot of x lies.
CUTWATER_INLINE std::complex<double> turn(const Edges& e, Double4 h2, double height, double scale,
                                          Bits4 isEdge) {
  const Double4 q1 = scale * (h2 + height * e.r1), q2 = scale * (h2 + height * e.r2);
  const Double4 i1 = scale * e.d * e.s1, i2 = scale * e.d * e.s2, zero = {};
  const Double4 re = isEdge ? q1 * q2 + i1 * i2 : zero + 1.0,
                im = isEdge ? i2 * q1 - q2 * i1 : zero;
  return product(product({re[0], im[0]}, {re[1], im[1]}), product({re[2], im[2]}, {re[3], im[3]}));
}

CUTWATER_INLINE double sum(Double4 x) { return (x[0] + x[1]) + (x[2] + x[3]); }

// The angle 0 ≤ |S| < 2π of the product over all edges: one arctangent for the panel. Off the plane
// 2π − |S| exceeds kInPlane, so a negative angle smaller than that is the round-off of 0.
double fullAngle(std::complex<double> turn) {
  const double angle = std::atan2(turn.imag(), turn.real());
  return angle < -0.01 * kInPlane ? angle + 2.0 * kPi : angle;
}

// Three-point Gauss rule on [0, 1]: exact to degree 5.
constexpr std::array<double, 3> kGaussPoint = {0.11270166537925831, 0.5, 0.88729833462074169};
constexpr std::array<double, 3> kGaussWeight = {5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0};

// Moments ∫ u^p v^q dS of degree 2, 3, 4, by falling power of u.
struct Moments {
  std::array<double, 3> second{};
  std::array<double, 4> third{};
  std::array<double, 5> fourth{};

  void add(double u, double v, double weight) {
    const double uu = u * u, uv = u * v, vv = v * v;
    const std::array<double, 3> two = {uu, uv, vv};
    const std::array<double, 4> three = {uu * u, uu * v, vv * u, vv * v};
    const std::array<double, 5> four = {uu * uu, uu * uv, uu * vv, uv * vv, vv * vv};
    for (std::size_t i = 0; i < 3; ++i) second[i] += weight * two[i];
    for (std::size_t i = 0; i < 4; ++i) third[i] += weight * three[i];
    for (std::size_t i = 0; i < 5; ++i) fourth[i] += weight * four[i];
  }
};

}  // namespace

RankinePanel::RankinePanel(std::span<const Vec3> corner) {
  if (corner.size() != 3 && corner.size() != 4) {
    throw HydroError(Fault::BadArgument, "RankinePanel: a panel has 3 or 4 corners, got " +
                                             std::to_string(corner.size()));
  }
  corners_ = static_cast<int>(corner.size());
  placeCorners(corner);
  measureEdges();
  takeMoments();
}

// Mean plane: the area vector is half the cross product of the diagonals, whether or not the
// corners are in one plane.
void RankinePanel::placeCorners(std::span<const Vec3> corner) {
  const std::size_t n = corner.size();
  const Vec3 diagonal = corner[2] - corner[0];
  const Vec3 other = n == 4 ? Vec3(corner[3] - corner[1]) : Vec3(corner[2] - corner[1]);
  const Vec3 areaVector = 0.5 * diagonal.cross(other);
  area_ = areaVector.norm();
  double longest = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    longest = std::max(longest, (corner[(i + 1) % n] - corner[i]).norm());
  }
  if (!(area_ > 1e-14 * longest * longest) || !std::isfinite(area_)) {
    throw HydroError(Fault::ValueOutOfRange, "RankinePanel: area is " + std::to_string(area_) +
                                                 " m² with a longest edge of " +
                                                 std::to_string(longest) + " m");
  }
  normal_ = areaVector / area_;
  const Vec3 inPlane = diagonal.norm() > other.norm() ? diagonal : other;
  u_ = (inPlane - inPlane.dot(normal_) * normal_).normalized();
  v_ = normal_.cross(u_);

  Vec3 origin = Vec3::Zero();
  for (const Vec3& c : corner) origin += c / static_cast<double>(n);
  for (std::size_t i = 0; i < n; ++i) {
    cornerU_[i] = u_.dot(corner[i] - origin);
    cornerV_[i] = v_.dot(corner[i] - origin);
  }
  double momentU = 0.0, momentV = 0.0;
  for (std::size_t i = 1; i + 1 < n; ++i) {
    fanArea_[i - 1] = (cornerU_[i] - cornerU_[0]) * (cornerV_[i + 1] - cornerV_[0]) -
                      (cornerU_[i + 1] - cornerU_[0]) * (cornerV_[i] - cornerV_[0]);
    momentU += fanArea_[i - 1] * (cornerU_[0] + cornerU_[i] + cornerU_[i + 1]) / 6.0;
    momentV += fanArea_[i - 1] * (cornerV_[0] + cornerV_[i] + cornerV_[i + 1]) / 6.0;
  }
  for (std::size_t i = 0; i < n; ++i) {
    cornerU_[i] -= momentU / area_;
    cornerV_[i] -= momentV / area_;
    radius_ = std::max(radius_, std::hypot(cornerU_[i], cornerV_[i]));
  }
  for (std::size_t i = n; i < 4; ++i) {  // a triangle's last edge has no length
    cornerU_[i] = cornerU_[0];
    cornerV_[i] = cornerV_[0];
  }
  scale_ = 1.0 / (radius_ * radius_);
  centroid_ = origin + (momentU / area_) * u_ + (momentV / area_) * v_;
}

void RankinePanel::measureEdges() {
  const auto n = static_cast<std::size_t>(corners_);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t next = (i + 1) % n;
    const double du = cornerU_[next] - cornerU_[i], dv = cornerV_[next] - cornerV_[i];
    length_[i] = std::hypot(du, dv);
    if (length_[i] <= 1e-14 * radius_) length_[i] = 0.0;  // a repeated corner: no edge
    if (length_[i] == 0.0) continue;
    tangentU_[i] = du / length_[i];
    tangentV_[i] = dv / length_[i];
  }
}

// ∫ 1/r dS = Σ_{p+q ≤ 4} (−1)^{p+q} M_pq /(p! q!) ∂_u^p ∂_v^q (1/r), M_10 = M_01 = 0 about the
// centroid. Written out by powers of 1/r the coefficients below are those of farAt.
void RankinePanel::takeMoments() {
  Moments m;
  for (std::size_t t = 0; t + 2 < static_cast<std::size_t>(corners_); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        // The square [0,1]² collapsed onto the triangle: area element 2A·a da db.
        const double a = kGaussPoint[i], b = kGaussPoint[j];
        const double w0 = 1.0 - a, w1 = a * (1.0 - b), w2 = a * b;
        m.add(w0 * cornerU_[0] + w1 * cornerU_[t + 1] + w2 * cornerU_[t + 2],
              w0 * cornerV_[0] + w1 * cornerV_[t + 1] + w2 * cornerV_[t + 2],
              kGaussWeight[i] * kGaussWeight[j] * fanArea_[t] * a);
      }
    }
  }
  const auto& [m20, m11, m02] = m.second;
  const auto& [m30, m21, m12, m03] = m.third;
  const auto& [m40, m31, m22, m13, m04] = m.fourth;
  c3_ = -0.5 * (m20 + m02);
  c5_ = 0.375 * (m40 + 2.0 * m22 + m04);
  linear5_ = {-1.5 * (m30 + m12), -1.5 * (m21 + m03)};
  quadratic5_ = {1.5 * m20, 3.0 * m11, 1.5 * m02};
  quadratic7_ = {-3.75 * (m40 + m22), -7.5 * (m31 + m13), -3.75 * (m22 + m04)};
  cubic7_ = {2.5 * m30, 7.5 * m21, 7.5 * m12, 2.5 * m03};
  quartic9_ = {4.375 * m40, 17.5 * m31, 26.25 * m22, 17.5 * m13, 4.375 * m04};
}

CUTWATER_VECTOR RankineIntegrals RankinePanel::exactAt(const Vec3& x) const noexcept {
  const Vec3 fromCentroid = x - centroid_;
  const double xu = u_.dot(fromCentroid), xv = v_.dot(fromCentroid);
  double z = normal_.dot(fromCentroid);
  const bool inPlane = std::abs(z) <= kInPlane * radius_;
  if (inPlane) z = 0.0;

  const Double4 au = load4(cornerU_.data()) - xu, av = load4(cornerV_.data()) - xv;
  const Double4 tangentU = load4(tangentU_.data()), tangentV = load4(tangentV_.data()),
                length = load4(length_.data());
  Edges e;
  e.r1 = squareRoot(au * au + av * av + z * z);
  e.r2 = Double4{e.r1[1], e.r1[2], e.r1[3], e.r1[0]};
  e.s1 = tangentU * au + tangentV * av;
  e.s2 = e.s1 + length;
  e.d = tangentV * au - tangentU * av;
  const Double4 h2 = e.d * e.d + z * z;
  const auto isEdge = length > 0.0;
  const Double4 integral = isEdge ? edgeIntegrals(e, h2) : length;
  double solidAngle = 0.0;
  if (!inPlane) solidAngle = std::copysign(fullAngle(turn(e, h2, std::abs(z), scale_, isEdge)), z);
  return {sum(e.d * integral) - z * solidAngle,
          -sum(tangentV * integral) * u_ + sum(tangentU * integral) * v_ - solidAngle * normal_,
          solidAngle};
}

namespace {

CUTWATER_INLINE double inverseRoot(double square) { return 1.0 / std::sqrt(square); }
CUTWATER_INLINE Double4 inverseRoot(Double4 square) {
  return 1.0 / Double4{std::sqrt(square[0]), std::sqrt(square[1]), std::sqrt(square[2]),
                       std::sqrt(square[3])};
}

}  // namespace

// potential = A/r + c3/r³ + a5(u,v)/r⁵ + a7(u,v)/r⁷ + a9(u,v)/r⁹, a_k polynomials in the plane.
template <typename Number>
CUTWATER_INLINE RankinePanel::FarSample<Number> RankinePanel::farSample(Number x, Number y,
                                                                        Number z) const noexcept {
  const Number u = u_.x() * x + u_.y() * y + u_.z() * z, v = v_.x() * x + v_.y() * y + v_.z() * z,
               height = normal_.x() * x + normal_.y() * y + normal_.z() * z;
  const Number i1 = inverseRoot(x * x + y * y + z * z), i2 = i1 * i1, i3 = i1 * i2, i5 = i3 * i2,
               i7 = i5 * i2, i9 = i7 * i2;

  const auto& [p5, q5, s5] = quadratic5_;
  const auto& [p7, q7, s7] = quadratic7_;
  const auto& [k30, k21, k12, k03] = cubic7_;
  const auto& [k40, k31, k22, k13, k04] = quartic9_;
  const Number a5 = c5_ + linear5_[0] * u + linear5_[1] * v + (p5 * u + q5 * v) * u + s5 * v * v;
  const Number a5u = linear5_[0] + 2.0 * p5 * u + q5 * v;
  const Number a5v = linear5_[1] + q5 * u + 2.0 * s5 * v;
  const Number uu = u * u, uv = u * v, vv = v * v;
  const Number a7 =
      p7 * uu + q7 * uv + s7 * vv + (k30 * u + k21 * v) * uu + (k12 * u + k03 * v) * vv;
  const Number a7u = 2.0 * p7 * u + q7 * v + 3.0 * k30 * uu + 2.0 * k21 * uv + k12 * vv;
  const Number a7v = q7 * u + 2.0 * s7 * v + k21 * uu + 2.0 * k12 * uv + 3.0 * k03 * vv;
  const Number a9 = (k40 * uu + k31 * uv + k22 * vv) * uu + (k13 * uv + k04 * vv) * vv;
  const Number a9u = (4.0 * k40 * u + 3.0 * k31 * v) * uu + (2.0 * k22 * u + k13 * v) * vv;
  const Number a9v = (k31 * u + 2.0 * k22 * v) * uu + (3.0 * k13 * u + 4.0 * k04 * v) * vv;

  const Number radial =
      -(area_ * i1 + 3.0 * c3_ * i3 + 5.0 * a5 * i5 + 7.0 * a7 * i7 + 9.0 * a9 * i9) * i2;
  const Number byU = a5u * i5 + a7u * i7 + a9u * i9, byV = a5v * i5 + a7v * i7 + a9v * i9;
  return {area_ * i1 + c3_ * i3 + a5 * i5 + a7 * i7 + a9 * i9,
          radial * x + byU * u_.x() + byV * v_.x(), radial * y + byU * u_.y() + byV * v_.y(),
          radial * z + byU * u_.z() + byV * v_.z(), -radial * height};
}

RankineIntegrals RankinePanel::farAt(const Vec3& x) const noexcept {
  const Vec3 d = x - centroid_;
  const FarSample<double> at = farSample(d.x(), d.y(), d.z());
  return {at.potential, {at.gradientX, at.gradientY, at.gradientZ}, at.doubleLayer};
}

CUTWATER_VECTOR RankinePanel::Integrals4 RankinePanel::farAt(const Points4& points) const noexcept {
  const FarSample<Double4> at =
      farSample(points.x - centroid_.x(), points.y - centroid_.y(), points.z - centroid_.z());
  return {at.potential, at.gradientX, at.gradientY, at.gradientZ, at.doubleLayer};
}

// ln ρ is the divergence of (½ ln ρ − ¼) times the vector from x, so each edge gives
// d ∫ (½ ln ρ − ¼) ds with ∫ ln ρ ds = s ln ρ − s + d atan(s/d).
double RankinePanel::logarithmInPlane(const Vec3& x) const noexcept {
  const double xu = u_.dot(x - centroid_), xv = v_.dot(x - centroid_);
  double sum = 0.0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(corners_); ++i) {
    const double au = cornerU_[i] - xu, av = cornerV_[i] - xv;
    const double d = tangentV_[i] * au - tangentU_[i] * av;
    if (d == 0.0) continue;  // x in line with the edge, or no edge: nothing
    const auto upTo = [d](double s) {
      return 0.25 * s * std::log(s * s + d * d) + 0.5 * d * std::atan(s / d) - 0.75 * s;
    };
    const double s1 = tangentU_[i] * au + tangentV_[i] * av;
    sum += d * (upTo(s1 + length_[i]) - upTo(s1));
  }
  return sum;
}

RankineIntegrals RankinePanel::at(const Vec3& x) const noexcept {
  const double far = kFarRatio * radius_;
  return (x - centroid_).squaredNorm() > far * far ? farAt(x) : exactAt(x);
}

RankineIntegrals rankineIntegrals(const Vec3& x, std::span<const Vec3> corner) {
  return RankinePanel(corner).at(x);
}

}  // namespace cutwater
