#include "hydro/memory/SpeedStability.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "hydro/memory/OwnEquation.h"

namespace cutwater {

namespace {

constexpr int kSteps = 12;
constexpr double kSlowSurge = 5.0;  // of OwnEquation::least

bool isCourse(const GrowingMotion& motion) { return motion.mode == Sway || motion.mode == Yaw; }

/// The first motion that is outside the theory; null if none grows. A ship that capsizes at rest
/// for want of stability does so rightly.
const GrowingMotion* outsideTheory(const std::vector<GrowingMotion>& growing, double least,
                                   const ShipParticulars& ship) {
  for (const GrowingMotion& motion : growing) {
    const bool slow = motion.mode == Surge && motion.s.real() < kSlowSurge * least;
    const double stiffness =
        ship.restoring(motion.mode, motion.mode) + ship.supplementary.stiffness[motion.mode];
    const bool capsizes = stiffness < 0.0 && std::abs(motion.s.imag()) < 1e-3 * motion.s.real();
    if (!isCourse(motion) && !slow && !capsizes) return &motion;
  }
  return nullptr;
}

/// The lowest of some speeds from 0 to `last` at which `grows`, to a thousandth of `last`.
std::optional<double> lowestSpeed(double last, const std::function<bool(double)>& grows) {
  double stable = 0.0;
  for (int n = 0; n <= kSteps; ++n) {
    double unstable = last * n / kSteps;
    if (!grows(unstable)) {
      stable = unstable;
      continue;
    }
    while (std::abs(unstable - stable) > 1e-3 * std::abs(last)) {
      const double middle = 0.5 * (stable + unstable);
      if (grows(middle)) {
        unstable = middle;
      } else {
        stable = middle;
      }
    }
    return std::abs(unstable);
  }
  return {};
}

GrowthLimit limitOf(const OwnEquation& equation, double last, const ShipParticulars& ship) {
  GrowthLimit limit;
  limit.speed = lowestSpeed(last, [&](double speed) {
    const std::vector<GrowingMotion> growing = equation.growing(speed);
    const GrowingMotion* found = outsideTheory(growing, equation.least(), ship);
    if (found != nullptr) limit.mode = found->mode;
    return found != nullptr;
  });
  return limit;
}

}  // namespace

double lastSpeedToCheck(const ShipParticulars& ship) {
  return 0.6 * std::sqrt(ship.gravity * ship.length());
}

SpeedStability speedStability(const CoefficientTables& c, const RadiationModel& model,
                              double last) {
  SpeedStability found;
  if (!(c.ship.gyradii.minCoeff() > 0.0) || !(c.ship.mass > 0.0) || !(last > 0.0)) return found;
  const OwnEquation equation(c, model);
  found.checkedTo = last;
  found.ahead = limitOf(equation, last, c.ship);
  found.astern = limitOf(equation, -0.5 * last, c.ship);
  found.course = lowestSpeed(last, [&](double speed) {
    const std::vector<GrowingMotion> growing = equation.growing(speed, true);
    return std::any_of(growing.begin(), growing.end(), isCourse);
  });
  return found;
}

std::string describe(const GrowthLimit& limit, bool astern) {
  return fmt::format("unstable above {:.3g} m/s{} in {}", limit.speed.value(),
                     astern ? " astern" : "", kModeNames[limit.mode]);
}

std::vector<std::string> describe(const SpeedStability& stability) {
  std::vector<std::string> lines;
  const auto add = [&](const GrowthLimit& limit, bool astern) {
    if (limit.speed)
      lines.push_back(describe(limit, astern) +
                      ": there the terms of forward speed feed the ship energy");
  };
  add(stability.ahead, false);
  add(stability.astern, true);
  if (stability.course)
    lines.push_back(fmt::format(
        "does not keep its course by itself from {:.3g} m/s on, lift of the hull included",
        *stability.course));
  return lines;
}

}  // namespace cutwater
