#pragma once
#include <array>
#include <memory>
#include <optional>

#include "hydro/database/Coefficients.h"
#include "plugin/WorldFrame.h"

CUTWATER_PLUGIN_BEGIN

/// Makes a ship's collision shape and body for Bullet, in the world's axes and units.

/// Convex hull of the ship's mesh in B (origin in G), of at most some forty of its vertices, taken
/// in directions spread evenly over its bounding box, so that a slender hull keeps its ends.
/// Its collision margin, which contacts add to it, is 1 % of the half beam, and never more than
/// Bullet's default of 0.04 units.
/// @param deck  only what of the mesh is below this height above calm water [m]; flat there.
/// @throws HydroError DatabaseIncomplete: the database has no mesh; ValueOutOfRange: a deck that is
///         not between calm water and the top of the mesh.
std::unique_ptr<btCollisionShape> convexHull(const ShipParticulars& ship, const WorldFrame& frame,
                                             std::optional<double> deck = {});

/// A shape given in the hull file's axes, moved to G; `shape` must outlive it.
std::unique_ptr<btCollisionShape> aboutG(btCollisionShape& shape, const ShipParticulars& ship,
                                         const WorldFrame& frame);

/// To make its body from: mass m, principal inertias m·gyradii² about G, no motion state.
/// @throws HydroError ValueOutOfRange: mass or a gyradius not positive.
btRigidBody::btRigidBodyConstructionInfo bodyInfo(const ShipParticulars& ship,
                                                  const WorldFrame& frame, btCollisionShape& shape);

/// The coefficients belong to one mass distribution; another would float and roll differently.
/// @throws HydroError ValueOutOfRange: mass not within 0.1 %; BadArgument: not in a world.
void requireBodyOf(const ShipParticulars& ship, const WorldFrame& frame, const btRigidBody& body);

/// Whether a world's gravity points down and is within 5 % of a database's [m/s²]: Bullet's own
/// examples take 10 m/s², and a ship's weight is carried.
bool gravityFits(const btVector3& gravity, const WorldFrame& frame, double right) noexcept;

/// Of a snapshot: linear and angular velocity, and the interpolated ones; and a body put back to
/// them and its poses.
std::array<btVector3, 4> velocitiesOf(const btRigidBody& body) noexcept;
void putBack(btRigidBody& body, const btTransform& pose, const btTransform& interpolated,
             const std::array<btVector3, 4>& velocities, int activation) noexcept;

CUTWATER_PLUGIN_END
