#include "hydro/bem/linear/Factorization.h"

#include <gtest/gtest.h>

#include "hydro/Conventions.h"
#include "hydro/bem/linear/LuByHalves.h"
#include "hydro/bem/linear/TransposedProduct.h"
#include "tests/support/Matrices.h"

namespace cutwater::test {
namespace {

/// Hilbert's matrix: 1/(i + j + 1), condition number 1e3 at n = 3, 1e13 at n = 10.
Eigen::MatrixXcd hilbert(Eigen::Index n) {
  Eigen::MatrixXcd m(n, n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j)
      m(i, j) = Complex(1.0, 0.2) / static_cast<double>(i + j + 1);
  return m;
}

double backwardError(const Eigen::MatrixXcd& m, const Eigen::MatrixXcd& x,
                     const Eigen::MatrixXcd& b) {
  const double norm = m.cwiseAbs().rowwise().sum().maxCoeff();
  return (b - m * x).cwiseAbs().maxCoeff() /
         (norm * x.cwiseAbs().maxCoeff() + b.cwiseAbs().maxCoeff());
}

// Single precision alone would leave 1e-7, 1e-10 are promised; beyond condition numbers of 1e7 it
// has no digit to refine and double precision takes over.
TEST(FactorizationIdentity, SolutionsAreThoseOfANearbyMatrix) {
  for (const Eigen::Index n : {3, 6, 10}) {
    const Eigen::MatrixXcd m = hilbert(n);
    Eigen::MatrixXcd b = Eigen::MatrixXcd::Ones(n, 2);
    b.col(1) *= 1e-45;  // below what single precision can hold
    b(0, 1) *= Complex(0.0, 3.0);
    const Factorization<Complex> factors(m);
    EXPECT_LT(backwardError(m, factors.solve(b).col(0), b.col(0)),
              Factorization<Complex>::kBackwardError)
        << n;
    EXPECT_LT(backwardError(m, 1e45 * factors.solve(b).col(1), 1e45 * b.col(1)),
              Factorization<Complex>::kBackwardError)
        << n;
    EXPECT_LT(backwardError(m.transpose(), factors.solveTransposed(b).col(0), b.col(0)),
              Factorization<Complex>::kBackwardError);
  }
}

// An estimate from below, rarely by more than a third [Higham88]; here of matrices whose inverse
// has one great column, many alike, and random ones. 2e-3: factors in single precision, condition
// 3e4 at most.
TEST(FactorizationIdentity, ConditionNumbersAreThoseOfTheInverse) {
  std::vector<Eigen::MatrixXcd> matrices{hilbert(3), hilbert(4), Eigen::MatrixXcd::Identity(1, 1)};
  for (const Eigen::Index n : {7, 40, 130})
    matrices.push_back(Eigen::MatrixXcd::Random(n, n) + 3.0 * Eigen::MatrixXcd::Identity(n, n));
  for (const Eigen::MatrixXcd& m : matrices) {
    const auto norm = [](const Eigen::MatrixXcd& a) {
      return a.cwiseAbs().rowwise().sum().maxCoeff();
    };
    const double exact = norm(m) * norm(solved(m, Eigen::MatrixXcd::Identity(m.rows(), m.rows())));
    const double estimate = Factorization<Complex>(m).condition();
    EXPECT_LE(estimate, exact * (1.0 + 2e-3)) << m.rows();
    EXPECT_GE(estimate, exact / 1.5) << m.rows();
  }
}

/// U diag(1 … 1/condition) V of random orthogonal U, V.
template <typename Scalar>
Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic> conditioned(Eigen::Index n,
                                                                  double condition) {
  using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
  Eigen::VectorXd values(n);
  for (Eigen::Index i = 0; i < n; ++i)
    values[i] = std::pow(condition, -static_cast<double>(i) / static_cast<double>(n - 1));
  const Matrix left = orthogonal(Matrix(Matrix::Random(n, n)));
  return left * values.asDiagonal() * orthogonal(Matrix(Matrix::Random(n, n)));
}

template <typename Scalar>
void expectSmallBackwardErrors() {
  using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
  for (const double condition : {1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7}) {
    const Matrix m = conditioned<Scalar>(90, condition), b = Matrix::Random(90, 3);
    const Factorization<Scalar> factors(m);
    const Matrix x = factors.solve(b), y = factors.solveTransposed(b);
    for (Eigen::Index c = 0; c < 3; ++c) {
      EXPECT_LT(backwardError(m.template cast<Complex>(), x.col(c).template cast<Complex>(),
                              b.col(c).template cast<Complex>()),
                Factorization<Scalar>::kBackwardError)
          << condition;
      EXPECT_LT(backwardError(m.transpose().template cast<Complex>(),
                              y.col(c).template cast<Complex>(), b.col(c).template cast<Complex>()),
                Factorization<Scalar>::kBackwardError)
          << condition;
    }
  }
}

// From condition numbers where two solves and one residual do, through more of both, to those where
// single precision does not: what is promised, real and complex.
TEST(FactorizationIdentity, BackwardErrorsAtEveryConditionNumber) {
  expectSmallBackwardErrors<double>();
  expectSmallBackwardErrors<Complex>();
}

// 1e-39 is no normal number of single precision, 1e39 none at all.
TEST(FactorizationClosedForm, WhatSinglePrecisionCannotHoldDoublePrecisionSolves) {
  const Eigen::MatrixXd tiny = Eigen::MatrixXd::Constant(1, 1, 1e-39);
  const Factorization<double> factors(tiny);
  EXPECT_NEAR(factors.solve(Eigen::MatrixXd::Ones(1, 1))(0, 0) * 1e-39, 1.0, 1e-10);
}

TEST(Factorization, ColumnsOfZerosStayZero) {
  Eigen::MatrixXcd b = Eigen::MatrixXcd::Zero(6, 2);
  b(2, 1) = 1.0;
  const Eigen::MatrixXcd x = Factorization<Complex>(hilbert(6)).solve(b);
  EXPECT_EQ(x.col(0).cwiseAbs().maxCoeff(), 0.0);
  EXPECT_LT(backwardError(hilbert(6), x.col(1), b.col(1)), 1e-10);
}

TEST(Factorization, RefusesAMatrixThatIsNotFinite) {
  Eigen::MatrixXcd m = hilbert(3);
  m(1, 2) = std::nan("");
  EXPECT_ANY_THROW(Factorization<Complex>{m});
}

// P M = L U to round-off of single precision, 6e-8, with sizes that are and are not halved.
TEST(LuByHalvesIdentity, FactorsMultiplyToTheMatrixWithItsRowsExchanged) {
  for (const int n : {1, 63, 65, 300}) {
    const Eigen::MatrixXcf m = Eigen::MatrixXcf::Random(n, n);
    Eigen::MatrixXcf lu = m, exchanged = m;
    std::vector<int> pivots(static_cast<std::size_t>(n));
    ASSERT_EQ(luByHalves(n, lu.data(), pivots.data()), 0);
    for (int i = 0; i < n; ++i)
      exchanged.row(i).swap(exchanged.row(pivots[static_cast<std::size_t>(i)] - 1));
    const Eigen::MatrixXcf upper = lu.triangularView<Eigen::Upper>();
    const Eigen::MatrixXcf product = lu.triangularView<Eigen::UnitLower>() * upper;
    EXPECT_LT((product - exchanged).norm(), 1e-6F * m.norm() * std::sqrt(static_cast<float>(n)));
    EXPECT_LE(lu.triangularView<Eigen::StrictlyLower>().toDenseMatrix().cwiseAbs().maxCoeff(),
              1.5F);  // |re| and |im| choose the pivot
  }
}

TEST(LuByHalves, NamesTheFirstZeroPivot) {
  for (const int zero : {10, 150}) {
    Eigen::MatrixXcf m = Eigen::MatrixXcf::Identity(200, 200);
    m(zero, zero) = 0.0F;
    std::vector<int> pivots(200);
    EXPECT_EQ(luByHalves(200, m.data(), pivots.data()), zero + 1);
  }
}

TEST(TransposedProductIdentity, OfEveryNumberOfColumnsAsEigens) {
  for (const Eigen::Index n : {1, 7, 301})
    for (const Eigen::Index columns : {0, 1, 3, 6, 11}) {
      const Eigen::MatrixXcd A = Eigen::MatrixXcd::Random(n, n / 2 + 1);
      const Eigen::MatrixXcd B = Eigen::MatrixXcd::Random(n, columns);
      const Eigen::MatrixXcd C = transposedProduct(A, B);
      ASSERT_EQ(C.cols(), columns);
      EXPECT_LE((C - A.transpose() * B).norm(), 1e-14 * A.norm() * B.norm());
    }
}

}  // namespace
}  // namespace cutwater::test
