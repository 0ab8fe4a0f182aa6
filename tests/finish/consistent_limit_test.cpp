#include <gtest/gtest.h>

#include "hydro/database/Interpolation.h"
#include "hydro/finish/ConsistentLimit.h"
#include "hydro/memory/Resonances.h"
#include "tests/memory/CausalShip.h"

// A ship whose A, B, ∂A and ∂B are known in closed form at every frequency.
namespace cutwater::test {
namespace {

/// Resolved up to 6 rad/s, where B is a fifth of its maximum; A(∞) of the ω = ∞ problem 3 % too
/// large.
Coefficients roughShip() {
  Coefficients c = CausalShip().coefficients(0.1, 8.0);
  c.resolvedOmega = 6.0;
  c.addedMass.atInfinity *= 1.03;
  for (std::size_t i = resolvedCount(c); i < c.omega.size(); ++i) {
    for (auto* matrices : {&c.addedMass, &c.damping, &c.addedMassX, &c.dampingX})
      (*matrices)[i] *= i % 2 == 0 ? 40.0 : -40.0;
  }
  return c;
}

TEST(ConsistentLimitClosedForm, IsTheLimitThatBelongsToAddedMassAndDamping) {
  const CausalShip ship;
  const Coefficients c = roughShip();
  const ConsistentLimit limit = consistentLimit(c, RetardationMatrix(c));
  EXPECT_TRUE(limit.trusted);
  EXPECT_LT(limit.scatter, 1e-3);  // the tail beyond 6 rad/s
  EXPECT_NEAR(limit.distance, 0.03, 0.005);
  EXPECT_LT((limit.addedMassInf - ship.addedMassInf).norm(), 1e-3 * ship.addedMassInf.norm());
}

// What the panels do not resolve becomes what the memory makes of the rest: the closed form but for
// the tail's law, which misses 1 % of what B is at 6 rad/s, a fifth of its maximum.
TEST(ConsistentLimitClosedForm, ContinuesEverythingAboveTheResolvedFrequencies) {
  const Coefficients exact = CausalShip().coefficients(0.1, 8.0);
  Coefficients c = roughShip();
  const Mat6 direct = c.addedMass.atInfinity;
  const RetardationMatrix memory(c, ForwardSpeedForm::Report);
  continueConsistently(c, memory, consistentLimit(c, memory).addedMassInf);
  EXPECT_EQ(c.addedMassInfDirect, direct);
  EXPECT_TRUE(c.hasConsistentLimit());
  for (const auto table : {&Coefficients::addedMass, &Coefficients::damping,
                           &Coefficients::addedMassX, &Coefficients::dampingX}) {
    double largest = 0.0, worst = 0.0;
    for (std::size_t i = 0; i < c.omega.size(); ++i) {
      largest = std::max(largest, (exact.*table)[i].cwiseAbs().maxCoeff());
      worst = std::max(worst, ((c.*table)[i] - (exact.*table)[i]).cwiseAbs().maxCoeff());
    }
    EXPECT_LT(worst, 3e-3 * largest);
  }
  EXPECT_LT((c.addedMassX.atInfinity - exact.addedMassX.atInfinity).norm(),
            2e-3 * exact.addedMassX.atInfinity.norm());
}

TEST(ConsistentLimit, IsNotTrustedFarFromTheInfiniteProblem) {
  Coefficients c = CausalShip().coefficients(0.1, 8.0);
  c.addedMass.atInfinity *= 1.2;
  const ConsistentLimit limit = consistentLimit(c, RetardationMatrix(c));
  EXPECT_NEAR(limit.distance, 0.2 / 1.2, 0.01);  // of the larger one
  EXPECT_LT(limit.scatter, kLargestScatter);
  EXPECT_FALSE(limit.trusted);
}

// One frequency of the band, 3 rad/s, is 5 % off in every entry.
TEST(ConsistentLimit, IsNotTrustedWhereItScatters) {
  Coefficients c = CausalShip().coefficients(0.1, 8.0);
  c.addedMass[29] *= 1.05;
  const ConsistentLimit limit = consistentLimit(c, RetardationMatrix(c));
  EXPECT_GT(limit.scatter, 0.03);
  EXPECT_LT(limit.distance, kLargestDistance);
  EXPECT_FALSE(limit.trusted);
}

// A damping that is there at one frequency ω₀ alone, area S under it, adds (2/π)S cos ω₀τ to the
// memory. So the limit from A(ω) is off by (2/π)S/(ω² − ω₀²): much near ω₀, little elsewhere.
TEST(ConsistentLimitClosedForm, AResonanceMovesTheMeanNotTheMedian) {
  const CausalShip ship;
  Coefficients c = CausalShip().coefficients(0.1, 8.0);
  c.damping[29](Sway, Sway) *= 20.0;
  const double S = 0.1 * c.damping[29](Sway, Sway) * 19.0 / 20.0;
  const RetardationMatrix memory(c);
  for (const std::size_t i : {std::size_t{4}, std::size_t{14}, std::size_t{59}}) {
    const double off = 2.0 / kPi * S / (c.omega[i] * c.omega[i] - 9.0);
    const double found =
        memory.addedMassInf(c.omega[i], c.addedMass[i])(Sway, Sway) - ship.addedMassInf(Sway, Sway);
    EXPECT_NEAR(found, off, 0.02 * std::abs(off)) << c.omega[i];  // width of a peak of one step
  }
  const ConsistentLimit limit = consistentLimit(c, memory);
  EXPECT_FALSE(limit.trusted);
  const double size = ship.addedMassInf(Sway, Sway);
  // (2/π)S/ω₀², the half of the frequencies below ω₀, is what the median may be off.
  EXPECT_NEAR(limit.median(Sway, Sway), size, 2.0 / kPi * S / 9.0 * 1.5);
  EXPECT_NEAR(limit.median(Heave, Heave), ship.addedMassInf(Heave, Heave), 1e-3 * size);
  const std::vector<Resonance> found = resonances(c, memory, limit.median);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].mode, Sway);
  EXPECT_DOUBLE_EQ(found[0].omega, 3.0);
}

}  // namespace
}  // namespace cutwater::test
