#include <gtest/gtest.h>

#include "hydro/base/FindRoot.h"

namespace cutwater {
namespace {

// Tolerances: that asked for, and round-off of the place.
TEST(FindRootClosedForm, RootsOfFunctionsOfKnownRoots) {
  const auto root = [](auto f, double a, double b) {
    return findRoot(f, {a, f(a)}, {b, f(b)}, 1e-14);
  };
  EXPECT_NEAR(root([](double x) { return x * x - 2.0; }, 0.0, 2.0), std::sqrt(2.0), 1e-13);
  EXPECT_NEAR(root([](double x) { return std::cos(x) - x; }, 1.0, 0.0), 0.7390851332151607, 1e-13);
  EXPECT_NEAR(root([](double x) { return std::exp(-50.0 * x) - 0.5; }, 0.0, 1.0),
              std::log(2.0) / 50.0, 1e-13);
  EXPECT_NEAR(root([](double x) { return x < 0.3 ? -1.0 : 2.0; }, 0.0, 1.0), 0.3, 1e-13);
  // Flat on one side: the place of the kink.
  EXPECT_NEAR(root([](double x) { return x < 0.5 ? -0.1 : x - 0.6; }, -3.0, 1.0), 0.6, 1e-13);
}

TEST(FindRoot, AnEndThatIsARootIsIt) {
  const auto f = [](double x) { return x - 1.0; };
  EXPECT_EQ(findRoot(f, {1.0, 0.0}, {2.0, 1.0}, 0.0), 1.0);
  EXPECT_EQ(findRoot(f, {0.0, -1.0}, {1.0, 0.0}, 0.0), 1.0);
}

TEST(FindRoot, ASmoothFunctionTakesFewCalls) {
  int calls = 0;
  const auto f = [&](double x) {
    ++calls;
    return x * x * x - 5.0;
  };
  findRoot(f, {0.0, -5.0}, {5.0, 120.0}, 1e-14);
  EXPECT_LE(calls, 20);  // bisection alone: 49
}

}  // namespace
}  // namespace cutwater
