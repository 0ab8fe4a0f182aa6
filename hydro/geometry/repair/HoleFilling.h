#pragma once
#include <string>
#include <vector>

#include "hydro/geometry/SurfaceMesh.h"

namespace cutwater {

/// A hole that fillHoles closed.
struct FilledHole {
  Vec3 place = Vec3::Zero();  ///< mean of its rim [m]
  double width = 0.0;         ///< four times area over circumference [m]: of a disc its diameter
  bool keel = false;          ///< it is the slit between two halves that do not meet
  bool open = false;          ///< it is too wide, and still there
};

/// Closes the holes of a wet surface whose faces agree, and says which: loops of open edges, chains
/// of them that begin and end on calm water near one another, and pairs of such chains with their
/// ends together (the keel line of two halves). Each is covered by triangles on its own rim,
/// shortest connections first. Edges on z = 0 are the waterline and no hole.
/// @param widest  [m] a wider hole is refused.
/// @throws HydroError HullNotClosed, naming the place.
std::vector<FilledHole> fillHoles(SurfaceMesh& wet, double widest, const std::string& name);

/// The same; holes that are too wide stay open, and are among those that it tells of.
std::vector<FilledHole> fillNarrowHoles(SurfaceMesh& wet, double widest);

}  // namespace cutwater
