#include "tests/support/Meshes.h"

#include <algorithm>
#include <random>
#include <set>

namespace cutwater::test {
namespace {

using Corners = std::vector<std::array<double, 3>>;

/// Each face from its least corner on, sorted.
std::vector<Corners> sortedFaces(const SurfaceMesh& mesh) {
  std::vector<Corners> all;
  for (const Face& f : mesh.faces) {
    Corners& face = all.emplace_back();
    for (int i = 0; i < f.size(); ++i) {
      const Vec3& p = mesh.corner(f, i);
      face.push_back({p.x(), p.y(), p.z()});
    }
    std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
  }
  std::sort(all.begin(), all.end());
  return all;
}

}  // namespace

SurfaceMesh cubes(const std::vector<std::array<int, 3>>& cells) {
  const std::set<std::array<int, 3>> body(cells.begin(), cells.end());
  SurfaceMesh mesh;
  for (const std::array<int, 3>& cell : body)
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const int side : {0, 1}) {
        std::array<int, 3> beside = cell;
        beside[axis] += side == 0 ? -1 : 1;
        if (body.contains(beside)) continue;
        Vec3 corner(cell[0], cell[1], cell[2]), u = Vec3::Zero(), v = Vec3::Zero();
        corner[static_cast<int>(axis)] += side;
        u[static_cast<int>((axis + 1) % 3)] = 1.0;
        v[static_cast<int>((axis + 2) % 3)] = 1.0;
        if (side == 0) std::swap(u, v);
        const int first = static_cast<int>(mesh.vertices.size());
        for (const Vec3& p : {corner, Vec3(corner + u), Vec3(corner + u + v), Vec3(corner + v)})
          mesh.vertices.push_back(p);
        mesh.faces.push_back({{first, first + 1, first + 2, first + 3}});
      }
  return welded(mesh, 0.0);
}

std::vector<std::array<int, 3>> cells(const std::array<int, 3>& low,
                                      const std::array<int, 3>& high) {
  std::vector<std::array<int, 3>> all;
  for (int x = low[0]; x < high[0]; ++x)
    for (int y = low[1]; y < high[1]; ++y)
      for (int z = low[2]; z < high[2]; ++z) all.push_back({x, y, z});
  return all;
}

SurfaceMesh openOnWater(SurfaceMesh mesh) {
  std::erase_if(mesh.faces, [&](const Face& f) {
    for (int i = 0; i < f.size(); ++i)
      if (mesh.corner(f, i).z() != 0.0) return false;
    return true;
  });
  return welded(mesh, 0.0);
}

SurfaceMesh shuffled(SurfaceMesh mesh) {
  std::mt19937 random(7);
  std::shuffle(mesh.faces.begin(), mesh.faces.end(), random);
  for (Face& f : mesh.faces) std::rotate(f.v.begin(), f.v.begin() + 1, f.v.begin() + f.size());
  return mesh;
}

bool sameFaces(const SurfaceMesh& a, const SurfaceMesh& b) {
  return sortedFaces(a) == sortedFaces(b);
}

Vec3 vectorAreaOf(const SurfaceMesh& mesh) {
  Vec3 sum = Vec3::Zero();
  for (const Face& f : mesh.faces) sum += vectorArea(mesh, f);
  return sum;
}

int openEdgesBelowWater(const SurfaceMesh& mesh) {
  const std::vector<OpenEdge> edges = openEdges(mesh);
  return static_cast<int>(std::count_if(edges.begin(), edges.end(), [&](const OpenEdge& e) {
    return mesh.vertices[static_cast<std::size_t>(e.from)].z() != 0.0 ||
           mesh.vertices[static_cast<std::size_t>(e.to)].z() != 0.0;
  }));
}

}  // namespace cutwater::test
