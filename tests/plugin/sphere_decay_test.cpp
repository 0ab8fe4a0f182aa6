#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "plugin/Seaway.h"
#include "tests/plugin/TestShip.h"
#include "tests/plugin/TestWorld.h"
#include "tests/support/CsvTable.h"
#include "tests/support/Results.h"

namespace cutwater::test {
namespace {

struct Extremum {
  double time, height;
};

// Of the parabola through each triple of samples that holds an extremum.
std::vector<Extremum> extremaOf(const std::vector<double>& z, double step) {
  std::vector<Extremum> found;
  for (std::size_t i = 2; i + 1 < z.size(); ++i) {
    const double before = z[i] - z[i - 1], after = z[i + 1] - z[i];
    if (before * after > 0.0 || after == before) continue;
    const double shift = 0.5 * (before + after) / (before - after);
    found.push_back(
        {(static_cast<double>(i) + shift) * step, z[i] + 0.25 * (before + after) * shift});
  }
  return found;
}

// Height of the sphere's G above its place at rest, dropped from 1 m above it.
std::vector<Extremum> drop(btScalar step, double duration) {
  TestWorld world(kSphereGravity);
  btSphereShape shape(5);
  const Coefficients coefficients = hemisphere();
  Seaway seaway(world.world);
  Vec6 raised = Vec6::Zero();
  raised[Heave] = 1.0;
  Ship& sphere =
      seaway.addShip(coefficients, {.start = {.offset = raised}, .collision = {.shape = &shape}});
  std::vector<double> z{sphere.motion()[Heave]};
  for (double t = 0.0; t < duration; t += static_cast<double>(step)) {
    world.world.stepSimulation(step, 1, step);
    z.push_back(sphere.motion()[Heave]);
  }
  EXPECT_EQ(seaway.faults(), kStepOk);
  return extremaOf(z, static_cast<double>(step));
}

// linear_here: the same equation integrated by trapezoidal convolution, ±1e-3 m. A start from rest
// comes half a tick early in Bullet (Seaway.h), 0.008 s at 1/64 s.
TEST(SphereDecayVerification, DroppedFromOneMetreItsExtremaAreThoseOfLinearTheory) {
  const CsvTable table("plugin/sphere_decay_1m_extrema.csv");
  const std::vector<Extremum> found = drop(btScalar(1) / 64, 18.0);
  double worstTime = 0.0, worstHeight = 0.0;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (table.text(row, "code") != "linear_here") continue;
    const auto index = static_cast<std::size_t>(table.number(row, "extremum_index")) - 1;
    ASSERT_LT(index, found.size());
    EXPECT_NEAR(found[index].time, table.number(row, "t_s"), 0.03) << "extremum " << index + 1;
    EXPECT_NEAR(found[index].height, table.number(row, "z_m"), 0.01) << "extremum " << index + 1;
    worstTime = std::max(worstTime, std::abs(found[index].time - table.number(row, "t_s")));
    worstHeight = std::max(worstHeight, std::abs(found[index].height - table.number(row, "z_m")));
  }
  recordResult("Plugin", withPrecision("sphere dropped from 1 m, time of extrema, worst [s]"),
               "linear_here", worstTime, "0.03");
  recordResult("Plugin", withPrecision("sphere dropped from 1 m, height of extrema, worst [m]"),
               "linear_here", worstHeight, "0.01");
}

}  // namespace
}  // namespace cutwater::test
