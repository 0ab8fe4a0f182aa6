#pragma once
#include <utility>
#include <vector>

#include "hydro/geometry/panels/PanelMesh.h"

/// Points on panels at which a function is evaluated to integrate it.
namespace cutwater {

/// Gauss-Legendre rule on [0, 1]: nodes and weights, n = 1..16 points, exact for degree 2n − 1.
const std::vector<std::pair<double, double>>& gaussLegendre(int n);

/// A point on a panel and the area it stands for.
struct QuadraturePoint {
  Vec3 x;         ///< [m]
  double weight;  ///< [m²]; all weights of a panel sum to its area
};

/// n × n Gauss points on a flat quadrilateral by its bilinear map. A triangle is three
/// quadrilaterals about its centroid, so that the points do not depend on which corner is the
/// first.
std::vector<QuadraturePoint> panelQuadrature(const Panel& panel, int n);

/// Seven points that integrate polynomials of degree 5 on a parallelogram or triangle [Radon48].
/// Except on a square, they depend on which corner is the first.
std::vector<QuadraturePoint> sevenPoints(const Panel& panel);

/// ∫ (x − centroid)(x − centroid)ᵀ dS [m⁴].
Eigen::Matrix3d secondMoments(const Panel& panel);

/// The four quarters of a panel, cut at the mid-points of its edges.
std::array<Panel, 4> quarters(const Panel& panel);

}  // namespace cutwater
