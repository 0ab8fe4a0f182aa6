#pragma once
#include <utility>
#include <vector>

#include "hydro/geometry/PanelMesh.h"

namespace cutwater {

/// Gauss-Legendre rule on [0, 1]: nodes and weights, n = 1..16 points, exact for degree 2n − 1.
const std::vector<std::pair<double, double>>& gaussLegendre(int n);

/// A point on a panel and the area it stands for.
struct QuadraturePoint {
  Vec3 x;         ///< [m]
  double weight;  ///< [m²]; all weights of a panel sum to its area
};

/// n × n Gauss points on a flat quadrilateral by its bilinear map; a triangle is three
/// quadrilaterals about its centroid, so that the points do not depend on which corner is the
/// first.
std::vector<QuadraturePoint> panelQuadrature(const Panel& panel, int n);

/// As few points as integrate polynomials of degree 3 or 5 on a parallelogram or triangle: 4 or 7.
/// They do not depend on which corner is the first, but of 7 on a square.
/// @param degree 3 (2 × 2 Gauss points; 7 on a triangle) or 5 (7: [Radon48]).
std::vector<QuadraturePoint> fewPoints(const Panel& panel, int degree);

/// The four quarters of a panel, cut at the mid-points of its edges.
std::array<Panel, 4> quarters(const Panel& panel);

}  // namespace cutwater
