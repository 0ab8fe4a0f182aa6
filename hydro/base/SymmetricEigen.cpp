#include "hydro/base/SymmetricEigen.h"

#include <Eigen/Eigenvalues>

namespace cutwater {

SymmetricEigen symmetricEigen(const Mat6& m) noexcept {
  const Eigen::SelfAdjointEigenSolver<Mat6> solver(m);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

Vec6 symmetricEigenvalues(const Mat6& m) noexcept {
  return Eigen::SelfAdjointEigenSolver<Mat6>(m, Eigen::EigenvaluesOnly).eigenvalues();
}

Vec6 symmetricEigenvalues(const Mat6& m, const Mat6& metric) noexcept {
  return Eigen::GeneralizedSelfAdjointEigenSolver<Mat6>(m, metric, Eigen::EigenvaluesOnly)
      .eigenvalues();
}

}  // namespace cutwater
