#include <gtest/gtest.h>

#include <set>

#include "hydro/bem/SweepRecord.h"
#include "hydro/geometry/shapes/Shapes.h"

// What a journal keeps of a frequency, and when it is another sweep's.
namespace cutwater::test {
namespace {

/// Room for three frequencies of all that a sweep may compute, every number another.
Coefficients numberedOutput() {
  Coefficients c;
  c.ship.wetSurface = wetHalfEllipsoid({10.0, 3.0, 2.0}, 3, 2);
  c.ship.symmetric = true;
  c.omega = {0.5, 1.0, 1.5};
  c.headings = {0.0, 2.0};
  double next = 1.0;
  const auto number = [&next](double) { return next++; };
  const auto complexNumber = [&next](const Complex&) {
    next += 2.0;
    return Complex(next - 2.0, next - 1.0);
  };
  for (auto* matrices : {&c.addedMass, &c.damping, &c.addedMassX, &c.dampingX})
    for (int i = 0; i < 3; ++i) matrices->values.push_back(Mat6::Zero().unaryExpr(number));
  for (auto* vectors : {&c.adjoint, &c.adjointX})
    for (int i = 0; i < 3; ++i)
      vectors->values.push_back(Eigen::MatrixXcd::Zero(6, 6).unaryExpr(complexNumber));
  for (auto* forces : {&c.froudeKrylov, &c.diffraction})
    for (int heading = 0; heading < 2; ++heading) {
      forces->emplace_back();
      for (int i = 0; i < 3; ++i) forces->back().push_back(CVec6::Zero().unaryExpr(complexNumber));
    }
  for (auto* condition : {&c.conditionEven, &c.conditionOdd}) condition->assign(3, next++);
  return c;
}

// 4 matrices of 36, 2 × 6 × 6 complex adjoints, 2 × 2 complex forces of 6, 2 condition numbers:
// none twice.
TEST(SweepRecordClosedForm, AFrequencyIsAllItsNumbersOnce) {
  Coefficients c = numberedOutput();
  const std::vector<double> numbers = packed(c, 1);
  EXPECT_EQ(numbers.size(), 4u * 36u + 2u * 72u + 4u * 12u + 2u);
  EXPECT_EQ(std::set<double>(numbers.begin(), numbers.end()).size(), numbers.size());
  EXPECT_NE(packed(c, 0), numbers);
}

TEST(SweepRecordIdentity, UnpackedNumbersAreTheSameBitsInTheirPlaces) {
  Coefficients from = numberedOutput(), to = numberedOutput();
  for (Mat6& m : to.damping) m.setZero();
  for (auto& heading : to.diffraction)
    for (CVec6& force : heading) force.setZero();
  to.conditionOdd.assign(3, 0.0);
  const std::vector<double> before = packed(to, 0), numbers = packed(from, 1);
  unpack(numbers, to, 1);
  EXPECT_EQ(packed(to, 1), numbers);
  EXPECT_EQ(packed(to, 0), before);  // the other frequencies as they were
  EXPECT_EQ(to.damping[1], from.damping[1]);
  EXPECT_EQ(to.dampingX[1], from.dampingX[1]);
  EXPECT_EQ(to.adjointX[1], from.adjointX[1]);
  EXPECT_EQ(to.diffraction[1][1], from.diffraction[1][1]);
  EXPECT_EQ(to.conditionOdd[1], from.conditionOdd[1]);
  EXPECT_EQ(to.damping[2], Mat6::Zero().eval());
}

// What was not asked for takes no room.
TEST(SweepRecordIdentity, PartsThatAreNotComputedAreNotKept) {
  Coefficients c = numberedOutput();
  c.addedMassX = {};
  c.dampingX = {};
  c.adjoint = {};
  c.adjointX = {};
  c.conditionOdd.clear();
  EXPECT_EQ(packed(c, 2).size(), 2u * 36u + 4u * 12u + 1u);
}

// A journal of another ship, other settings or another program must not be gone on with.
TEST(SweepRecordIdentity, KeyChangesWithAllThatAFrequencyDependsOn) {
  const SolveSettings settings;
  const Coefficients base = numberedOutput();
  std::set<std::uint64_t> keys{journalKey(base, settings)};
  EXPECT_EQ(journalKey(numberedOutput(), settings), *keys.begin());
  const auto changed = [&](auto change) {
    Coefficients c = numberedOutput();
    change(c);
    keys.insert(journalKey(c, settings));
  };
  changed([](auto& c) { c.ship.wetSurface.vertices[3].z() += 1e-12; });
  changed([](auto& c) { std::swap(c.ship.wetSurface.faces[0], c.ship.wetSurface.faces[1]); });
  changed([](auto& c) { c.ship.cog.x() = 1e-9; });
  changed([](auto& c) { c.ship.density = 1000.0; });
  changed([](auto& c) { c.ship.gravity = 9.81; });
  changed([](auto& c) { c.ship.symmetric = false; });
  changed([](auto& c) { c.omega[2] = 1.6; });
  changed([](auto& c) { c.headings[1] = 2.1; });
  changed([](auto& c) { c.provenance.version = "another"; });
  changed([](auto& c) { c.provenance.settings = "galerkin_points = 9"; });
  SolveSettings finerLid;
  finerLid.lidPanelLength = 0.5;
  keys.insert(journalKey(base, finerLid));
  EXPECT_EQ(keys.size(), 12u);
}

// What is only found out by the sweep does not change its key.
TEST(SweepRecordIdentity, KeyDoesNotDependOnResultsOrThreads) {
  SolveSettings settings;
  settings.forwardSpeed = ForwardSpeedForm::Report;
  Coefficients c = numberedOutput();
  const std::uint64_t key = journalKey(c, settings);
  c.damping[0].setZero();
  settings.threads = 7;
  EXPECT_EQ(journalKey(c, settings), key);
}

TEST(SweepRecordIdentity, MeshesOfTheSamePanelsHaveTheSameHash) {
  const SurfaceMesh mesh = wetHalfEllipsoid({10.0, 3.0, 2.0}, 3, 2);
  SurfaceMesh other = mesh;
  EXPECT_EQ(hashOf(mesh), hashOf(other));
  EXPECT_EQ(hashOf(mesh).size(), 16u);  // hexadecimal digits
  EXPECT_EQ(hashOf(mesh).find_first_not_of("0123456789abcdef"), std::string::npos);
  other.vertices.back().x() = std::nextafter(other.vertices.back().x(), 1e9);
  EXPECT_NE(hashOf(mesh), hashOf(other));
}

}  // namespace
}  // namespace cutwater::test
