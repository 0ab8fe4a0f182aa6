#include "demos/cutwater/input/HullVolume.h"

#include <fmt/format.h>

#include <cmath>

#include "hydro/Errors.h"
#include "hydro/base/FindRoot.h"
#include "hydro/geometry/MeshIntegrals.h"

namespace cutwater::command {

namespace {

// Enough for an outer surface whose volume is right to 0.1 %.
constexpr int kPanels = 433;

// The volume below the height [m], as hydrostatics takes it: of a symmetric hull twice the port
// half.
double volumeBelow(Hull hull, double height) {
  for (Vec3& p : hull.surface.vertices) p.z() -= height;
  return volumeIntegrals(displacingSurface(hull)).volume;
}

}  // namespace

Hull readTrustedHull(const std::string& mesh, const MeshReadOptions& options) {
  try {
    return readRepaired(mesh, options).hull;
  } catch (const HydroError&) {
    return readAnyHull(mesh, kPanels, options, PanelsBy::Surface).hull;
  }
}

double waterlineFor(const std::string& mesh, MeshReadOptions options, double volume, double start,
                    double highest) {
  options.waterline = start;
  const double unit = filePlacement(options).metresPerUnit;
  // Only below calm water is a hull repaired: what is found above it is repaired and looked at
  // again. Each turn halves an interval of height, so a handful of turns is enough.
  for (int turn = 0; turn < 12; ++turn) {
    const Hull hull = readTrustedHull(mesh, options);
    const Bounds box = bounds(hull.surface);
    const double low = box.low.z(), high = (highest - options.waterline) * unit;
    const double most = volumeBelow(hull, high);
    if (most < volume)
      throw HydroError(Fault::ValueOutOfRange,
                       fmt::format("{}: displaces {:.4g} m3 at most before water comes in, "
                                   "{:.4g} m3 are needed; is its unit right (--unit)?",
                                   mesh, most, volume));
    const double at = findRoot([&](double z) { return volumeBelow(hull, z) - volume; },
                               {low, -volume}, {high, most - volume}, 1e-9 * box.diagonal());
    options.waterline += at / unit;
    if (std::abs(at) < 1e-6 * box.diagonal()) return options.waterline;
  }
  return options.waterline;
}

}  // namespace cutwater::command
