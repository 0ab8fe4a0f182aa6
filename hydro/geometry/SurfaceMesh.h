#pragma once
#include <Eigen/Geometry>  // cross products
#include <array>
#include <vector>

#include "hydro/Conventions.h"

namespace cutwater {

/// Three or four corners, counter-clockwise seen from the water (normal out of the hull).
struct Face {
  std::array<int, 4> v{-1, -1, -1, -1};  ///< vertex indices; v[3] = −1 marks a triangle
  int size() const noexcept { return v[3] < 0 ? 3 : 4; }
  /// Index of corner i = 0..size()−1.
  int operator[](int i) const noexcept { return v[static_cast<std::size_t>(i)]; }
};

/// Faces on shared vertices. Plain data: functions take a mesh and return a new one.
struct SurfaceMesh {
  std::vector<Vec3> vertices;  ///< [m]
  std::vector<Face> faces;
  /// Position [m] of corner i of a face.
  const Vec3& corner(const Face& face, int i) const {
    return vertices[static_cast<std::size_t>(face[i])];
  }
};

/// Vector area n·S of a face [m²]: exact also for a twisted quadrilateral (half the cross product
/// of its diagonals).
Vec3 vectorArea(const SurfaceMesh& mesh, const Face& face);

/// The same surface mirrored in the plane y = 0, faces turned so that normals stay outward.
SurfaceMesh mirroredInY(const SurfaceMesh& mesh);

/// Every face turned over.
SurfaceMesh turnedOver(const SurfaceMesh& mesh);

/// Each quadrilateral as two triangles: flat faces without the gaps that flattening a quadrilateral leaves.
/// Triangles of no area are left out.
SurfaceMesh triangulated(const SurfaceMesh& mesh);

/// Both meshes in one, a's faces first, vertices not merged.
SurfaceMesh joined(const SurfaceMesh& a, const SurfaceMesh& b);

/// A port half and its mirror image as one surface, port faces first; vertices nearer than 1e-9 of the
/// size, as on the centreplane, are shared.
SurfaceMesh bothHalves(const SurfaceMesh& port);

/// Vertices closer than `tolerance` [m] made one (the first of them stays where it is); faces that
/// collapse are dropped, quads that lose a corner become triangles, unused vertices go. The order
/// of faces and of the vertices that stay is kept. 0 merges only equal vertices. O(vertices).
/// @throws HydroError BadArgument if tolerance < 0, MeshNotFinite, MeshIndexOutOfRange.
SurfaceMesh welded(const SurfaceMesh& mesh, double tolerance);

/// Smallest and largest coordinates of the vertices [m]; zeros for a mesh without vertices.
struct Bounds {
  Vec3 low = Vec3::Zero(), high = Vec3::Zero();
  double diagonal() const { return (high - low).norm(); }
};
Bounds bounds(const SurfaceMesh& mesh);

/// An edge used by one face only, in that face's sense of rotation.
struct OpenEdge {
  int from, to, face;
};

/// Edges not matched by an opposite edge of another face: none for a closed, consistently oriented
/// surface. Order: by face. Vertices must be shared (welded).
std::vector<OpenEdge> openEdges(const SurfaceMesh& mesh);

}  // namespace cutwater
