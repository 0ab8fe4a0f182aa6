#include "hydro/bem/linear/TransposedProduct.h"

#include <algorithm>

#include "hydro/Conventions.h"
#include "hydro/base/SimdMath.h"

namespace cutwater {
namespace {

CUTWATER_INLINE Double4 twoOf(const Complex* from) {
  return load4(reinterpret_cast<const double*>(from));
}

/// Adds aᵀb_j over `rows` rows to c_j, j < width. `step` from column to column of B and of c.
/// Meanwhile memory is asked for `next`, as many rows of the next column of A.
template <int width>
CUTWATER_INLINE void addDots(const Complex* a, const Complex* next, const Complex* B,
                             Eigen::Index step, Eigen::Index rows, Complex* c,
                             Eigen::Index stepOfC) {
  Double4 straight[width] = {}, crossed[width] = {};
  for (Eigen::Index row = 0; row + 1 < rows; row += 2) {
    if (row % 4 == 0) __builtin_prefetch(next + row);
    const Double4 two = twoOf(a + row), swapped = __builtin_shufflevector(two, two, 1, 0, 3, 2);
    for (int j = 0; j < width; ++j) {
      const Double4 b = twoOf(B + j * step + row);
      straight[j] += two * b;
      crossed[j] += swapped * b;
    }
  }
  for (int j = 0; j < width; ++j) {
    const Double4 s = straight[j], x = crossed[j];
    c[j * stepOfC] += Complex((s[0] - s[1]) + (s[2] - s[3]), (x[0] + x[1]) + (x[2] + x[3]));
    if (rows % 2 == 1) c[j * stepOfC] += a[rows - 1] * B[j * step + rows - 1];
  }
}

// Rows in pieces, so that those of B stay in the nearest cache.
CUTWATER_VECTOR void addProduct(const Eigen::MatrixXcd& A, const Eigen::MatrixXcd& B,
                                Eigen::MatrixXcd& C) {
  constexpr Eigen::Index kPiece = 256;
  for (Eigen::Index row = 0; row < A.rows(); row += kPiece) {
    const Eigen::Index rows = std::min(kPiece, A.rows() - row);
    for (Eigen::Index i = 0; i < A.cols(); ++i) {
      const Complex* a = &A(row, i);
      const Complex* next = i + 1 < A.cols() ? a + A.rows() : a;
      Eigen::Index j = 0;
      for (; j + 6 <= B.cols(); j += 6)
        addDots<6>(a, next, &B(row, j), B.rows(), rows, &C(i, j), C.rows());
      for (; j + 3 <= B.cols(); j += 3)
        addDots<3>(a, next, &B(row, j), B.rows(), rows, &C(i, j), C.rows());
      for (; j < B.cols(); ++j) addDots<1>(a, next, &B(row, j), B.rows(), rows, &C(i, j), C.rows());
    }
  }
}

}  // namespace

Eigen::MatrixXcd transposedProduct(const Eigen::MatrixXcd& A, const Eigen::MatrixXcd& B) {
  Eigen::MatrixXcd C = Eigen::MatrixXcd::Zero(A.cols(), B.cols());
  if (C.size() > 0 && B.rows() > 0) addProduct(A, B, C);
  return C;
}

}  // namespace cutwater
