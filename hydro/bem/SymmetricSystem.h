#pragma once
#include <array>
#include <vector>

#include "hydro/bem/InfluenceMatrices.h"

namespace cutwater {

/// LU factors of a square matrix by LAPACK (?getrf), real or complex.
template <typename Scalar>
class Factorization {
 public:
  using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
  Factorization() = default;
  /// @throws HydroError MatrixSingular naming the pivot.
  explicit Factorization(Matrix matrix);
  /// M⁻¹ b.
  Matrix solve(Matrix b) const;
  /// M⁻ᵀ b, plain transpose.
  Matrix solveTransposed(Matrix b) const;
  /// Estimate of ‖M‖·‖M⁻¹‖ in the max-row-sum norm, by ?gecon   [M03] (61), (62).
  double condition() const;

 private:
  Matrix lu_;
  std::vector<int> pivots_;
  double norm_ = 0.0;
};

/// The factored system of one frequency for both parities of a symmetric hull, or the one system of
/// a hull solved whole. Vectors have one row per hull panel (port panels if symmetric). Immutable;
/// any thread may call. Cost: (8/3)(n + m)³ flops a parity to build if complex.
template <typename Scalar>
class SymmetricSystem {
 public:
  using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;

  /// @param systems indexed by Parity.  @param parities 1 or 2.
  SymmetricSystem(std::array<InfluencePair<Scalar>, 2> systems, int parities);

  int parities() const noexcept { return parities_; }
  /// φ = L⁻¹ R v on the hull, column by column.
  Matrix potentials(Parity parity, const Matrix& v) const;
  /// b = Rᵀ L⁻ᵀ w, w zero on the lid: bᵀ v = wᵀ φ for every v.
  Matrix adjoints(Parity parity, const Matrix& w) const;
  double condition(Parity parity) const;

 private:
  int parities_;
  std::array<Matrix, 2> right_;
  std::array<Factorization<Scalar>, 2> left_;
};

/// Holds OpenBLAS to one thread while it lives: our own threads each solve a frequency, and results
/// do not depend on how many there are. Not for use from several threads at once.
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
