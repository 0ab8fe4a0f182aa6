#pragma once
#include <optional>

#include "hydro/geometry/Hull.h"
#include "hydro/geometry/Hydrostatics.h"
#include "hydro/ship/ShipParticulars.h"

namespace cutwater {

/// A hull and the panels of its wet part, which may be another division of the same surface.
struct PanelledHull {
  SurfaceMesh surface;  ///< both sides, wet and dry; empty: the ship has no hull, only panels
  SurfaceMesh panels;   ///< of the port half if symmetric, else of both sides
  bool symmetric = false;
  FilePlacement file = {};  ///< Hull::file
  /// The panels' corners stand off the surface so far that they enclose its volume: they are to be
  /// taken as flat (PanelShape).
  bool filledOut = false;
};
/// A hull whose own faces below water are the panels.
PanelledHull panelledAsItIs(const Hull& hull);
/// The panels of both sides, vertices shared.
SurfaceMesh wholeWet(const PanelledHull& hull);

/// What the ship weighs and where. What is absent follows from the hull.
struct Loading {
  std::optional<double> mass = {};  ///< [kg]; absent: density × volume
  Vec3 cog = Vec3::Zero();          ///< centre of gravity in hull axes [m]
  /// The ship floats as it lies: cog stands over the centre of buoyancy, its x (without symmetry
  /// its y as well) is not read.
  bool level = false;
  /// Roll, pitch, yaw, about G [m]; absent: 0.35 B, 0.25 L, 0.25 L.
  std::optional<Vec3> gyradii = {};
  Supplementary supplementary = {};
};

struct Water {
  double density = kSeaWaterDensity;  ///< [kg/m³]
  double gravity = kStandardGravity;  ///< [m/s²]
};

/// A ship at rest: what solver and database take, and its hydrostatics.
struct Afloat {
  ShipParticulars ship;
  Hydrostatics hydrostatics;
};

/// Lets a hull float as it lies:
///     const Hull hull = readHull("frigate.obj");  // files/MeshIO.h
///     const Loading loading{.cog = {0, 0, 1.29}, .level = true};
///     ShipParticulars ship = afloat(panelledAsItIs(hull), loading).ship;
/// Fills everything but the name: hull and panels, mass, centre of gravity, gyradii, volume, centre
/// of buoyancy, C. Volume and C are the hull's; panels, inscribed in it, would lack some.
/// @throws HydroError as hydrostatics.
Afloat afloat(const PanelledHull& hull, const Loading& loading = {}, const Water& water = {});

/// The hydrostatics again of a ship that was made so, as one read from a database: of its hull, or
/// without one of its panels.
/// @throws HydroError as hydrostatics.
Hydrostatics hydrostaticsOf(const ShipParticulars& ship);

}  // namespace cutwater
