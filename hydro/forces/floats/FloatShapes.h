#pragma once
#include <span>
#include <vector>

#include "hydro/geometry/SurfaceMesh.h"

/// Closed meshes of few triangles that enclose what they stand for, to round-off: the hulls of
/// small floating bodies. Lengths in one unit, normals out, vertices shared.
namespace cutwater {

/// A box about the origin; each side is divided in two to six, so that faces are about square.
SurfaceMesh floatBox(const Vec3& halfExtents);

/// A ball about the origin: 180 triangles of one size or nearly, moved out to the volume of the
/// ball.
SurfaceMesh floatBall(double radius);

/// What turns about z: the profile from its lower end to its upper end, both on the axis.
struct ProfilePoint {
  double radius, z;
};
/// @param sides  of each ring, ≥ 3.  @param volume  of the body meant: rings are moved out to it.
SurfaceMesh floatTurned(std::span<const ProfilePoint> profile, int sides, double volume);
/// Cylinder, capsule and cone along z about the middle of their height.
SurfaceMesh floatCylinder(double radius, double halfHeight);
/// @param halfHeight  of the part between the centres of both half balls.
SurfaceMesh floatCapsule(double radius, double halfHeight);
SurfaceMesh floatCone(double radius, double height);

/// ∫ r rᵀ dV of a closed surface about the origin.
Mat3 secondMoments(const SurfaceMesh& closed);

/// Share of the sum of volumes of closed convex meshes that lies in more than one of them: 0 if
/// none overlap. By a lattice of points in each, good to some percent of it.
double overlapOf(std::span<const SurfaceMesh> convex);

}  // namespace cutwater
