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

/// n × n Gauss points on a flat panel by its bilinear map; a triangle is the quadrilateral whose
/// last two corners coincide. Exact for polynomials of degree 2n − 2 in x on parallelograms.
std::vector<QuadraturePoint> panelQuadrature(const Panel& panel, int n);

/// n × n points on each triangle (apex, edge) of a convex panel, dense at `apex`, a point of the
/// panel: the area element cancels a 1/r there, and a logarithm costs one order.
std::vector<QuadraturePoint> polarQuadrature(const Panel& panel, const Vec3& apex, int n);

/// The four quarters of a panel: corners, edge mid-points and the image of the map's centre.
std::array<Panel, 4> quarters(const Panel& panel);

}  // namespace cutwater
