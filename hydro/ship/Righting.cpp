#include "hydro/ship/Righting.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "hydro/Errors.h"
#include "hydro/base/FindRoot.h"
#include "hydro/base/Radians.h"

namespace cutwater {

namespace {

constexpr double kStep = kDegree;            // of heel, on the way from upright
constexpr double kLeastStep = kStep / 64.0;  // where the trim changes fast
constexpr double kSmoothTrim = kDegree;      // what it may change by in a step
constexpr double kSteepest = 89.0 * kDegree;
constexpr double kFirstProbe = 1e-4;  // of trim [rad]
// Of the scale: levers below this are round-off of sums over the hull.
constexpr double kRoundOff = 1e-13;

}  // namespace

Righting::Righting(const ShipParticulars& ship, RightingTrim trim)
    : water_(ship),
      mode_(trim),
      volume_(ship.mass / ship.density),
      scale_(std::cbrt(volume_)),
      fileOrigin_(ship.file.toHull(Vec3::Zero()) - ship.cog),
      pose_{.height = ship.cog.z()} {
  const double whole = water_.wholeVolume();
  if (!(volume_ < (1.0 - 1e-12) * whole)) {
    throw HydroError(
        Fault::ValueOutOfRange,
        fmt::format("mass = {:.6g} kg: must be below {:.6g} kg, the water that the closed hull "
                    "displaces ({:.6g} m^3 of {:.6g} kg/m^3), or the ship sinks",
                    ship.mass, ship.density * whole, whole, ship.density));
  }
  if (mode_ == RightingTrim::Free) balanceTrim(0.0);
  const RightingLever upright = balanced(0.0, {.trim = pose_.pitch, .heightOfG = pose_.height});
  for (auto& side : steps_) side.push_back(upright);
}

RightingLever Righting::at(double heel) {
  requireRadians("Righting: heel", heel, kHalfTurn);
  const double sense = heel < 0.0 ? -1.0 : 1.0;
  std::vector<RightingLever>& steps = steps_[heel < 0.0 ? 1 : 0];
  const auto before = static_cast<std::size_t>(std::abs(heel) / kStep);
  // One more than needed, so that a jump just beyond is known.
  while (steps.size() <= std::min<std::size_t>(before + 1, 180)) {
    const double next = sense * kStep * static_cast<double>(steps.size());
    steps.push_back(advanced(steps.back(), next, jumps_));
  }
  std::vector<TrimJump> known;
  return advanced(steps[std::min<std::size_t>(before, 180)], heel, known);
}

RightingLever Righting::advanced(const RightingLever& from, double heel,
                                 std::vector<TrimJump>& jumps) {
  const RightingLever next = balanced(heel, from);
  if (std::abs(next.trim - from.trim) <= kSmoothTrim) return next;
  if (std::abs(heel - from.heel) > kLeastStep) {
    const RightingLever middle = advanced(from, 0.5 * (from.heel + heel), jumps);
    return advanced(middle, heel, jumps);
  }
  jumps.push_back({heel, from.trim, next.trim});
  return next;
}

RightingLever Righting::balanced(double heel, const RightingLever& guess) {
  pose_ = {guess.heightOfG, heel, guess.trim};
  RightingLever lever{.heel = heel};
  if (mode_ == RightingTrim::Fixed) {
    pose_ = water_.afloat(volume_, pose_);
  } else {
    if (!newton(guess)) balanceTrim(guess.trim);
    lever.trim = pose_.pitch;
    lever.trimIsStable = pitchesBack();
  }
  const Immersed wet = water_.at(pose_);
  lever.gz = -wet.centre.y();
  lever.volume = wet.volume;
  lever.heightOfG = pose_.height;
  lever.height = pose_.height + (pose_.rotation() * fileOrigin_).z();
  return lever;
}

/// Height and trim by Newton's method, on V = m/ρ and ∫x dV = 0. False if that does not converge,
/// or to a trim farther off than the branch goes in a step.
bool Righting::newton(const RightingLever& guess) {
  constexpr double kSmallest = 1e-14,
                   kSmall = 1e-12;  // the last step; where it stays, by round-off
  double last = 1.0;
  for (int i = 0; i < 12 && last > kSmallest; ++i) {
    const Immersed wet = water_.at(pose_);
    const ImmersedSlopes s = water_.slopes(pose_);
    const double lacking = volume_ - wet.volume, moment = -wet.volume * wet.centre.x();
    const double determinant = s.areaMoment * s.areaMoment - s.area * s.momentSlope;
    const double height = (s.momentSlope * lacking - s.areaMoment * moment) / determinant;
    const double pitch = (s.areaMoment * lacking - s.area * moment) / determinant;
    last = std::abs(height) / scale_ + std::abs(pitch);
    if (!(last < 1.0)) return false;
    pose_.height += height;
    pose_.pitch += pitch;
  }
  return last <= kSmall && std::abs(pose_.pitch - guess.trim) <= kSmoothTrim;
}

/// How far the buoyancy acts before G [m], afloat at this trim.
double Righting::trimmingLever(double trim) {
  pose_.pitch = trim;
  pose_ = water_.afloat(volume_, pose_);
  return water_.at(pose_).centre.x();
}

/// Buoyancy before G lifts the bow. So a trim is stable if more of it, bow down, brings the
/// buoyancy forward at the same volume.
bool Righting::pitchesBack() {
  const ImmersedSlopes s = water_.slopes(pose_);
  const double sinking = s.area > 0.0 ? s.areaMoment * s.areaMoment / s.area : 0.0;
  return s.momentSlope - sinking > -1e-6 * scale_ * volume_;  // GM along the ship, of the scale
}

/// The next trim at which the ship is balanced, where Newton's method fails: from `start` the way
/// that it turns by itself, in growing steps; the other way if there is none.
void Righting::balanceTrim(double start) {
  const auto lever = [&](double trim) { return trimmingLever(trim); };
  const Sample middle{start, lever(start)};
  if (std::abs(middle.y) <= kRoundOff * scale_) return;
  const double falls = middle.y > 0.0 ? -1.0 : 1.0;
  for (const double way : {falls, -falls}) {
    Sample last = middle;
    for (double step = kFirstProbe; std::abs(last.x) < kSteepest; step *= 2.0) {
      const double trim = std::clamp(start + way * step, -kSteepest, kSteepest);
      const Sample next{trim, lever(trim)};
      if ((next.y > 0.0) != (middle.y > 0.0)) {
        trimmingLever(findRoot(lever, last, next, 1e-15));
        return;
      }
      last = next;
    }
  }
  throw HydroError(
      Fault::ValueOutOfRange,
      fmt::format("at heel {:.6g} deg no trim within {:.0f} deg balances the ship, which "
                  "would stand on its end; at fixed trim it needs no balance",
                  pose_.roll / kDegree, kSteepest / kDegree));
}

}  // namespace cutwater
