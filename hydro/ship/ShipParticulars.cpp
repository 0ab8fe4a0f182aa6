#include "hydro/ship/ShipParticulars.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "hydro/Errors.h"

namespace cutwater {

Mat6 ShipParticulars::massMatrix() const {
  Vec6 diagonal;
  diagonal << Vec3::Constant(mass), mass * gyradii.cwiseAbs2();
  return diagonal.asDiagonal();
}

namespace {

double lengthOf(const SurfaceMesh& mesh) {
  const Bounds box = bounds(mesh);
  return box.high.x() - box.low.x();
}

}  // namespace

double ShipParticulars::length() const {
  return wetSurface.vertices.empty() ? 5.0 * std::cbrt(std::max(volume, 1e-9))
                                     : lengthOf(wetSurface);
}

double ShipParticulars::lengthOverall() const {
  return hull.vertices.empty() ? length() : lengthOf(hull);
}

double ShipParticulars::beam() const {
  if (wetSurface.vertices.empty()) return length() / 7.0;
  const Bounds wet = bounds(wetSurface);
  return symmetric ? 2.0 * wet.high.y() : wet.high.y() - wet.low.y();
}

double ShipParticulars::draught() const {
  if (wetSurface.vertices.empty()) return volume / (length() * beam());
  return -bounds(wetSurface).low.z();
}

double ShipParticulars::sternX() const {
  return wetSurface.vertices.empty() ? cog.x() - 0.5 * length() : bounds(wetSurface).low.x();
}

namespace {

constexpr double kSmallest = 1e-9, kLargest = 1e15;

class Bounded {
 public:
  Bounded(const char* section, const std::string& where) : section_(section), where_(where) {}
  void operator()(const char* key, double value, double low, double high) const {
    if (value >= low && value <= high) return;
    throw HydroError(Fault::ValueOutOfRange,
                     fmt::format("{}: [{}] {} = {:.6g}: must be in {:.6g}..{:.6g}", where_,
                                 section_, key, value, low, high));
  }
  void operator()(const char* key, const std::optional<double>& value, double low,
                  double high) const {
    if (value) (*this)(key, *value, low, high);
  }
  void place(const std::optional<Vec3>& place) const {
    if (place) (*this)("place", place->cwiseAbs().maxCoeff(), 0.0, 1e6);
  }

 private:
  const char* section_;
  const std::string& where_;
};

}  // namespace

void requireUsable(const HullDrag& drag, const std::string& where) {
  const Bounded bounded("resistance", where);
  bounded("cross_flow_drag", drag.crossFlow, 0.0, 100.0);
  bounded("form_factor", drag.formFactor, 0.0, 100.0);
}

void requireUsable(const EngineParticulars& engine, const std::string& where) {
  const Bounded bounded("engine", where);
  bounded("max_thrust", engine.maxThrust, 0.0, kLargest);
  bounded("astern", engine.astern, 0.0, 1.0);
  bounded("no_thrust_speed", engine.noThrustSpeed, 1e-3, 100.0);
  bounded("time_constant", engine.timeConstant, 0.0, 1e4);
  bounded("diameter", engine.diameter, kSmallest, 1e3);
  bounded.place(engine.place);
}

void requireUsable(const RudderParticulars& rudder, const std::string& where) {
  constexpr double kDegrees = 180.0 / kPi;
  const Bounded bounded("rudder", where);
  bounded("area", rudder.area, kSmallest, 1e6);
  bounded.place(rudder.place);
  bounded("aspect_ratio", rudder.aspectRatio, 0.1, 20.0);
  bounded("limit_deg", kDegrees * rudder.limit, 1e-3, 90.0);
  if (rudder.rate) bounded("rate_deg", kDegrees * *rudder.rate, 1e-3, 1e4);
  bounded("stall_deg", kDegrees * rudder.stall, 1.0, 75.0);
  bounded("slipstream", rudder.slipstream, 0.0, 1.0);
  bounded("flow_straightening", rudder.flowStraightening, 0.01, 1.0);
}

}  // namespace cutwater
