#pragma once
#include "hydro/geometry/SurfaceMesh.h"
#include "hydro/geometry/outer/WaterGrid.h"

namespace cutwater {

/// What holds a vertex of a dual surface.
struct VertexHold {
  int planes = 1;  ///< faces of so many directions meet there: 1 on a smooth surface, 2 on
                   ///< an edge, 3 at a corner
  Vec3 along = Vec3::Zero();  ///< of the edge, where planes = 2: unit
  bool onCentreplane = false,
       onWater = false;  ///< it lies on a boundary of the grid and stays there
};

/// The outer surface that a grid of water sees, as quadrilaterals: one for each crossing, a vertex
/// in each cell for each piece of surface in it, normals towards the water.
/// A vertex is where the planes of the faces met in its cell come nearest to one another, so that
/// sharp edges stay. Vertices in cells at the grid's first plane of y (of a half) lie on y = 0,
/// and those in cells at its last plane of z, if that is calm water, on z = 0.
/// A vertex minimises the sum of squares of its distances to the planes; in directions without a
/// plane it stays at the mean of the crossings [Ju02].
struct DualSurface {
  SurfaceMesh mesh;
  std::vector<VertexHold> hold;  ///< of each vertex
};

/// @param normals  unit normal of each face that the grid's crossings name, of either sense.
/// @param endsAtWater  the last plane of z is calm water.
DualSurface dualSurface(const WaterGrid& water, const std::vector<Vec3>& normals, bool endsAtWater);

}  // namespace cutwater
