#include <gtest/gtest.h>

#include "hydro/Errors.h"
#include "hydro/geometry/SurfaceMesh.h"
#include "hydro/geometry/shapes/Shapes.h"

namespace cutwater {
namespace {

TEST(SurfaceMesh, AClosedHullHasNoOpenEdgesAndItsVectorAreasSumToZero) {
  for (const SurfaceMesh& mesh : {closedBox({10, 4, 2, 1}, 5, 2, 2), closedSphere(2.0, 9, 5),
                                  closedWigley(wigley(1), 0.1, 12, 4), closedFrigate(16, 4)}) {
    EXPECT_TRUE(openEdges(mesh).empty());
    Vec3 sum = Vec3::Zero();
    for (const Face& f : mesh.faces) sum += vectorArea(mesh, f);
    // Round-off of some hundred sums of areas.
    EXPECT_LT(sum.norm(), 1e-11 * bounds(mesh).diagonal() * bounds(mesh).diagonal());
  }
}

TEST(SurfaceMesh, TwistedQuadrilateralHasTheVectorAreaOfEitherTriangulation) {
  const SurfaceMesh mesh{{{0, 0, 0}, {2, 0, 0.3}, {2, 1, -0.2}, {0, 1.5, 0.7}}, {{{0, 1, 2, 3}}}};
  const auto triangle = [&](int a, int b, int c) { return vectorArea(mesh, {{a, b, c, -1}}); };
  const Vec3 whole = vectorArea(mesh, mesh.faces[0]);
  EXPECT_LT((whole - triangle(0, 1, 2) - triangle(0, 2, 3)).norm(), 1e-15);
  EXPECT_LT((whole - triangle(0, 1, 3) - triangle(1, 2, 3)).norm(), 1e-15);
}

TEST(SurfaceMesh, MirroringTwiceGivesTheSameSurface) {
  const SurfaceMesh mesh = wetWigley(wigley(2), 6, 3), back = mirroredInY(mirroredInY(mesh));
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
    EXPECT_EQ(mesh.vertices[i], back.vertices[i]);
  for (std::size_t k = 0; k < mesh.faces.size(); ++k)
    EXPECT_EQ(vectorArea(mesh, mesh.faces[k]), vectorArea(back, back.faces[k]));
}

TEST(SurfaceMesh, WeldingKeepsTheFirstVertexAndTurnsCollapsedQuadsIntoTriangles) {
  const SurfaceMesh mesh{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1 + 1e-7, 0}, {9, 9, 9}},
                         {{{0, 1, 2, 3}}, {{2, 3, 1, -1}}}};
  const SurfaceMesh out = welded(mesh, 1e-6);
  ASSERT_EQ(out.faces.size(), 1u);  // the second face collapses to a line
  EXPECT_EQ(out.faces[0].size(), 3);
  EXPECT_EQ(out.vertices.size(), 3u);
  EXPECT_EQ(out.vertices[2], Vec3(1, 1, 0));
  EXPECT_EQ(welded(mesh, 0.0).faces.size(), 2u);
}

TEST(SurfaceMesh, WeldingFindsNeighboursAcrossTheCellsOfItsGrid) {
  SurfaceMesh mesh;
  for (int i = 0; i < 300; ++i) {  // pairs 0.9 tolerance apart at every offset within a cell
    const double x = -5.0 + 0.03717 * i;
    const int n = static_cast<int>(mesh.vertices.size());
    for (const Vec3& p : {Vec3(x, -x, 2 * x), Vec3(x + 9e-5, -x, 2 * x), Vec3(x, 1 - x, 2 * x),
                          Vec3(x, -x, 2 * x + 1)})
      mesh.vertices.push_back(p);
    mesh.faces.push_back({{n, n + 2, n + 3, -1}});
    mesh.faces.push_back({{n + 1, n + 3, n + 2, -1}});
  }
  EXPECT_EQ(welded(mesh, 1e-4).vertices.size(), 900u);
  EXPECT_EQ(welded(mesh, 8e-5).vertices.size(), 1200u);
}

TEST(SurfaceMesh, BadIndicesAndTolerancesAreRefused) {
  const SurfaceMesh mesh{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, {{{0, 1, 3, -1}}}};
  EXPECT_THROW(welded(mesh, 0.0), HydroError);
  EXPECT_THROW(welded({}, -1.0), HydroError);
}

}  // namespace
}  // namespace cutwater
