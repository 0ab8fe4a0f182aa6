#include "hydro/bem/Factorization.h"

#include <gtest/gtest.h>

#include "hydro/Conventions.h"

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

// Single precision alone would leave 1e-7; beyond condition numbers of 1e7 it has no digit to refine
// and double precision takes over.
TEST(FactorizationIdentity, ResidualsAreThoseOfDoublePrecision) {
  for (const Eigen::Index n : {3, 6, 10}) {
    const Eigen::MatrixXcd m = hilbert(n);
    Eigen::MatrixXcd b = Eigen::MatrixXcd::Ones(n, 2);
    b.col(1) *= 1e-45;  // below what single precision can hold
    b(0, 1) *= Complex(0.0, 3.0);
    const Factorization<Complex> factors(m);
    EXPECT_LT(backwardError(m, factors.solve(b).col(0), b.col(0)), 2e-12) << n;
    EXPECT_LT(backwardError(m, 1e45 * factors.solve(b).col(1), 1e45 * b.col(1)), 2e-12) << n;
    EXPECT_LT(backwardError(m.transpose(), factors.solveTransposed(b).col(0), b.col(0)), 2e-12);
  }
}

TEST(Factorization, RefusesAMatrixThatIsNotFinite) {
  Eigen::MatrixXcd m = hilbert(3);
  m(1, 2) = std::nan("");
  EXPECT_ANY_THROW(Factorization<Complex>{m});
}

}  // namespace
}  // namespace cutwater::test
