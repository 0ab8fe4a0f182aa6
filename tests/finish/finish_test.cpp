#include "hydro/finish/Finish.h"

#include <gtest/gtest.h>

#include <cmath>
#include <type_traits>

#include "hydro/Errors.h"
#include "hydro/bem/BuildCoefficients.h"
#include "hydro/database/CoefficientsFile.h"
#include "hydro/database/Interpolation.h"
#include "hydro/finish/GridNeeds.h"
#include "hydro/forces/Hydrodynamics.h"
#include "hydro/memory/RadiationModel.h"
#include "tests/bem/Frigate.h"

namespace cutwater {
namespace {

// What the solver returns cannot be written, read by the time domain or passed off as coefficients,
// and coefficients cannot be finished again.
using Output = const SolverOutput&;
static_assert(!std::is_convertible_v<SolverOutput, Coefficients>);
static_assert(!std::is_constructible_v<Coefficients, SolverOutput>);
static_assert(!std::is_assignable_v<Coefficients&, SolverOutput>);
static_assert(!std::is_assignable_v<CoefficientTables&, Output>);
static_assert(!std::is_constructible_v<CoefficientTables, Output>);
static_assert(
    !std::is_invocable_v<decltype(writeCoefficients), Output, std::string, ImpulseResponse>);
static_assert(!std::is_constructible_v<RetardationMatrix, Output>);
static_assert(!std::is_constructible_v<RadiationModel, Output, ForwardSpeedForm>);
static_assert(!std::is_constructible_v<Hydrodynamics, Output>);
static_assert(!std::is_invocable_v<decltype(finish), Coefficients>);
static_assert(std::is_invocable_r_v<Coefficients, decltype(finish), SolverOutput>);

/// Frigate, 224 panels a side, resolved up to 2.44 rad/s.
SolverOutput frigateOutput(int count, double step, bool vectors = false) {
  SolveSettings settings;
  settings.forwardSpeed = ForwardSpeedForm::Report;
  for (int i = 1; i <= count; ++i) settings.omega.push_back(step * i);
  if (vectors) settings.headings = {kPi};
  return buildCoefficients(test::frigateAfloat(frigateDivision(224)), settings);
}

std::size_t count(const std::string& text, const std::string& word) {
  std::size_t found = 0;
  for (std::size_t at = 0; (at = text.find(word, at)) != std::string::npos; at += word.size())
    ++found;
  return found;
}

/// Least B_jj(ω) of the largest of its mode.
double leastDampingOf(const CoefficientTables& c) {
  Vec6 peak = Vec6::Zero(), least = peak;
  for (const Mat6& B : c.damping) {
    peak = peak.cwiseMax(B.diagonal());
    least = least.cwiseMin(B.diagonal());
  }
  return least.cwiseQuotient(peak).minCoeff();
}

TEST(FinishIdentity, TheFrigateIsFinishedAndItsDampingPositive) {
  const SolverOutput output = frigateOutput(60, 0.1, true);
  const Coefficients c = finish(output);
  EXPECT_EQ(c.status, CoefficientStatus::Finished);
  EXPECT_EQ(c.unfinishedBecause, "");
  EXPECT_TRUE(c.hasConsistentLimit());
  // As the solver left it: −179 % above 2.44 rad/s, whose waves the panels do not resolve.
  EXPECT_LT(leastDampingOf(output), -1.0);
  EXPECT_GT(leastDampingOf(c), -1e-3);  // the solver's error where B nearly vanishes
  for (const auto* matrices : {&c.addedMass, &c.damping})
    for (std::size_t i = 0; i < resolvedCount(c); ++i)
      EXPECT_EQ((*matrices)[i], Mat6((*matrices)[i].transpose()));
  for (const char* key : {"added_mass_asymmetry", "damping_asymmetry", "formulation"})
    EXPECT_EQ(count(c.provenance.settings, key), 1u) << key;
}

TEST(FinishIdentity, KeepsWhatThePanelsResolve) {
  const SolverOutput output = frigateOutput(60, 0.1, true);
  const Coefficients c = finish(output);
  const std::size_t resolved = resolvedCount(output);
  ASSERT_EQ(resolved, 24u);
  for (std::size_t i = 0; i < resolved; ++i) {
    const Mat6 &A = output.addedMass[i], &B = output.damping[i];
    EXPECT_EQ(c.addedMass[i], Mat6(0.5 * (A + A.transpose())));
    EXPECT_EQ(c.damping[i], Mat6(0.5 * (B + B.transpose())));
    EXPECT_EQ(c.dampingX[i], output.dampingX[i]);
    EXPECT_EQ(c.adjoint[i], output.adjoint[i]);
    EXPECT_EQ(c.adjointX[i], output.adjointX[i]);
    EXPECT_EQ(c.diffraction[0][i], output.diffraction[0][i]);
    if (c.omega[i] < 0.5 * c.omega[resolved - 1]) {
      EXPECT_EQ(c.addedMassX[i], output.addedMassX[i]);
    }
  }
  EXPECT_EQ(c.froudeKrylov, output.froudeKrylov);
  EXPECT_EQ(c.addedMassInfDirect, output.addedMass.atInfinity);
  EXPECT_EQ(c.addedMass.atZero, output.addedMass.atZero);
  EXPECT_EQ(c.adjoint.atInfinity, output.adjoint.atInfinity);
  EXPECT_NE(c.damping[resolved], output.damping[resolved]);
}

// With 0.2 rad/s, 0.7 √(g/L), the memory of bow and stern's interference is not there. 0.1 would
// do.
TEST(Finish, AGridTooCoarseIsUnfinishedAndSaysWhatWouldDo) {
  const Coefficients c = finish(frigateOutput(30, 0.2));
  EXPECT_EQ(c.status, CoefficientStatus::Unfinished);
  EXPECT_FALSE(c.hasConsistentLimit());
  for (const char* word : {"0.2 rad/s", "0.1 rad/s (0.36 sqrt(g/L))", "A(inf)", "2 %"})
    EXPECT_NE(c.unfinishedBecause.find(word), std::string::npos) << c.unfinishedBecause;
  EXPECT_EQ(c.unfinishedBecause.find('\n'), std::string::npos);
}

// The reason says it, and no second warning does.
TEST(Finish, NegativeDampingOfUnfinishedCoefficientsIsSaidOnce) {
  SolverOutput output = frigateOutput(30, 0.2);
  double most = 0.0;
  for (const Mat6& B : output.damping) most = std::max(most, B(Heave, Heave));
  output.damping[4](Heave, Heave) = -0.03 * most;
  const Coefficients c = finish(output);
  ASSERT_EQ(c.status, CoefficientStatus::Unfinished);
  const std::string said = "damping in heave near 1 rad/s, where it is -3 % of its largest";
  const std::size_t first = c.unfinishedBecause.find(said);
  ASSERT_NE(first, std::string::npos) << c.unfinishedBecause;
  EXPECT_EQ(c.unfinishedBecause.find(said, first + 1), std::string::npos);
  EXPECT_EQ(dampingWarnings(c).size(), 1u);
  for (const std::string& line : panelWarnings(c)) EXPECT_EQ(line.find("damping in"), line.npos);
}

TEST(Finish, ARangeTooShortIsUnfinishedAndSaysWhatWouldDo) {
  const Coefficients c = finish(frigateOutput(10, 0.1));
  EXPECT_EQ(c.status, CoefficientStatus::Unfinished);
  for (const char* word : {"end at 1 rad/s", "2.5 rad/s (3 sqrt(g/beam))"})
    EXPECT_NE(c.unfinishedBecause.find(word), std::string::npos) << c.unfinishedBecause;
  EXPECT_EQ(c.unfinishedBecause.find("too coarse"), std::string::npos) << c.unfinishedBecause;
}

// Steps of 0.4 rad/s to 6 leave 6 frequencies below 2.44 rad/s; the other nine say nothing of the
// ship.
TEST(Finish, FrequenciesThatThePanelsDoNotResolveMakeNoMemory) {
  const Coefficients c = finish(frigateOutput(15, 0.4));
  EXPECT_EQ(c.status, CoefficientStatus::Unfinished);
  EXPECT_NE(c.unfinishedBecause.find("fewer than 8"), std::string::npos) << c.unfinishedBecause;
}

TEST(Finish, UnfinishedCoefficientsAreRefusedByTheTimeDomain) {
  const auto c = std::make_shared<const Coefficients>(finish(frigateOutput(1, 0.8)));
  EXPECT_EQ(c->status, CoefficientStatus::Unfinished);
  const auto refused = [&](const auto& use) {
    try {
      use();
      ADD_FAILURE() << "accepted";
    } catch (const HydroError& error) {
      EXPECT_EQ(error.fault(), Fault::DatabaseIncomplete);
      EXPECT_NE(std::string(error.what()).find(c->unfinishedBecause), std::string::npos)
          << error.what();
    }
  };
  refused([&] { requireFinished(*c, "test"); });
  refused([&] { RetardationMatrix memory(*c); });
  refused([&] { RadiationModel model(*c, c->forwardSpeed); });
  refused([&] { Hydrodynamics shared(c); });  // and with it Seaway::addShip
  EXPECT_NO_THROW(requireFinished(Coefficients{}, "given"));
}

// Where the mask leaves one frequency of two there is nothing to interpolate between.
TEST(Finish, ConditionLimitsThatLeaveNothingAreRefused) {
  SolverOutput output = frigateOutput(2, 0.5);
  output.conditionLimitEven = {{1.0, 1.0}};
  try {
    finish(std::move(output));
    FAIL();
  } catch (const HydroError& error) {
    EXPECT_EQ(error.fault(), Fault::DatabaseIncomplete);
    EXPECT_NE(std::string(error.what()).find("0 of 2"), std::string::npos) << error.what();
  }
}

TEST(Asymmetry, IsTheLargestDifferenceOfItsModes) {
  OverFrequency<Mat6> table;
  Mat6 m = Mat6::Identity() * 4.0;
  m(0, 4) = 0.5;
  m(4, 0) = 0.1;
  table.values = {Mat6::Identity(), m};
  EXPECT_DOUBLE_EQ(asymmetry(table), 0.1);  // 0.4 of √(4 · 4)
}

}  // namespace
}  // namespace cutwater
