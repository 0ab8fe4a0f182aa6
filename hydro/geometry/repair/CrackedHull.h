#pragma once
#include <string>

#include "hydro/geometry/Hull.h"

namespace cutwater {

/// A hull whose panels do not share all their edges, as panel methods take them.
struct CrackedHull {
  Hull hull;  ///< closed: of triangles that share their edges
  SurfaceMesh
      panels;  ///< the faces below water as they were drawn; the port half if hull.symmetric
  Vec3 volumes = Vec3::Zero();  ///< ∫ x n_x dS, ∫ y n_y dS, ∫ z n_z dS over them, both sides [m³]
  int looseEdges = 0;           ///< edges below water with one face
  double tolerance = 0.0;       ///< [m] up to which gaps were closed for `hull`
};

/// Takes faces with hanging nodes, T-junctions and gaps up to a thousandth of the length. The three
/// volumes agree if the faces close the body and are turned alike; that is asked for to 0.5 %.
/// @param name  of the file, for messages.
/// @throws HydroError as makeHull; HullNotClosed if wider gaps are left or the volumes differ.
CrackedHull crackedHull(const SurfaceMesh& raw, const std::string& name, Symmetry symmetry);

}  // namespace cutwater
