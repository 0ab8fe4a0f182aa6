#pragma once
#include "hydro/Conventions.h"

/// Eigenvalues of symmetric matrices over the six modes. Eigen's solvers take some seconds to
/// compile wherever they are named; here that is once.
namespace cutwater {

/// Eigenvalues rising, unit eigenvectors as columns.
struct SymmetricEigen {
  Vec6 values = Vec6::Zero();
  Mat6 vectors = Mat6::Identity();
};
/// @param m  symmetric: only its lower triangle is read.
SymmetricEigen symmetricEigen(const Mat6& m) noexcept;

/// The eigenvalues alone, rising.
Vec6 symmetricEigenvalues(const Mat6& m) noexcept;
/// Those of m x = l metric x, rising.
/// @param metric  symmetric and positive.
Vec6 symmetricEigenvalues(const Mat6& m, const Mat6& metric) noexcept;

}  // namespace cutwater
