#include <algorithm>
#include <cmath>
#include <utility>

#include "plugin/Seaway.h"
#include "plugin/ShipAxes.h"

CUTWATER_PLUGIN_BEGIN

namespace {

constexpr int kGrid = 12;             // cells of the wave grid to each side of a ship
constexpr double kCell = 0.125;       // of her length
constexpr double kForceScale = 0.01;  // of her weight: 1 m of arrow

const std::pair<Vec6 ForceParts::*, btVector3> kArrows[] = {
    {&ForceParts::restoring, btVector3(0.2f, 0.4f, 1)},
    {&ForceParts::froudeKrylov, btVector3(0, 1, 1)},
    {&ForceParts::diffraction, btVector3(0, 1, 0)},
    {&ForceParts::radiation, btVector3(1, 1, 0)},
    {&ForceParts::addedMass, btVector3(1, 0.5f, 0)},
    {&ForceParts::supplementary, btVector3(1, 0, 1)}};

void drawForces(btIDebugDraw& drawer, const Ship& ship, const WorldFrame& frame) {
  const ShipParticulars& p = ship.coefficients().ship;
  const double scale = 1.0 / (kForceScale * p.mass * p.gravity);
  const Mat3 course = rotationZ(ship.course().heading());
  for (const auto& [part, colour] : kArrows) {
    const Vec3 force = (ship.lastTick().forces.*part).head<3>();
    const Vec3 weight = part == &ForceParts::restoring
                            ? Vec3(ship.lastTick().forces.gravity.head<3>())
                            : Vec3(Vec3::Zero());
    const Vec3 tip = ship.position() + scale * (course * (force + weight));
    if (tip.allFinite()) drawer.drawLine(frame.place(ship.position()), frame.place(tip), colour);
  }
}

// Where the hull's triangles cross the surface of the waves.
void drawWaterline(btIDebugDraw& drawer, const Ship& ship, const Seaway& sea) {
  const SurfaceMesh& hull = ship.coefficients().ship.hull;
  const auto place = [&](int i) {
    return ship.pointMotion(hull.vertices[static_cast<std::size_t>(i)]).position;
  };
  const auto above = [&](const Vec3& p) { return p.z() - sea.waveHeight(p.x(), p.y()); };
  for (const auto& face : hull.faces) {
    Vec3 ends[2];
    int found = 0;
    const int n = face.size();
    for (int i = 0; i < n && found < 2; ++i) {
      const Vec3 a = place(face[i]), b = place(face[(i + 1) % n]);
      const double ha = above(a), hb = above(b);
      if ((ha < 0.0) == (hb < 0.0)) continue;
      ends[found++] = a + ha / (ha - hb) * (b - a);
    }
    if (found == 2)
      drawer.drawLine(sea.frame().place(ends[0]), sea.frame().place(ends[1]), btVector3(1, 1, 1));
  }
}

void drawWaves(btIDebugDraw& drawer, const Seaway& sea, const Vec3& middle, double cell) {
  const auto node = [&](int i, int j) {
    const double x = cell * std::floor(middle.x() / cell) + cell * i;
    const double y = cell * std::floor(middle.y() / cell) + cell * j;
    return sea.frame().place(Vec3(x, y, sea.waveHeight(x, y)));
  };
  const btVector3 colour(0, 0.3f, 0.6f);
  for (int i = -kGrid; i < kGrid; ++i) {
    for (int j = -kGrid; j < kGrid; ++j) {
      const btVector3 at = node(i, j);
      drawer.drawLine(at, node(i + 1, j), colour);
      drawer.drawLine(at, node(i, j + 1), colour);
    }
  }
}

}  // namespace

void Seaway::debugDraw(btIDebugDraw& drawer) const {
  for (const auto& ship : ships_) {
    if (!ship->position().allFinite()) continue;
    drawWaves(drawer, *this, ship->position(), kCell * ship->length());
    drawWaterline(drawer, *ship, *this);
    drawForces(drawer, *ship, frame_);
  }
}

CUTWATER_PLUGIN_END
