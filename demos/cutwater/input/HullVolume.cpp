#include "demos/cutwater/input/HullVolume.h"

#include <fmt/format.h>

#include <cmath>

#include "hydro/Errors.h"
#include "hydro/geometry/MeshCut.h"
#include "hydro/geometry/MeshIntegrals.h"
#include "hydro/geometry/guess/HullGuess.h"

namespace cutwater::command {

namespace {

constexpr double kAgree = 0.01;  // of the volume: what `new` says to three digits

// ∫ r_i n_i dS of the part below calm water for i = x, y, z: the volume three times if it is closed
// there, as the lid on z = 0 adds nothing to any of them.
Vec3 threeVolumes(const SurfaceMesh& surface) {
  const SurfaceMesh wet = triangulated(cutBelow(surface));
  Vec3 volumes = Vec3::Zero();
  for (const Face& face : wet.faces)
    volumes += meanCorner(wet, face).cwiseProduct(vectorArea(wet, face));
  return volumes;
}

// A vessel of planks or of two skins is closed, its three volumes agree, and yet they are those of
// the wood alone: a tenth or a third of what it keeps the water from. Columns on pontoons, which
// volumeFromBelow counts as filled down to the pontoons, have more than this share of it.
constexpr double kSolid = 0.4;

bool isSolid(const SurfaceMesh& surface, double volume) {
  return volume > kSolid * volumeFromBelow(surface, "z", 0.0);
}

// The volume below the height [m], as hydrostatics takes it: of a symmetric hull twice the port
// half.
double volumeBelow(const HullVolume& hull, double height) {
  Hull lowered{hull.surface, hull.symmetric};
  for (Vec3& p : lowered.surface.vertices) p.z() -= height;
  return volumeIntegrals(displacingSurface(lowered)).volume;
}

}  // namespace

HullVolume readHullVolume(const std::string& mesh, const MeshReadOptions& options) {
  try {
    RepairedHull repaired = readRepaired(mesh, options);
    return {std::move(repaired.hull.surface), repaired.hull.symmetric, repaired.hull.file, {}};
  } catch (const HydroError& error) {
    HullVolume asItIs{readSurface(mesh, options), false, filePlacement(options), error.what()};
    Vec3 volumes = threeVolumes(asItIs.surface);
    if (volumes.sum() < 0.0) {
      asItIs.surface = turnedOver(asItIs.surface);
      volumes = -volumes;
    }
    const bool agree = volumes.minCoeff() > (1.0 - kAgree) * volumes.maxCoeff();
    if (!agree || !isSolid(asItIs.surface, volumes.z()))
      throw HydroError(error.fault(), asItIs.problem +
                                          "; nor do its faces as they are give a volume that can "
                                          "be trusted, so nothing is written");
    return asItIs;
  }
}

double waterlineFor(const std::string& mesh, MeshReadOptions options, double volume, double start,
                    double highest) {
  options.waterline = start;
  const double unit = filePlacement(options).metresPerUnit;
  // Only below calm water is a hull repaired: what is found above it is repaired and looked at
  // again. Each turn halves an interval of height, so a handful of turns is enough.
  for (int turn = 0; turn < 12; ++turn) {
    const HullVolume hull = readHullVolume(mesh, options);
    const Bounds box = bounds(hull.surface);
    double low = box.low.z(), high = (highest - options.waterline) * unit;
    const double most = volumeBelow(hull, high);
    if (most < volume)
      throw HydroError(Fault::ValueOutOfRange,
                       fmt::format("{}: displaces {:.4g} m3 at most before water comes in, "
                                   "{:.4g} m3 are needed; is its unit right (--unit)?",
                                   mesh, most, volume));
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (low + high);
      (volumeBelow(hull, middle) < volume ? low : high) = middle;
      if (high - low < 1e-9 * box.diagonal()) break;
    }
    options.waterline += high / unit;
    if (std::abs(high) < 1e-6 * box.diagonal()) return options.waterline;
  }
  return options.waterline;
}

}  // namespace cutwater::command
