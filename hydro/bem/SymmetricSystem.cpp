#include "hydro/bem/SymmetricSystem.h"

// LAPACKE's complex numbers are ours; it must be told before it is read.
#include <complex>
#define lapack_complex_float std::complex<float>
#define lapack_complex_double std::complex<double>
#include <cblas.h>
#include <lapacke.h>

#include <algorithm>
#include <string>

#include "hydro/Errors.h"

namespace cutwater {
namespace {

// The LAPACK routines by scalar type, column-major.
int getrf(int n, double* a, int* pivots) {
  return LAPACKE_dgetrf(LAPACK_COL_MAJOR, n, n, a, n, pivots);
}
int getrf(int n, Complex* a, int* pivots) {
  return LAPACKE_zgetrf(LAPACK_COL_MAJOR, n, n, a, n, pivots);
}
int getrs(char trans, int n, int columns, const double* a, const int* pivots, double* b) {
  return LAPACKE_dgetrs(LAPACK_COL_MAJOR, trans, n, columns, a, n, pivots, b, n);
}
int getrs(char trans, int n, int columns, const Complex* a, const int* pivots, Complex* b) {
  return LAPACKE_zgetrs(LAPACK_COL_MAJOR, trans, n, columns, a, n, pivots, b, n);
}
int gecon(int n, const double* a, double norm, double* reciprocal) {
  return LAPACKE_dgecon(LAPACK_COL_MAJOR, 'I', n, a, n, norm, reciprocal);
}
int gecon(int n, const Complex* a, double norm, double* reciprocal) {
  return LAPACKE_zgecon(LAPACK_COL_MAJOR, 'I', n, a, n, norm, reciprocal);
}

void check(int info, const char* routine) {
  if (info == 0) return;
  throw HydroError(Fault::MatrixSingular, std::string("SymmetricSystem: LAPACK's ") + routine +
                                              " returned " + std::to_string(info) +
                                              (info > 0 ? " (a zero pivot there)" : ""));
}

}  // namespace

template <typename Scalar>
Factorization<Scalar>::Factorization(Matrix matrix)
    : lu_(std::move(matrix)),
      pivots_(static_cast<std::size_t>(lu_.rows())),
      norm_(lu_.cwiseAbs().rowwise().sum().maxCoeff()) {
  check(getrf(static_cast<int>(lu_.rows()), lu_.data(), pivots_.data()), "getrf");
}

template <typename Scalar>
typename Factorization<Scalar>::Matrix Factorization<Scalar>::solve(Matrix b) const {
  check(getrs('N', static_cast<int>(lu_.rows()), static_cast<int>(b.cols()), lu_.data(),
              pivots_.data(), b.data()),
        "getrs");
  return b;
}

template <typename Scalar>
typename Factorization<Scalar>::Matrix Factorization<Scalar>::solveTransposed(Matrix b) const {
  check(getrs('T', static_cast<int>(lu_.rows()), static_cast<int>(b.cols()), lu_.data(),
              pivots_.data(), b.data()),
        "getrs");
  return b;
}

template <typename Scalar>
double Factorization<Scalar>::condition() const {
  double reciprocal = 0.0;
  check(gecon(static_cast<int>(lu_.rows()), lu_.data(), norm_, &reciprocal), "gecon");
  return 1.0 / std::max(reciprocal, 1e-300);  // a finite number goes into the file
}

template <typename Scalar>
SymmetricSystem<Scalar>::SymmetricSystem(std::array<InfluenceSystem<Scalar>, 2> systems,
                                         int parities)
    : parities_(parities), isSource_(systems[0].formulation == Formulation::Source) {
  for (std::size_t p = 0; p < static_cast<std::size_t>(parities); ++p) {
    right_[p] = std::move(systems[p].R);
    derivative_[p] = std::move(systems[p].H);
    left_[p] = {{1.0, std::make_shared<const Factorization<Scalar>>(std::move(systems[p].L))}};
  }
}

template <typename Scalar>
SymmetricSystem<Scalar> SymmetricSystem<Scalar>::betweenInverses(const SymmetricSystem& a,
                                                                 const SymmetricSystem& b,
                                                                 double t) {
  SymmetricSystem between = a;
  for (std::size_t p = 0; p < static_cast<std::size_t>(a.parities_); ++p) {
    between.right_[p] += t * (b.right_[p] - a.right_[p]);
    if (a.derivative_[p].size() > 0)
      between.derivative_[p] += t * (b.derivative_[p] - a.derivative_[p]);
    between.left_[p] = {{1.0 - t, a.left_[p].front().factors}, {t, b.left_[p].front().factors}};
  }
  return between;
}

template <typename Scalar>
typename SymmetricSystem<Scalar>::Matrix SymmetricSystem<Scalar>::solve(Parity parity,
                                                                        const Matrix& b) const {
  const std::vector<Part>& parts = left_[static_cast<std::size_t>(parity)];
  Matrix x = parts.front().weight * parts.front().factors->solve(b);
  for (std::size_t i = 1; i < parts.size(); ++i) x += parts[i].weight * parts[i].factors->solve(b);
  return x;
}

template <typename Scalar>
typename SymmetricSystem<Scalar>::Matrix SymmetricSystem<Scalar>::solveTransposed(
    Parity parity, const Matrix& b) const {
  const std::vector<Part>& parts = left_[static_cast<std::size_t>(parity)];
  Matrix x = parts.front().weight * parts.front().factors->solveTransposed(b);
  for (std::size_t i = 1; i < parts.size(); ++i)
    x += parts[i].weight * parts[i].factors->solveTransposed(b);
  return x;
}

/// Zeros on the lid below what is given on the hull.
template <typename Scalar>
typename SymmetricSystem<Scalar>::Matrix SymmetricSystem<Scalar>::extended(
    Parity parity, const Matrix& onHull) const {
  const Matrix& right = right_[static_cast<std::size_t>(parity)];
  Matrix all = Matrix::Zero(isSource_ ? right.cols() : right.rows(), onHull.cols());
  all.topRows(onHull.rows()) = onHull;
  return all;
}

template <typename Scalar>
typename SymmetricSystem<Scalar>::Matrix SymmetricSystem<Scalar>::potentials(
    Parity parity, const Matrix& v) const {
  const auto p = static_cast<std::size_t>(parity);
  if (isSource_) return right_[p] * solve(parity, extended(parity, v));
  return solve(parity, right_[p] * v).topRows(v.rows());
}

template <typename Scalar>
typename SymmetricSystem<Scalar>::Matrix SymmetricSystem<Scalar>::adjoints(Parity parity,
                                                                           const Matrix& w) const {
  const auto p = static_cast<std::size_t>(parity);
  if (isSource_) return solveTransposed(parity, right_[p].transpose() * w).topRows(w.rows());
  return right_[p].transpose() * solveTransposed(parity, extended(parity, w));
}

template <typename Scalar>
typename SymmetricSystem<Scalar>::Matrix SymmetricSystem<Scalar>::xDerivatives(
    Parity parity, const Matrix& v) const {
  const auto p = static_cast<std::size_t>(parity);
  return derivative_[p] * solve(parity, extended(parity, v));
}

template <typename Scalar>
typename SymmetricSystem<Scalar>::Matrix SymmetricSystem<Scalar>::xAdjoints(Parity parity,
                                                                            const Matrix& w) const {
  const auto p = static_cast<std::size_t>(parity);
  return solveTransposed(parity, derivative_[p].transpose() * w).topRows(w.rows());
}

template <typename Scalar>
double SymmetricSystem<Scalar>::condition(Parity parity) const {
  return left_[static_cast<std::size_t>(parity)].front().factors->condition();
}

OneBlasThread::OneBlasThread() : before_(openblas_get_num_threads()) {
  openblas_set_num_threads(1);
}
OneBlasThread::~OneBlasThread() { openblas_set_num_threads(before_); }

template class Factorization<double>;
template class Factorization<Complex>;
template class SymmetricSystem<double>;
template class SymmetricSystem<Complex>;

}  // namespace cutwater
