#pragma once
#include <Eigen/Geometry>  // cross products
#include <array>
#include <vector>

#include "hydro/Conventions.h"

/// A surface of triangles and quadrilaterals, and what can be done with it: mirror, turn, join,
/// merge vertices, look for open edges. A mesh is plain data; functions take one and return a new
/// one.
///     const SurfaceMesh whole = bothHalves(wetWigley(wigley(3), 40, 10));
///     const bool watertight = openEdges(whole).empty();
namespace cutwater {

/// Three or four corners, counter-clockwise seen from the water, so that the normal points out of
/// the hull.
struct Face {
  std::array<int, 4> v{-1, -1, -1, -1};  ///< vertex indices; v[3] = −1 marks a triangle
  int size() const noexcept { return v[3] < 0 ? 3 : 4; }
  /// Index of corner i = 0..size()−1.
  int operator[](int i) const noexcept { return v[static_cast<std::size_t>(i)]; }
};

/// Faces on shared vertices.
struct SurfaceMesh {
  std::vector<Vec3> vertices;  ///< [m]
  std::vector<Face> faces;
  /// Position [m] of corner i of a face.
  const Vec3& corner(const Face& face, int i) const {
    return vertices[static_cast<std::size_t>(face[i])];
  }
};

/// How the axes of the file that a mesh was read from lie in hull axes:
///     p in hull axes [m] = metresPerUnit · rotation · p in the file + origin
struct FilePlacement {
  Mat3 rotation = Mat3::Identity();  ///< its rows: forward, port and up in the file's axes
  double metresPerUnit = 1.0;        ///< [m] in one unit of the file
  Vec3 origin = Vec3::Zero();        ///< the file's origin in hull axes [m]
  Vec3 toHull(const Vec3& inFile) const { return metresPerUnit * (rotation * inFile) + origin; }
};

/// How the solver's panels stand to the faces of a mesh (panels/SolverPanels.h). A database holds
/// these numbers, so that its panels can be made again.
enum class PanelShape {
  FlattenedOnly = 0,  ///< flat, with the areas of the flattened panels; databases of 0.1.0
  MovedOnly = 1,      ///< all curved, waves meeting the moved panels' areas; databases of 0.1.0
  Flat = 2,           ///< flat, with the vector areas of the faces
  Curved = 3,         ///< moved out to the curved surface on which the vertices lie
  Auto = 4            ///< curved where the neighbours' normals bear the curved surface out
};

/// Vector area n·S of a face [m²]: half the cross product of its diagonals, exact for a twisted
/// quadrilateral too.
Vec3 vectorArea(const SurfaceMesh& mesh, const Face& face);
/// Mean of a face's corners.
Vec3 meanCorner(const SurfaceMesh& mesh, const Face& face);

/// The surface mirrored in the plane y = 0, with its faces turned so that normals stay outward.
SurfaceMesh mirroredInY(const SurfaceMesh& mesh);

/// The surface with every face turned over.
SurfaceMesh turnedOver(const SurfaceMesh& mesh);

/// Each quadrilateral as two triangles: flat faces without the gaps that flattening a quadrilateral
/// leaves. Triangles of no area are left out.
SurfaceMesh triangulated(const SurfaceMesh& mesh);

/// Both meshes in one, a's faces first. Vertices are not merged.
SurfaceMesh joined(const SurfaceMesh& a, const SurfaceMesh& b);

/// A port half and its mirror image as one surface, port faces first. Vertices nearer than 1e-9 of
/// the size, as on the centreplane, are shared.
SurfaceMesh bothHalves(const SurfaceMesh& port);

/// The mesh with vertices closer than `tolerance` [m] merged; the first of them stays where it is.
/// Faces that collapse are dropped, quadrilaterals that lose a corner become triangles, unused
/// vertices go. What stays keeps its order. 0 merges only equal vertices. O(vertices).
/// @throws HydroError BadArgument if tolerance < 0, MeshNotFinite, MeshIndexOutOfRange.
SurfaceMesh welded(const SurfaceMesh& mesh, double tolerance);

/// Smallest and largest coordinates of the vertices [m]; zeros for a mesh without vertices.
struct Bounds {
  Vec3 low = Vec3::Zero(), high = Vec3::Zero();
  double diagonal() const { return (high - low).norm(); }
};
Bounds bounds(const SurfaceMesh& mesh);

/// An edge used by one face only, from and to as that face runs along it.
struct OpenEdge {
  int from, to, face;
};

/// Edges without an opposite edge of another face, ordered by face. A closed surface whose faces
/// agree has none. @pre vertices are shared (welded).
std::vector<OpenEdge> openEdges(const SurfaceMesh& mesh);

}  // namespace cutwater
