#include "hydro/bem/linear/LuByHalves.h"

#define lapack_complex_float std::complex<float>
#define lapack_complex_double std::complex<double>
#include <cblas.h>
#include <lapacke.h>

#include <cstddef>

namespace cutwater {
namespace {

using Low = std::complex<float>;

constexpr int kLeast = 64;  // no halves of so few columns or rows
constexpr Low kOne = 1.0F, kMinusOne = -1.0F;

/// About half of n, and columns that begin where the first one does in a cache line.
int half(int n) { return (n / 2 + 31) / 32 * 32; }

/// A part of a column-major matrix.
struct Part {
  Low* first;
  int step;  // from column to column
  Part at(int row, int column) const {
    return {first + row + static_cast<std::ptrdiff_t>(column) * step, step};
  }
};

/// C −= AB, A m × k, B k × n.
void subtractProduct(int m, int n, int k, Part A, Part B, Part C) {
  cblas_cgemm3m(CblasColMajor, CblasNoTrans, CblasNoTrans, m, n, k, &kMinusOne, A.first, A.step,
                B.first, B.step, &kOne, C.first, C.step);
}

/// B ← L⁻¹B, L n × n lower triangular with 1 on its diagonal.
void solveLower(int n, int columns, Part L, Part B) {
  if (n <= kLeast) {
    cblas_ctrsm(CblasColMajor, CblasLeft, CblasLower, CblasNoTrans, CblasUnit, n, columns, &kOne,
                L.first, L.step, B.first, B.step);
    return;
  }
  const int upper = half(n);
  solveLower(upper, columns, L, B);
  subtractProduct(n - upper, columns, upper, L.at(upper, 0), B, B.at(upper, 0));
  solveLower(n - upper, columns, L.at(upper, upper), B.at(upper, 0));
}

/// @param pivots  of the n columns, rows counted from 1 in this part.  @returns as luByHalves.
int factor(int m, int n, Part a, int* pivots) {
  if (n <= kLeast) return LAPACKE_cgetrf_work(LAPACK_COL_MAJOR, m, n, a.first, a.step, pivots);
  const int left = half(n), right = n - left;
  const Part upperRight = a.at(0, left), rest = a.at(left, left);
  const int zeroLeft = factor(m, left, a, pivots);
  LAPACKE_claswp_work(LAPACK_COL_MAJOR, right, upperRight.first, a.step, 1, left, pivots, 1);
  solveLower(left, right, a, upperRight);
  subtractProduct(m - left, right, left, a.at(left, 0), upperRight, rest);
  const int zeroRight = factor(m - left, right, rest, pivots + left);
  for (int i = left; i < n; ++i) pivots[i] += left;
  LAPACKE_claswp_work(LAPACK_COL_MAJOR, left, a.first, a.step, left + 1, n, pivots, 1);
  return zeroLeft != 0 ? zeroLeft : zeroRight != 0 ? zeroRight + left : 0;
}

}  // namespace

int luByHalves(int n, std::complex<float>* a, int* pivots) { return factor(n, n, {a, n}, pivots); }

}  // namespace cutwater
