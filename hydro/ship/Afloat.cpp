#include "hydro/ship/Afloat.h"

namespace cutwater {

PanelledHull panelledAsItIs(const Hull& hull) {
  return {hull.surface, wetSurface(hull), hull.symmetric, hull.file};
}

SurfaceMesh wholeWet(const PanelledHull& hull) {
  return hull.symmetric ? bothHalves(hull.panels) : hull.panels;
}

namespace {

/// What the ship displaces: the part of its hull below calm water, both sides.
SurfaceMesh displacing(const PanelledHull& hull) {
  if (hull.surface.faces.empty()) return wholeWet(hull);
  return displacingSurface({hull.surface, hull.symmetric, false});
}

}  // namespace

Afloat afloat(const PanelledHull& hull, const Loading& loading, const Water& water) {
  const SurfaceMesh wet = displacing(hull);
  Vec3 cog = loading.cog;
  if (loading.level) {
    const Vec3 buoyancy = hydrostatics(wet, cog, water.density, water.gravity).buoyancy;
    cog.x() = buoyancy.x();
    cog.y() = hull.symmetric ? 0.0 : buoyancy.y();
  }
  Afloat result;
  result.hydrostatics = hydrostatics(wet, cog, water.density, water.gravity);
  const Hydrostatics& h = result.hydrostatics;
  ShipParticulars& ship = result.ship;
  ship.hull = hull.surface;
  ship.wetSurface = hull.panels;
  ship.symmetric = hull.symmetric;
  ship.file = hull.file;
  ship.mass = loading.mass.value_or(h.displacement);
  ship.cog = cog;
  ship.gyradii = loading.gyradii.value_or(Vec3(0.35 * h.beam, 0.25 * h.length, 0.25 * h.length));
  ship.volume = h.volume;
  ship.centreOfBuoyancy = h.buoyancy;
  ship.restoring = h.restoring;
  ship.density = water.density;
  ship.gravity = water.gravity;
  ship.supplementary = loading.supplementary;
  return result;
}

Hydrostatics hydrostaticsOf(const ShipParticulars& ship) {
  const SurfaceMesh wet = displacing({ship.hull, ship.wetSurface, ship.symmetric, ship.file});
  return hydrostatics(wet, ship.cog, ship.density, ship.gravity);
}

}  // namespace cutwater
