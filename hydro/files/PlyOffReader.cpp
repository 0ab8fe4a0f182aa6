#include "hydro/files/PlyOffReader.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "hydro/files/Polygons.h"
#include "hydro/files/TextScanner.h"

namespace cutwater {
namespace {

void addVertex(SurfaceMesh& mesh, const Vec3& p, const TextScanner& text) {
  if (!p.allFinite())
    text.fail("vertex " + std::to_string(mesh.vertices.size()) + " is (" + std::to_string(p.x()) +
                  ", " + std::to_string(p.y()) + ", " + std::to_string(p.z()) + ")",
              Fault::MeshNotFinite);
  mesh.vertices.push_back(p);
}

void addFace(SurfaceMesh& mesh, const std::vector<double>& corners, int face,
             const TextScanner& text) {
  std::vector<int> indices;
  for (const double v : corners) {
    if (!(v >= 0 && v < static_cast<double>(mesh.vertices.size())) || v != std::floor(v))
      text.fail("face " + std::to_string(face) + " names vertex " + std::to_string(v) + " of " +
                    std::to_string(mesh.vertices.size()),
                Fault::MeshIndexOutOfRange);
    indices.push_back(static_cast<int>(v));
  }
  addPolygon(mesh, indices);
}

struct Property {
  std::string name, type, countType;  ///< countType is empty unless it is a list
};

struct Element {
  std::string name;
  int count = 0;
  std::vector<Property> properties;
};

/// Where the values of a PLY file come from: words or bytes.
class PlyValues {
 public:
  PlyValues(TextScanner& text, const std::string& format)
      : text_(text), ascii_(format == "ascii"), bytes_(text.rest()) {
    const bool big = format == "binary_big_endian";
    if (!ascii_ && !big && format != "binary_little_endian")
      text.fail("format '" + format.substr(0, 40) + "' is none of PLY's");
    swap_ = big != (std::endian::native == std::endian::big);
  }

  double next(const std::string& type) {
    if (ascii_) return text_.next("its last element");
    if (type == "char" || type == "int8") return take<std::int8_t>();
    if (type == "uchar" || type == "uint8") return take<std::uint8_t>();
    if (type == "short" || type == "int16") return take<std::int16_t>();
    if (type == "ushort" || type == "uint16") return take<std::uint16_t>();
    if (type == "int" || type == "int32") return take<std::int32_t>();
    if (type == "uint" || type == "uint32") return take<std::uint32_t>();
    if (type == "float" || type == "float32") return static_cast<double>(take<float>());
    if (type == "double" || type == "float64") return take<double>();
    text_.fail("type '" + type.substr(0, 40) + "' is none of PLY's");
  }

 private:
  template <class T>
  T take() {
    if (bytes_.size() < sizeof(T)) text_.fail("the file ends before its last element");
    char raw[sizeof(T)];
    std::memcpy(raw, bytes_.data(), sizeof(T));
    if (swap_) std::reverse(std::begin(raw), std::end(raw));
    bytes_.remove_prefix(sizeof(T));
    T value;
    std::memcpy(&value, raw, sizeof(T));
    return value;
  }

  TextScanner& text_;
  bool ascii_, swap_ = false;
  std::string_view bytes_;
};

/// Reads up to end_header; `format` is set.
std::vector<Element> plyHeader(TextScanner& text, std::string& format, double fileSize) {
  if (!text.nextLine() || text.wordInLine() != "ply") text.fail("does not begin with 'ply'");
  std::vector<Element> elements;
  while (text.nextLine()) {
    const std::string key = text.wordInLine();
    if (key == "end_header") return elements;
    if (key == "format") format = text.wordInLine();
    if (key == "element") {
      Element& e = elements.emplace_back();
      e.name = text.wordInLine();
      e.count = text.nextCount(e.name.substr(0, 40).c_str(), fileSize);
    }
    if (key == "property") {
      if (elements.empty()) text.fail("a property before any element");
      Property p;
      p.type = text.wordInLine();
      if (p.type == "list") {
        p.countType = text.wordInLine();
        p.type = text.wordInLine();
      }
      p.name = text.wordInLine();
      if (p.name.empty()) text.fail("a property without type or name");
      elements.back().properties.push_back(p);
    }
  }
  text.fail("the file ends before end_header");
}

void readElement(const Element& e, int number, PlyValues& values, const TextScanner& text,
                 SurfaceMesh& mesh) {
  Vec3 point = Vec3::Constant(std::nan(""));
  std::vector<double> corners;
  for (const Property& p : e.properties) {
    if (p.countType.empty()) {
      const double value = values.next(p.type);
      if (p.name == "x" || p.name == "y" || p.name == "z") point[p.name[0] - 'x'] = value;
      continue;
    }
    const double count = values.next(p.countType);
    if (!(count >= 0 && count <= kMostCorners))
      text.fail(e.name.substr(0, 40) + " " + std::to_string(number) + " has a list of " +
                std::to_string(count));
    std::vector<double> list;
    for (int i = 0; i < static_cast<int>(count); ++i) list.push_back(values.next(p.type));
    if (p.name == "vertex_indices" || p.name == "vertex_index") corners = list;
  }
  if (e.name == "vertex") addVertex(mesh, point, text);
  if (e.name == "face") addFace(mesh, corners, number, text);
}

}  // namespace

SurfaceMesh parsePly(const std::string& file, const std::string& name) {
  TextScanner text(file, name);
  std::string format;
  const std::vector<Element> elements = plyHeader(text, format, static_cast<double>(file.size()));
  PlyValues values(text, format);
  SurfaceMesh mesh;
  for (const Element& e : elements) {
    if (e.properties.empty()) continue;
    for (int k = 0; k < e.count; ++k) readElement(e, k, values, text, mesh);
  }
  return mesh;
}

SurfaceMesh parseOff(const std::string& file, const std::string& name) {
  TextScanner text(file, name, '#');
  const std::string kind = text.nextWord();
  if (kind.size() < 3 || kind.size() > 6 || !kind.ends_with("OFF"))
    text.fail("does not begin with 'OFF'");
  const double most = static_cast<double>(file.size());
  const int vertices = text.nextCount("the number of vertices", most);
  const int faces = text.nextCount("the number of faces", most);
  text.endRecord();  // edges, which nobody counts
  SurfaceMesh mesh;
  for (int i = 0; i < vertices; ++i) {
    Vec3 p;
    for (int k = 0; k < 3; ++k) p[k] = text.next("the last vertex");
    text.endRecord();
    addVertex(mesh, p, text);
  }
  for (int k = 0; k < faces; ++k) {
    std::vector<double> corners(
        static_cast<std::size_t>(text.nextCount("the number of corners", kMostCorners)));
    for (double& v : corners) v = text.next("the last face");
    text.endRecord();  // a colour may follow
    addFace(mesh, corners, k, text);
  }
  return mesh;
}

}  // namespace cutwater
