#pragma once
#include <array>
#include <memory>
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
/// a hull solved whole, whichever the formulation. Vectors have one row per hull panel (port panels
/// if symmetric). Immutable; any thread may call. Cost: (8/3)(n + m)³ flops a parity to build if
/// complex.
template <typename Scalar>
class SymmetricSystem {
 public:
  using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;

  /// @param systems indexed by Parity.  @param parities 1 or 2.
  SymmetricSystem(std::array<InfluenceSystem<Scalar>, 2> systems, int parities);

  /// What lies between two systems of the same hull if R, H and the inverse of L are linear there:
  /// (1 − t)a + tb.                                                         [M03] (84)-(87)
  static SymmetricSystem betweenInverses(const SymmetricSystem& a, const SymmetricSystem& b,
                                         double t);

  int parities() const noexcept { return parities_; }
  /// φ on the hull, column by column: L⁻¹ R v or, from sources, R L⁻¹ v.
  Matrix potentials(Parity parity, const Matrix& v) const;
  /// b with bᵀ v = wᵀ φ for every v: Rᵀ L⁻ᵀ w, w zero on the lid, or L⁻ᵀ Rᵀ w.
  Matrix adjoints(Parity parity, const Matrix& w) const;
  /// The system has H: ∂φ/∂x straight from sources.
  bool hasXDerivative() const noexcept { return derivative_[0].size() > 0; }
  /// ∂φ/∂x = H L⁻¹ v.  @pre hasXDerivative().
  Matrix xDerivatives(Parity parity, const Matrix& v) const;
  /// b with bᵀ v = wᵀ ∂φ/∂x: L⁻ᵀ Hᵀ w.  @pre hasXDerivative().
  Matrix xAdjoints(Parity parity, const Matrix& w) const;
  /// Of L; of a mean of inverses that of its first part.
  double condition(Parity parity) const;

 private:
  /// L⁻¹ as a weighted sum of inverses; nearly always one.
  struct Part {
    double weight;
    std::shared_ptr<const Factorization<Scalar>> factors;
  };

  Matrix extended(Parity parity, const Matrix& onHull) const;
  Matrix solve(Parity parity, const Matrix& b) const;
  Matrix solveTransposed(Parity parity, const Matrix& b) const;

  int parities_;
  bool isSource_;
  std::array<Matrix, 2> right_, derivative_;
  std::array<std::vector<Part>, 2> left_;
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
