#pragma once
#include "demos/make_meshes/Glb.h"

namespace cutwater::meshes {

/// BOAT-12, a round-bilged motor boat of 12 m with an immersed transom, a wheelhouse on a coachroof
/// and a mast. x = 0 is halfway between transom and bow, z = 0 calm water. Parts:
///     hull       closed: bottom, topsides and deck are surfaces of it; what the water acts on
///     transom    board on the transom, above water, closed
///     coachroof, wheelhouse, mast   closed; each stands on what is below it, without overlap
///     rudder     the blade, a plate without thickness
Model boat();

}  // namespace cutwater::meshes
