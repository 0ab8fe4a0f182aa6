#pragma once
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

  /// Rigid-body mass matrix about G: diag(m, m, m, m r_xx², m r_yy², m r_zz²).
  Mat6 massMatrix() const;
  /// Of the wet surface, along and across [m]; without one as a ship of that volume: five cube
  /// roots of it, and a seventh of that.
  double length() const;
  double beam() const;
  /// Of the hull, above water too [m]; without a hull length().
  double lengthOverall() const;
};

}  // namespace cutwater
