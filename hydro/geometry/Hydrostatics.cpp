#include "hydro/geometry/Hydrostatics.h"

#include <cmath>
#include <string>

#include "hydro/Errors.h"
#include "hydro/geometry/MeshIntegrals.h"

namespace cutwater {
namespace {

/// Integrals with x and y measured from G.
WaterplaneIntegrals about(const WaterplaneIntegrals& w, double x, double y) {
  return {w.area,
          w.x - x * w.area,
          w.y - y * w.area,
          w.xx - 2 * x * w.x + x * x * w.area,
          w.xy - x * w.y - y * w.x + x * y * w.area,
          w.yy - 2 * y * w.y + y * y * w.area};
}

Mat6 restoringMatrix(const WaterplaneIntegrals& w, double volume, const Vec3& arm) {
  Mat6 c = Mat6::Zero();
  c(Heave, Heave) = w.area;
  c(Heave, Roll) = c(Roll, Heave) = w.y;
  c(Heave, Pitch) = c(Pitch, Heave) = -w.x;
  c(Roll, Roll) = w.yy + volume * arm.z();
  c(Roll, Pitch) = c(Pitch, Roll) = -w.xy;
  c(Pitch, Pitch) = w.xx + volume * arm.z();
  c(Roll, Yaw) = -volume * arm.x();
  c(Pitch, Yaw) = -volume * arm.y();
  return c;
}

/// Extent of the waterline along x and y.
Vec3 waterlineExtent(const SurfaceMesh& wet) {
  const double tolerance = 1e-9 * bounds(wet).diagonal();
  SurfaceMesh line;
  for (const Vec3& p : wet.vertices)
    if (std::abs(p.z()) <= tolerance) line.vertices.push_back(p);
  const Bounds b = bounds(line);
  return b.high - b.low;
}

void check(const VolumeIntegrals& v, const WaterplaneIntegrals& w, double density, double gravity) {
  if (!(density > 0) || !(gravity > 0))
    throw HydroError(Fault::ValueOutOfRange, "hydrostatics: density " + std::to_string(density) +
                                                 " kg/m³, gravity " + std::to_string(gravity) +
                                                 " m/s²: both must be positive");
  if (!(v.volume > 0) || !(w.area > 0))
    throw HydroError(Fault::HullNotInWater, "hydrostatics: volume " + std::to_string(v.volume) +
                                                " m³, waterplane area " + std::to_string(w.area) +
                                                " m²: both must be positive");
}

}  // namespace

Hydrostatics hydrostatics(const SurfaceMesh& wet, const Vec3& centreOfGravity, double density,
                          double gravity) {
  const VolumeIntegrals v = volumeIntegrals(wet);
  const WaterplaneIntegrals plane = waterplaneIntegrals(wet);
  check(v, plane, density, gravity);

  Hydrostatics h;
  h.volume = v.volume;
  h.displacement = density * v.volume;
  h.wettedArea = surfaceArea(wet);
  h.waterplaneArea = plane.area;
  h.buoyancy = v.centroid();
  h.flotation = {plane.x / plane.area, plane.y / plane.area, 0.0};
  h.draft = -bounds(wet).low.z();
  h.kb = h.buoyancy.z() + h.draft;
  const WaterplaneIntegrals central = about(plane, h.flotation.x(), h.flotation.y());
  h.bmT = central.yy / h.volume;
  h.bmL = central.xx / h.volume;
  h.gmT = h.buoyancy.z() + h.bmT - centreOfGravity.z();
  h.gmL = h.buoyancy.z() + h.bmL - centreOfGravity.z();
  const Vec3 extent = waterlineExtent(wet);
  h.length = extent.x();
  h.beam = extent.y();
  h.restoring = density * gravity *
                restoringMatrix(about(plane, centreOfGravity.x(), centreOfGravity.y()), h.volume,
                                h.buoyancy - centreOfGravity);
  return h;
}

}  // namespace cutwater
