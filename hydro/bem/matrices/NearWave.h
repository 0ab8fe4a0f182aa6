#pragma once
#include <span>
#include <vector>

#include "hydro/base/Simd.h"
#include "hydro/geometry/panels/PanelQuadrature.h"
#include "hydro/green/RankineIntegrals.h"

namespace cutwater {

/// The singular part of the wave term over one source panel, seen from field point x; with
/// ρ = R₁ + |z + ζ|, R₁ the distance to the mirror image of x in z = 0. None depends on frequency.
/// THEORY.md, chapter 5.
struct NearImage {
  double log = 0.0;           ///< ∫ ln ρ dS [m² ln m]
  double inverse = 0.0;       ///< ∫ 1/R₁ dS [m]
  double inverseAlong = 0.0;  ///< ∫ e·∇_ξ (1/R₁) dS [–], e the direction of the derivative
  double distance = 0.0;      ///< R₁ of the centroid [m]
  double logAlong = 0.0;      ///< ∫ e_h·∇_ξ ln ρ dS [m], e_h the horizontal part of e
};

/// A source panel and its quarters, their quarters and so on with Gauss points on each, made when
/// first asked for: for many field points. One thread.
class QuarteredPanel {
 public:
  explicit QuarteredPanel(const Panel& panel);
  const Panel& panel() const { return panel_; }
  /// Adds `log` and `logAlong`, quartered until each part is smaller than its distance from the
  /// image of x, `depth` times at most; the 4 × 4 rule then leaves less than 1e-5 of a logarithm.
  void addLog(const Vec3& x, const Vec3& along, int depth, NearImage& sum);

 private:
  void makePoints();

  Panel panel_;
  double radius_;                           // centroid to the farthest corner [m]
  std::vector<double> x_, y_, z_, weight_;  // of the points
  std::vector<QuarteredPanel> quarters_;
};

/// Exact where x and the panel are both on z = 0; else `log` and `logAlong` by QuarteredPanel.
/// @param rankine of the same panel.  @param along e.
NearImage nearImage(const Vec3& x, QuarteredPanel& source, const RankinePanel& rankine,
                    const Vec3& along);

/// Wave part g = K F − 2πiK e^{−Y}J₀ of −4πG, integrated over a source panel.
struct WaveIntegral {
  Complex value;  ///< ∫ g dS [m]
  Complex along;  ///< ∫ e·∇_ξ g dS [–]
};

/// g and its derivatives at K·(horizontal distance) X and Y = −K(z + ζ).
struct WavePoint {
  WavePoint(double K, double X, double Y);
  Complex value;  ///< g [1/m]
  Complex slope;  ///< ∂g by the horizontal distance [1/m²]
  Complex rise;   ///< −∂g/∂ζ [1/m²]
};

/// Share w of −2/R₁ taken out of K F and integrated exactly: 0 in long waves, 1 in short ones. Half
/// at R = 4, where F + 2/R has become smooth on a panel as near as it is long.
/// @param perR 1/(K R₁) of the panel's centroid, a number or several.
template <typename Number>
CUTWATER_INLINE Number inverseShare(Number perR) {
  const Number square = 16.0 * perR * perR;
  return 1.0 / (1.0 + square * square);
}

/// What is left of the wave term without its singular part, over two panels: sums over the points
/// of both with their weights [m⁴] of
///   smooth F + 2 ln((R + Y)/2),  rest F + 2/R,  oscillation e^{−Y}J₀
/// and of their derivatives by K times the source point, `up` against z. One evaluation of the wave
/// term a pair of points serves both ways: it depends on the horizontal distance and on z + ζ only.
struct NearSums {
  struct Horizontal {
    double x = 0.0, y = 0.0;
  };
  double weights = 0.0;
  double smooth = 0.0, rest = 0.0, oscillation = 0.0;
  Horizontal smoothAlong, restAlong, oscillationAlong;
  double restUp = 0.0;

  /// @param mirrored  the field points at −y.  @param K [1/m].
  NearSums(std::span<const QuadraturePoint> field, bool mirrored,
           std::span<const QuadraturePoint> source, double K);
  /// Field and source exchanged.
  NearSums exchanged(bool mirrored) const;
};

/// Averaged over the field panel, with the singular part exact: the share w of −2/R₁, which is what
/// K F becomes in short waves, else −2 ln((R + Y)/2).
/// @param along  direction e of the derivative.  @param fieldArea of the points in `sums` [m²].
WaveIntegral nearWave(const NearSums& sums, double fieldArea, const NearImage& image,
                      const Vec3& along, double K);

}  // namespace cutwater
