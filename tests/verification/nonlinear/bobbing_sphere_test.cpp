#include <gtest/gtest.h>

#include <cmath>

#include "hydro/geometry/shapes/Shapes.h"
#include "tests/support/CsvTable.h"
#include "tests/support/Results.h"
#include "tests/verification/nonlinear/NonlinearShip.h"

// A sphere that rests at its equator and bobs: m z'' = −ρgπ(R²z − z³/3), whose period is known for
// any amplitude up to where it just leaves the water and just goes under.
namespace cutwater::test {
namespace {

constexpr double kRadius = 5.0;
constexpr int kTicksAPeriod = 240, kPeriods = 6;

double bobbingPeriod(const std::shared_ptr<const Hydrodynamics>& sphere, double amplitude,
                     double step, bool addedMass) {
  ShipSettings settings = pressureOnly();
  settings.model.immersion = Immersion::Constant;
  if (addedMass) std::erase(settings.model.without, "added_mass");
  settings.start.offset[Heave] = amplitude;
  OneShip run(sphere, {}, settings);
  // With G below its centre it is a pendulum, which bobbing would set swinging.
  run.ship.body().setLinearFactor(btVector3(0, 0, 1));
  run.ship.body().setAngularFactor(btVector3(0, 0, 0));
  std::vector<double> height{amplitude};
  for (int i = 0; i < kPeriods * kTicksAPeriod; ++i) {
    run.tick(step);
    height.push_back(run.ship.motion()[Heave]);
  }
  EXPECT_EQ(run.seaway.faults(), kStepOk) << amplitude;
  return meanPeriod(height, step);
}

// Acceptance: 0.1 %. The sphere of the mesh has the exact volume, and T₀ is that of the mesh's
// waterplane. Ticks shorten a period by (ωh)²/24, 3e-5; between its rings, β apart, the mesh lies
// inside the sphere, and beside its equator the waterplane is β²/6 smaller: periods are up to
// β²/12 = 9e-5 longer.
TEST(BobbingSphereClosedForm, PeriodAtEachAmplitude) {
  const double volume = 4.0 / 3.0 * kPi * std::pow(kRadius, 3);
  const auto sphere = bareShip({.closed = scaledToVolume(closedSphere(kRadius, 16, 48), volume),
                                .cog = Vec3(0.0, 0.0, -1.0),
                                .gyradii = Vec3::Constant(2.0)});
  const ShipParticulars& ship = sphere->ship();
  const double rest = 2.0 * kPi * std::sqrt(ship.mass / ship.restoring(Heave, Heave));
  const double step = rest / kTicksAPeriod;
  const CsvTable table("verification/nonlinear/bobbing_sphere_exact_period.csv");
  double worst = 0.0;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const double amplitude = table.number(row, "amplitude_over_Rs");
    const double exact = table.number(row, "T_over_T0");
    const double found = bobbingPeriod(sphere, amplitude * kRadius, step, false) / rest;
    EXPECT_NEAR(found, exact, 1e-3 * exact) << amplitude;
    worst = std::max(worst, std::abs(found / exact - 1.0));
  }
  recordResult(kTopic, "sphere bobbing at 12 amplitudes up to its radius: period, worst", "exact",
               worst, "1e-3");
  // A constant added mass lengthens all periods by √(1 + A/m).
  const double full = table.number(table.rows() - 1, "T_over_T0");
  const double added = sphere->coefficients().addedMass.atInfinity(Heave, Heave);
  const double longer = std::sqrt(1.0 + added / ship.mass);
  const double heavier = bobbingPeriod(sphere, kRadius, step, true) / rest / longer;
  EXPECT_NEAR(heavier, full, 1e-3 * full);
}

}  // namespace
}  // namespace cutwater::test
