#include "tests/support/Matrices.h"

#include <utility>

namespace cutwater::test {
namespace {

template <class Matrix>
Matrix eliminated(Matrix m, Matrix right) {
  const Eigen::Index n = m.rows();
  for (Eigen::Index k = 0; k < n; ++k) {
    Eigen::Index largest = 0;
    m.col(k).tail(n - k).cwiseAbs().maxCoeff(&largest);
    m.row(k).swap(m.row(k + largest));
    right.row(k).swap(right.row(k + largest));
    for (Eigen::Index i = k + 1; i < n; ++i) {
      const auto factor = m(i, k) / m(k, k);
      m.row(i) -= factor * m.row(k);
      right.row(i) -= factor * right.row(k);
    }
  }
  for (Eigen::Index k = n - 1; k >= 0; --k) {
    for (Eigen::Index i = k + 1; i < n; ++i) right.row(k) -= m(k, i) * right.row(i);
    right.row(k) /= m(k, k);
  }
  return right;
}

template <class Matrix>
Matrix withoutOverlap(Matrix q) {
  for (Eigen::Index k = 0; k < q.cols(); ++k) {
    for (int time = 0; time < 2; ++time)  // the second time for the first one's round-off
      for (Eigen::Index i = 0; i < k; ++i) q.col(k) -= q.col(i).dot(q.col(k)) * q.col(i);
    q.col(k).normalize();
  }
  return q;
}

}  // namespace

Eigen::MatrixXd solved(const Eigen::MatrixXd& m, const Eigen::MatrixXd& right) {
  return eliminated(m, right);
}

Eigen::MatrixXcd solved(const Eigen::MatrixXcd& m, const Eigen::MatrixXcd& right) {
  return eliminated(m, right);
}

Mat6 inverse(const Mat6& m) { return eliminated<Eigen::MatrixXd>(m, Mat6::Identity()); }

Eigen::MatrixXd orthogonal(Eigen::MatrixXd any) { return withoutOverlap(std::move(any)); }

Eigen::MatrixXcd orthogonal(Eigen::MatrixXcd any) { return withoutOverlap(std::move(any)); }

}  // namespace cutwater::test
