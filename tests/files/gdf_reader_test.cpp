#include <gtest/gtest.h>

#include "hydro/files/GdfReader.h"
#include "hydro/geometry/MeshIntegrals.h"
#include "hydro/geometry/shapes/Shapes.h"
#include "tests/files/MeshFiles.h"
#include "tests/support/Meshes.h"
#include "tests/support/Refusal.h"

namespace cutwater {
namespace {

/// A file of one panel, its records given.
std::string gdfOfOnePanel(const std::string& scale, const std::string& symmetry,
                          const std::string& count = "1") {
  return "a hull\n" + scale + "\n" + symmetry + "\n" + count + "\n1 2 -3\n4 2 -3\n4 5 -3\n1 5 -3\n";
}

void expectGdfRefusal(const std::string& text, const std::vector<std::string>& words) {
  test::expectRefusal(Fault::FileMalformed, words, [&] { parseGdf(text, "hull.gdf"); });
}

TEST(GdfReader, APanelHasItsCornersInTheOrderOfTheFile) {
  const GdfSurface read = parseGdf(gdfOfOnePanel("1 9.80665", "0 0"), "hull.gdf");
  EXPECT_FALSE(read.mirrored);
  ASSERT_EQ(read.mesh.faces.size(), 1u);
  const Vec3 corners[] = {{1, 2, -3}, {4, 2, -3}, {4, 5, -3}, {1, 5, -3}};
  for (int i = 0; i < 4; ++i) EXPECT_EQ(read.mesh.corner(read.mesh.faces[0], i), corners[i]);
}

TEST(GdfReaderIdentity, NumbersMayBeWrappedInAnyWay) {
  const SurfaceMesh box = wetBox({10, 4, 2, 1}, 3, 2, 2);
  for (const int perLine : {1, 2, 3, 5, 12, 1000}) {
    const SurfaceMesh read = parseGdf(test::gdfText(box, 0, 0, perLine), "hull.gdf").mesh;
    ASSERT_EQ(read.faces.size(), box.faces.size()) << perLine;
    for (std::size_t k = 0; k < box.faces.size(); ++k)
      for (int i = 0; i < 4; ++i)  // written with nine digits, and of few: exact but for 1/3
        EXPECT_LT((read.corner(read.faces[k], i) - box.corner(box.faces[k], i)).norm(), 1e-8);
  }
}

TEST(GdfReader, HigherOrderFilesAreNamedAsSuch) {
  test::expectRefusal(Fault::FormatNotSupported, {"hull.gdf: line 4", "IGDEF is 1", "B-spline"},
                      [] { parseGdf(gdfOfOnePanel("1 9.8", "0 0", "1 1"), "hull.gdf"); });
  test::expectRefusal(Fault::FormatNotSupported, {"IGDEF is -5", "higher-order"},
                      [] { parseGdf(gdfOfOnePanel("1 9.8", "0 0", "1 -5"), "hull.gdf"); });
  // Flat patches are panels.
  EXPECT_EQ(parseGdf(gdfOfOnePanel("1 9.8", "0 0", "1 0"), "hull.gdf").mesh.faces.size(), 1u);
}

TEST(GdfReaderIdentity, TextAfterTheNumbersOfARecordIsIgnored) {
  const std::string said = gdfOfOnePanel("1.0D0, 9.8  ULEN GRAV 7 8", "0 0 ISX ISY 5", "1 NPAN 3");
  const SurfaceMesh read = parseGdf(said, "hull.gdf").mesh;
  const SurfaceMesh plain = parseGdf(gdfOfOnePanel("1 9.8", "0 0"), "hull.gdf").mesh;
  EXPECT_EQ(read.vertices, plain.vertices);
}

// Each image is mirrored and turned over: its normals stay out of the hull.
TEST(GdfReaderClosedForm, ImagesCompleteTheHull) {
  const SurfaceMesh half = wetBox({10, 4, 2, 1}, 4, 2, 2);
  SurfaceMesh quarter{half.vertices, {}};
  for (const Face& f : half.faces)
    if ((half.corner(f, 0) + half.corner(f, 2)).x() > 0) quarter.faces.push_back(f);
  struct Case {
    const SurfaceMesh& mesh;
    int isx, isy;
    double share;  // of the box of 80 m³
  };
  for (const Case& c :
       {Case{half, 0, 0, 0.5}, {half, 0, 1, 1.0}, {quarter, 1, 0, 0.5}, {quarter, 1, 1, 1.0}}) {
    const GdfSurface read = parseGdf(test::gdfText(c.mesh, c.isx, c.isy), "hull.gdf");
    EXPECT_EQ(read.mirrored, c.isy == 1);
    EXPECT_EQ(read.mesh.faces.size(),
              c.mesh.faces.size() * static_cast<std::size_t>((1 + c.isx) * (1 + c.isy)));
    EXPECT_NEAR(volumeIntegrals(read.mesh).volume, 80 * c.share, 1e-12);  // round-off of 80
    if (c.share < 1.0) continue;
    const SurfaceMesh whole = welded(read.mesh, 1e-9);
    EXPECT_EQ(test::openEdgesBelowWater(whole), 0);
    EXPECT_LT((test::vectorAreaOf(whole) - Vec3(0, 0, -40)).norm(), 1e-12);
  }
}

TEST(GdfReaderIdentity, TheGivenPanelsComeFirst) {
  const SurfaceMesh plain = parseGdf(gdfOfOnePanel("1 9.8", "0 0"), "hull.gdf").mesh;
  const SurfaceMesh all = parseGdf(gdfOfOnePanel("1 9.8", "1 1"), "hull.gdf").mesh;
  ASSERT_EQ(all.faces.size(), 4u);
  EXPECT_EQ(all.faces[0].v, plain.faces[0].v);
  for (int i = 0; i < 4; ++i)
    EXPECT_EQ(all.corner(all.faces[0], i), plain.corner(plain.faces[0], i));
}

TEST(GdfReader, RecordsThatDoNotHoldAreRefused) {
  expectGdfRefusal("", {"hull.gdf: ", "ends before ULEN"});
  expectGdfRefusal(gdfOfOnePanel("-1 9.8", "0 0"), {"line 2: ULEN is -1", "not positive"});
  expectGdfRefusal(gdfOfOnePanel("nan 9.8", "0 0"), {"line 2: ULEN is nan"});
  expectGdfRefusal(gdfOfOnePanel("1 g", "0 0"), {"line 2: 'g' is not a number (GRAV)"});
  expectGdfRefusal(gdfOfOnePanel("1 9.8", "0.5 0"), {"line 3: ISX is 0.5", "not 0 or 1"});
  expectGdfRefusal(gdfOfOnePanel("1 9.8", "0 -1"), {"line 3: ISY is -1", "not 0 or 1"});
  expectGdfRefusal(gdfOfOnePanel("1 9.8", "0 0", "1.5"), {"line 4: NPAN is 1.5", "not a count"});
  expectGdfRefusal(gdfOfOnePanel("1 9.8", "0 0", "2"), {"ends before the last vertex"});
}

// The count is held against the bytes there are: no memory is taken for panels that are not there.
TEST(GdfReader, ACountBeyondTheFilesBytesIsRefusedAtOnce) {
  expectGdfRefusal(gdfOfOnePanel("1 9.8", "0 0", "10"),
                   {"line 4: NPAN is 10.", "more than the file can hold"});
}

TEST(GdfReader, NoPanelsAndInfiniteVerticesHaveFaultsOfTheirOwn) {
  test::expectRefusal(Fault::MeshEmpty, {"hull.gdf: line 4: NPAN is 0"},
                      [] { parseGdf(gdfOfOnePanel("1 9.8", "0 0", "0"), "hull.gdf"); });
  std::string text = gdfOfOnePanel("1 9.8", "0 0");
  text.replace(text.find("5 -3"), 1, "1e999");
  test::expectRefusal(Fault::MeshNotFinite, {"line 7: vertex 3 of panel 1 is not finite"},
                      [&] { parseGdf(text, "hull.gdf"); });
}

}  // namespace
}  // namespace cutwater
