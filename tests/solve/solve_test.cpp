#include "hydro/solve/Solve.h"

#include <gtest/gtest.h>

#include <cmath>

#include "hydro/Errors.h"
#include "hydro/bem/BuildCoefficients.h"
#include "hydro/excitation/WaveExcitation.h"
#include "hydro/finish/Finish.h"
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
  EXPECT_NE(c.unfinishedBecause.find("damping in heave is -"), std::string::npos)
      << c.unfinishedBecause;
}

}  // namespace
}  // namespace cutwater
