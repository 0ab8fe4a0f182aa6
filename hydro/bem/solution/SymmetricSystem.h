#pragma once
#include <array>
#include <memory>
#include <vector>

#include "hydro/bem/linear/Factorization.h"
#include "hydro/bem/matrices/InfluenceMatrices.h"

namespace cutwater {

/// The factored system of one frequency for both parities of a symmetric hull, or the one system of
/// a hull solved whole, whichever the formulation. Vectors have one row per hull panel (port panels
/// if symmetric). Immutable; any thread may call. Cost: (8/3)(n + m)³ flops a parity to build if
/// complex.
template <typename Scalar>
class SymmetricSystem {
 public:
  using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;

  using Systems = std::array<InfluenceSystem<Scalar>, 2>;
  using Factors = std::array<typename Factorization<Scalar>::LowMatrix, 2>;
  /// What an earlier frequency leaves, to be written over.
  struct Workspace {
    Systems systems;
    Factors factors;
  };

  /// @param systems indexed by Parity.  @param parities 1 or 2.
  SymmetricSystem(Systems systems, int parities, Factors workspace = {});

  /// What lies between two systems of the same hull if R, H and the inverse of L are linear there:
  /// (1 − t)a + tb.                                                         [M03] (84)-(87)
  static SymmetricSystem betweenInverses(const SymmetricSystem& a, const SymmetricSystem& b,
                                         double t);

  int parities() const noexcept { return parities_; }
  /// φ on the hull, column by column: L⁻¹ R v or, from sources, R L⁻¹ v.
  Matrix potentials(Parity parity, const Matrix& v) const;
  /// b with bᵀ v = wᵀ φ for every v: Rᵀ L⁻ᵀ w, w zero on the lid, or L⁻ᵀ Rᵀ w.
  Matrix adjoints(Parity parity, const Matrix& w) const;
  /// [adjoints(parity, w), xAdjoints(parity, wX)] for the price of one. Without H: the adjoints of
  /// both.
  Matrix bothAdjoints(Parity parity, const Matrix& w, const Matrix& wX) const;
  /// The system has H: ∂φ/∂x straight from sources.
  bool hasXDerivative() const noexcept { return derivative_[0].size() > 0; }
  /// ∂φ/∂x = H L⁻¹ v.  @pre hasXDerivative().
  Matrix xDerivatives(Parity parity, const Matrix& v) const;
  /// b with bᵀ v = wᵀ ∂φ/∂x: L⁻ᵀ Hᵀ w.  @pre hasXDerivative().
  Matrix xAdjoints(Parity parity, const Matrix& w) const;
  /// Takes the matrices back. Nothing else may be called afterwards.
  Workspace release() &&;
  /// Of L; of a mean of inverses that of its first part.
  double condition(Parity parity) const;

 private:
  /// L⁻¹ as a weighted sum of inverses; nearly always one.
  struct Part {
    double weight;
    std::shared_ptr<Factorization<Scalar>> factors;
  };

  Matrix extended(Parity parity, const Matrix& onHull) const;
  Matrix solve(Parity parity, const Matrix& b) const;
  Matrix solveTransposed(Parity parity, const Matrix& b) const;

  int parities_;
  bool isSource_;
  std::array<Matrix, 2> right_, derivative_;
  std::array<std::vector<Part>, 2> left_;
};

}  // namespace cutwater
