#include "hydro/geometry/wetted/SymmetricTriangles.h"

#include <cmath>

namespace cutwater {

namespace {

constexpr double kFlat = 1e-12;  // twist of round-off

/// Of a quadrilateral: six times the volume of the tetrahedron of its corners, over the cube of its
/// diagonals' mean length.
double twist(const SurfaceMesh& mesh, const Face& face) {
  const Vec3 &a = mesh.corner(face, 0), &b = mesh.corner(face, 1), &c = mesh.corner(face, 2),
             &d = mesh.corner(face, 3);
  const double size = 0.5 * ((c - a).norm() + (d - b).norm());
  return std::abs((b - a).cross(c - a).dot(d - a)) / (size * size * size);
}

}  // namespace

SurfaceMesh symmetricTriangles(const SurfaceMesh& mesh) {
  SurfaceMesh result{mesh.vertices, {}};
  for (const Face& face : mesh.faces) {
    const auto& v = face.v;
    if (face.size() == 3) {
      result.faces.push_back(face);
    } else if (twist(mesh, face) > kFlat) {
      const int middle = static_cast<int>(result.vertices.size());
      result.vertices.push_back(meanCorner(mesh, face));
      for (std::size_t i = 0; i < 4; ++i)
        result.faces.push_back({{v[i], v[(i + 1) % 4], middle, -1}});
    } else {
      result.faces.push_back({{v[0], v[1], v[2], -1}});
      result.faces.push_back({{v[0], v[2], v[3], -1}});
    }
  }
  return result;
}

}  // namespace cutwater
