#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/CsvTable.h"
#include "tests/support/Results.h"
#include "tests/verification/nonlinear/NonlinearShip.h"

// The heaving sphere of IEA OES Task 10 in regular waves, beside the two codes that took buoyancy
// and Froude-Krylov force on the wetted surface, and the rest linear.
namespace cutwater::test {
namespace {

constexpr int kTicksAPeriod = 240;

struct Row {
  std::string sheet;
  double period, height, damping;  // [s], [m], [N/(m/s)]
  double marin, nrel;              // heave, of the wave's amplitude
  double mean() const { return 0.5 * (marin + nrel); }
  double apart() const { return std::abs(marin - nrel) / mean(); }
};

std::vector<Row> rows() {
  const CsvTable table("verification/nonlinear/oes_sphere_regular.csv");
  std::vector<Row> rows;
  for (std::size_t i = 0; i < table.rows(); ++i)
    rows.push_back({table.text(i, "sheet"), table.number(i, "T_s"), table.number(i, "H_m"),
                    table.number(i, "pto_damping_Ns_m"), table.number(i, "Marin_nonlin"),
                    table.number(i, "NREL_nonlin")});
  return rows;
}

constexpr double kAgree = 0.01;  // of rows in which the two codes count as one

std::string nameOf(const Row& row) {
  char name[80];
  std::snprintf(name, sizeof name, "OES sphere, %s, T %g s", row.sheet.c_str(), row.period);
  return name;
}

// The sphere with the damping of a row. Its 1728 triangles are as they are in the database.
std::shared_ptr<const Hydrodynamics> sphereOf(const Row& row) {
  Coefficients sphere = readHydrodynamics(CUTWATER_SOLVED "/sphere.h5")->coefficients();
  sphere.ship.supplementary.damping[Heave] = row.damping;
  return std::make_shared<const Hydrodynamics>(std::move(sphere));
}

// Half of highest less lowest, of the wave's amplitude, when it has settled. It heaves only. The
// height of a row is from trough to crest.
double heaveOf(const Row& row, WaveProfile profile, Immersion immersion) {
  constexpr int kRamp = 5, kUntil = 30, kKept = 4;  // periods
  const auto sphere = sphereOf(row);
  const double amplitude = 0.5 * row.height;
  const WaveComponent wave{.omega = 2.0 * kPi / row.period, .amplitude = amplitude, .heading = kPi};
  const SeaState sea({wave}, sphere->ship().gravity, kRamp * row.period, profile);
  ShipSettings settings;
  settings.model.mean = Mean::Fixed;
  settings.model.mode = HullPressure::Nonlinear;
  settings.model.immersion = immersion;
  OneShip run(sphere, sea, settings);
  run.ship.body().setLinearFactor(btVector3(0, 0, 1));
  run.ship.body().setAngularFactor(btVector3(0, 0, 0));
  double low = 1e9, high = -1e9;
  for (int i = 0; i < kUntil * kTicksAPeriod; ++i) {
    run.tick(row.period / kTicksAPeriod);
    if (i < (kUntil - kKept) * kTicksAPeriod) continue;
    low = std::min(low, run.ship.motion()[Heave]);
    high = std::max(high, run.ship.motion()[Heave]);
  }
  EXPECT_EQ(run.seaway.faults(), kStepOk) << nameOf(row);
  return 0.5 * (high - low) / amplitude;
}

// Acceptance: within 1.5 % of the mean of the two codes, in the rows in which they agree within 1 %
// with each other. They hold A, B and F_D as they are. They do not say which profile they take;
// Wheeler's is the one that agrees with all of them: in long waves the sphere goes with the
// surface, where p must be 0 (decision 0112).
TEST(OesSphereVerification, HeaveInRegularWavesIsThatOfTwoOtherCodes) {
  int compared = 0;
  for (const Row& row : rows()) {
    if (!(row.apart() < kAgree)) continue;
    ++compared;
    const bool inShort = compared % 5 == 2;  // without damping, with it, and in the lowest waves
    if (!fullSize() && !inShort) continue;
    const double off = heaveOf(row, WaveProfile::Wheeler, Immersion::Constant) / row.mean() - 1.0;
    recordResult(kTopic, nameOf(row) + ", Wheeler, s = 1: heave less the mean of two codes, of it",
                 "Marin, NREL", off, "+- 1.5e-2");
    EXPECT_NEAR(off, 0.0, 0.015) << nameOf(row);
  }
  EXPECT_EQ(compared, 16);
}

// How much profile and immersion matter, in all rows: stated. That of immersion is bounded by the
// width of the comparison; it is far less, as s stays near 1 in waves up to the sphere's radius.
TEST(OesSphereVerification, WhatProfileAndImmersionChange) {
  for (const Row& row : rows()) {
    if (!fullSize() && row.period != 9.0) continue;
    const double constant = heaveOf(row, WaveProfile::Wheeler, Immersion::Constant);
    const double scaled = heaveOf(row, WaveProfile::Wheeler, Immersion::Scaled);
    recordResult(kTopic, nameOf(row) + ", Wheeler: heave with s scaled less that with s = 1, of it",
                 "stated", scaled / constant - 1.0, "+- 1.5e-2");
    EXPECT_NEAR(scaled / constant, 1.0, 0.015) << nameOf(row);
    for (const WaveProfile profile : {WaveProfile::Extrapolated, WaveProfile::Constant}) {
      const char* const name = kWaveProfileNames.at(static_cast<std::size_t>(profile));
      const double off = heaveOf(row, profile, Immersion::Constant) / constant - 1.0;
      recordResult(kTopic, nameOf(row) + ", " + name + ": heave less that of Wheeler, of it",
                   "stated", off, "none");
    }
  }
}

}  // namespace
}  // namespace cutwater::test
