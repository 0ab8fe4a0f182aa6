#include "demos/cutwater/output/ShipListing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "hydro/finish/Finish.h"
#include "hydro/geometry/MeshIntegrals.h"

namespace cutwater::command {

namespace {

// An axis of the ship in the file's: by name where it is one of them.
std::string axisText(const Vec3& axis) {
  for (int i = 0; i < 3; ++i) {
    if (axis == Vec3::Unit(i)) return std::string(1, "xyz"[i]);
    if (axis == -Vec3::Unit(i)) return std::string("-") + "xyz"[i];
  }
  return fmt::format("[{:.6g}, {:.6g}, {:.6g}]", axis.x(), axis.y(), axis.z());
}

// The hull file's own axes, unit and origin, as the ship was solved with.
void listFile(Listing& rows, const FilePlacement& file) {
  rows.add("file_up", axisText(file.rotation.row(2)));
  rows.add("file_forward", axisText(file.rotation.row(0)));
  rows.add("file_unit", file.metresPerUnit, "m");
  for (int i = 0; i < 3; ++i) rows.add(std::string("file_origin_") + "xyz"[i], file.origin[i], "m");
}

// What is left of a symmetric hull's zeros when a computer sums up its panels.
bool isRoundOff(const Mat6& restoring, int j, int k) {
  const auto size = [&](int mode) {  // of its own stiffness; yaw, which has none, as long as pitch
    return std::sqrt(std::abs(restoring(std::min<int>(mode, Pitch), std::min<int>(mode, Pitch))));
  };
  return std::abs(restoring(j, k)) <= 1e-12 * size(j) * size(k);
}

}  // namespace

void listShip(Listing& rows, const ShipParticulars& ship) {
  rows.add("ship", ship.name);
  rows.add("mass", ship.mass, "kg");
  const char* axes[3] = {"x", "y", "z"};
  for (int i = 0; i < 3; ++i) rows.add(std::string("cog_") + axes[i], ship.cog[i], "m");
  const char* about[3] = {"roll", "pitch", "yaw"};
  for (int i = 0; i < 3; ++i) rows.add(std::string("gyradius_") + about[i], ship.gyradii[i], "m");
  rows.add("volume", ship.volume, "m^3");
  rows.add("density", ship.density, "kg/m^3");
  rows.add("gravity", ship.gravity, "m/s^2");
  rows.add("symmetric", ship.symmetric ? 1 : 0);
  listFile(rows, ship.file);
  rows.add("wet_panels_stored", static_cast<double>(ship.wetSurface.faces.size()));
  rows.add("hull_faces", static_cast<double>(ship.hull.faces.size()));
  for (int i = 0; i < 6; ++i) {
    const std::string mode = kModeNames[i];
    if (ship.supplementary.damping[i] != 0.0) {
      rows.add(mode + "_damping", ship.supplementary.damping[i], i < 3 ? "N/(m/s)" : "N m/(rad/s)");
    }
    if (ship.supplementary.stiffness[i] != 0.0) {
      rows.add(mode + "_stiffness", ship.supplementary.stiffness[i], i < 3 ? "N/m" : "N m/rad");
    }
  }
  rows.add("roll_damping_quadratic", ship.supplementary.rollDampingQuadratic, "N m/(rad/s)^2");
  rows.add("cross_flow_drag", ship.drag.crossFlow);
  rows.add("form_factor", ship.drag.formFactor);
  rows.add("engine", ship.engine ? "1" : "0");
  rows.add("rudder", ship.rudder ? "1" : "0");
}

std::string sizeText(const SurfaceMesh& wholeWet, double hullVolume) {
  const Vec3 size = bounds(wholeWet).high - bounds(wholeWet).low;
  return fmt::format("{:.4g} x {:.4g} x {:.4g} m, volume {:.6g} m3 of the hull's {:.6g} m3",
                     size.x(), size.y(), size.z(), volumeIntegrals(wholeWet).volume, hullVolume);
}

double infinityDifference(const Coefficients& c) {
  if (!c.hasConsistentLimit()) return 0.0;
  const Vec6 size = c.addedMass.atInfinity.diagonal().cwiseSqrt();
  const Mat6 difference = c.addedMassInfDirect - c.addedMass.atInfinity;
  return 100.0 * difference.cwiseQuotient(size * size.transpose()).cwiseAbs().maxCoeff();
}

double solversAsymmetry(const Coefficients& c, const std::string& name,
                        const OverFrequency<Mat6>& table) {
  std::string told = c.provenance.setting(name + "_asymmetry_resolved");
  if (told.empty()) told = c.provenance.setting(name + "_asymmetry");  // as 0.1.0 wrote it
  return 100.0 * (told.empty() ? asymmetry(table) : std::strtod(told.c_str(), nullptr));
}

void listHydrostatics(Listing& rows, const ShipParticulars& ship, const Hydrostatics& h) {
  const auto add = [&](const std::string& name, double value, const std::string& unit) {
    rows.add(name, value, unit);
  };
  add("volume", h.volume, "m^3");
  add("displacement", h.displacement, "kg");
  add("mass", ship.mass, "kg");
  add("wetted_area", h.wettedArea, "m^2");
  add("waterplane_area", h.waterplaneArea, "m^2");
  add("lcb", h.buoyancy.x(), "m");
  add("tcb", h.buoyancy.y(), "m");
  add("vcb", h.buoyancy.z(), "m");
  add("kb", h.kb, "m");
  add("lcf", h.flotation.x(), "m");
  for (int j = 0; j < 6; ++j) {
    for (int k = 0; k < 6; ++k) {
      const bool always = j == k && j >= 2 && j <= 4;
      if (!always && isRoundOff(h.restoring, j, k)) continue;
      const int angles = (j >= 3 ? 1 : 0) + (k >= 3 ? 1 : 0);
      add(fmt::format("C{}{}", j + 1, k + 1), h.restoring(j, k),
          angles == 0   ? "N/m"
          : angles == 1 ? "N"
                        : "N m");
    }
  }
  add("bm_t", h.bmT, "m");
  add("bm_l", h.bmL, "m");
  add("gm_t", h.gmT, "m");
  add("gm_l", h.gmL, "m");
  add("draft", h.draft, "m");
  add("length", h.length, "m");
  add("beam", h.beam, "m");
  add("panels", static_cast<double>(ship.wetSurface.faces.size()), "");
  add("symmetric", ship.symmetric ? 1.0 : 0.0, "");
}

}  // namespace cutwater::command
