#include "tests/files/MeshFiles.h"

#include <fmt/format.h>
#include <stdlib.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace cutwater::test {
namespace {

template <class T>
void append(std::string& out, T value) {
  char bytes[sizeof(T)];
  std::memcpy(bytes, &value, sizeof(T));
  out.append(bytes, sizeof(T));
}

void appendFloats(std::string& out, const Vec3& p) {
  for (int i = 0; i < 3; ++i) append(out, static_cast<float>(p[i]));
}

std::vector<std::array<int, 3>> triangles(const SurfaceMesh& mesh) {
  std::vector<std::array<int, 3>> out;
  for (const Face& f : mesh.faces)
    for (int i = 1; i + 1 < f.size(); ++i) out.push_back({f[0], f[i], f[i + 1]});
  return out;
}

const Vec3& at(const SurfaceMesh& mesh, int i) {
  return mesh.vertices[static_cast<std::size_t>(i)];
}

std::string numbers(const Vec3& p) {
  return fmt::format("{:.9g} {:.9g} {:.9g}", p.x(), p.y(), p.z());
}

std::string base64(const std::string& bytes) {
  constexpr char kLetters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned v = 0;
    for (std::size_t k = 0; k < 3; ++k)
      v = v << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k)
      out += i + k <= bytes.size() ? kLetters[v >> (18 - 6 * k) & 63u] : '=';
  }
  return out;
}

std::string gltfBuffer(const SurfaceMesh& mesh) {
  std::string bytes;
  for (const Vec3& p : mesh.vertices) appendFloats(bytes, 0.5 * p);
  for (const auto& t : triangles(mesh))
    for (int i : t) append(bytes, static_cast<std::uint32_t>(i));
  return bytes;
}

std::string gltfHead(const SurfaceMesh& mesh, const std::string& buffer) {
  Vec3 low = Vec3::Constant(1e9), high = -low;
  for (const Vec3& p : mesh.vertices) {
    low = low.cwiseMin(0.5 * p);
    high = high.cwiseMax(0.5 * p);
  }
  const std::size_t n = mesh.vertices.size(), m = triangles(mesh).size() * 3;
  return fmt::format(
      R"({{"asset":{{"version":"2.0"}},"scene":0,"scenes":[{{"nodes":[0]}}],)"
      R"("nodes":[{{"children":[1]}},{{"mesh":0,"scale":[2,2,2]}}],)"
      R"("meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}},"indices":1}}]}}],)"
      R"("buffers":[{{{}"byteLength":{}}}],"bufferViews":[{{"buffer":0,"byteLength":{}}},)"
      R"({{"buffer":0,"byteOffset":{},"byteLength":{}}}],"accessors":[{{"bufferView":0,)"
      R"("componentType":5126,"count":{},"type":"VEC3","min":[{},{},{}],"max":[{},{},{}]}},)"
      R"({{"bufferView":1,"componentType":5125,"count":{},"type":"SCALAR"}}]}})",
      buffer, 12 * n + 4 * m, 12 * n, 12 * n, 4 * m, n, low.x(), low.y(), low.z(), high.x(),
      high.y(), high.z(), m);
}

}  // namespace

TemporaryFolder::TemporaryFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "cutwater_XXXXXX").string();
  if (!mkdtemp(name.data())) throw std::runtime_error("no temporary folder");
  folder_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(folder_, ignored);
}

std::string TemporaryFolder::write(const std::string& file, const std::string& content) const {
  std::ofstream(path(file), std::ios::binary) << content;
  return path(file);
}

std::string objText(const SurfaceMesh& mesh) {
  std::string out;
  for (const Vec3& p : mesh.vertices) out += "v " + numbers(p) + "\n";
  for (const Face& f : mesh.faces) {
    out += "f";
    for (int i = 0; i < f.size(); ++i) out += fmt::format(" {}", f[i] + 1);
    out += "\n";
  }
  return out;
}

std::string stlText(const SurfaceMesh& mesh) {
  std::string out = "solid hull\n";
  for (const auto& t : triangles(mesh)) {
    out += "facet normal 0 0 0\nouter loop\n";
    for (int i : t) out += "vertex " + numbers(at(mesh, i)) + "\n";
    out += "endloop\nendfacet\n";
  }
  return out + "endsolid hull\n";
}

std::string stlBinary(const SurfaceMesh& mesh) {
  std::string out(80, ' ');
  append(out, static_cast<std::uint32_t>(triangles(mesh).size()));
  for (const auto& t : triangles(mesh)) {
    appendFloats(out, Vec3::Zero());
    for (int i : t) appendFloats(out, at(mesh, i));
    append(out, std::uint16_t{0});
  }
  return out;
}

std::string plyText(const SurfaceMesh& mesh) {
  std::string out = fmt::format(
      "ply\nformat ascii 1.0\nelement vertex {}\nproperty float x\nproperty float y\nproperty "
      "float z\nelement face {}\nproperty list uchar int vertex_indices\nend_header\n",
      mesh.vertices.size(), mesh.faces.size());
  for (const Vec3& p : mesh.vertices) out += numbers(p) + "\n";
  for (const Face& f : mesh.faces) {
    out += std::to_string(f.size());
    for (int i = 0; i < f.size(); ++i) out += fmt::format(" {}", f[i]);
    out += "\n";
  }
  return out;
}

std::string plyBinary(const SurfaceMesh& mesh) {
  std::string out = fmt::format(
      "ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty float x\nproperty float "
      "y\nproperty float z\nelement face {}\nproperty list uchar int vertex_indices\nend_header\n",
      mesh.vertices.size(), mesh.faces.size());
  for (const Vec3& p : mesh.vertices) appendFloats(out, p);
  for (const Face& f : mesh.faces) {
    append(out, static_cast<unsigned char>(f.size()));
    for (int i = 0; i < f.size(); ++i) append(out, std::int32_t{f[i]});
  }
  return out;
}

std::string offText(const SurfaceMesh& mesh) {
  std::string out = fmt::format("OFF\n{} {} 0\n", mesh.vertices.size(), mesh.faces.size());
  for (const Vec3& p : mesh.vertices) out += numbers(p) + "\n";
  for (const Face& f : mesh.faces) {
    out += std::to_string(f.size());
    for (int i = 0; i < f.size(); ++i) out += fmt::format(" {}", f[i]);
    out += "\n";
  }
  return out;
}

std::string gltfText(const SurfaceMesh& mesh) {
  return gltfHead(
      mesh, "\"uri\":\"data:application/octet-stream;base64," + base64(gltfBuffer(mesh)) + "\",");
}

std::string glb(const SurfaceMesh& mesh) {
  std::string head = gltfHead(mesh, ""), bytes = gltfBuffer(mesh);
  head.resize((head.size() + 3) / 4 * 4, ' ');
  bytes.resize((bytes.size() + 3) / 4 * 4, '\0');
  std::string out = "glTF";
  append(out, std::uint32_t{2});
  append(out, static_cast<std::uint32_t>(28 + head.size() + bytes.size()));
  append(out, static_cast<std::uint32_t>(head.size()));
  out += "JSON" + head;
  append(out, static_cast<std::uint32_t>(bytes.size()));
  return out + std::string("BIN\0", 4) + bytes;
}

std::string colladaText(const SurfaceMesh& mesh) {
  std::string points, counts, indices;
  for (const Vec3& p : mesh.vertices) points += numbers(p) + " ";
  for (const Face& f : mesh.faces) {
    counts += std::to_string(f.size()) + " ";
    for (int i = 0; i < f.size(); ++i) indices += std::to_string(f[i]) + " ";
  }
  return fmt::format(
      R"(<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" )"
      R"(version="1.4.1">)"
      R"(<asset><unit name="meter" meter="1"/><up_axis>Z_UP</up_axis></asset><library_geometries>)"
      R"(<geometry id="g"><mesh><source id="p"><float_array id="a" count="{}">{}</float_array>)"
      R"(<technique_common><accessor source="#a" count="{}" stride="3">)"
      R"(<param name="X" type="float"/><param name="Y" type="float"/>)"
      R"(<param name="Z" type="float"/></accessor></technique_common></source>)"
      R"(<vertices id="v"><input semantic="POSITION" source="#p"/></vertices><polylist count="{}">)"
      R"(<input semantic="VERTEX" source="#v" offset="0"/><vcount>{}</vcount><p>{}</p></polylist>)"
      R"(</mesh>)"
      R"(</geometry></library_geometries><library_visual_scenes><visual_scene id="s"><node id="n">)"
      R"(<instance_geometry url="#g"/></node></visual_scene></library_visual_scenes><scene>)"
      R"(<instance_visual_scene url="#s"/></scene></COLLADA>)",
      3 * mesh.vertices.size(), points, mesh.vertices.size(), mesh.faces.size(), counts, indices);
}

std::string gdfText(const SurfaceMesh& mesh, int isx, int isy, int perLine) {
  std::string out = fmt::format("a hull\n1.0 9.80665 ULEN GRAV\n{} {} ISX ISY\n{}\n", isx, isy,
                                mesh.faces.size());
  int written = 0;
  for (const Face& f : mesh.faces)
    for (int i = 0; i < 4; ++i)
      for (int k = 0; k < 3; ++k)
        out += fmt::format("{:.9g}{}", mesh.corner(f, std::min(i, f.size() - 1))[k],
                           ++written % perLine == 0 ? "\n" : " ");
  return out + "\n";
}

}  // namespace cutwater::test
