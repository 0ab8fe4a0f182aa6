#pragma once
#include <functional>
#include <string>
#include <vector>

#include "hydro/geometry/Hull.h"

/// Hulls on which panelling is judged, and the ways in which a mesh may be spoilt.
namespace cutwater::test {

/// A finely divided hull and the panels that its formula or table gives.
struct TestHull {
  std::string name;
  cutwater::Hull hull;
  std::function<SurfaceMesh(int panels)> structured;  ///< port half; 224, 433 or 1040 panels
};

/// Frigate, hemisphere, barge, a catamaran of two chined hulls with transoms, S-175: seconds to
/// build, as each test is a process of its own. One that needs one hull asks for that.
std::vector<TestHull> testHulls();
TestHull testFrigate();
TestHull testBarge();
TestHull testCatamaran();
TestHull testS175();

/// Demi-hull on its own centre plane, 60 × 6 × 3 m, vertical sides down to a chine, V bottom,
/// transom, sharp stem; closed by a deck 2 m up, or open at calm water.
SurfaceMesh chinedHull(int along, int sideRows, int bottomRows, bool closed);

SurfaceMesh moved(SurfaceMesh mesh, const Vec3& by);

/// Each triangle with vertices of its own.
SurfaceMesh unwelded(const SurfaceMesh& mesh);
/// Every vertex moved by up to `by` [m] along each axis; the same way each time.
SurfaceMesh shaken(SurfaceMesh mesh, double by);
/// About a third of the faces turned over.
SurfaceMesh turnedAtRandom(SurfaceMesh mesh);
/// A quarter of the faces twice, and some without area.
SurfaceMesh withDoubles(SurfaceMesh mesh);
/// Deck, bulkheads through it and a closed tank, all below water in the frigate.
SurfaceMesh withInterior(const SurfaceMesh& frigate);
/// Without the faces whose centre is nearer than `radius` [m] to one of the places.
SurfaceMesh withHoles(const SurfaceMesh& mesh, const std::vector<Vec3>& places, double radius);
/// The two halves moved apart where they meet at the keel, by twice `gap` [m]. The mesh must be
/// unwelded.
SurfaceMesh openAtKeel(SurfaceMesh mesh, double gap);
SurfaceMesh portHalf(const SurfaceMesh& mesh);

}  // namespace cutwater::test
