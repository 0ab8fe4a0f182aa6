#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "hydro/Errors.h"
#include "hydro/files/MeshIO.h"
#include "hydro/geometry/MeshIntegrals.h"
#include "hydro/geometry/shapes/Shapes.h"
#include "hydro/ship/Afloat.h"
#include "tests/files/MeshFiles.h"

namespace cutwater {
namespace {

using test::TemporaryFolder;

SurfaceMesh hull() { return closedWigley(wigley(2), 0.1, 16, 5); }

std::size_t quads(const SurfaceMesh& mesh) {
  return static_cast<std::size_t>(std::count_if(mesh.faces.begin(), mesh.faces.end(),
                                                [](const Face& f) { return f.size() == 4; }));
}

TEST(MeshIoIdentity, EveryFormatGivesTheSameHull) {
  const TemporaryFolder folder;
  const SurfaceMesh mesh = hull();
  const double whole = volumeIntegrals(mesh).volume;
  struct Case {
    const char* file;
    std::string content;
    bool keepsQuads;
  };
  const Case cases[] = {
      {"a.obj", test::objText(mesh), true},       {"A.OBJ", test::objText(mesh), true},
      {"a.stl", test::stlText(mesh), false},      {"b.stl", test::stlBinary(mesh), false},
      {"a.ply", test::plyText(mesh), true},       {"b.ply", test::plyBinary(mesh), true},
      {"a.off", test::offText(mesh), true},       {"a.gltf", test::gltfText(mesh), false},
      {"a.glb", test::glb(mesh), false},          {"a.dae", test::colladaText(mesh), true},
      {"a.gdf", test::gdfText(mesh, 0, 0), true}, {"b.gdf", test::gdfText(mesh, 0, 0, 7), true}};
  for (const Case& c : cases) {
    const Hull read = readHull(folder.write(c.file, c.content));
    EXPECT_TRUE(read.closed) << c.file;
    EXPECT_TRUE(read.symmetric) << c.file;
    // Single precision vertices: 1e-7 of 3 m times a surface of 3 m². Triangulation changes the
    // volume of twisted quadrilaterals, which is why those are compared with their own mean below.
    const double tolerance = c.keepsQuads ? 1e-6 : 2e-4;
    EXPECT_NEAR(volumeIntegrals(read.surface).volume, whole, tolerance) << c.file;
    EXPECT_EQ(quads(read.surface), c.keepsQuads ? quads(mesh) : 0u) << c.file;
    if (c.keepsQuads) {
      EXPECT_EQ(read.surface.faces.size(), mesh.faces.size()) << c.file;
    }
  }
}

TEST(MeshIoIdentity, WhatWeWriteWeRead) {
  const TemporaryFolder folder;
  const SurfaceMesh mesh = hull();
  writeObj(folder.path("hull.obj"), mesh, "two\nlines");
  const SurfaceMesh back = welded(readSurface(folder.path("hull.obj")), 1e-7);
  ASSERT_EQ(back.faces.size(), mesh.faces.size());
  for (std::size_t k = 0; k < mesh.faces.size(); ++k)
    for (int i = 0; i < mesh.faces[k].size(); ++i)
      EXPECT_LT((back.corner(back.faces[k], i) - mesh.corner(mesh.faces[k], i)).norm(), 3e-7);
  // Nothing but the file itself is left in the folder.
  const auto entries = std::filesystem::directory_iterator(folder.path(""));
  EXPECT_EQ(std::distance(begin(entries), end(entries)), 1);
  EXPECT_THROW(writeObj(folder.path("missing/hull.obj"), mesh), HydroError);
}

TEST(MeshIoIdentity, AxesUnitAndWaterlineAreTurnedToOurs) {
  const TemporaryFolder folder;
  const SurfaceMesh ours = hull();
  const Vec3 centroid = volumeIntegrals(ours).centroid();
  struct Case {
    MeshReadOptions options;
    Vec3 forward, port, up;  // our axes in the file's
    double scale;            // file units per metre
  };
  const Vec3 X = Vec3::UnitX(), Y = Vec3::UnitY(), Z = Vec3::UnitZ();
  std::vector<Case> cases(5);
  cases[0] = {{.up = "y", .forward = "x", .unit = "mm"}, X, -Z, Y, 1000.0};
  cases[1] = {{.up = "y", .forward = "-z"}, -Z, -X, Y, 1.0};
  cases[2] = {{.up = "-z", .forward = "-x", .unit = "ft"}, -X, Y, -Z, 1 / 0.3048};
  cases[3] = {{.up = "+z", .forward = "y", .unit = "cm", .waterline = 30.0}, Y, -X, Z, 100.0};
  cases[4] = {{.up = "x", .forward = "z", .unit = "in", .waterline = -7.0}, Z, -Y, X, 1 / 0.0254};
  for (const Case& c : cases) {
    SurfaceMesh inFile = ours;
    for (Vec3& p : inFile.vertices)
      p = c.scale * (p.x() * c.forward + p.y() * c.port + p.z() * c.up) +
          c.options.waterline * c.up;
    const Hull read = readHull(folder.write("t.obj", test::objText(inFile)), c.options);
    EXPECT_TRUE(read.symmetric) << c.options.up << c.options.forward;
    EXPECT_LT((volumeIntegrals(read.surface).centroid() - centroid).norm(), 1e-6);
    EXPECT_NEAR(bounds(read.surface).high.x(), 1.5, 1e-6);
    EXPECT_NEAR(bounds(read.surface).low.z(), -0.1875, 1e-6);
    // And the hull knows where its file lies: every vertex comes back, to round-off.
    for (std::size_t i = 0; i < ours.vertices.size(); ++i)
      EXPECT_LT((read.file.toHull(inFile.vertices[i]) - ours.vertices[i]).norm(), 1e-14);
  }
}

// A COLLADA file's <unit> is applied when it is read, as filePlacement says.
TEST(MeshIoClosedForm, AColladaUnitIsTurnedToMetres) {
  const TemporaryFolder folder;
  std::string text = test::colladaText(hull());
  const std::string metre = "meter=\"1\"";
  ASSERT_NE(text.find(metre), std::string::npos);
  text.replace(text.find(metre), metre.size(), "meter=\"0.01\"");
  EXPECT_NEAR(bounds(readSurface(folder.write("h.dae", text))).high.x(), 0.015, 1e-6);
}

// A box trimmed and heeled about the point on calm water: R = R_y(trim) R_x(heel).
TEST(MeshIoClosedForm, TheFilesPlacementHoldsTrimHeelAndWaterline) {
  const MeshReadOptions options{
      .up = "y", .forward = "-x", .unit = "cm", .waterline = 40.0, .trimDeg = 2.0, .heelDeg = 5.0};
  const FilePlacement file = filePlacement(options);
  const double trim = 2.0 * kPi / 180.0, heel = 5.0 * kPi / 180.0;
  const Vec3 inFile(-300.0, 140.0, 200.0);  // 3 m forward, 1 m above water; port is y × -x = z
  const Vec3 level(3.0, 2.0, 1.0);
  const Vec3 heeled(level.x(), level.y() * std::cos(heel) - level.z() * std::sin(heel),
                    level.y() * std::sin(heel) + level.z() * std::cos(heel));
  const Vec3 trimmed(heeled.x() * std::cos(trim) + heeled.z() * std::sin(trim), heeled.y(),
                     -heeled.x() * std::sin(trim) + heeled.z() * std::cos(trim));
  EXPECT_LT((file.toHull(inFile) - trimmed).norm(), 1e-14);
  EXPECT_THROW(filePlacement({.up = "x"}), HydroError);
  const TemporaryFolder folder;
  const std::string box = folder.write("b.obj", test::objText(closedBox({10, 4, 2, 3}, 5, 2, 2)));
  const Hull read = readHull(box, {.heelDeg = 2.0});
  EXPECT_EQ(read.file.rotation, filePlacement({.heelDeg = 2.0}).rotation);
  EXPECT_EQ(readRepaired(box, {.unit = "ft"}).hull.file.metresPerUnit, 0.3048);
  EXPECT_EQ(panelledAsItIs(read).file.rotation, read.file.rotation);
  EXPECT_EQ(afloat(panelledAsItIs(read)).ship.file.rotation, read.file.rotation);
}

TEST(MeshIo, TrimIsBowDownAndHeelStarboardDown) {
  const TemporaryFolder folder;
  const std::string file =
      folder.write("box.obj", test::objText(closedBox({10, 4, 2, 3}, 5, 2, 2)));
  const auto lowest = [&](const MeshReadOptions& o) {
    const SurfaceMesh mesh = readSurface(file, o);
    return *std::min_element(mesh.vertices.begin(), mesh.vertices.end(),
                             [](const Vec3& a, const Vec3& b) { return a.z() < b.z(); });
  };
  EXPECT_GT(lowest({.trimDeg = 2.0}).x(), 4.0);
  EXPECT_LT(lowest({.heelDeg = 2.0}).y(), -1.0);
  EXPECT_NEAR(lowest({.trimDeg = 2.0}).z(),
              -2 * std::cos(2 * kPi / 180) - 5 * std::sin(2 * kPi / 180), 1e-6);
  EXPECT_FALSE(readHull(file, {.heelDeg = 2.0}).symmetric);
  EXPECT_TRUE(readHull(file, {.trimDeg = 2.0}).symmetric);
}

TEST(MeshIo, GdfSymmetryPlanesAreApplied) {
  const TemporaryFolder folder;
  const SurfaceMesh half = wetHemisphere(5.0, 12, 6);
  const double whole = 2 * volumeIntegrals(half).volume;
  SurfaceMesh quarter{half.vertices, {}};
  for (const Face& f : half.faces)
    if ((half.corner(f, 0) + half.corner(f, 1) + half.corner(f, 2)).x() > 0)
      quarter.faces.push_back(f);
  ASSERT_EQ(2 * quarter.faces.size(), half.faces.size());
  const std::pair<const char*, std::string> cases[] = {
      {"half.gdf", test::gdfText(half, 0, 1)}, {"quarter.gdf", test::gdfText(quarter, 1, 1)}};
  for (const auto& [name, text] : cases)
    for (const char* symmetric : {"auto", "half"}) {
      const Hull hull = readHull(folder.write(name, text), {.symmetric = symmetric});
      EXPECT_TRUE(hull.symmetric) << name;
      EXPECT_NEAR(volumeIntegrals(hull.surface).volume, whole, 1e-6 * whole) << name;
      EXPECT_EQ(wetSurface(hull).faces.size(), half.faces.size()) << name;
    }
}

TEST(MeshIo, GdfReadsFortranNumbersAndCommentary) {
  const TemporaryFolder folder;
  const SurfaceMesh box = closedBox({2, 2, 1, 1}, 1, 1, 1);
  std::string text = test::gdfText(box, 0, 0, 5);
  for (std::size_t at = text.find("-1 "); at != std::string::npos; at = text.find("-1 ", at))
    text.replace(at, 3, "-1.0D+00,\t");
  EXPECT_NEAR(volumeIntegrals(readHull(folder.write("d.gdf", text)).surface).volume, 8.0, 1e-12);
}

TEST(MeshIo, LargePolygonsAndReentrantQuadsAreDividedWithoutOverlap) {
  const TemporaryFolder folder;
  // A prism over an L with six corners; its ends are one polygon each.
  const double l[6][2] = {{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 2}, {0, 2}};
  std::string obj;
  for (const double z : {-1.0, 1.0})
    for (const auto& p : l)
      obj +=
          "v " + std::to_string(p[0]) + " " + std::to_string(p[1]) + " " + std::to_string(z) + "\n";
  obj += "f 6 5 4 3 2 1\nf 7 8 9 10 11 12\n";
  for (int i = 0; i < 6; ++i) {
    const int j = (i + 1) % 6;
    obj += "f " + std::to_string(i + 1) + " " + std::to_string(j + 1) + " " +
           std::to_string(j + 7) + " " + std::to_string(i + 7) + "\n";
  }
  const Hull hull = readHull(folder.write("l.obj", obj));
  EXPECT_NEAR(volumeIntegrals(hull.surface).volume, 8.0, 1e-12);
  // Divided without overlap, the areas of the parts (not only the vector areas) add up.
  EXPECT_NEAR(surfaceArea(hull.surface), 2 * 4.0 + 2 * 10.0, 1e-12);
  EXPECT_TRUE(hull.closed);
}

TEST(MeshIo, RareFormatsNeedPermission) {
  const TemporaryFolder folder;
  const std::string file = folder.write("a.fbx", "something");
  try {
    readHull(file);
    FAIL();
  } catch (const HydroError& e) {
    EXPECT_EQ(e.fault(), Fault::FormatNotSupported);
    EXPECT_NE(std::string(e.what()).find("any_format"), std::string::npos);
  }
  EXPECT_THROW(readHull(file, {.anyFormat = true}), HydroError);
}

TEST(MeshIo, AFormatIsKnownByItsEndingNotByWhatItContains) {
  const TemporaryFolder folder;
  // An FBX signature in a file named .obj must not reach the FBX importer.
  try {
    readHull(folder.write("a.obj", std::string("Kaydara FBX Binary  \0\x1a\0", 23)));
    FAIL();
  } catch (const HydroError& e) {
    EXPECT_EQ(std::string(e.what()).find("FBX-"), std::string::npos) << e.what();
  }
}

}  // namespace
}  // namespace cutwater
