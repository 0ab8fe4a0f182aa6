#include "hydro/geometry/SurfaceMesh.h"

namespace cutwater {

Vec3 vectorArea(const SurfaceMesh& mesh, const Face& face) {
  const auto vertex = [&](int i) { return mesh.vertices[static_cast<std::size_t>(face.v[static_cast<std::size_t>(i)])]; };
  if (face.size() == 3) return 0.5 * (vertex(1) - vertex(0)).cross(vertex(2) - vertex(0));
  return 0.5 * (vertex(2) - vertex(0)).cross(vertex(3) - vertex(1));
}

}  // namespace cutwater
