#include <gtest/gtest.h>

#include "hydro/Errors.h"
#include "hydro/bem/solution/SymmetricSystem.h"
#include "tests/support/Matrices.h"

// The algebra of a factored system, on matrices that belong to no hull.
namespace cutwater::test {
namespace {

constexpr Eigen::Index kHullRows = 12, kLidRows = 3, kAllRows = kHullRows + kLidRows;
// Two solves, backward errors of 1e-10 times condition numbers of some ten.
constexpr double kOfTwoSolves = 1e-8;

using ComplexSystem = SymmetricSystem<Complex>;

Eigen::MatrixXcd randomMatrix(Eigen::Index rows, Eigen::Index columns) {
  return Eigen::MatrixXcd::Random(rows, columns);
}

/// Well conditioned; R and H as the formulation shapes them.
InfluenceSystem<Complex> anySystem(Formulation formulation, bool withH) {
  const bool source = formulation == Formulation::Source;
  InfluenceSystem<Complex> system;
  system.formulation = formulation;
  system.L =
      randomMatrix(kAllRows, kAllRows) + 8.0 * Eigen::MatrixXcd::Identity(kAllRows, kAllRows);
  system.R = source ? randomMatrix(kHullRows, kAllRows) : randomMatrix(kAllRows, kHullRows);
  if (withH) system.H = randomMatrix(kHullRows, kAllRows);
  return system;
}

ComplexSystem::Systems twoSystems(Formulation formulation, bool withH) {
  return {anySystem(formulation, withH), anySystem(formulation, withH)};
}

constexpr Formulation kFormulations[] = {Formulation::Potential, Formulation::Source};
constexpr Parity kParities[] = {Parity::Even, Parity::Odd};

Eigen::MatrixXcd onLidZero(const Eigen::MatrixXcd& onHull) {
  Eigen::MatrixXcd all = Eigen::MatrixXcd::Zero(kAllRows, onHull.cols());
  all.topRows(kHullRows) = onHull;
  return all;
}

// Potential: Lφ = Rv, φ on the hull the first rows. Source: Lσ = v, nothing on the lid, φ = Rσ,
// ∂φ/∂x = Hσ.
TEST(SymmetricSystemIdentity, PotentialsSolveTheEquationOfEitherFormulation) {
  for (const Formulation formulation : kFormulations) {
    const ComplexSystem::Systems systems = twoSystems(formulation, true);
    const ComplexSystem solver(systems, 2);
    EXPECT_EQ(solver.parities(), 2);
    const Eigen::MatrixXcd v = randomMatrix(kHullRows, 4);
    for (const Parity parity : kParities) {
      const auto& [L, R, H, which] = systems[static_cast<std::size_t>(parity)];
      const bool source = formulation == Formulation::Source;
      const Eigen::MatrixXcd unknowns = solved(L, source ? onLidZero(v) : Eigen::MatrixXcd(R * v));
      const Eigen::MatrixXcd ofAll = source ? Eigen::MatrixXcd(R * unknowns) : unknowns;
      const Eigen::MatrixXcd phi = ofAll.topRows(kHullRows);
      EXPECT_LT((solver.potentials(parity, v) - phi).norm(), kOfTwoSolves * phi.norm());
      if (!source) continue;
      const Eigen::MatrixXcd slope = H * unknowns;
      EXPECT_LT((solver.xDerivatives(parity, v) - slope).norm(), kOfTwoSolves * slope.norm());
    }
  }
}

// bᵀv = wᵀφ for every v and w, plain transpose: one adjoint solution replaces all direct ones.
TEST(SymmetricSystemIdentity, AdjointsGiveWhatDirectSolutionsGive) {
  for (const Formulation formulation : kFormulations) {
    const ComplexSystem solver(twoSystems(formulation, true), 2);
    const Eigen::MatrixXcd v = randomMatrix(kHullRows, 3), w = randomMatrix(kHullRows, 2);
    for (const Parity parity : kParities) {
      const Eigen::MatrixXcd direct = w.transpose() * solver.potentials(parity, v);
      const Eigen::MatrixXcd adjoint = solver.adjoints(parity, w).transpose() * v;
      EXPECT_LT((adjoint - direct).norm(), kOfTwoSolves * direct.norm());
      if (formulation != Formulation::Source) continue;
      const Eigen::MatrixXcd directX = w.transpose() * solver.xDerivatives(parity, v);
      EXPECT_LT((solver.xAdjoints(parity, w).transpose() * v - directX).norm(),
                kOfTwoSolves * directX.norm());
    }
  }
}

// Both for the price of one; without H the second are adjoints like the first.
TEST(SymmetricSystemIdentity, BothAdjointsAreTheOneAndTheOther) {
  const Eigen::MatrixXcd w = randomMatrix(kHullRows, 2), wX = randomMatrix(kHullRows, 3);
  for (const bool withH : {true, false}) {
    const ComplexSystem solver(twoSystems(Formulation::Source, withH), 2);
    EXPECT_EQ(solver.hasXDerivative(), withH);
    for (const Parity parity : kParities) {
      const Eigen::MatrixXcd both = solver.bothAdjoints(parity, w, wX);
      ASSERT_EQ(both.cols(), 5);
      const Eigen::MatrixXcd second =
          withH ? solver.xAdjoints(parity, wX) : solver.adjoints(parity, wX);
      EXPECT_LT((both.leftCols(2) - solver.adjoints(parity, w)).norm(), kOfTwoSolves);
      EXPECT_LT((both.rightCols(3) - second).norm(), kOfTwoSolves);
    }
  }
}

// [M03] (84)-(87): at either end it is that system; between, R, H and the inverse of L are linear.
// With one R for both the potentials are linear themselves.
TEST(SymmetricSystemIdentity, InversesAreLinearBetweenTwoSystems) {
  for (const Formulation formulation : kFormulations) {
    ComplexSystem::Systems systems = twoSystems(formulation, false), others = systems;
    for (std::size_t p = 0; p < 2; ++p) others[p].L += 0.5 * randomMatrix(kAllRows, kAllRows);
    const ComplexSystem a(systems, 2), b(others, 2);
    const Eigen::MatrixXcd v = randomMatrix(kHullRows, 2);
    for (const Parity parity : kParities) {
      const Eigen::MatrixXcd atA = a.potentials(parity, v), atB = b.potentials(parity, v);
      EXPECT_GT((atA - atB).norm(), 1e-3 * atA.norm());
      for (const double t : {0.0, 0.3, 1.0}) {
        const ComplexSystem between = ComplexSystem::betweenInverses(a, b, t);
        const Eigen::MatrixXcd expected = (1.0 - t) * atA + t * atB;
        EXPECT_LT((between.potentials(parity, v) - expected).norm(), kOfTwoSolves * expected.norm())
            << t;
        const Eigen::MatrixXcd direct = v.transpose() * expected;
        EXPECT_LT((between.adjoints(parity, v).transpose() * v - direct).norm(),
                  kOfTwoSolves * direct.norm())
            << t;
      }
    }
  }
}

// R itself is linear between: with one L, the potentials of the mean are the mean of the
// potentials.
TEST(SymmetricSystemIdentity, RightSidesAreLinearBetweenTwoSystems) {
  ComplexSystem::Systems systems = twoSystems(Formulation::Source, true), others = systems;
  for (std::size_t p = 0; p < 2; ++p) {
    others[p].R = randomMatrix(kHullRows, kAllRows);
    others[p].H = randomMatrix(kHullRows, kAllRows);
  }
  const ComplexSystem a(systems, 2), b(others, 2);
  const ComplexSystem middle = ComplexSystem::betweenInverses(a, b, 0.5);
  const Eigen::MatrixXcd v = randomMatrix(kHullRows, 2);
  for (const Parity parity : kParities) {
    const Eigen::MatrixXcd phi = 0.5 * (a.potentials(parity, v) + b.potentials(parity, v)),
                           slope = 0.5 * (a.xDerivatives(parity, v) + b.xDerivatives(parity, v));
    EXPECT_LT((middle.potentials(parity, v) - phi).norm(), kOfTwoSolves * phi.norm());
    EXPECT_LT((middle.xDerivatives(parity, v) - slope).norm(), kOfTwoSolves * slope.norm());
  }
}

// The matrices come back as they were, and what is left behind changes nothing at the next
// frequency.
TEST(SymmetricSystemIdentity, ReleasedMatricesAreTheOriginalsAndServeAgain) {
  const ComplexSystem::Systems systems = twoSystems(Formulation::Source, true),
                               next = twoSystems(Formulation::Source, true);
  ComplexSystem first(systems, 2);
  auto [matrices, factors] = std::move(first).release();
  for (std::size_t p = 0; p < 2; ++p) {
    EXPECT_EQ(matrices[p].L, systems[p].L);
    EXPECT_EQ(matrices[p].R, systems[p].R);
    EXPECT_EQ(matrices[p].H, systems[p].H);
  }
  const ComplexSystem fresh(next, 2), reused(next, 2, std::move(factors));
  const Eigen::MatrixXcd v = randomMatrix(kHullRows, 2);
  for (const Parity parity : kParities)
    EXPECT_EQ(fresh.potentials(parity, v), reused.potentials(parity, v));
}

// Each parity has its own condition; of a mean of inverses it is the first one's. Diagonal
// matrices: the ratio of their entries; the estimate is exact there but for factors in single
// precision.
TEST(SymmetricSystemClosedForm, ConditionNumbersOfEachParity) {
  SymmetricSystem<double>::Systems systems;
  for (std::size_t p = 0; p < 2; ++p) {
    systems[p].L = Eigen::MatrixXd::Identity(4, 4);
    systems[p].L(3, 3) = p == 0 ? 10.0 : 1000.0;
    systems[p].R = Eigen::MatrixXd::Identity(4, 4);
  }
  const SymmetricSystem<double> solver(systems, 2);
  EXPECT_NEAR(solver.condition(Parity::Even), 10.0, 1e-4);
  EXPECT_NEAR(solver.condition(Parity::Odd), 1000.0, 1e-2);
  systems[0].L(3, 3) = 50.0;
  const SymmetricSystem<double> other(systems, 2);
  EXPECT_NEAR(SymmetricSystem<double>::betweenInverses(solver, other, 0.9).condition(Parity::Even),
              10.0, 1e-4);
}

// A hull solved whole has one system; the second of the array is ignored.
TEST(SymmetricSystem, WholeHullHasOneSystem) {
  ComplexSystem::Systems systems{anySystem(Formulation::Potential, false), {}};
  const ComplexSystem solver(systems, 1);
  EXPECT_EQ(solver.parities(), 1);
  EXPECT_FALSE(solver.hasXDerivative());
  EXPECT_EQ(solver.potentials(Parity::Even, randomMatrix(kHullRows, 2)).rows(), kHullRows);
}

TEST(SymmetricSystem, RefusesASystemWithoutASolution) {
  ComplexSystem::Systems systems = twoSystems(Formulation::Potential, false);
  systems[1].L.row(4).setZero();
  try {
    const ComplexSystem solver(systems, 2);
    FAIL() << "a singular system was factored";
  } catch (const HydroError& error) {
    EXPECT_EQ(error.fault(), Fault::MatrixSingular);
  }
}

}  // namespace
}  // namespace cutwater::test
