#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "demos/cutwater/commands/Commands.h"
#include "demos/cutwater/commands/Listings.h"
#include "demos/cutwater/input/ShipFile.h"

namespace cutwater::command {

namespace {

// What is left of a symmetric hull's zeros when a computer sums up its panels.
bool isRoundOff(const Mat6& restoring, int j, int k) {
  const auto size = [&](int mode) {  // of its own stiffness; yaw, which has none, as long as pitch
    return std::sqrt(std::abs(restoring(std::min<int>(mode, Pitch), std::min<int>(mode, Pitch))));
  };
  return std::abs(restoring(j, k)) <= 1e-12 * size(j) * size(k);
}

}  // namespace

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

void hydrostatics(const std::string& path, const std::string& out) {
  const ShipFile ship = readShipFile(path);
  Listing rows;
  listHydrostatics(rows, ship.particulars, ship.hydrostatics);
  rows.write(out);
}

}  // namespace cutwater::command
