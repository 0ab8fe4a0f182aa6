#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <random>

#include "hydro/Errors.h"
#include "hydro/excitation/ExcitationTable.h"
#include "hydro/forces/linear/Excitation.h"
#include "tests/forces/BoxShip.h"

namespace cutwater {
namespace {

/// The box with adjoint vectors that differ from panel to panel and smoothly over ω, as a hull's do.
Coefficients tableBox(bool symmetric = true) {
  Coefficients c = test::boxShip();
  if (!symmetric) {
    c.ship.wetSurface = welded(joined(c.ship.wetSurface, mirroredInY(c.ship.wetSurface)), 1e-9);
    c.ship.symmetric = false;
  }
  const SurfaceMesh& wet = c.ship.wetSurface;
  const auto vectors = [&](double w, double factor) {
    Coefficients::AdjointVectors b(6, static_cast<Eigen::Index>(wet.faces.size()));
    for (Eigen::Index i = 0; i < b.cols(); ++i) {
      Vec3 x = Vec3::Zero();
      const Face& face = wet.faces[static_cast<std::size_t>(i)];
      for (int n = 0; n < face.size(); ++n) x += wet.corner(face, n) / face.size();
      for (int j = 0; j < 6; ++j) {
        // Of one side's port half modes 2, 4, 6 are odd in y, and so is what is given for the whole.
        const double side = j % 2 == 1 && x.y() < 0.0 ? -1.0 : 1.0;
        const double shape = 1.0 + 0.1 * j * x.x() + 0.2 * std::abs(x.y()) - 0.3 * x.z();
        b(j, i) = side * factor * test::kBoxDensity * shape *
                  Complex(0.3 * w * std::exp(-0.5 * w), (1.0 + 0.1 * x.x() * w) / (1.0 + w * w));
      }
    }
    return b;
  };
  for (std::size_t i = 0; i < c.omega.size(); ++i) {
    c.adjoint[i] = vectors(c.omega[i], 1.0);
    c.adjointX.push_back(vectors(c.omega[i], 0.3));
  }
  c.adjointZero = vectors(0.0, 1.0);
  c.adjointXZero = vectors(0.0, 0.3);
  c.adjointInf = 0.05 * vectors(4.0, 1.0);
  c.adjointXInf = 0.05 * vectors(4.0, 0.3);
  return c;
}

SeaState tableSea(int count = 40, double from = 0.4, double to = 2.4) {
  std::vector<WaveComponent> waves;
  for (int i = 0; i < count; ++i)
    waves.push_back({from + (to - from) * i / std::max(1, count - 1), 0.1, 1.7 * i, 0.02 * i});
  return {waves, test::kBoxGravity};
}

/// Largest distance from direct evaluation at random courses and speeds of each mode's largest; `overtaken` counts
/// conditions with ω′ < 0.
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

// F_I's triangles are cut along other diagonals on the starboard side, which to second order in their size over the
// wave length is not quite the same: (kd)³ of waves twice as long as a panel's length.
TEST(ExcitationTableIdentity, AWholeHullIsTwiceItsHalf) {
  const SeaState sea = tableSea(6);
  const ExcitationTable half(tableBox(true), sea), whole(tableBox(false), sea);
  for (const double psi : {0.3, 2.0, -1.0})
    for (std::size_t i = 0; i < 6; ++i) {
      const auto a = half.at(i, psi, 4.0), b = whole.at(i, psi, 4.0);
      const double size = b.froudeKrylov.norm();
      EXPECT_LT((a.froudeKrylov - b.froudeKrylov).norm(), 1e-4 * size);
      EXPECT_LT((a.diffraction - b.diffraction).norm(), 2e-3 * b.diffraction.norm());  // two bases
    }
}

TEST(ExcitationTableIdentity, AWaveFromTheOtherSideIsTheMirrorImage) {
  const ExcitationTable table(tableBox(), SeaState({{1.2, 1.0, 0.0, 0.0}}, test::kBoxGravity));
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
  const auto calm = std::make_shared<ExcitationTable>(c, SeaState());
  ExcitationForce force(calm, 0.0);
  EXPECT_EQ(force.at({}), Vec6::Zero().eval());
  EXPECT_EQ(force.stateSize(), 1u);
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
  c.adjoint.clear();
  c.adjointX.clear();
  // On a grid of 15° the database's own straight lines have corners, of which cubics cut 1 %.
  EXPECT_LT(tableError(c, tableSea(), ForwardSpeedForm::Report, 0.0), 0.02);
  const ExcitationTable table(c, tableSea());
  EXPECT_EQ(table.at(3, 0.4, 7.0).diffraction, table.at(3, 0.4, 0.0).diffraction);
}

TEST(ExcitationTable, RefusesSeasBeyondTheDatabaseByNameAndLivesWithoutVectorsOfInfinity) {
  Coefficients c = tableBox();
  try {
    ExcitationTable(c, SeaState({{1.0, 1.0, 0.0, 0.0}, {4.5, 1.0, 0.0, 0.0}}, test::kBoxGravity));
    FAIL();
  } catch (const HydroError& error) {
    EXPECT_EQ(error.fault(), Fault::ValueOutOfRange);
    EXPECT_NE(std::string(error.what()).find("component 1"), std::string::npos) << error.what();
  }
  c.adjointInf.resize(6, 0);
  c.adjointXInf.resize(6, 0);
  const ExcitationTable table(c,
                              tableSea(40, 0.4, 3.9));  // head seas at speed are met beyond 4 rad/s
  EXPECT_TRUE(table.at(39, kPi, 10.0).diffraction.allFinite());
}

TEST(ExcitationTable, ACourseThatIsNoNumberGivesNone) {
  const auto table = std::make_shared<ExcitationTable>(tableBox(), tableSea());
  for (const double bad : {std::nan(""), HUGE_VAL}) {
    EXPECT_FALSE(table->at(0, bad, 1.0).froudeKrylov.allFinite());
    EXPECT_FALSE(table->at(0, 1.0, bad).diffraction.allFinite());
  }
  ExcitationForce force(table, 0.2, 3.0), other(table, 0.2, 3.0);
  ShipMotion motion;
  motion.meanHeading = std::nan("");
  motion.speed = 3.0;
  force.at(motion);  // one bad tick leaves no trace
  motion.meanHeading = 0.2;
  EXPECT_EQ(force.at(motion), other.at(motion));
}

// Two components a tick: 40 of them follow within 20 ticks, then nothing changes any more.
TEST(ExcitationForceIdentity, AShipThatTurnedIsRenewedToTheLastBit) {
  const auto table = std::make_shared<ExcitationTable>(tableBox(), tableSea());
  ExcitationForce turned(table, 0.2, 3.0), fresh(table, 1.2, 5.0);
  ShipMotion motion;
  motion.meanHeading = 1.2;
  motion.speed = 5.0;
  Vec6 force;
  for (int n = 0; n < 21; ++n) force = turned.at(motion);
  EXPECT_EQ(force, fresh.at(motion));
  turned.renew(0.2, 3.0);
  motion.meanHeading = 0.2;
  motion.speed = 3.0;
  EXPECT_EQ(turned.at(motion), ExcitationForce(table, 0.2, 3.0).at(motion));
}

/// The most that the two amplitudes of one tick can change when the course turns by `turn`, mode by mode.
Vec6 twoAmplitudesTurned(const ExcitationTable& table, double turn, double speed) {
  Vec6 most = Vec6::Zero();
  for (double psi = 0.0; psi < 1.0; psi += 0.01)
    for (std::size_t i = 0; i + 1 < table.sea().components().size(); i += 2) {
      Vec6 both = Vec6::Zero();
      for (const std::size_t n : {i, i + 1}) {
        const auto before = table.at(n, psi, speed), after = table.at(n, psi + turn, speed);
        both += table.sea().components()[n].amplitude *
                (after.froudeKrylov + after.diffraction - before.froudeKrylov - before.diffraction)
                    .cwiseAbs();
      }
      most = most.cwiseMax(both);
    }
  return most;
}

// 1°/s, 60 ticks a second, 40 components, so that each is renewed every 20 ticks by 0.33°, two of them a tick. Against a
// force all of whose amplitudes are those of the moment, no tick brings more than that: 1 to 4 % of the mode's
// largest force here, where the shortest waves turn by 6 rad · 0.0058 at her ends. 15 %: the drift of the others
// by 1/60°, and courses between those tried.
TEST(ExcitationForce, TurnsWithoutLargerJumpsThanTwoAmplitudesMake) {
  const auto table = std::make_shared<ExcitationTable>(tableBox(), tableSea());
  ExcitationForce turning(table, 0.0, 5.0), smooth(table, 0.0, 5.0);
  Vec6 before = Vec6::Zero(), largest = before, jump = before;
  ShipMotion motion;
  motion.speed = 5.0;
  for (int n = 0; n < 3000; ++n) {
    motion.time = n / 60.0;
    motion.meanHeading = n / 60.0 * kPi / 180.0;
    smooth.renew(motion.meanHeading, 5.0);
    const Vec6 force = turning.at(motion), lag = force - smooth.at(motion);
    if (n > 0) jump = jump.cwiseMax((lag - before).cwiseAbs());
    largest = largest.cwiseMax(force.cwiseAbs());
    before = lag;
  }
  const Vec6 allowed = twoAmplitudesTurned(*table, kPi / 540.0, 5.0);
  EXPECT_LT(jump.cwiseQuotient(allowed).maxCoeff(), 1.15);
  EXPECT_LT(jump.cwiseQuotient(largest).maxCoeff(), 0.05);
}

TEST(ExcitationForce, RestoredStateGivesTheSameBitsAndDamagedOnesAreRefused) {
  const auto table = std::make_shared<ExcitationTable>(tableBox(), tableSea());
  const auto drive = [](ExcitationForce& force, int from, int to) {
    Vec6 sum = Vec6::Zero();
    ShipMotion motion;
    for (int n = from; n < to; ++n) {
      motion.time = 0.02 * n;
      motion.meanHeading = 0.003 * n;
      motion.speed = 4.0 + 0.01 * n;
      sum += force.at(motion);
    }
    return sum;
  };
  ExcitationForce one(table, 0.0, 4.0), other(table, 1.0, 9.0);
  drive(one, 0, 333);
  std::vector<double> state(one.stateSize());
  one.save(state);
  other.restore(state);
  const Vec6 a = drive(one, 333, 400), b = drive(other, 333, 400);
  EXPECT_EQ(std::memcmp(a.data(), b.data(), sizeof a), 0);
  for (const double place : {-1.0, 40.0, 1e300, std::nan("")}) {
    state[0] = place;
    EXPECT_THROW(other.restore(state), HydroError) << place;
  }
  EXPECT_THROW(other.restore(std::span(state).first(5)), HydroError);
}

}  // namespace
}  // namespace cutwater
