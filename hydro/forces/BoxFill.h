#pragma once
#include "hydro/Conventions.h"

namespace cutwater {

/// Water in a box that lies as it likes, under a level surface. Closed form but for the height of
/// the surface, which is found by Newton's method to rounding. Allocates nothing.
///     const BoxFill half = fillBox({10, 4, 3}, 60.0, up);   // half of 120 m³
struct BoxFill {
  double volume = 0.0;         ///< [m³]
  Vec3 centre = Vec3::Zero();  ///< of the water, from the middle of the box in its axes [m]
  double height = 0.0;         ///< of the surface above the middle of the box, along `up` [m]
  double surface = 0.0;        ///< area of the surface within the box [m²]
};

/// @param size  length, breadth, height [m], > 0, along the box's axes.
/// @param volume  of water [m³]; below 0 counts as 0, beyond the box as the whole box.
/// @param up  unit vector in the box's axes, normal to the surface.
BoxFill fillBox(const Vec3& size, double volume, const Vec3& up) noexcept;

/// The same for a surface at a height [m] above the middle of the box.
BoxFill fillBoxTo(const Vec3& size, double height, const Vec3& up) noexcept;

}  // namespace cutwater
