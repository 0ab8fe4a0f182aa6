#pragma once
#include <array>
#include <span>

#include "hydro/Conventions.h"
#include "hydro/base/Simd.h"

namespace cutwater {

/// Integrals of 1/r over one flat panel, r = |x − ξ|, ξ on the panel.
/// THEORY.md, chapter 4.
struct RankineIntegrals {
  double potential = 0.0;        ///< ∫ 1/r dS [m]
  Vec3 gradient = Vec3::Zero();  ///< ∇_x ∫ 1/r dS [–]; in the panel no normal part
  double doubleLayer = 0.0;  ///< ∫ ∂/∂n_ξ (1/r) dS = −n·gradient [–]: the signed solid angle
};

/// A flat panel of 3 or 4 corners with all that does not depend on the field point.
///
/// Exact form, by Gauss's theorem in the plane of the panel [HessSmith67] [Wilton84]:
///     ∫ 1/r dS = Σ d_i L_i − z S,    ∇_x ∫ 1/r dS = −Σ m_i L_i − n S,    double layer = S
/// z height of x over the plane, m_i outward normal of edge i in the plane, d_i distance from the
/// foot of x to edge i along m_i, L_i = ∫ dl/r along the edge, S = ∫ z/r³ dS the solid angle:
/// positive on the side n points to, ±2π at the panel, 0 in its plane. Over a closed surface with
/// normals outwards the double layers add up to −4π inside, 0 outside, −2π on a panel (whose own
/// part is 0).
///
/// Field points may lie anywhere. Nearer to the plane than 1e-10 radius() they count as in it. On
/// an edge or corner, where the gradient is infinite, its part along m_i is cut off (L_i < 60).
///
/// Far form, beyond kFarRatio radii: moments about the centroid up to the fourth. Its error is
/// below 2e-7 of the potential and 1e-6 of |gradient|; it costs a third of the exact form, which
/// takes about 0.1 µs, and a tenth for four points at a time.
///
/// Immutable: any thread may read it. No allocation after construction.
class RankinePanel {
 public:
  /// Distance from the centroid, in radii, from which at() uses the far form.
  static constexpr double kFarRatio = 12.0;

  /// @param corner  3 or 4 points [m], counter-clockwise about n. Repeated points and an inward
  ///         corner are allowed; points off the mean plane are projected onto it along n.
  /// @throws HydroError BadArgument for another number of corners, ValueOutOfRange when the corners
  ///         span no area or are not finite.
  explicit RankinePanel(std::span<const Vec3> corner);

  /// The integrals at field point x [m], by the cheaper form that is accurate there.
  RankineIntegrals at(const Vec3& x) const noexcept;
  /// The exact form, whatever the distance.
  RankineIntegrals exactAt(const Vec3& x) const noexcept;
  /// The far form, whatever the distance. @pre x is not the centroid.
  RankineIntegrals farAt(const Vec3& x) const noexcept;

  /// The far form at four points.
  struct alignas(32) Points4 {
    Double4 x, y, z;
  };
  struct alignas(32) Integrals4 {
    Double4 potential, gradientX, gradientY, gradientZ, doubleLayer;
  };
  Integrals4 farAt(const Points4& points) const noexcept;

  /// ∫ ln ρ dS [m²], ρ [m] the distance on the panel from the foot of x: the logarithm that the
  /// wave term has where both points are on the free surface (see WaveTerm.h). Exact, anywhere.
  double logarithmInPlane(const Vec3& x) const noexcept;

  const Vec3& centroid() const { return centroid_; }  ///< of the area [m]
  const Vec3& normal() const { return normal_; }      ///< unit vector n
  double area() const { return area_; }               ///< [m²]
  double radius() const { return radius_; }           ///< greatest distance centroid to corner [m]

 private:
  // In the plane: axis u_, axis v_ = n × u, origin in the centroid. All arrays are per corner; edge
  // i runs from corner i to the next one.
  void placeCorners(std::span<const Vec3> corner);
  void measureEdges();
  void takeMoments();

  Vec3 centroid_, normal_, u_, v_;
  double area_ = 0.0, radius_ = 0.0, scale_ = 0.0;  // scale_ = 1/radius²
  int corners_ = 0;
  std::array<double, 4> cornerU_{}, cornerV_{};
  std::array<double, 4> tangentU_{}, tangentV_{}, length_{};
  std::array<double, 2> fanArea_{};  // twice the signed area of triangles 0-1-2 and 0-2-3
  template <typename Number>
  struct FarSample {
    Number potential, gradientX, gradientY, gradientZ, doubleLayer;
  };
  template <typename Number>
  FarSample<Number> farSample(Number x, Number y, Number z) const noexcept;

  // Coefficients of the far form; see farSample.
  double c3_ = 0.0, c5_ = 0.0;
  std::array<double, 2> linear5_{};
  std::array<double, 3> quadratic5_{}, quadratic7_{};
  std::array<double, 4> cubic7_{};
  std::array<double, 5> quartic9_{};
};

/// RankinePanel(corner).at(x), for a panel that is used once. Same arguments and faults.
RankineIntegrals rankineIntegrals(const Vec3& x, std::span<const Vec3> corner);

}  // namespace cutwater
