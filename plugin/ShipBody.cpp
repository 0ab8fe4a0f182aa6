#include "plugin/ShipBody.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "hydro/Errors.h"
#include "hydro/geometry/MeshCut.h"

CUTWATER_PLUGIN_BEGIN

namespace {

void requirePositive(double value, const char* what) {
  if (std::isfinite(value) && value > 0.0) return;
  throw HydroError(Fault::ValueOutOfRange, std::string("Seaway::addShip: ") + what +
                                               " is not positive: " + std::to_string(value));
}

constexpr double kMarginOfHalfBeam = 0.01;

void requireDeck(double deck, double top) {
  if (deck > 0.0 && deck <= top) return;
  throw HydroError(Fault::ValueOutOfRange,
                   "Seaway::addShip: collision.deck = " + std::to_string(deck) +
                       " m: must be above calm water, 0 m, and at most at the top of the hull's "
                       "mesh, " +
                       std::to_string(top) + " m");
}

// What is below the deck: vertices, and the points where edges cross it.
std::vector<Vec3> pointsBelow(const SurfaceMesh& hull, double deck) {
  requireDeck(deck, bounds(hull).high.z());
  std::vector<Vec3> points = cutBelow(hull, {Vec3::UnitZ(), deck}).vertices;
  if (!points.empty()) return points;
  throw HydroError(Fault::DatabaseIncomplete,
                   "Seaway::addShip: the database's hull has no faces to cut at collision.deck");
}

// All vertices in B: of the closed hull, or of the panels where a file has nothing else.
std::vector<Vec3> hullPoints(const ShipParticulars& ship, std::optional<double> deck) {
  const bool closed = !ship.hull.vertices.empty();
  std::vector<Vec3> points = closed ? ship.hull.vertices : ship.wetSurface.vertices;
  if (points.empty()) {
    throw HydroError(
        Fault::DatabaseIncomplete,
        "Seaway::addShip: the database has no hull; give ShipSettings::collision.shape");
  }
  if (deck) {
    points = pointsBelow(closed ? ship.hull : ship.wetSurface, *deck);
  }
  if (!closed && ship.symmetric) {
    const std::size_t half = points.size();
    for (std::size_t i = 0; i < half; ++i) {
      points.emplace_back(points[i].x(), -points[i].y(), points[i].z());
    }
  }
  for (Vec3& point : points) point -= ship.cog;
  return points;
}

// Indices of the points that lie farthest out in 124 directions of the bounding box made a cube:
// along its axes, its diagonals and between.
std::set<std::size_t> farthest(const std::vector<Vec3>& points, const Vec3& extent) {
  std::set<std::size_t> chosen;
  for (int code = 0; code < 125; ++code) {
    const int i = code % 5 - 2, j = code / 5 % 5 - 2, k = code / 25 - 2;
    const Vec3 direction = Vec3(i, j, k).cwiseQuotient(extent);
    const auto behind = [&](const Vec3& a, const Vec3& b) {
      return direction.dot(a) < direction.dot(b);
    };
    const auto best = std::max_element(points.begin(), points.end(), behind);
    if (code != 62)
      chosen.insert(static_cast<std::size_t>(best - points.begin()));  // not (0, 0, 0)
  }
  return chosen;
}

}  // namespace

std::unique_ptr<btCollisionShape> convexHull(const ShipParticulars& ship, const WorldFrame& frame,
                                             std::optional<double> deck) {
  const std::vector<Vec3> points = hullPoints(ship, deck);
  Vec3 low = points[0], high = points[0];
  for (const Vec3& point : points) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  const Vec3 extent = (high - low).cwiseMax(1e-3);
  auto shape = std::make_unique<btConvexHullShape>();
  const double margin = kMarginOfHalfBeam * 0.5 * extent.y() / frame.metresPerUnit;
  shape->setMargin(std::min(shape->getMargin(), static_cast<btScalar>(margin)));
  for (const std::size_t i : farthest(points, extent)) {
    shape->addPoint(frame.length(points[i]), false);
  }
  shape->recalcLocalAabb();
  return shape;
}

std::unique_ptr<btCollisionShape> aboutG(btCollisionShape& shape, const ShipParticulars& ship,
                                         const WorldFrame& frame) {
  auto compound = std::make_unique<btCompoundShape>();
  compound->addChildShape(btTransform(btQuaternion::getIdentity(), frame.length(-ship.cog)),
                          &shape);
  return compound;
}

btRigidBody::btRigidBodyConstructionInfo bodyInfo(const ShipParticulars& ship,
                                                  const WorldFrame& frame,
                                                  btCollisionShape& shape) {
  requirePositive(ship.mass, "mass");
  for (int i = 0; i < 3; ++i) requirePositive(ship.gyradii[i], "a gyradius");
  const Vec3 inertia = ship.mass * ship.gyradii.cwiseProduct(ship.gyradii);
  return {static_cast<btScalar>(ship.mass / frame.kilogramsPerUnit), nullptr, &shape,
          frame.inertia(inertia)};
}

void requireBodyOf(const ShipParticulars& ship, const WorldFrame& frame, const btRigidBody& body) {
  const double mass = frame.kilogramsPerUnit / static_cast<double>(body.getInvMass());
  if (!(std::abs(mass - ship.mass) <= 1e-3 * ship.mass)) {
    throw HydroError(Fault::ValueOutOfRange,
                     "Seaway::addShip: the body's mass " + std::to_string(mass) +
                         " kg is not that of the database, " + std::to_string(ship.mass) + " kg");
  }
  if (!body.isInWorld()) {
    throw HydroError(Fault::BadArgument, "Seaway::addShip: add the body to the world first");
  }
}

bool gravityFits(const btVector3& gravity, const WorldFrame& frame, double right) noexcept {
  const Vec3 g = frame.lengthToEarth(gravity);
  const double sideways = std::hypot(g.x(), g.y());
  return sideways <= 1e-6 * right && std::abs(-g.z() - right) <= 0.05 * right;
}

std::array<btVector3, 4> velocitiesOf(const btRigidBody& body) noexcept {
  return {body.getLinearVelocity(), body.getAngularVelocity(),
          body.getInterpolationLinearVelocity(), body.getInterpolationAngularVelocity()};
}

void putBack(btRigidBody& body, const btTransform& pose, const btTransform& interpolated,
             const std::array<btVector3, 4>& velocities, int activation) noexcept {
  body.setCenterOfMassTransform(pose);
  body.setInterpolationWorldTransform(interpolated);
  body.setLinearVelocity(velocities[0]);
  body.setAngularVelocity(velocities[1]);
  body.setInterpolationLinearVelocity(velocities[2]);
  body.setInterpolationAngularVelocity(velocities[3]);
  body.forceActivationState(activation);
}

CUTWATER_PLUGIN_END
