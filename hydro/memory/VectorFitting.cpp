#include "hydro/memory/VectorFitting.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace cutwater {

namespace {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

std::size_t columnsOf(const std::vector<Complex>& poles) {
  std::size_t count = 0;
  for (const Complex& s : poles) count += s.imag() > 0.0 ? 2 : 1;
  return count;
}

/// Weighted real and imaginary parts, one below the other.
Matrix stacked(const Eigen::MatrixXcd& m, const Response& r) {
  Matrix rows(2 * m.rows(), m.cols());
  rows.topRows(m.rows()) = r.weightRe.asDiagonal() * m.real();
  rows.bottomRows(m.rows()) = r.weightIm.asDiagonal() * m.imag();
  return rows;
}

std::vector<Complex> startingPoles(double first, double last, std::size_t count) {
  std::vector<Complex> poles;
  const std::size_t pairs = count / 2;
  for (std::size_t i = 0; i < pairs; ++i) {
    const double share = pairs > 1 ? static_cast<double>(i) / static_cast<double>(pairs - 1) : 0.5;
    const double at = first * std::pow(last / first, share);
    poles.emplace_back(-0.1 * at, at);
  }
  return poles;
}

/// Zeros of 1 + Σ c̃ φ: eigenvalues of the poles' matrix less b c̃ᵀ.
std::vector<Complex> zerosOf(const std::vector<Complex>& poles, const Vector& c) {
  Matrix m = Matrix::Zero(c.size(), c.size());
  Vector b = Vector::Zero(c.size());
  Eigen::Index at = 0;
  for (const Complex& s : poles) {
    m(at, at) = s.real();
    b[at] = 1.0;
    if (s.imag() > 0.0) {
      m(at + 1, at + 1) = s.real();
      m(at, at + 1) = s.imag();
      m(at + 1, at) = -s.imag();
      b[at++] = 2.0;
    }
    ++at;
  }
  const Eigen::VectorXcd found =
      Eigen::EigenSolver<Matrix>(m - b * c.transpose(), false).eigenvalues();
  std::vector<Complex> zeros;
  for (const Complex& z : found) {
    if (z.imag() >= 0.0) zeros.emplace_back(-std::max(std::abs(z.real()), 1e-4), z.imag());
  }
  return zeros;
}

/// One step of vector fitting: Σ c φ − H Σ c̃ φ = H in least squares for all responses; each gives
/// what its own c leaves of the equations for the common c̃.
Vector commonFactors(const Eigen::MatrixXcd& basis, const std::vector<Response>& responses) {
  const Eigen::Index n = basis.cols();
  Matrix equations(static_cast<Eigen::Index>(responses.size()) * n, n);
  Vector right(equations.rows());
  Eigen::Index row = 0;
  for (const Response& r : responses) {
    Matrix system(2 * basis.rows(), 2 * n);
    system << stacked(basis, r), stacked(-(r.value.asDiagonal() * basis), r);
    const Vector value = stacked(r.value, r);
    const Eigen::HouseholderQR<Matrix> qr(system);
    const Vector turned = qr.householderQ().adjoint() * value;
    equations.middleRows(row, n) =
        Matrix(qr.matrixQR().topRows(2 * n).triangularView<Eigen::Upper>()).bottomRightCorner(n, n);
    right.segment(row, n) = turned.segment(n, n);
    row += n;
  }
  const Vector norms = equations.colwise().norm().cwiseMax(1e-300);
  const Matrix scaled = equations * norms.cwiseInverse().asDiagonal();
  return scaled.colPivHouseholderQr().solve(right).cwiseQuotient(norms);
}

}  // namespace

Eigen::MatrixXcd rationalBasis(const std::vector<double>& omega,
                               const std::vector<Complex>& poles) {
  Eigen::MatrixXcd basis(static_cast<Eigen::Index>(omega.size()),
                         static_cast<Eigen::Index>(columnsOf(poles)));
  for (Eigen::Index i = 0; i < basis.rows(); ++i) {
    const Complex iw(0.0, omega[static_cast<std::size_t>(i)]);
    Eigen::Index c = 0;
    for (const Complex& s : poles) {
      const Complex one = 1.0 / (iw - s), other = 1.0 / (iw - std::conj(s));
      if (s.imag() > 0.0) {
        basis(i, c++) = one + other;
        basis(i, c++) = Complex(0.0, 1.0) * (one - other);
      } else {
        basis(i, c++) = one;
      }
    }
  }
  return basis;
}

std::vector<Complex> fitPoles(const std::vector<double>& omega,
                              const std::vector<Response>& responses, std::size_t count,
                              int iterations) {
  std::vector<Complex> poles = startingPoles(omega.front(), omega.back(), count);
  for (int i = 0; i < iterations; ++i) {
    poles = zerosOf(poles, commonFactors(rationalBasis(omega, poles), responses));
  }
  std::sort(poles.begin(), poles.end(),
            [](const Complex& a, const Complex& b) { return std::abs(a) < std::abs(b); });
  return poles;
}

namespace {

/// Of each column of the basis at ω = 0: its value and its slope over iω, both real.
Matrix basisAtZero(const std::vector<Complex>& poles) {
  const Matrix value = rationalBasis({0.0}, poles).real();
  Matrix known(value.cols(), 2);
  known.col(0) = value.row(0).transpose();
  Eigen::Index c = 0;
  for (const Complex& s : poles) {
    const Complex slope = -1.0 / (s * s);
    if (s.imag() > 0.0) {
      known(c++, 1) = 2.0 * slope.real();
      known(c++, 1) = -2.0 * slope.imag();
    } else {
      known(c++, 1) = slope.real();
    }
  }
  return known;
}

}  // namespace

std::vector<std::vector<Complex>> fitResidues(const std::vector<double>& omega,
                                              const std::vector<Response>& responses,
                                              const std::vector<Complex>& poles) {
  const Eigen::MatrixXcd basis = rationalBasis(omega, poles);
  const Matrix known = basisAtZero(poles);
  std::vector<std::vector<Complex>> residues;
  for (const Response& r : responses) {
    const Matrix rows = stacked(basis, r);
    const Vector norms = rows.colwise().norm().cwiseMax(1e-300);
    const Eigen::HouseholderQR<Matrix> qr(rows * norms.cwiseInverse().asDiagonal());
    Vector factors = qr.solve(Vector(stacked(r.value, r)));
    if (r.holdsZero) {
      const Matrix goals = norms.cwiseInverse().asDiagonal() * known.leftCols(r.holdsSlope ? 2 : 1);
      const Vector values = Eigen::Vector2d(r.atZero, r.slope).head(goals.cols());
      const auto R = qr.matrixQR().topRows(rows.cols()).triangularView<Eigen::Upper>();
      const Matrix half = R.transpose().solve(goals);
      const Matrix directions = R.solve(half);  // (XᵀX)⁻¹ G
      const Matrix among = goals.transpose() * directions;
      factors += directions * among.partialPivLu().solve(values - goals.transpose() * factors);
    }
    factors = factors.cwiseQuotient(norms);
    std::vector<Complex> found;
    Eigen::Index c = 0;
    for (const Complex& s : poles) {
      const bool pair = s.imag() > 0.0;
      found.push_back(pair ? 2.0 * Complex(factors[c], factors[c + 1]) : Complex(factors[c]));
      c += pair ? 2 : 1;
    }
    residues.push_back(std::move(found));
  }
  return residues;
}

}  // namespace cutwater
