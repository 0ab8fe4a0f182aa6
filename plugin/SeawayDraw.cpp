#include <algorithm>
#include <cmath>
#include <iterator>

#include "hydro/database/Coefficients.h"
#include "plugin/Seaway.h"
#include "plugin/ShipAxes.h"

CUTWATER_PLUGIN_BEGIN

namespace {

constexpr int kGrid = 12;             // cells of the wave grid to each side of a ship
constexpr double kCell = 0.125;       // of the ship's length
constexpr double kForceScale = 0.01;  // of its weight: 1 m of arrow

// One colour after the other in the order of the parts, so that a part has the same colour on all
// ships.
const btVector3 kColours[] = {btVector3(1, 1, 1), btVector3(0.2f, 0.4f, 1), btVector3(0, 1, 1),
                              btVector3(0, 1, 0), btVector3(1, 1, 0),       btVector3(1, 0.5f, 0),
                              btVector3(1, 0, 1), btVector3(1, 0, 0)};

// Gravity is drawn with the part that carries it: what is left of both. Without one, by itself.
void drawForces(btIDebugDraw& drawer, const Ship& ship, const WorldFrame& frame) {
  const ShipParticulars& p = ship.coefficients().ship;
  const double scale = 1.0 / (kForceScale * p.mass * p.gravity);
  const Mat3 course = rotationZ(ship.course().heading());
  const std::vector<Vec6>& loads = ship.lastTick().loads;
  const std::vector<std::string_view> parts = ship.parts();
  const std::size_t carrier = ship.weightCarrier();
  for (std::size_t i = 0; i < loads.size(); ++i) {
    if (parts[i] == "gravity" && carrier < parts.size()) continue;
    Vec3 force = loads[i].head<3>();
    if (i == carrier) force += ship.load("gravity").head<3>();
    const Vec3 tip = ship.position() + scale * (course * force);
    const btVector3& colour = kColours[i % std::size(kColours)];
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
  for (const auto& one : floats()) {
    for (const auto& [a, b] : one->waterline()) {
      if (a.allFinite() && b.allFinite())
        drawer.drawLine(frame_.place(a), frame_.place(b), btVector3(1, 1, 1));
    }
  }
}

CUTWATER_PLUGIN_END
