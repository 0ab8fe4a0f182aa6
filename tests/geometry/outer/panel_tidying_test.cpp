#include <gtest/gtest.h>

#include "hydro/geometry/MeshIntegrals.h"
#include "hydro/geometry/outer/PanelTidying.h"
#include "tests/geometry/outer/OuterBodies.h"

namespace cutwater {
namespace {

TEST(PanelTidyingIdentity, WhatIsTidyStaysAsItIs) {
  const SurfaceMesh sphere = closedSphere(2.0, 12, 8);
  const std::vector<Face> faces = tidied(sphere);
  EXPECT_TRUE(test::sameFaces(sphere, {sphere.vertices, faces}));
}

TEST(PanelTidyingClosedForm, ASliversMiddleCornerGoesToTheFaceAcrossItsLongestEdge) {
  // A square, an edge of which has a sliver of 0.001 m beside it, and a square beyond that.
  const SurfaceMesh mesh{
      {{0, 0, -1}, {1, 0, -1}, {1, 1, -1}, {0, 1, -1}, {0.5, 1.001, -1}, {1, 2, -1}, {0, 2, -1}},
      {{{0, 1, 2, 3}}, {{3, 2, 4, -1}}, {{3, 4, 6, -1}}, {{4, 2, 5, -1}}, {{4, 5, 6, -1}}}};
  const SurfaceMesh tidy{mesh.vertices, tidied(mesh)};
  EXPECT_NEAR(surfaceArea(tidy), 2.0, 1e-12);
  for (const Face& f : tidy.faces) EXPECT_GT(vectorArea(tidy, f).z(), 0.1);
  EXPECT_EQ(openEdges(tidy).size(), 6u);  // around both squares
}

TEST(PanelTidyingClosedForm, AReentrantQuadrilateralIsDividedWithin) {
  const SurfaceMesh mesh{{{0, 0, -1}, {2, 0, -1}, {0.4, 0.4, -1}, {0, 2, -1}}, {{{0, 1, 2, 3}}}};
  const SurfaceMesh turned{mesh.vertices, {{{1, 2, 3, 0}}}};
  for (const SurfaceMesh& m : {mesh, turned}) {
    const SurfaceMesh tidy{m.vertices, tidied(m)};
    ASSERT_EQ(tidy.faces.size(), 2u);
    for (const Face& f : tidy.faces) EXPECT_NEAR(vectorArea(tidy, f).z(), 0.4, 1e-12);
  }
}

}  // namespace
}  // namespace cutwater
