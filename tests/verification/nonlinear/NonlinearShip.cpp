#include "tests/verification/nonlinear/NonlinearShip.h"

namespace cutwater::test {

OneShip::OneShip(std::shared_ptr<const Hydrodynamics> hydrodynamics, const SeaState& sea,
                 const ShipSettings& settings)
    : bullet(hydrodynamics->ship().gravity),
      seaway(bullet.world, sea),
      ship(seaway.addShip(std::move(hydrodynamics), settings)) {}

ShipSettings pressureOnly(Mean mean) {
  ShipSettings settings;
  settings.model.mean = mean;
  settings.model.mode = HullPressure::Nonlinear;
  settings.model.hullLift = settings.model.resistance = false;
  settings.model.without = {"radiation", "added_mass", "diffraction", "supplementary"};
  return settings;
}

std::vector<double> risesThroughZero(const std::vector<double>& samples, double step) {
  std::vector<double> times;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const double before = samples[i - 1], now = samples[i];
    if (before < 0.0 && now >= 0.0)
      times.push_back(step * (static_cast<double>(i) - now / (now - before)));
  }
  return times;
}

double meanPeriod(const std::vector<double>& samples, double step) {
  const std::vector<double> times = risesThroughZero(samples, step);
  if (times.size() < 2) return 0.0;
  return (times.back() - times.front()) / static_cast<double>(times.size() - 1);
}

}  // namespace cutwater::test
