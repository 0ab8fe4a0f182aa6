#include "plugin/WorldFrame.h"

#include <cmath>
#include <string>

#include "hydro/Errors.h"

CUTWATER_PLUGIN_BEGIN

void WorldFrame::check() const {
  const auto refuse = [](const char* field, double value) {
    throw HydroError(Fault::ValueOutOfRange,
                     std::string("WorldFrame: ") + field + " = " + std::to_string(value));
  };
  const auto positive = [](double value) { return value > 0.0 && std::isfinite(value); };
  if (!positive(metresPerUnit)) refuse("metresPerUnit", metresPerUnit);
  if (!positive(kilogramsPerUnit)) refuse("kilogramsPerUnit", kilogramsPerUnit);
  if (!std::isfinite(seaLevel)) refuse("seaLevel", seaLevel);
}

Mat3 WorldFrame::axes() const noexcept {
  if (up == Up::Z) return Mat3::Identity();
  Mat3 turned;
  turned << 1, 0, 0, 0, 0, 1, 0, -1, 0;
  return turned;
}

Mat6 WorldFrame::mass(const Mat6& m) const noexcept {
  Mat6 turn = Mat6::Zero();
  turn.topLeftCorner<3, 3>() = axes();
  turn.bottomRightCorner<3, 3>() = axes() / metresPerUnit;
  return turn * m * turn.transpose() / kilogramsPerUnit;
}

Vec6 WorldFrame::momentum(const Vec6& p) const noexcept {
  const double unit = kilogramsPerUnit * metresPerUnit;
  Vec6 result;
  result << axes() * p.head<3>() / unit, axes() * p.tail<3>() / (unit * metresPerUnit);
  return result;
}

btVector3 WorldFrame::inertia(const Vec3& principal) const noexcept {
  const Vec3 scaled = principal / (kilogramsPerUnit * metresPerUnit * metresPerUnit);
  return toBullet(Vec3((axes() * scaled).cwiseAbs()));
}

CUTWATER_PLUGIN_END
