#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>

#include "hydro/files/PlyOffReader.h"
#include "hydro/geometry/MeshIntegrals.h"
#include "tests/files/MeshFiles.h"
#include "tests/support/Meshes.h"
#include "tests/support/Refusal.h"

namespace cutwater {
namespace {

const std::string kPlyTriangle =
    "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0\n1 0 0\n0 1 -1\n";

std::string asciiPly(const std::string& rest) { return "ply\nformat ascii 1.0\n" + rest; }

/// A number as PLY's binary kinds write it.
template <class T>
std::string binaryNumber(double value, bool big) {
  const T number = static_cast<T>(value);
  std::string bytes(sizeof(T), '\0');
  std::memcpy(bytes.data(), &number, sizeof(T));
  if (big != (std::endian::native == std::endian::big)) std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

/// Two triangles with coordinates and indices of these types.
template <class Coordinate, class Count, class Index>
std::string binaryPly(const std::string& types, bool big) {
  const std::size_t coordinate = types.find(' '), count = types.find(' ', coordinate + 1);
  const std::string type = types.substr(0, coordinate);
  std::string text = std::string("ply\nformat binary_") + (big ? "big" : "little") +
                     "_endian 1.0\nelement vertex 4\nproperty " + type + " x\nproperty " + type +
                     " y\nproperty " + type + " z\nelement face 2\nproperty list " +
                     types.substr(coordinate + 1, count - coordinate - 1) + " " +
                     types.substr(count + 1) + " vertex_index\nend_header\n";
  for (const double value : {0, 0, -3, 2, 0, -3, 2, 5, -3, 0, 5, -3})
    text += binaryNumber<Coordinate>(value, big);
  for (const std::vector<int>& face : {std::vector<int>{0, 1, 2}, {0, 2, 3}}) {
    text += binaryNumber<Count>(3, big);
    for (const int v : face) text += binaryNumber<Index>(v, big);
  }
  return text;
}

void expectPlyRefusal(Fault fault, const std::string& text, const std::vector<std::string>& words) {
  test::expectRefusal(fault, words, [&] { parsePly(text, "hull.ply"); });
}

void expectOffRefusal(Fault fault, const std::string& text, const std::vector<std::string>& words) {
  test::expectRefusal(fault, words, [&] { parseOff(text, "hull.off"); });
}

// A rectangle of 2 × 5 m; all its numbers are exact in every type.
TEST(PlyReaderIdentity, EveryNumberTypeInEitherOrderOfBytesGivesTheSameSurface) {
  for (const bool big : {false, true})
    for (const std::string& text :
         {binaryPly<float, std::uint8_t, std::int32_t>("float uchar int", big),
          binaryPly<double, std::int8_t, std::uint32_t>("double char uint", big),
          binaryPly<float, std::uint16_t, std::int16_t>("float32 ushort short", big),
          binaryPly<double, std::int32_t, std::uint16_t>("float64 int32 uint16", big),
          binaryPly<std::int16_t, std::uint32_t, std::int8_t>("int16 uint32 int8", big),
          binaryPly<std::int8_t, std::uint8_t, std::uint8_t>("char uint8 uchar", big)}) {
      const SurfaceMesh mesh = parsePly(text, "hull.ply");
      ASSERT_EQ(mesh.faces.size(), 2u);
      EXPECT_EQ(test::vectorAreaOf(mesh), Vec3(0, 0, 10));
      EXPECT_EQ(mesh.vertices[2], Vec3(2, 5, -3));
    }
}

TEST(PlyReaderIdentity, PropertiesMayComeInAnyOrderAndOthersAreSkipped) {
  const SurfaceMesh plain = parsePly(asciiPly(kPlyTriangle + "3 0 1 2\n"), "hull.ply");
  const SurfaceMesh other = parsePly(
      asciiPly("comment made by hand\nelement material 1\nproperty float shine\n"
               "element nothing 5\n"
               "element vertex 3\nproperty float nx\nproperty double z\nproperty double x\n"
               "property list uchar float weights\nproperty double y\n"
               "element face 1\nproperty list uchar int texture\nproperty uchar red\n"
               "property list uchar int vertex_index\nelement edge 1\nproperty int vertex1\n"
               "end_header\n0.5\n9 0 0 2 7 7 0\n9 0 1 0 0\n9 -1 0 1 7 1\n2 8 9 255 3 0 1 2\n4\n"),
      "hull.ply");
  EXPECT_EQ(other.vertices, plain.vertices);
  ASSERT_EQ(other.faces.size(), 1u);
  EXPECT_EQ(other.faces[0].v, plain.faces[0].v);
}

TEST(PlyReader, WhatDoesNotFitTheHeaderIsRefused) {
  const Fault malformed = Fault::FileMalformed;
  expectPlyRefusal(malformed, "plyx\n", {"hull.ply: line 1: does not begin with 'ply'"});
  expectPlyRefusal(malformed, "ply\nformat ascii 2\n", {"ends before end_header"});
  expectPlyRefusal(malformed, "ply\nformat middle 1.0\n" + kPlyTriangle, {"'middle' is none of"});
  expectPlyRefusal(malformed, "ply\n" + kPlyTriangle, {"format '' is none of PLY's"});
  expectPlyRefusal(malformed, asciiPly("property float x\nend_header\n"), {"before any element"});
  expectPlyRefusal(malformed, asciiPly("element vertex 1\nproperty float\nend_header\n"),
                   {"line 4: a property without type or name"});
  expectPlyRefusal(malformed, asciiPly("element vertex -1\nend_header\n"), {"vertex is -1"});
  expectPlyRefusal(malformed, asciiPly(kPlyTriangle), {"ends before its last element"});
  expectPlyRefusal(malformed, asciiPly(kPlyTriangle + "10001 0\n"), {"face 0 has a list of 10001"});
  expectPlyRefusal(malformed, asciiPly(kPlyTriangle + "-3 0 1 2\n"), {"face 0 has a list of -3"});
  std::string half = binaryPly<float, std::uint8_t, std::int32_t>("float uchar int", false);
  half.resize(half.size() - 1);
  expectPlyRefusal(malformed, half, {"the file ends before its last element"});
  expectPlyRefusal(malformed,
                   binaryPly<float, std::uint8_t, std::int32_t>("float uchar int128", false),
                   {"type 'int128' is none of PLY's"});
}

TEST(PlyReader, VerticesThatAreNotThereHaveFaultsOfTheirOwn) {
  const Fault range = Fault::MeshIndexOutOfRange;
  expectPlyRefusal(range, asciiPly(kPlyTriangle + "3 0 1 3\n"), {"face 0 names vertex 3", "of 3"});
  expectPlyRefusal(range, asciiPly(kPlyTriangle + "3 0 -1 2\n"), {"face 0 names vertex -1"});
  expectPlyRefusal(range, asciiPly(kPlyTriangle + "3 0 0.5 2\n"), {"face 0 names vertex 0.5"});
  expectPlyRefusal(range, asciiPly(kPlyTriangle + "3 0 nan 2\n"), {"face 0 names vertex nan"});
  expectPlyRefusal(Fault::MeshNotFinite,
                   asciiPly("element vertex 1\nproperty float x\nproperty float y\nend_header\n"
                            "1 2\n"),
                   {"vertex 0 is (1", "nan)"});  // without z
}

TEST(OffReaderIdentity, MoreNumbersAVertexAndColoursAreSkipped) {
  const SurfaceMesh plain = parseOff("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 -1\n3 0 1 2\n", "hull.off");
  ASSERT_EQ(plain.faces.size(), 1u);
  for (const char* text :
       {"OFF 3 1 0\n0 0 0\n1 0 0\n0 1 -1\n3 0 1 2\n",
        "# drawn by hand\nOFF # a hull\n\n3 1 7 edges\n0 0 0\n1 0 0 # the bow\n0 1 -1\n3 0 1 2\n",
        "COFF\n3 1 0\n0 0 0 255 0 0 1\n1 0 0 0 0 0 0\n0 1 -1 9 9 9 9\n3 0 1 2 0.5 0.5 0.5\n",
        "STNOFF\n3 1\n0 0 0 1 0 0\n1 0 0 1 0 0\n0 1 -1 1 0 0\n3\n0\n1 2\n"}) {
    const SurfaceMesh read = parseOff(text, "hull.off");
    EXPECT_EQ(read.vertices, plain.vertices) << text;
    ASSERT_EQ(read.faces.size(), 1u) << text;
    EXPECT_EQ(read.faces[0].v, plain.faces[0].v) << text;
  }
}

TEST(PlyOffReaderIdentity, BothFormatsGiveTheSameDividedPolygons) {
  const std::string corners = "0 0 -1\n3 0 -1\n3 1 -1\n1 1 -1\n1 2 -1\n0 2 -1\n";
  const SurfaceMesh off = parseOff("OFF\n6 1 0\n" + corners + "6 0 1 2 3 4 5\n", "l.off");
  const SurfaceMesh ply =
      parsePly(asciiPly("element vertex 6\nproperty float x\nproperty float y\nproperty float z\n"
                        "element face 1\nproperty list uchar int vertex_indices\nend_header\n" +
                        corners + "6 0 1 2 3 4 5\n"),
               "l.ply");
  ASSERT_EQ(off.faces.size(), 4u);  // an L with six corners
  ASSERT_EQ(ply.faces.size(), 4u);
  for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(off.faces[k].v, ply.faces[k].v);
  EXPECT_EQ(test::vectorAreaOf(off), Vec3(0, 0, 4));
  EXPECT_EQ(surfaceArea(off), 4.0);
}

TEST(OffReader, WhatIsDamagedIsRefused) {
  const Fault malformed = Fault::FileMalformed;
  for (const char* text : {"", "OF\n", "OFFX\n3 1 0\n", "off\n3 1 0\n", "SOMEOFF\n3 1 0\n"})
    expectOffRefusal(malformed, text, {"hull.off: line ", "does not begin with 'OFF'"});
  expectOffRefusal(malformed, "OFF\n-3 1 0\n", {"line 2: the number of vertices is -3"});
  expectOffRefusal(malformed, "OFF\n3 1e9 0\n", {"the number of faces is 1000000000"});
  expectOffRefusal(malformed, "OFF\n1 0 0\n0 0\n", {"ends before the last vertex"});
  expectOffRefusal(malformed, "OFF\n1 1 0\n0 0 0\n20000 0\n", {"the number of corners is 20000"});
  expectOffRefusal(malformed, "OFF\n1 1 0\n0 0 0\n3 0 0\n", {"line 4: the file ends before"});
  expectOffRefusal(Fault::MeshIndexOutOfRange, "OFF\n1 1 0\n0 0 0\n3 0 0 1\n",
                   {"line 4: face 0 names vertex 1"});
  expectOffRefusal(Fault::MeshNotFinite, "OFF\n2 0 0\n0 0 0\n1 inf 0\n", {"line 4: vertex 1 is"});
}

}  // namespace
}  // namespace cutwater
