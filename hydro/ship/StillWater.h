#pragma once
#include "hydro/geometry/wetted/WettedTriangles.h"
#include "hydro/ship/ShipParticulars.h"

namespace cutwater {

/// A ship's closed hull held in calm water, upright, on its side or keel up, afloat or not.
///     StillWater water(ship);
///     const Attitude pose{.height = ship.cog.z(), .roll = 0.5};
///     const Immersed wet = water.at(pose);  // volume, where it is, load
///
/// Level axes: origin in G, x forward, y to port, both level, z up. The hull is turned by
/// R_y(pitch) R_x(roll): about its own x and the level y.

/// Where the hull is held.
/// THEORY.md, chapter 2.
struct Attitude {
  double height = 0.0;    ///< of G above calm water [m]
  double roll = 0.0;      ///< starboard down [rad]
  double pitch = 0.0;     ///< bow down [rad]
  Mat3 rotation() const;  ///< from hull axes to level axes
};

/// What the water does to the hull there; level axes.
struct Immersed {
  double volume = 0.0;         ///< under water [m³]
  Vec3 centre = Vec3::Zero();  ///< of that volume, from G [m]; 0 without one
  Vec3 force = Vec3::Zero();   ///< of the pressure ρg(−z) [N]
  Vec3 moment = Vec3::Zero();  ///< its moment about G [N·m]
};

/// How the volume under water V and its moment X = ∫x dV about G change with the pose.
struct ImmersedSlopes {
  double area = 0.0;         ///< −∂V/∂height: the waterplane [m²]
  double areaMoment = 0.0;   ///< ∂V/∂pitch = −∂X/∂height: ∫x dA over it [m³]
  double momentSlope = 0.0;  ///< ∂X/∂pitch: ∫x² dA + V z_B, with z_B above G [m⁴]
};

class StillWater {
 public:
  /// @throws HydroError HullNotClosed; MeshEmpty for a ship without a hull.
  explicit StillWater(const ShipParticulars& ship);

  /// O(triangles). One thread.
  Immersed at(const Attitude& pose);
  ImmersedSlopes slopes(const Attitude& pose);

  /// The pose that displaces `volume` with the roll and pitch of `guess`. The volume falls with
  /// height, so there is one such height; found to round-off. `guess.height` saves time.
  /// @pre 0 < volume < wholeVolume().
  Attitude afloat(double volume, const Attitude& guess);

  double wholeVolume() const noexcept { return hull_.volume(); }  ///< of the closed hull [m³]

 private:
  void setDepths(const Attitude& pose, const Vec3& up);

  WettedTriangles hull_;
  WettedTriangles::State state_;
  double weightOfWater_;  ///< ρg [N/m³]
};

/// Pressure of calm water on the hull at `pose`, weight left out: force in level axes [N], moment
/// about G [N·m] by its parts about the ship's own x, the level y and the vertical.
Vec6 buoyancyLoad(StillWater& water, const Attitude& pose);

/// The same to first order about the pose at rest, as the hull lies in its file: ρgV with its
/// moments, minus C η. `shift` is η: heave, roll and pitch from that pose.
Vec6 linearBuoyancyLoad(const ShipParticulars& ship, const Attitude& shift);

}  // namespace cutwater
