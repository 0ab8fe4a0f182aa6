#include <gtest/gtest.h>

#include <filesystem>
#include <random>

#include "hydro/Errors.h"
#include "hydro/files/MeshIO.h"
#include "hydro/geometry/shapes/Shapes.h"
#include "tests/files/MeshFiles.h"

// Assimp 5.2.5 itself leaks when it gives up on some damaged files (DamageIsSurvived); ours would
// still show.
// Visible, or the sanitizer's library would not find it in a program built with hidden symbols.
extern "C" __attribute__((visibility("default"))) const char*
__lsan_default_suppressions();                                                     // NOLINT
extern "C" const char* __lsan_default_suppressions() { return "leak:libassimp"; }  // NOLINT

namespace cutwater {
namespace {

using test::TemporaryFolder;

/// The file must be refused with this fault, in one line that names the file and holds `value`;
/// nothing may be written to the terminal.
void expectRefused(const std::string& path, Fault fault, const std::string& value,
                   const MeshReadOptions& options = {}) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  std::string what = "accepted";
  Fault found = Fault::BadArgument;
  try {
    readHull(path, options);
  } catch (const HydroError& e) {
    what = e.what();
    found = e.fault();
  }
  EXPECT_EQ(testing::internal::GetCapturedStdout() + testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(static_cast<int>(found), static_cast<int>(fault)) << path << ": " << what;
  EXPECT_NE(what.find(value), std::string::npos) << what;
  EXPECT_EQ(what.find('\n'), std::string::npos) << what;
  EXPECT_EQ(what.substr(0, path.size()), path);
}

TEST(MalformedFiles, EachIsRefusedInOneLine) {
  const TemporaryFolder folder;
  const SurfaceMesh hull = closedBox({10, 4, 2, 1}, 5, 2, 2);
  const std::string obj = test::objText(hull);
  const auto with = [](std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
  };
  expectRefused(folder.path("none.obj"), Fault::FileNotReadable, "no such file");
  expectRefused(folder.path(""), Fault::FileNotReadable, "");
  for (const char* name : {"e.obj", "e.stl", "e.ply", "e.off", "e.gltf", "e.glb", "e.dae", "e.gdf"})
    expectRefused(folder.write(name, ""), Fault::MeshEmpty, "empty");
  for (const char* name : {"j.obj", "j.stl", "j.ply", "j.off", "j.gltf", "j.glb", "j.dae"}) try {
      readHull(folder.write(name, "this is not a mesh, whatever its name says\n"));
      ADD_FAILURE() << name;
    } catch (const HydroError& e) {
      EXPECT_TRUE(e.fault() == Fault::FileMalformed || e.fault() == Fault::MeshEmpty) << e.what();
    }
  expectRefused(folder.write("p.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n"), Fault::MeshEmpty, "");
  expectRefused(folder.write("n.obj", with(obj, "v -5 2 0", "v nan 2 0")), Fault::MeshNotFinite,
                "nan");
  expectRefused(folder.write("i.obj", with(obj, "v -5 2 0", "v inf 2 0")), Fault::MeshNotFinite,
                "inf");
  expectRefused(folder.write("h.obj", with(obj, "v -5 2 0", "v 1e60 2 0")), Fault::MeshNotFinite,
                "inf");
  expectRefused(folder.write("m.obj", with(obj, "v -5 2 0", "v -5 2")), Fault::FileMalformed, "");
  expectRefused(folder.write("b.obj", with(obj, "f ", "f 999 ")), Fault::FileMalformed, "");
  expectRefused(folder.write("b.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 -1\n3 0 1 77\n"),
                Fault::MeshIndexOutOfRange, "77");
  expectRefused(folder.write("b.ply",
                             "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
                             "property float y\nproperty float z\nelement face 1\n"
                             "property list uchar int vertex_index\nend_header\n"
                             "0 0 0\n1 0 0\n0 1 -1\n3 0 1 77\n"),
                Fault::MeshIndexOutOfRange, "77");
  expectRefused(
      folder.write("l.ply", "ply\nformat ascii 1.0\nelement vertex 9\nproperty float x\n"),
      Fault::FileMalformed, "end_header");
  expectRefused(folder.write("t.ply", test::plyBinary(hull).substr(0, 500)), Fault::FileMalformed,
                "the file ends before");
  expectRefused(folder.write("c.off", "OFF\n4000000000 1 0\n0 0 0\n"), Fault::FileMalformed,
                "4000000000");
  expectRefused(folder.write("c.ply",
                             "ply\nformat ascii 1.0\nelement vertex 4000000000\n"
                             "property float x\nend_header\n0\n"),
                Fault::FileMalformed, "4000000000");
  expectRefused(folder.write("t.stl", test::stlBinary(hull).substr(0, 500)), Fault::FileMalformed,
                "");
  expectRefused(folder.write("l.dae", with(test::colladaText(hull), "</p>", "7 x</p>")),
                Fault::FileMalformed, "<p> at byte");
  expectRefused(
      folder.write("a.dae", with(test::colladaText(hull), "stride=\"3\"", "stride=\"4\"")),
      Fault::FileMalformed, "<accessor> at byte");
  expectRefused(folder.write("t.glb", test::glb(hull).substr(0, 500)), Fault::FileMalformed, "");
}

TEST(MalformedFiles, GdfFaultsNameTheLine) {
  const TemporaryFolder folder;
  const SurfaceMesh hull = closedBox({10, 4, 2, 1}, 5, 2, 2);
  const std::string gdf = test::gdfText(hull, 0, 0);
  const auto refuse = [&](const std::string& text, Fault fault, const std::string& value) {
    expectRefused(folder.write("x.gdf", text), fault, value);
  };
  refuse("only a title\n", Fault::FileMalformed, "ULEN");
  refuse("t\n0 9.8\n0 0\n1\n", Fault::FileMalformed, "ULEN is 0");
  refuse("t\n1 9.8\n0 2\n1\n", Fault::FileMalformed, "line 3: ISY is 2");
  refuse("t\n1 9.8\n0 0\n0\n", Fault::MeshEmpty, "NPAN is 0");
  refuse("t\n1 9.8\n0 0\nmany\n", Fault::FileMalformed, "'many' is not a number (NPAN)");
  refuse("t\n1 9.8\n0 0\n-3\n", Fault::FileMalformed, "NPAN is -3");
  refuse("t\n1 9.8\n0 0\n2000000000\n0 0 0\n", Fault::FileMalformed, "NPAN is 2000000000");
  refuse(gdf.substr(0, gdf.size() - 60), Fault::FileMalformed, "the file ends before");
  refuse("t\n1 9.8\n0 0\n1\n0 0 0 1 0 0 1 abc 0 0 0 0\n", Fault::FileMalformed,
         "line 5: 'abc' is not a number");
  refuse("t\n1 9.8\n0 0\n1\n0 0 0 1 0 0\n1 nan 0 0 0 0\n", Fault::MeshNotFinite,
         "line 6: vertex 3 of panel 1");
}

TEST(MalformedFiles, OptionsAreChecked) {
  const TemporaryFolder folder;
  const std::string file = folder.write("a.obj", test::objText(closedSphere(1.0, 8, 4)));
  const auto message = [&](const MeshReadOptions& o) -> std::string {
    try {
      readHull(file, o);
    } catch (const HydroError& e) {
      return e.what();
    }
    return "accepted";
  };
  EXPECT_EQ(message({.up = "w"}), "up = \"w\" is none of x, -x, y, -y, z, -z");
  EXPECT_EQ(message({.up = "z", .forward = "-z"}),
            "up = \"z\" and forward = \"-z\" are the same axis");
  EXPECT_EQ(message({.unit = "yd"}), "unit = \"yd\" is none of m, mm, cm, ft, in");
  EXPECT_EQ(message({.symmetric = "yes"}),
            "symmetric = \"yes\" is none of \"auto\", \"none\", \"half\"");
  EXPECT_NE(message({.waterline = std::nan("")}).find("waterline = nan"), std::string::npos);
  EXPECT_NE(message({.trimDeg = 95}).find("trim_deg = 95"), std::string::npos);
  EXPECT_NE(message({.waterline = 3}).find("wholly below calm water"), std::string::npos);
  EXPECT_NE(message({.waterline = -3}).find("wholly above calm water"), std::string::npos);
}

// Files cut short or with bytes changed are refused or read, but never crash, hang or print.
TEST(MalformedFiles, DamageIsSurvived) {
  const TemporaryFolder folder;
  const SurfaceMesh hull = closedBox({10, 4, 2, 1}, 2, 1, 1);
  const std::pair<const char*, std::string> files[] = {
      {"d.obj", test::objText(hull)},     {"d.stl", test::stlText(hull)},
      {"s.stl", test::stlBinary(hull)},   {"d.ply", test::plyText(hull)},
      {"s.ply", test::plyBinary(hull)},   {"d.off", test::offText(hull)},
      {"d.gltf", test::gltfText(hull)},   {"d.glb", test::glb(hull)},
      {"d.dae", test::colladaText(hull)}, {"d.gdf", test::gdfText(hull, 0, 0)}};
  std::mt19937 random(4);
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  for (const auto& [name, whole] : files)
    for (int i = 0; i < 40; ++i) {
      std::string text = whole;
      if (i % 2 == 0) text.resize(random() % text.size());
      for (int k = 0; k < i / 8; ++k)
        if (!text.empty()) text[random() % text.size()] = static_cast<char>(random() % 256);
      try {
        readHull(folder.write(name, text));
      } catch (const HydroError&) {
      }
    }
  EXPECT_EQ(testing::internal::GetCapturedStdout() + testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace cutwater
