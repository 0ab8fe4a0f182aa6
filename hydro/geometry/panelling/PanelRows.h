#pragma once
#include <vector>

#include "hydro/geometry/panelling/SectionCurves.h"

/// Curves divided into panel edges, and the panels between two of them; not installed.
namespace cutwater {

/// At which ends of a curve panels are closer together, down to 0.4 of the mean (spacedAtStart's
/// rule with c = 0.6) or to 1 − c for another c.
struct Crowding {
  bool start = false, end = false;
  double c = 0.6;
};

/// Places on a curve of this length: both ends, each corner, and between them about `count` parts in
/// all, `crowding` permitting.
struct Division {
  std::vector<double> place;  ///< from the start [m]
  std::vector<int> breaks;    ///< indices of both ends and of the corners
};
Division divided(double length, const std::vector<double>& corners, double count,
                 const Crowding& crowding);

/// A row of panel corners.
struct PanelRow {
  std::vector<int> vertex;
  std::vector<int> breaks;  ///< indices into `vertex`: both ends and the knuckles
};

/// Faces between two rows of a mesh: quadrilaterals where parts are as many, triangles between them
/// where one row has more. Between rows with as many knuckles these are joined. Normals along
/// (a → b) × (along the rows).
void addPanelsBetween(const PanelRow& a, const PanelRow& b, SurfaceMesh& mesh);

/// The same with a parameter given for each vertex, rising along both rows: panels join what has the
/// same parameter.
void addPanelsBetween(const std::vector<int>& a, const std::vector<double>& parameterA,
                      const std::vector<int>& b, const std::vector<double>& parameterB,
                      SurfaceMesh& mesh);

}  // namespace cutwater
