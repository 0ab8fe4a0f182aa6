#pragma once
#include <Eigen/Core>
#include <complex>
#include <vector>

namespace cutwater {

/// LU factors of a square matrix, real or complex: factored in single precision (LuByHalves.h; real
/// ones by LAPACK), which takes half the time, the solutions refined in double precision until they
/// are those of a matrix changed by less than kBackwardError of its norm: by their residual, or by
/// what the first residual says of a second solve. Where refinement does not get there (condition
/// numbers above some 1e6) the factors are taken again in double precision. Immutable; any thread
/// may call.
template <typename Scalar>
class Factorization {
 public:
  using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
  /// ‖b − Mx‖ / (‖M‖·‖x‖ + ‖b‖), max norms, of every column.
  static constexpr double kBackwardError = 1e-10;

  using Low = std::conditional_t<std::is_same_v<Scalar, double>, float, std::complex<float>>;
  using LowMatrix = Eigen::Matrix<Low, Eigen::Dynamic, Eigen::Dynamic>;
  /// A matrix and its factors, to be written over by the next: saves the time in which the system
  /// finds memory.
  struct Workspace {
    Matrix matrix;
    LowMatrix factors;
  };

  /// @throws HydroError MatrixSingular naming the pivot.
  explicit Factorization(Matrix matrix, LowMatrix workspace = {});
  /// M⁻¹ b.
  Matrix solve(const Matrix& b) const { return refined('N', b); }
  /// M⁻ᵀ b, plain transpose.
  Matrix solveTransposed(const Matrix& b) const { return refined('T', b); }
  /// Estimate of ‖M‖·‖M⁻¹‖ in the max-row-sum norm, from below, by three solves   [M03] (61), (62).
  double condition() const;
  const Matrix& matrix() const noexcept { return matrix_; }
  /// Takes them back. Nothing else may be called afterwards.
  Workspace release() && { return {std::move(matrix_), std::move(lu_)}; }

 private:
  Matrix refined(char form, const Matrix& b) const;
  Matrix solvedInDouble(char form, Matrix b) const;

  Matrix matrix_;
  LowMatrix lu_;
  std::vector<int> pivots_;
  double norm_ = 0.0;  // greatest row sum
};

/// op(A)·B, op the plain transpose if `transposed`: by BLAS, or TransposedProduct.h if complex.
template <typename Scalar>
Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic> product(
    const Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>& A, bool transposed,
    const Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>& B);

/// Holds OpenBLAS to one thread while it lives: our own threads each solve a frequency, and results
/// do not depend on how many there are. Not for use from several threads at once.
/// THEORY.md, chapter 5.
class OneBlasThread {
 public:
  OneBlasThread();
  ~OneBlasThread();
  OneBlasThread(const OneBlasThread&) = delete;
  OneBlasThread& operator=(const OneBlasThread&) = delete;

 private:
  int before_;
};

}  // namespace cutwater
