#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "hydro/geometry/panelling/StationField.h"
#include "hydro/geometry/shapes/Shapes.h"
#include "tests/support/Hulls.h"

namespace cutwater {
namespace {

/// A box of 40 × 8 × 4 m whose stern leans, x = −20 + rake z, and what is aft of midships with it.
SurfaceMesh rakedBox(double rake) {
  SurfaceMesh box = bothHalves(wetBox({40, 8, 4, 1}, 20, 4, 4));
  for (Vec3& p : box.vertices)
    if (p.x() < 0) p.x() += rake * p.z() * p.x() / -20;
  return box;
}

/// Half ellipsoid whose ends lean by `rake` a metre of depth, and what lies between in proportion.
SurfaceMesh rakedEllipsoid(double rake) {
  SurfaceMesh hull = bothHalves(wetHalfEllipsoid({20, 3, 2}, 40, 8));
  for (Vec3& p : hull.vertices) p.x() *= 1 + rake * p.z() / 20;
  return hull;
}

TEST(StationFieldClosedForm, UprightEndsHaveStationsAcrossTheHull) {
  for (const SurfaceMesh& hull :
       {bothHalves(wetBox({40, 8, 4, 1}, 20, 4, 4)), wetBox({40, 8, 4, 1}, 20, 4, 4)}) {
    const std::vector<double> station = stationField(hull, 1.0);
    ASSERT_EQ(station.size(), hull.vertices.size());
    // The mean plane of an end is that of its faces to round-off.
    for (std::size_t i = 0; i < station.size(); ++i)
      EXPECT_NEAR(station[i], hull.vertices[i].x(), 1e-13);
  }
}

TEST(StationFieldClosedForm, ALeaningTransomIsOneStation) {
  for (const double rake : {-0.5, 0.2, 0.5}) {
    const SurfaceMesh box = rakedBox(rake);
    const std::vector<double> station = stationField(box, 1.0);
    int onTransom = 0;
    for (std::size_t i = 0; i < station.size(); ++i) {
      const Vec3& p = box.vertices[i];
      if (std::abs(p.x() - (-20 + rake * p.z())) < 1e-9) {
        EXPECT_EQ(station[i], station[0]) << p.transpose();
        EXPECT_NEAR(station[i], -20.0, 1e-12);  // where it meets calm water
        ++onTransom;
      } else if (p.x() >= 0) {
        EXPECT_NEAR(station[i], p.x(), 1e-13);
      }
    }
    EXPECT_EQ(onTransom, 9 * 5);
  }
}

TEST(StationField, StationsDoNotTurnBackAlongTheHull) {
  const SurfaceMesh box = rakedBox(0.5);
  const std::vector<double> station = stationField(box, 1.0);
  for (std::size_t i = 0; i < station.size(); ++i)
    for (std::size_t k = 0; k < station.size(); ++k) {
      const Vec3 &p = box.vertices[i], &q = box.vertices[k];
      if (p.z() == q.z() && p.x() < q.x() - 1e-9) {
        EXPECT_LT(station[i], station[k]);
      }
    }
}

TEST(StationField, AFaceSmallerThanTheLeastAreaIsNoEnd) {
  const SurfaceMesh box = rakedBox(0.05);
  const double area = 8 * 4 * std::hypot(1.0, 0.05);
  const auto lean = [&](double least) {
    const std::vector<double> station = stationField(box, least);
    double most = 0.0;
    for (std::size_t i = 0; i < station.size(); ++i)
      most = std::max(most, std::abs(station[i] - box.vertices[i].x()));
    return most;
  };
  EXPECT_NEAR(lean(0.99 * area), 0.05 * 4, 1e-9);  // the foot of the transom
  // Then it may be a stem, whose stations are planes through one line: they lean farther in.
  const std::vector<double> face = stationField(box, 0.99 * area),
                            none = stationField(box, 1.01 * area);
  EXPECT_NE(face, none);
}

TEST(StationField, ARoughTransomIsStillOneStation) {
  // 2e-4 of 41 m may be off; this is a tenth.
  const SurfaceMesh box = test::shaken(rakedBox(0.3), 8e-4);
  const std::vector<double> station = stationField(box, 1.0);
  const SurfaceMesh smooth = rakedBox(0.3);
  std::vector<double> transom;
  for (std::size_t i = 0; i < station.size(); ++i)
    if (std::abs(smooth.vertices[i].x() - (-20 + 0.3 * smooth.vertices[i].z())) < 1e-9)
      transom.push_back(station[i]);
  ASSERT_EQ(transom.size(), 45u);
  EXPECT_EQ(*std::min_element(transom.begin(), transom.end()),
            *std::max_element(transom.begin(), transom.end()));
}

TEST(StationFieldClosedForm, ARakedStemIsOneStation) {
  const double rake = 0.3;
  SurfaceMesh
      hull;  // a wedge of 20 m: port and starboard planes from a broad stern to a raked stem
  for (const double side : {1.0, -1.0})
    for (int i = 0; i <= 20; ++i)
      for (int k = 0; k <= 4; ++k) {
        const double z = -k, stem = 20 + rake * z;
        hull.vertices.emplace_back(stem * i / 20, side * 3 * (1 - i / 20.0), z);
      }
  for (int i = 0; i < 20; ++i)
    for (int k = 0; k < 4; ++k) {
      const int v = 5 * i + k, w = v + 105;
      hull.faces.push_back({{v, v + 5, v + 6, v + 1}});
      hull.faces.push_back({{w, w + 1, w + 6, w + 5}});
    }
  const std::vector<double> station = stationField(hull, 1.0);
  for (std::size_t i = 0; i < station.size(); ++i) {
    const Vec3& p = hull.vertices[i];
    if (std::abs(p.x() - (20 + rake * p.z())) < 1e-9)
      EXPECT_EQ(station[i], 20.0) << p.transpose();
    else
      EXPECT_LT(station[i], 20.0) << p.transpose();
    if (p.z() != 0.0) continue;
    EXPECT_NEAR(station[i], p.x(), 1e-12);  // every station keeps its waterline
  }
}

TEST(StationFieldIdentity, TurnedEndForEndStationsChangeTheirSign) {
  for (const SurfaceMesh& hull : {rakedBox(0.4), rakedEllipsoid(0.3)}) {
    SurfaceMesh turned = hull;
    for (Vec3& p : turned.vertices) p = {-p.x(), -p.y(), p.z()};
    const std::vector<double> a = stationField(hull, 1.0), b = stationField(turned, 1.0);
    for (std::size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(a[i], -b[i], 1e-12);  // of 20 m
  }
}

TEST(StationFieldIdentity, TheMirrorImageHasTheSameStations) {
  for (const SurfaceMesh& hull : {rakedBox(0.4), rakedEllipsoid(0.3), wetFrigate(32, 7)}) {
    const std::vector<double> a = stationField(hull, 1.0), b = stationField(mirroredInY(hull), 1.0);
    for (std::size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(a[i], b[i], 1e-12);
  }
}

TEST(StationFieldIdentity, MetresAndStationsGrowTogether) {
  const SurfaceMesh hull = rakedBox(0.4);
  SurfaceMesh large = hull;
  for (Vec3& p : large.vertices) p *= 8.0;  // a power of two: exact
  const std::vector<double> a = stationField(hull, 1.0), b = stationField(large, 64.0);
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_EQ(8 * a[i], b[i]);
}

// A sphere sunk deeper than its centre bulges out below its waterline: stations lean as it does.
TEST(StationField, ABulgingEndIsFollowed) {
  SurfaceMesh ball = test::moved(closedSphere(10, 48, 24), {0, 0, -3});
  std::erase_if(ball.faces, [&](const Face& f) {
    return ball.corner(f, 0).z() > 0 || ball.corner(f, 1).z() > 0 || ball.corner(f, 2).z() > 0;
  });
  ball = welded(ball, 0.0);
  double top = -1e300;
  for (const Vec3& p : ball.vertices) top = std::max(top, p.z());
  ball = test::moved(ball, {0, 0, -top});
  for (Vec3& p : ball.vertices)
    if (std::abs(p.z()) < 1e-9) p.z() = 0.0;
  double tip = 0.0;
  for (const Vec3& p : ball.vertices)
    if (p.z() == 0.0) tip = std::max(tip, p.x());
  const std::vector<double> station = stationField(ball, 1e9);
  const auto most = *std::max_element(station.begin(), station.end());
  EXPECT_EQ(most, tip);  // no station lies beyond the waterline's end, though the hull does
  EXPECT_GT(bounds(ball).high.x(), tip + 0.1);
}

}  // namespace
}  // namespace cutwater
