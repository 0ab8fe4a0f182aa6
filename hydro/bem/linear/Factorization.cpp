#include "hydro/bem/linear/Factorization.h"

// LAPACKE's complex numbers are ours; it must be told before it is read.
#define lapack_complex_float std::complex<float>
#define lapack_complex_double std::complex<double>
#include <cblas.h>
#include <lapacke.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "hydro/Conventions.h"
#include "hydro/Errors.h"
#include "hydro/base/Simd.h"
#include "hydro/bem/linear/LuByHalves.h"
#include "hydro/bem/linear/TransposedProduct.h"

namespace cutwater {
namespace {

using LowComplex = std::complex<float>;

// The LAPACK and BLAS routines by scalar type, column-major; _work: without a look for NaN each
// time.
int getrf(int n, float* a, int* p) { return LAPACKE_sgetrf_work(LAPACK_COL_MAJOR, n, n, a, n, p); }
int getrf(int n, LowComplex* a, int* p) { return luByHalves(n, a, p); }
int getrf(int n, double* a, int* p) { return LAPACKE_dgetrf_work(LAPACK_COL_MAJOR, n, n, a, n, p); }
int getrf(int n, Complex* a, int* p) {
  return LAPACKE_zgetrf_work(LAPACK_COL_MAJOR, n, n, a, n, p);
}

int getrs(char form, int n, int columns, const float* a, const int* p, float* b) {
  return LAPACKE_sgetrs_work(LAPACK_COL_MAJOR, form, n, columns, a, n, p, b, n);
}
int getrs(char form, int n, int columns, const LowComplex* a, const int* p, LowComplex* b) {
  return LAPACKE_cgetrs_work(LAPACK_COL_MAJOR, form, n, columns, a, n, p, b, n);
}
int getrs(char form, int n, int columns, const double* a, const int* p, double* b) {
  return LAPACKE_dgetrs_work(LAPACK_COL_MAJOR, form, n, columns, a, n, p, b, n);
}
int getrs(char form, int n, int columns, const Complex* a, const int* p, Complex* b) {
  return LAPACKE_zgetrs_work(LAPACK_COL_MAJOR, form, n, columns, a, n, p, b, n);
}

void gemm(CBLAS_TRANSPOSE form, int m, int n, int k, const double* a, int lda, const double* b,
          double* c) {
  cblas_dgemm(CblasColMajor, form, CblasNoTrans, m, n, k, 1.0, a, lda, b, k, 0.0, c, m);
}
void gemm(CBLAS_TRANSPOSE form, int m, int n, int k, const Complex* a, int lda, const Complex* b,
          Complex* c) {
  constexpr Complex one = 1.0, zero = 0.0;
  cblas_zgemm(CblasColMajor, form, CblasNoTrans, m, n, k, &one, a, lda, b, k, &zero, c, m);
}

void check(int info, const char* routine) {
  if (info == 0) return;
  throw HydroError(Fault::MatrixSingular, std::string("Factorization: LAPACK's ") + routine +
                                              " returned " + std::to_string(info) +
                                              (info > 0 ? " (a zero pivot there)" : ""));
}

/// One column in single precision; |entries| added to the row sums.
template <typename Scalar, typename Low>
CUTWATER_INLINE void lowerColumn(const Scalar* from, Eigen::Index n, Low* to, double* sums) {
  for (Eigen::Index i = 0; i < n; ++i) {
    to[i] = static_cast<Low>(from[i]);
    sums[i] += std::sqrt(std::norm(from[i]));
  }
}
void lower(const double* from, Eigen::Index n, float* to, double* sums) {
  lowerColumn(from, n, to, sums);
}
CUTWATER_VECTOR void lower(const Complex* from, Eigen::Index n, LowComplex* to, double* sums) {
  lowerColumn(from, n, to, sums);
}

}  // namespace

template <typename Scalar>
Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic> product(
    const Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>& A, bool transposed,
    const Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>& B) {
  if constexpr (std::is_same_v<Scalar, Complex>)
    if (transposed) return transposedProduct(A, B);
  Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic> C(transposed ? A.cols() : A.rows(),
                                                          B.cols());
  if (C.size() > 0 && B.rows() > 0)
    gemm(transposed ? CblasTrans : CblasNoTrans, static_cast<int>(C.rows()),
         static_cast<int>(C.cols()), static_cast<int>(B.rows()), A.data(),
         static_cast<int>(A.rows()), B.data(), C.data());
  return C;
}

template <typename Scalar>
Factorization<Scalar>::Factorization(Matrix matrix, LowMatrix workspace)
    : matrix_(std::move(matrix)),
      lu_(std::move(workspace)),
      pivots_(static_cast<std::size_t>(matrix_.rows())) {
  const Eigen::Index n = matrix_.rows();
  lu_.resize(n, n);
  Eigen::VectorXd sums = Eigen::VectorXd::Zero(n);
  for (Eigen::Index j = 0; j < n; ++j) lower(&matrix_(0, j), n, &lu_(0, j), sums.data());
  norm_ = sums.maxCoeff();
  if (!sums.allFinite())
    throw HydroError(Fault::MatrixSingular, "Factorization: an entry of the matrix is not finite");
  check(getrf(static_cast<int>(n), lu_.data(), pivots_.data()), "getrf");
}

// Columns are scaled to 1 for single precision, which has no numbers below 1e-38. A product with
// the matrix costs as much as a solve: the first residual tells how good one solve is, the second
// solve is taken to be four times worse. Measured on frigates with lid: 0.2 to 2 times what is
// expected here. The norm is that of M for its transpose too, whose own is as large.
template <typename Scalar>
typename Factorization<Scalar>::Matrix Factorization<Scalar>::refined(char form,
                                                                      const Matrix& b) const {
  constexpr int kMostSteps = 10;
  constexpr double kWorse = 4.0;
  const auto n = static_cast<int>(lu_.rows()), columns = static_cast<int>(b.cols());
  if (columns == 0) return b;
  const auto greatest = [](const Matrix& m) -> Eigen::ArrayXd {
    return m.cwiseAbs2().colwise().maxCoeff().transpose().array().sqrt();
  };
  const Eigen::ArrayXd size = greatest(b);
  Matrix x = Matrix::Zero(b.rows(), b.cols()), rest = b;
  double ofOneSolve = HUGE_VAL;  // backward error
  for (int step = 0; step < kMostSteps; ++step) {
    const Eigen::VectorXd scale = greatest(rest).max(1e-300).matrix();
    LowMatrix low = (rest * scale.cwiseInverse().asDiagonal()).template cast<Low>();
    check(getrs(form, n, columns, lu_.data(), pivots_.data(), low.data()), "getrs");
    const Matrix change = low.template cast<Scalar>() * scale.asDiagonal();
    x += change;
    const Eigen::ArrayXd reached = greatest(x);
    if (step > 0 && (kWorse * ofOneSolve * greatest(change) <= kBackwardError * reached).all())
      return x;
    rest = b - product<Scalar>(matrix_, form == 'T', x);
    const Eigen::ArrayXd error = greatest(rest) / (norm_ * reached + size).max(1e-300);
    if (!error.allFinite()) break;
    if ((error <= kBackwardError).all()) return x;
    if (step == 0) ofOneSolve = error.maxCoeff();
  }
  return solvedInDouble(form, b);
}

template <typename Scalar>
typename Factorization<Scalar>::Matrix Factorization<Scalar>::solvedInDouble(char form,
                                                                             Matrix b) const {
  const auto n = static_cast<int>(matrix_.rows());
  Matrix lu = matrix_;
  std::vector<int> pivots(pivots_.size());
  check(getrf(n, lu.data(), pivots.data()), "getrf");
  check(getrs(form, n, static_cast<int>(b.cols()), lu.data(), pivots.data(), b.data()), "getrs");
  return b;
}

// ‖M⁻¹‖ in the max-row-sum norm is ‖M⁻ᵀ‖₁, which an estimate from below finds in three solves: of
// the mean of all columns, of the sum of them in which the most is in phase, taken at its greatest
// column; a vector of alternating signs guards against cancellation. ?gecon does the same in five
// or more.
//                                                                    [Hager84] [Higham88]
template <typename Scalar>
double Factorization<Scalar>::condition() const {
  const auto n = static_cast<int>(lu_.rows());
  const auto solve = [&](char form, LowMatrix& b) {
    check(getrs(form, n, static_cast<int>(b.cols()), lu_.data(), pivots_.data(), b.data()),
          "getrs");
  };
  LowMatrix y(n, 2);
  for (int i = 0; i < n; ++i) {
    y(i, 0) = 1.0F / static_cast<float>(n);
    y(i, 1) = (i % 2 == 0 ? 1.0F : -1.0F) * (1.0F + static_cast<float>(i) / static_cast<float>(n));
  }
  const double put = y.col(1).cwiseAbs().sum();
  solve('T', y);
  double norm = std::max<double>(y.col(0).cwiseAbs().sum(), y.col(1).cwiseAbs().sum() / put);
  LowMatrix phases(n, 1);
  for (int i = 0; i < n; ++i) {
    const float size = std::abs(y(i, 0));
    phases(i, 0) = size > 0.0F ? Eigen::numext::conj(y(i, 0)) / size : Low(1.0F);
  }
  solve('N', phases);
  Eigen::Index greatest = 0;
  phases.col(0).cwiseAbs().maxCoeff(&greatest);
  LowMatrix column = LowMatrix::Zero(n, 1);
  column(greatest, 0) = 1.0F;
  solve('T', column);
  norm = norm_ * std::max<double>(norm, column.cwiseAbs().sum());
  return std::isfinite(norm) ? std::max(norm, 1.0) : 1e300;  // finite: it goes into the file
}

OneBlasThread::OneBlasThread() : before_(openblas_get_num_threads()) {
  openblas_set_num_threads(1);
}
OneBlasThread::~OneBlasThread() { openblas_set_num_threads(before_); }

template class Factorization<double>;
template class Factorization<Complex>;
template Eigen::MatrixXd product(const Eigen::MatrixXd&, bool, const Eigen::MatrixXd&);
template Eigen::MatrixXcd product(const Eigen::MatrixXcd&, bool, const Eigen::MatrixXcd&);

}  // namespace cutwater
