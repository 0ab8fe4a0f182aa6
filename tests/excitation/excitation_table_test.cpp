#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "hydro/Errors.h"
#include "hydro/excitation/ExcitationTable.h"
#include "hydro/excitation/WaveExcitation.h"
#include "tests/excitation/TableBox.h"

namespace cutwater {
namespace {

using test::tableBox, test::tableSea;

constexpr ForwardSpeedForm kForm = ForwardSpeedForm::Report;

/// Largest distance from direct evaluation at random courses and speeds of each mode's largest;
/// `overtaken` counts conditions with ω′ < 0.
double tableError(const Coefficients& c, const SeaState& sea, ForwardSpeedForm form, double fastest,
                  int* overtaken = nullptr) {
  const ExcitationTable table(c, sea, form);
  const WaveExcitation direct(c, form);
  std::mt19937 random(8);
  std::uniform_real_distribution<double> course(-10.0, 10.0), speeds(-2.0, fastest);
  Eigen::Array<double, 6, 1> worst = Eigen::Array<double, 6, 1>::Zero(), largest = worst;
  for (int n = 0; n < 400; ++n) {
    const std::size_t i = random() % sea.components().size();
    const WaveComponent& wave = sea.components()[i];
    const double psi = course(random), U = fastest > 0.0 ? speeds(random) : 0.0;
    const auto found = table.at(i, psi, U);
    const auto exact = direct.at(wave.omega, wave.heading + psi, U);
    worst = worst.max((found.froudeKrylov + found.diffraction - exact.total()).array().abs());
    largest = largest.max(exact.total().array().abs());
    if (overtaken != nullptr)
      *overtaken += encounterFrequency(wave.omega, U, wave.heading + psi, sea.gravity()) < 0.0;
  }
  return (worst / largest).maxCoeff();
}

constexpr ForwardSpeedForm kTableForms[] = {ForwardSpeedForm::Report, ForwardSpeedForm::Tuck};

// The table's acceptance line: 1 % of the mode's largest force in this sea.
TEST(ExcitationTableIdentity, IsDirectEvaluationAtAnyCourseAndSpeedOvertakingOrNot) {
  for (const bool symmetric : {true, false}) {
    const Coefficients c = tableBox(symmetric);
    for (const auto form : kTableForms) {
      int overtaken = 0;
      EXPECT_LT(tableError(c, tableSea(), form, 12.0, &overtaken), 0.01) << symmetric;
      EXPECT_GT(overtaken, 20);
    }
  }
}

// Leeway V is felt in the encounter frequency alone: of Tuck's form, F_D = ω′F^ω + U F^U, sway and
// heave are those at the speed U − V tan β, at which the wave is met alike; pitch has i U F^ω₃
// beside them, yaw −i U F^ω₂.
TEST(ExcitationTableIdentity, LeewayChangesTheFrequencyOfMeetingAlone) {
  const Coefficients c = tableBox();
  const SeaState sea = tableSea();
  const ExcitationTable table(c, sea, ForwardSpeedForm::Tuck);
  for (const std::size_t i : {3u, 17u, 35u}) {
    const WaveComponent& wave = sea.components()[i];
    const double psi = 0.6, U = 4.0, V = 0.7, beta = wave.heading + psi;
    const double met = wave.omega - wave.omega * wave.omega / sea.gravity() *
                                        (U * std::cos(beta) - V * std::sin(beta));
    const double same = U - V * std::tan(beta);
    const CVec6 found = table.diffraction(i, psi, U, V);
    CVec6 expected = table.diffraction(i, psi, same);
    const Complex more = Complex(0.0, U - same) / met;
    expected[Pitch] += more * expected[Heave];
    expected[Yaw] -= more * expected[Sway];
    EXPECT_LT((found - expected).norm(), 1e-10 * expected.norm()) << i;  // U and V round ω′
    EXPECT_EQ(table.diffraction(i, psi, U, 0.0), table.diffraction(i, psi, U));
    EXPECT_FALSE(table.diffraction(i, psi, U, std::nan("")).allFinite());
  }
}

// F_I's triangles are cut along other diagonals on the starboard side, which to second order in
// their size over the wave length is not quite the same: (kd)³ of waves twice as long as a panel's
// length.
TEST(ExcitationTableIdentity, AWholeHullIsTwiceItsHalf) {
  const SeaState sea = tableSea(6);
  const ExcitationTable half(tableBox(true), sea, kForm), whole(tableBox(false), sea, kForm);
  for (const double psi : {0.3, 2.0, -1.0})
    for (std::size_t i = 0; i < 6; ++i) {
      const auto a = half.at(i, psi, 4.0), b = whole.at(i, psi, 4.0);
      const double size = b.froudeKrylov.norm();
      EXPECT_LT((a.froudeKrylov - b.froudeKrylov).norm(), 1e-4 * size);
      EXPECT_LT((a.diffraction - b.diffraction).norm(), 2e-3 * b.diffraction.norm());  // two bases
    }
}

TEST(ExcitationTableIdentity, AWaveFromTheOtherSideIsTheMirrorImage) {
  const ExcitationTable table(tableBox(), SeaState({{1.2, 1.0, 0.0, 0.0}}, test::kBoxGravity),
                              kForm);
  for (const double psi : {0.4, 1.9, 3.0})
    for (const double U : {0.0, 5.0}) {
      const auto port = table.at(0, psi, U), starboard = table.at(0, -psi, U);
      const CVec6 a = port.froudeKrylov + port.diffraction,
                  b = starboard.froudeKrylov + starboard.diffraction;
      for (int j = 0; j < 6; ++j) {
        const double sign = j % 2 == 0 ? 1.0 : -1.0;
        EXPECT_LT(std::abs(a[j] - sign * b[j]), 1e-9 * a.norm()) << psi << ' ' << j;
      }
    }
}

TEST(ExcitationTable, HoldsNarrowSeasAndSinglesAndNone) {
  const Coefficients c = tableBox();
  EXPECT_LT(tableError(c, tableSea(60, 1.5, 1.6), ForwardSpeedForm::Report, 8.0), 0.01);
  EXPECT_LT(tableError(c, tableSea(60, 1.5, 1.5 + 1e-9), ForwardSpeedForm::Report, 8.0), 0.01);
  EXPECT_LT(tableError(c, tableSea(1), ForwardSpeedForm::Report, 8.0), 0.01);
  EXPECT_LT(tableError(c, tableSea(3), ForwardSpeedForm::Report, 8.0), 0.01);
  EXPECT_NO_THROW(ExcitationTable(c, SeaState(), kForm));
}

TEST(ExcitationTable, WithoutVectorsDiffractionIsThatAtRest) {
  Coefficients c = tableBox();
  const Coefficients whole = tableBox();
  const WaveExcitation exact(whole);
  for (int h = 0; h <= 12; ++h) {
    c.headings.push_back(kPi / 12 * h);
    c.froudeKrylov.emplace_back();
    c.diffraction.emplace_back();
    for (const double omega : c.omega) {
      const auto force = exact.at(omega, c.headings.back());
      c.froudeKrylov.back().push_back(force.froudeKrylov);
      c.diffraction.back().push_back(force.diffraction);
    }
  }
  c.adjoint = {};
  c.adjointX = {};
  // On a grid of 15° the database's own straight lines have corners, of which cubics cut 1 %.
  EXPECT_LT(tableError(c, tableSea(), ForwardSpeedForm::Report, 0.0), 0.02);
  const ExcitationTable table(c, tableSea(), kForm);
  EXPECT_EQ(table.at(3, 0.4, 7.0).diffraction, table.at(3, 0.4, 0.0).diffraction);
}

TEST(ExcitationTable, RefusesAWaveBeyondTheDatabaseByNameAndLivesWithoutVectorsOfInfinity) {
  Coefficients c = tableBox();
  try {
    ExcitationTable(c, SeaState({{4.5, 1.0, 0.0, 0.0}}, test::kBoxGravity), kForm);
    FAIL();
  } catch (const HydroError& error) {
    EXPECT_EQ(error.fault(), Fault::ValueOutOfRange);
    EXPECT_NE(std::string(error.what()).find("omega = 4.5 rad/s"), std::string::npos)
        << error.what();
  }
  c.adjoint.atInfinity.resize(6, 0);
  c.adjointX.atInfinity.resize(6, 0);
  // Head seas at speed are met beyond 4 rad/s.
  const ExcitationTable table(c, tableSea(40, 0.4, 3.9), kForm);
  EXPECT_TRUE(table.at(39, kPi, 10.0).diffraction.allFinite());
}

TEST(ExcitationTable, ACourseThatIsNoNumberGivesNone) {
  const auto table = std::make_shared<ExcitationTable>(tableBox(), tableSea(), kForm);
  for (const double bad : {std::nan(""), HUGE_VAL}) {
    EXPECT_FALSE(table->at(0, bad, 1.0).froudeKrylov.allFinite());
    EXPECT_FALSE(table->at(0, 1.0, bad).diffraction.allFinite());
  }
}

}  // namespace
}  // namespace cutwater
