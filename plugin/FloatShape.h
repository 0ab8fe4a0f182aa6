#pragma once
#include "hydro/geometry/SurfaceMesh.h"
#include "plugin/BulletTypes.h"

CUTWATER_PLUGIN_BEGIN

/// What a collision shape encloses, as a closed mesh in its own axes and units, with its own
/// scaling: boxes, balls, cylinders and capsules with their margin, cones and convex hulls as their
/// points say, compounds of these. Other convex shapes by the hull of their support in 500
/// directions.
/// @throws HydroError BadArgument: a shape that encloses nothing that is known (triangle meshes,
///         planes, terrains), or a compound whose children overlap in more than a hundredth of
///         their volume, which would count twice.
SurfaceMesh meshOf(const btCollisionShape& shape);

CUTWATER_PLUGIN_END
