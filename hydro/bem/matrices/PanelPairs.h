#pragma once
#include <array>
#include <vector>

#include "hydro/bem/matrices/PanelMoments.h"
#include "hydro/bem/settings/Formulation.h"
#include "hydro/geometry/panels/PanelMesh.h"
#include "hydro/geometry/panels/PanelQuadrature.h"

namespace cutwater {

/// G = kG [1/R + …].
inline constexpr double kG = -1.0 / (4.0 * kPi);

/// How the influence of panel on panel is integrated.
/// THEORY.md, chapter 5.
struct InfluenceSettings {
  Formulation formulation = Formulation::Potential;
  bool xDerivative = false;  ///< H as well; Formulation::Source only
  int sourcePoints = 0;      ///< of the wave term on a source panel: 1, 4, 9; 0: by the wave length
  int galerkinPoints = 4;    ///< of a field panel, over which its equation is averaged: 1, 4, 9
  int threads = 1;           ///< the result does not depend on it
};

/// Even or odd in y. The potentials of modes 1, 3, 5 are even, of 2, 4, 6 odd; a hull solved whole
/// has one system only, stored as Even.
enum class Parity { Even = 0, Odd = 1 };

/// A field panel, or its mirror image in y, and a source panel.
struct Pair {
  int field, source;
  bool mirrored;
};

/// The panels of hull and lid with what pairs of them need that does not depend on frequency: Gauss
/// points, sizes, and the direction of the normal derivative. Immutable; any thread may read.
class PanelPairs {
 public:
  static constexpr int kMostPoints = 4;  ///< per side of a panel
  /// Images nearer than this many panel diameters (the greater of both) take the split wave term.
  /// One point and second moments would be off by 1e-3 and more nearer than 1.5 in long waves, and
  /// nearer than 2.5 in waves that the panels just resolve.
  static constexpr double kNearRatio = 2.5;

  /// @throws HydroError BadArgument for points that are not 1, 4 or 9 (sourcePoints: or 0), or H
  /// asked of the potential formulation.
  PanelPairs(PanelMesh mesh, const InfluenceSettings& settings);

  const PanelMesh& mesh() const noexcept { return mesh_; }
  const InfluenceSettings& settings() const noexcept { return settings_; }
  int hull() const noexcept { return hull_; }  ///< n
  int all() const noexcept { return all_; }    ///< n + m
  int parities() const noexcept { return mesh_.symmetric ? 2 : 1; }
  bool isSource() const noexcept { return settings_.formulation == Formulation::Source; }
  const Panel& panel(int i) const { return panels_[static_cast<std::size_t>(i)]; }
  double size(int i) const { return size_[static_cast<std::size_t>(i)]; }

  const PanelMoments& moments(int i) const { return moments_[static_cast<std::size_t>(i)]; }

  /// n × n Gauss points of a panel, n = 1 … kMostPoints.
  const std::vector<QuadraturePoint>& points(int panel, int n) const {
    return points_[static_cast<std::size_t>(panel)][static_cast<std::size_t>(n - 1)];
  }
  /// The points over which the equation of a field panel is averaged.
  const std::vector<QuadraturePoint>& galerkin(int panel) const {
    return galerkin_ == 1 ? centroid_[static_cast<std::size_t>(panel)] : points(panel, galerkin_);
  }

  /// e, so that the derivative which the formulation needs is e·∇_ξ of a function of the horizontal
  /// distance and of z + ζ: the source's normal (potential), or the field's, the sign of whose
  /// horizontal part changes with the variable (source).
  Vec3 direction(const Pair& pair) const;

  /// The image of the field panel in z = 0 lies nearer than kNearRatio diameters; so does it seen
  /// the other way.
  bool isNear(const Pair& pair) const;

  /// Gauss points a side of `panel` for a wave seen from `from`, wave number K: as many as the
  /// wave length asks for, or as the settings say.
  int pointsPerSide(int from, int panel, double K) const;
  /// As few points as that takes on a panel of a near pair: 4, 7 or, at most, 9; on a triangle 7.
  const std::vector<QuadraturePoint>& fewPoints(int from, int panel, double K) const;
  /// The same for the average over a field panel: 1 for collocation, at most 2.
  int fieldPointsPerSide(const Pair& pair, double K) const;

 private:
  /// Half the panel in radians of the wave, and what of the wave is left there.
  struct WaveOn {
    double theta, size;
  };
  WaveOn waveOn(int from, int panel, double K) const;

  PanelMesh mesh_;
  InfluenceSettings settings_;
  int hull_, all_, galerkin_, fixedPoints_;
  std::vector<Panel> panels_;  // hull, then lid
  std::vector<double> size_;   // diameter of each panel [m]
  std::vector<double> top_;    // highest z of each panel [m]
  std::vector<PanelMoments> moments_;
  std::vector<std::array<std::vector<QuadraturePoint>, kMostPoints>> points_;
  // Seven points of each panel; and one, as a triangle's rule has three.
  std::vector<std::vector<QuadraturePoint>> seven_, centroid_;
};

inline Vec3 imageInY(const Vec3& x, bool mirrored) {
  return {x.x(), mirrored ? -x.y() : x.y(), x.z()};
}
inline Vec3 imageInZ(const Vec3& x) { return {x.x(), x.y(), -x.z()}; }

}  // namespace cutwater
