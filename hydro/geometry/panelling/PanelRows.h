#pragma once
#include <vector>

#include "hydro/geometry/panelling/SectionCurves.h"

/// Divides curves into panel edges, and lays panels between two rows of them.
namespace cutwater {

/// At which ends of a curve panels are closer together: down to 1 − c of the mean, as spacedAtStart
/// gives.
struct Crowding {
  bool start = false, end = false;
  double c = 0.6;
};

/// Places on a curve: both ends, each corner, and others between them.
struct Division {
  std::vector<double> place;  ///< from the start [m]
  std::vector<int> breaks;    ///< indices of both ends and of the corners
};
/// About `count` parts of a curve of this length.
/// @param corners  lengths from the start, rising [m].
Division divided(double length, const std::vector<double>& corners, double count,
                 const Crowding& crowding);

/// A row of panel corners.
struct PanelRow {
  std::vector<int> vertex;
  std::vector<int> breaks;  ///< indices into `vertex`: both ends and the knuckles
};

/// Adds the faces between two rows of a mesh: quadrilaterals where both rows have as many parts,
/// triangles between them where one has more. Rows with as many knuckles are joined knuckle to
/// knuckle. Normals along (a → b) × (along the rows).
void addPanelsBetween(const PanelRow& a, const PanelRow& b, SurfaceMesh& mesh);

/// The same with a parameter given for each vertex, rising along both rows: panels join vertices of
/// the same parameter.
void addPanelsBetween(const std::vector<int>& a, const std::vector<double>& parameterA,
                      const std::vector<int>& b, const std::vector<double>& parameterB,
                      SurfaceMesh& mesh);

}  // namespace cutwater
