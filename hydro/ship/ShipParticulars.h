#pragma once
#include <optional>
#include <string>

#include "hydro/Conventions.h"
#include "hydro/geometry/SurfaceMesh.h"

namespace cutwater {

/// A ship as the solver and the database take it.
///     ShipParticulars ship = afloat(panelledAsItIs(readHull("frigate.obj"))).ship;
///     ship.name = "frigate";
///     ship.supplementary.damping[Roll] = 2e7;

/// Terms that potential theory lacks, given by the user: the force on the ship is
/// −damping·η̇ − quadratic·|η̇₄|η̇₄ − stiffness·η.
struct Supplementary {
  Vec6 damping = Vec6::Zero();        ///< diagonal, N/(m/s) or N·m/(rad/s)
  Vec6 stiffness = Vec6::Zero();      ///< diagonal, N/m or N·m/rad
  double rollDampingQuadratic = 0.0;  ///< N·m/(rad/s)²
};

/// Calm-water drag of the hull (forces/manoeuvring/Resistance.h), which potential theory lacks.
struct HullDrag {
  /// C_D of the flow from abeam, of the lateral area. Hoerner's curve for ships [Faltinsen 1990]
  /// goes from 2 (B/2T < 0.4) through 0.9 (B/2T = 0.8) to 0.6 (B/2T > 2.5); bilge keels add to it.
  double crossFlow = 1.0;
  /// k: viscous resistance is 1 + k times the friction of a plate. Prohaska's method gives 0.1 to
  /// 0.4 for ships.
  double formFactor = 0.2;
};

/// An engine with its propellers, taken as one (forces/appendages/Engine.h has the formulas, and
/// what follows from the hull where a value is absent). EngineParticulars{} suffices to sail.
struct EngineParticulars {
  std::optional<double> maxThrust = {};      ///< ahead, with the ship at rest [N]
  double astern = 0.5;                       ///< greatest thrust astern, as a share of that
  std::optional<double> noThrustSpeed = {};  ///< at which full thrust has fallen to 0 [m/s]
  std::optional<double> timeConstant = {};   ///< [s] with which thrust follows its order
  std::optional<double> diameter = {};       ///< of one propeller of the same thrust [m]
  std::optional<Vec3> place = {};            ///< of the thrust, in hull axes [m]
};

/// A rudder, or several taken as one (forces/appendages/Rudder.h). RudderParticulars{} suffices.
struct RudderParticulars {
  std::optional<double> area = {};  ///< of the blade [m²]
  std::optional<Vec3> place = {};   ///< of the force, in hull axes [m]
  double aspectRatio = 1.5;         ///< height² / area
  double limit = 35.0 * kPi / 180;  ///< largest angle [rad]
  std::optional<double> rate = {};  ///< of its turning [rad/s]
  double stall = 35.0 * kPi / 180;  ///< incidence at which the flow begins to separate [rad]
  double slipstream = 0.4;          ///< share of the propeller's jet that meets the blade
  double flowStraightening = 0.5;   ///< incidence left of leeway and turning behind the hull
};

/// The ship as it floats at rest: hull, mass, hydrostatic stiffness. `afloat` (ship/Afloat.h) fills
/// all of it. Lengths in hull axes: x forward, y port, z up from calm water.
struct ShipParticulars {
  std::string name;
  SurfaceMesh hull;        ///< closed hull [m], normals out; empty in a plain BEMIO file
  SurfaceMesh wetSurface;  ///< the solver's panels before flattening; port half if symmetric
  bool symmetric = false;
  /// Axes, unit and origin of the file that the hull was read from, so that a program can draw that
  /// file where the ship is. Hull axes themselves if that is not known: hulls that were not read
  /// from a file, databases of format 5 and before, databases of other codes.
  FilePlacement file;
  double mass = 0.0;            ///< [kg]
  Vec3 cog = Vec3::Zero();      ///< centre of gravity G [m]
  Vec3 gyradii = Vec3::Ones();  ///< roll, pitch, yaw, about G [m]
  double volume = 0.0;          ///< displaced [m³]
  Vec3 centreOfBuoyancy = Vec3::Zero();
  Mat6 restoring = Mat6::Zero();  ///< C about G, gravity and density included [N/m, N, N·m]
  double density = kSeaWaterDensity;
  double gravity = kStandardGravity;
  Supplementary supplementary;
  HullDrag drag;
  std::optional<EngineParticulars> engine;  ///< absent: the ship has none
  std::optional<RudderParticulars> rudder;

  /// Rigid-body mass matrix about G: diag(m, m, m, m r_xx², m r_yy², m r_zz²).
  Mat6 massMatrix() const;
  /// Of the wet surface, along and across [m]; without one as a ship of that volume: five cube
  /// roots of it, and a seventh of that.
  double length() const;
  double beam() const;
  /// Depth of its lowest point [m]; without one that of a box of this length, beam and volume.
  double draught() const;
  /// Its aft end in hull axes [m]; without one half a length aft of G.
  double sternX() const;
  /// Of the hull, above water too [m]; without a hull length().
  double lengthOverall() const;
};

/// Refuse what no ship has. @param where begins the message: a file or a function.
/// @throws HydroError ValueOutOfRange, naming the key of ship.toml, value and bounds.
void requireUsable(const HullDrag& drag, const std::string& where);
void requireUsable(const EngineParticulars& engine, const std::string& where);
void requireUsable(const RudderParticulars& rudder, const std::string& where);

}  // namespace cutwater
