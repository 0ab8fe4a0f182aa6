#pragma once
#include <array>
#include <string>
#include <vector>

#include "hydro/geometry/SurfaceMesh.h"

namespace cutwater::meshes {

/// A colour without texture.
struct Material {
  std::string name;
  std::array<double, 3> colour;  ///< linear red, green, blue, 0 to 1
  bool bothSides = false;        ///< drawn from both sides: plates without thickness
};

/// Faces of one material.
struct Surface {
  SurfaceMesh mesh;      ///< hull axes [m]: x forward, y port, z up
  std::size_t material;  ///< which of the model's
};

/// A node of the scene.
struct Part {
  std::string name;
  std::vector<Surface> surfaces;
};

struct Model {
  std::vector<Material> materials;
  std::vector<Part> parts;
};

/// The bytes of a binary glTF 2.0 file: y up, +z forward, hence +x to port, in metres. One node and
/// one mesh for each part, one primitive of triangles for each of its surfaces. Normals are left
/// out: readers then shade each face flat, as the format says.
std::string glb(const Model& model, const std::string& copyright);

}  // namespace cutwater::meshes
