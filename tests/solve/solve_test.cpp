#include "hydro/solve/Solve.h"

#include <gtest/gtest.h>

#include <cmath>

#include "hydro/Errors.h"
#include "hydro/bem/BuildCoefficients.h"
#include "hydro/excitation/WaveExcitation.h"
#include "hydro/finish/Finish.h"
#include "hydro/finish/GridNeeds.h"
#include "hydro/geometry/shapes/Shapes.h"
#include "hydro/memory/RetardationMatrix.h"
#include "hydro/response/FrequencyResponse.h"
#include "hydro/ship/Afloat.h"
#include "tests/support/Hulls.h"

namespace cutwater {
namespace {

ShipParticulars floatingSphere() {
  const PanelledHull hull{closedSphere(5.0, 12, 8), wetHemisphere(5.0, 12, 8), true};
  return afloat(hull, {.cog = {0.0, 0.0, -1.0}, .gyradii = Vec3(3.0, 3.0, 3.0)}).ship;
}

SolveSettings upTo(int count) {
  SolveSettings settings;
  for (int i = 1; i <= count; ++i) settings.omega.push_back(0.3 * i);
  settings.headings = {kPi};
  settings.threads = 2;
  return settings;
}

TEST(SolveIdentity, IsSolverAndFinishInOne) {
  int last = 0;
  const Coefficients made = solve(floatingSphere(), upTo(12), [&](int done, int) { last = done; });
  const Coefficients parts = finish(buildCoefficients(floatingSphere(), upTo(12)));
  EXPECT_EQ(last, 12);
  EXPECT_EQ(made.status, CoefficientStatus::Finished);
  EXPECT_EQ(made.addedMass.values, parts.addedMass.values);
  EXPECT_EQ(made.damping.values, parts.damping.values);
  EXPECT_EQ(made.addedMass.atInfinity, parts.addedMass.atInfinity);
  EXPECT_EQ(made.adjoint.values, parts.adjoint.values);
  EXPECT_EQ(made.provenance.settings, parts.provenance.settings);
}

// One frequency is solved, and at that frequency gives the motions and forces that a whole grid
// does: the same numbers, as nothing is interpolated there.
TEST(SolveIdentity, ASingleFrequencyWorksInTheFrequencyDomain) {
  SolveSettings one = upTo(1);
  one.omega = {0.9};
  const Coefficients single = solve(floatingSphere(), one),
                     whole = solve(floatingSphere(), upTo(12));
  EXPECT_EQ(single.status, CoefficientStatus::Unfinished);
  EXPECT_NE(single.unfinishedBecause.find("one frequency"), std::string::npos);
  const CVec6 motion = FrequencyResponse(single).at(0.9, kPi),
              expected = FrequencyResponse(whole).at(0.9, kPi);
  EXPECT_GT(std::abs(expected[Heave]), 0.5);
  EXPECT_LT((motion - expected).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_LT(
      (WaveExcitation(single).at(0.9, 2.0).total() - WaveExcitation(whole).at(0.9, 2.0).total())
          .norm(),
      1e-12 * WaveExcitation(whole).at(0.9, 2.0).total().norm());
}

TEST(Solve, ASingleFrequencyAnswersForNoOther) {
  SolveSettings one = upTo(1);
  one.omega = {0.9};
  const Coefficients single = solve(floatingSphere(), one);
  EXPECT_THROW(FrequencyResponse(single).at(0.8, kPi), HydroError);
  EXPECT_THROW(FrequencyResponse(single).at(0.9, kPi, 3.0), HydroError);  // ω_e is another
}

TEST(Solve, GridWarningsSayWhatWouldDo) {
  EXPECT_TRUE(gridWarnings(solve(floatingSphere(), upTo(12))).empty());
  const Coefficients low = solve(floatingSphere(), upTo(9));  // 2.7 rad/s; 3 √(g/B) is 2.97
  ASSERT_EQ(low.status, CoefficientStatus::Finished);
  ASSERT_EQ(gridWarnings(low).size(), 1u);
  EXPECT_NE(gridWarnings(low).front().find("K^UU"), std::string::npos);
  EXPECT_NE(gridWarnings(low).front().find("the frequencies end at 2.7 rad/s, 3 rad/s"),
            std::string::npos)
      << gridWarnings(low).front();
  const Coefficients one = solve(floatingSphere(), upTo(1));
  ASSERT_EQ(gridWarnings(one).size(), 1u);
  EXPECT_NE(gridWarnings(one).front().find(one.unfinishedBecause), std::string::npos);
}

/// A hull λ times as large; panels that are not its own faces, a lid, two headings.
Coefficients solvedAtScale(double scale) {
  SurfaceMesh hull = closedFrigate(32, 10), panels = wetFrigate(16, 4);
  for (SurfaceMesh* mesh : {&hull, &panels})
    for (Vec3& vertex : mesh->vertices) vertex *= scale;
  const ShipParticulars ship =
      afloat({hull, panels, true}, {.cog = scale * Vec3(-2.4, 0.0, 1.29), .level = true}).ship;
  SolveSettings settings;
  settings.omega = usualOmega(ship);
  settings.headings = {kPi, 2.0};
  settings.threads = 2;
  return solve(ship, settings);
}

// Froude's law: of a hull λ times as large in the same water, time goes with √λ, and every number
// of the database with its own power of λ, the default frequencies included. To the solver's
// refinement, 1e-12 times condition numbers up to 1e3, of each matrix's largest entry.
TEST(SolveIdentity, ModelsAndGiantsFollowFroudesLaw) {
  constexpr double kRefined = 1e-9;
  const Coefficients one = solvedAtScale(1.0);
  const double L = one.ship.length();
  for (const double scale : {2.0 / L, 450.0 / L}) {
    SCOPED_TRACE(scale);
    const Coefficients other = solvedAtScale(scale);
    const double time = std::sqrt(scale);
    ASSERT_EQ(other.omega.size(), one.omega.size());
    EXPECT_EQ(other.status, one.status);
    const Vec6 arms = (Vec6() << 1, 1, 1, scale, scale, scale).finished();
    const auto apart = [&](const Mat6& a, const Mat6& b, double power) {
      const Mat6 unscaled = arms.cwiseInverse().asDiagonal() * b * arms.cwiseInverse().asDiagonal();
      return (unscaled * std::pow(scale, -power) - a).cwiseAbs().maxCoeff() /
             a.cwiseAbs().maxCoeff();
    };
    const auto forcesApart = [&](const CVec6& a, const CVec6& b) {
      return (arms.cwiseInverse().cwiseProduct(b) / (scale * scale) - a).norm() / a.norm();
    };
    EXPECT_LT(apart(one.ship.restoring, other.ship.restoring, 2.0), kRefined);
    EXPECT_LT(apart(one.addedMass.atInfinity, other.addedMass.atInfinity, 3.0), kRefined);
    for (std::size_t i = 0; i < one.omega.size(); ++i) {
      EXPECT_NEAR(other.omega[i] * time / one.omega[i], 1.0, 1e-12);
      EXPECT_LT(apart(one.addedMass[i], other.addedMass[i], 3.0), kRefined) << i;
      EXPECT_LT(apart(one.damping[i], other.damping[i], 2.5), kRefined) << i;
      for (std::size_t h = 0; h < one.headings.size(); ++h) {
        EXPECT_LT(forcesApart(one.froudeKrylov[h][i], other.froudeKrylov[h][i]), kRefined) << i;
        EXPECT_LT(forcesApart(one.diffraction[h][i], other.diffraction[h][i]), kRefined) << i;
      }
    }
    EXPECT_NEAR(other.stability.checkedTo / time / one.stability.checkedTo, 1.0, 1e-9);
    const RetardationMatrix here(one), there(other);
    for (const double tau : {0.0, 2.0, 8.0})
      EXPECT_LT(apart(here.at(tau), there.at(tau * time), 2.0), 1e3 * kRefined) << tau;
  }
}

// What a user is told: nothing against a good database; of one whose panels are too large, which
// coefficients they do not carry, where, and how much.
TEST(Solve, TheVerdictSaysWhatCoefficientsAreGoodFor) {
  const Coefficients good = solve(floatingSphere(), upTo(12));
  EXPECT_TRUE(panelWarnings(good).empty());
  EXPECT_EQ(verdict(good).find("good for the frequency and the time domain"), 0u);

  const PanelledHull box{closedBox({40.0, 10.0, 3.0, 2.0}, 14, 4, 3),
                         wetBox({40.0, 10.0, 3.0, 2.0}, 14, 4, 3), true};
  SolveSettings settings;
  for (int i = 1; i <= 40; ++i) settings.omega.push_back(0.1 * i);
  const Coefficients coarse = solve(afloat(box, {.cog = {0.0, 0.0, 1.0}}).ship, settings);
  std::string all;
  for (const std::string& line : panelWarnings(coarse)) all += line + "\n";
  EXPECT_NE(all.find("damping in heave"), std::string::npos) << all;
  EXPECT_NE(all.find("rad/s"), std::string::npos);
  EXPECT_NE(all.find("use a finer mesh"), std::string::npos);
  EXPECT_NE(verdict(coarse).find("damping in heave"), std::string::npos);
}

TEST(Solve, ImpulseResponseIsTheRetardationFunction) {
  const Coefficients c = solve(floatingSphere(), upTo(12));
  const ImpulseResponse response = impulseResponse(c, 0.5, 2.0);
  ASSERT_EQ(response.values.size(), 5u);
  EXPECT_EQ(response.values[3], RetardationMatrix(c).at(1.5));
  EXPECT_EQ(impulseResponse(c).values.size(), 601u);
  EXPECT_TRUE(impulseResponse(solve(floatingSphere(), upTo(1))).values.empty());
  EXPECT_THROW(impulseResponse(c, 1.0, 0.5), HydroError);
}

// Between two hulls the water sways in resonances that no usual grid follows: they are named by
// mode and frequency, and the ship is not refused. Far from them (below 0.5 rad/s, a third of the
// first) the memory gives back what was solved, to 5 % of A(∞): that much of A22 belongs to them.
TEST(SolveVerification, ACatamaranHasAMemoryAndItsResonancesAreNamed) {
  const test::TestHull catamaran = test::testCatamaran();
  const PanelledHull hull{catamaran.hull.surface, catamaran.structured(224), true};
  SolveSettings settings;
  for (int i = 1; i <= 32; ++i) settings.omega.push_back(0.1 * i);
  settings.threads = 2;
  const Coefficients c = solve(afloat(hull, {.cog = {0, 0, 1}}).ship, settings);
  ASSERT_EQ(c.status, CoefficientStatus::Finished) << c.unfinishedBecause;
  const std::vector<std::string> warnings = gridWarnings(c);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("1.6 (sway, roll"), std::string::npos) << warnings[0];
  const RetardationMatrix memory(c);
  const Vec6 size = c.addedMass.atInfinity.diagonal().cwiseSqrt();
  for (std::size_t i = 0; i < 5; ++i) {
    const Mat6 off = memory.addedMassInf(c.omega[i], c.addedMass[i]) - c.addedMass.atInfinity;
    EXPECT_LT(off.cwiseQuotient(size * size.transpose()).cwiseAbs().maxCoeff(), 0.05) << i;
  }
}

// A barge of 196 panels: damping in heave is −5 % of its largest at 3.7 rad/s, below the frequency
// that its panels are said to resolve. No resonance, and no memory is made of it.
TEST(SolveRegression, ABargeOfNegativeDampingHasNoMemory) {
  const BoxShape box{60.0, 16.0, 4.0, 4.0};
  const PanelledHull hull{closedBox(box, 30, 4, 2), wetBox(box, 30, 4, 2), true};
  SolveSettings settings;
  for (int i = 1; i <= 40; ++i) settings.omega.push_back(0.1 * i);
  settings.threads = 2;
  const Coefficients c = solve(afloat(hull, {.cog = {0, 0, 1}}).ship, settings);
  EXPECT_EQ(c.status, CoefficientStatus::Unfinished);
  EXPECT_NE(c.unfinishedBecause.find("damping in heave near"), std::string::npos)
      << c.unfinishedBecause;
}

}  // namespace
}  // namespace cutwater
