#pragma once
#include <array>
#include <vector>

#include "hydro/Conventions.h"

namespace cutwater {

/// Three or four corners, counter-clockwise seen from the water (normal out of the hull).
struct Face {
  std::array<int, 4> v{-1, -1, -1, -1};  ///< vertex indices; v[3] = −1 marks a triangle
  int size() const noexcept { return v[3] < 0 ? 3 : 4; }
};

/// Faces on shared vertices. Plain data: functions take a mesh and return a new one.
struct SurfaceMesh {
  std::vector<Vec3> vertices;  ///< [m]
  std::vector<Face> faces;
};

/// Vector area n·S of a face [m²]: exact also for a twisted quadrilateral (half the cross product of
/// its diagonals).
Vec3 vectorArea(const SurfaceMesh& mesh, const Face& face);

/// The same surface mirrored in the plane y = 0, faces turned so that normals stay outward.
SurfaceMesh mirroredInY(const SurfaceMesh& mesh);

/// Both meshes in one, vertices not merged.
SurfaceMesh joined(const SurfaceMesh& a, const SurfaceMesh& b);

/// Vertices closer than `tolerance` [m] made one; faces that collapse are dropped, quads that lose a
/// corner become triangles.
SurfaceMesh welded(const SurfaceMesh& mesh, double tolerance);

}  // namespace cutwater
