#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>

#include "hydro/forces/MeanCourse.h"

namespace cutwater {
namespace {

MeanCourse course(const MeanCourse::Place& place, const MeanCourse::Way& way) {
  MeanCourse mean;
  mean.set(place, way);
  return mean;
}

void expectPlace(const MeanCourse& mean, double x, double y, double heading) {
  EXPECT_NEAR(mean.x(), x, 1e-12);  // round-off of some hundred steps of metres
  EXPECT_NEAR(mean.y(), y, 1e-12);
  EXPECT_NEAR(mean.heading(), heading, 1e-12);
}

// x = x₀ + t(U cos ψ − V sin ψ), y = y₀ + t(U sin ψ + V cos ψ): leeway goes to port.
TEST(MeanCourseClosedForm, GoesAlongItsHeadingAndToPort) {
  MeanCourse mean = course({1.0, 2.0, kPi / 2}, {5.0, 0.5, 0.0});
  for (int n = 0; n < 100; ++n) mean.advance(0.1);
  expectPlace(mean, 1.0 - 5.0, 2.0 + 50.0, kPi / 2);
  EXPECT_EQ(mean.speed(), 5.0);
  EXPECT_EQ(mean.leeway(), 0.5);
}

// The heading goes on at its rate and is not wrapped; the step is along the heading it began with.
TEST(MeanCourseClosedForm, TurnsAtItsRate) {
  MeanCourse mean = course({0.0, 0.0, 3.0}, {2.0, 0.0, 0.25});
  const MeanCourse::Place soon = mean.ahead(4.0);
  EXPECT_DOUBLE_EQ(soon.heading, 4.0);
  EXPECT_DOUBLE_EQ(soon.x, 8.0 * std::cos(3.0));
  mean.advance(4.0);
  expectPlace(mean, soon.x, soon.y, 4.0);
}

TEST(MeanCourse, LooksAwayFromWhatIsNotFinite) {
  MeanCourse mean = course({1.0, 2.0, 0.4}, {4.0, 0.1, 0.01});
  const double nan = std::nan("");
  mean.set({nan, 0.0, 0.0}, {});
  mean.set({0.0, HUGE_VAL, 0.0}, {});
  mean.set({0.0, 0.0, nan}, {});
  mean.set({}, {nan, 0.0, 0.0});
  mean.set({}, {0.0, -HUGE_VAL, 0.0});
  mean.set({}, {0.0, 0.0, nan});
  expectPlace(mean, 1.0, 2.0, 0.4);
  EXPECT_EQ(mean.speed(), 4.0);
  EXPECT_EQ(mean.leeway(), 0.1);
  EXPECT_EQ(mean.turnRate(), 0.01);
}

TEST(MeanCourse, RestoredStateGivesTheSameBits) {
  MeanCourse one = course({1.0, 2.0, 0.3}, {6.0, -0.2, 0.02}), other;
  one.advance(0.7);
  std::array<double, MeanCourse::kStateSize> middle{}, end{}, again{};
  one.save(middle);
  other.restore(middle);
  one.advance(0.3);
  other.advance(0.3);
  one.save(end);
  other.save(again);
  EXPECT_EQ(std::memcmp(end.data(), again.data(), sizeof end), 0);
}

}  // namespace
}  // namespace cutwater
