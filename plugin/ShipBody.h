#pragma once
#include <array>
#include <memory>

#include "hydro/database/Coefficients.h"
#include "plugin/BulletTypes.h"

CUTWATER_PLUGIN_BEGIN

/// What a ship is to Bullet: shape, body, and a joint that holds some of her modes.

/// Convex hull of the ship's mesh in B (origin in G), of at most some forty of its vertices, taken
/// in directions spread evenly over her bounding box, so that a slender hull keeps her ends.
/// Bullet's collision margin, 4 cm, is added to it in contacts.
/// @throws HydroError DatabaseIncomplete: the database has no mesh.
std::unique_ptr<btCollisionShape> convexHull(const ShipParticulars& ship);

/// Mass m, principal inertias m·gyradii² about G, no motion state; not yet in a world.
/// @throws HydroError ValueOutOfRange: mass or a gyradius not positive.
std::unique_ptr<btRigidBody> makeBody(const ShipParticulars& ship, btCollisionShape& shape);

/// The coefficients belong to one mass distribution; another would float and roll differently.
/// @throws HydroError ValueOutOfRange: mass not within 0.1 %; BadArgument: not in a world.
void requireBodyOf(const ShipParticulars& ship, const btRigidBody& body);

/// A stock joint to the fixed world that holds the chosen modes at their value in `mean`, the pose
/// of the mean course, and leaves the others free; null if none is chosen. The body's pose is kept.
std::unique_ptr<btTypedConstraint> makeRestraint(btRigidBody& body, const btTransform& mean,
                                                 const std::array<bool, 6>& modes);

CUTWATER_PLUGIN_END
