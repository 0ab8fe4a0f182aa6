#include "demos/make_meshes/Glb.h"

#include <fmt/format.h>

#include <bit>
#include <cstdint>

#include "hydro/Errors.h"

namespace cutwater::meshes {
namespace {

static_assert(std::endian::native == std::endian::little, "glTF is little-endian");

// Numbers of the format.
constexpr std::uint32_t kMagic = 0x46546C67, kJsonChunk = 0x4E4F534A, kBinaryChunk = 0x004E4942;
constexpr int kFloat = 5126, kUnsignedShort = 5123, kVertices = 34962, kIndices = 34963;
constexpr std::size_t kMostVertices = 65535;

template <class T>
void put(std::string& bytes, T value) {
  const auto raw = std::bit_cast<std::array<char, sizeof(T)>>(value);
  bytes.append(raw.begin(), raw.end());
}

void padTo4(std::string& bytes, char with) {
  while (bytes.size() % 4 != 0) bytes += with;
}

void add(std::string& list, const std::string& item) {
  if (!list.empty()) list += ",\n";
  list += item;
}

/// Collects buffer, views and accessors.
struct Builder {
  std::string binary, views, accessors;
  int count = 0;  ///< of accessors, each with a view of its own

  int addAccessor(std::size_t start, int target, const std::string& rest) {
    add(views, fmt::format(R"({{"buffer":0,"byteOffset":{},"byteLength":{},"target":{}}})", start,
                           binary.size() - start, target));
    add(accessors, fmt::format(R"({{"bufferView":{},{}}})", count, rest));
    padTo4(binary, '\0');
    return count++;
  }

  int addPositions(const SurfaceMesh& mesh) {
    const std::size_t start = binary.size();
    SurfaceMesh stored;
    for (const Vec3& p : mesh.vertices) {
      for (const double value : {p.y(), p.z(), p.x()})
        put(binary, static_cast<float>(value == 0.0 ? 0.0 : value));  // no −0
      stored.vertices.push_back(Vec3(p.y(), p.z(), p.x()).cast<float>().cast<double>());
    }
    const Bounds box = bounds(stored);
    const auto text = [](const Vec3& p) {
      return fmt::format("[{:.9g},{:.9g},{:.9g}]", p.x() + 0.0, p.y() + 0.0, p.z() + 0.0);
    };
    return addAccessor(start, kVertices,
                       fmt::format(R"("componentType":{},"count":{},"type":"VEC3",)"
                                   R"("min":{},"max":{})",
                                   kFloat, mesh.vertices.size(), text(box.low), text(box.high)));
  }

  int addIndices(const SurfaceMesh& triangles) {
    const std::size_t start = binary.size();
    for (const Face& face : triangles.faces)
      for (int i = 0; i < 3; ++i) put(binary, static_cast<std::uint16_t>(face[i]));
    return addAccessor(start, kIndices,
                       fmt::format(R"("componentType":{},"count":{},"type":"SCALAR")",
                                   kUnsignedShort, 3 * triangles.faces.size()));
  }

  std::string primitive(const Surface& surface) {
    const SurfaceMesh triangles = triangulated(surface.mesh);
    if (triangles.vertices.size() > kMostVertices)
      throw HydroError(Fault::BadArgument, "glb: a surface of more than 65535 vertices");
    const int positions = addPositions(triangles), indices = addIndices(triangles);
    return fmt::format(R"({{"attributes":{{"POSITION":{}}},"indices":{},"material":{}}})",
                       positions, indices, surface.material);
  }
};

std::string materialText(const Material& m) {
  return fmt::format(
      R"({{"name":"{}","doubleSided":{},"pbrMetallicRoughness":)"
      R"({{"baseColorFactor":[{},{},{},1],"metallicFactor":0,"roughnessFactor":0.6}}}})",
      m.name, m.bothSides, m.colour[0], m.colour[1], m.colour[2]);
}

std::string container(std::string json, std::string binary) {
  padTo4(json, ' ');
  padTo4(binary, '\0');
  std::string bytes;
  const auto size = [](const std::string& s) { return static_cast<std::uint32_t>(s.size()); };
  put(bytes, kMagic);
  put(bytes, std::uint32_t{2});  // version
  put(bytes, 12 + 8 + size(json) + 8 + size(binary));
  put(bytes, size(json));
  put(bytes, kJsonChunk);
  bytes += json;
  put(bytes, size(binary));
  put(bytes, kBinaryChunk);
  bytes += binary;
  return bytes;
}

}  // namespace

std::string glb(const Model& model, const std::string& copyright) {
  Builder builder;
  std::string materials, meshes, nodes, scene;
  for (const Material& m : model.materials) add(materials, materialText(m));
  for (std::size_t i = 0; i < model.parts.size(); ++i) {
    const Part& part = model.parts[i];
    std::string primitives;
    for (const Surface& surface : part.surfaces) add(primitives, builder.primitive(surface));
    add(meshes, fmt::format(R"({{"name":"{}","primitives":[{}]}})", part.name, primitives));
    add(nodes, fmt::format(R"({{"name":"{}","mesh":{}}})", part.name, i));
    add(scene, std::to_string(i));
  }
  const std::string json = fmt::format(
      R"({{"asset":{{"version":"2.0","generator":"make_meshes","copyright":"{}"}},)"
      R"("scene":0,"scenes":[{{"nodes":[{}]}}],"nodes":[{}],"materials":[{}],"meshes":[{}],)"
      R"("accessors":[{}],"bufferViews":[{}],"buffers":[{{"byteLength":{}}}]}})",
      copyright, scene, nodes, materials, meshes, builder.accessors, builder.views,
      (builder.binary.size() + 3) / 4 * 4);
  return container(json, builder.binary);
}

}  // namespace cutwater::meshes
