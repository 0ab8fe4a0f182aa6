#include "hydro/bem/solution/SymmetricSystem.h"

namespace cutwater {

template <typename Scalar>
SymmetricSystem<Scalar>::SymmetricSystem(Systems systems, int parities, Factors workspace)
    : parities_(parities), isSource_(systems[0].formulation == Formulation::Source) {
  for (std::size_t p = 0; p < static_cast<std::size_t>(parities); ++p) {
    right_[p] = std::move(systems[p].R);
    derivative_[p] = std::move(systems[p].H);
    left_[p] = {{1.0, std::make_shared<Factorization<Scalar>>(std::move(systems[p].L),
                                                              std::move(workspace[p]))}};
  }
}

template <typename Scalar>
SymmetricSystem<Scalar> SymmetricSystem<Scalar>::betweenInverses(const SymmetricSystem& a,
                                                                 const SymmetricSystem& b,
                                                                 double t) {
  SymmetricSystem between = a;
  for (std::size_t p = 0; p < static_cast<std::size_t>(a.parities_); ++p) {
    between.right_[p] += t * (b.right_[p] - a.right_[p]);
    if (a.derivative_[p].size() > 0)
      between.derivative_[p] += t * (b.derivative_[p] - a.derivative_[p]);
    between.left_[p] = {{1.0 - t, a.left_[p].front().factors}, {t, b.left_[p].front().factors}};
  }
  return between;
}

template <typename Scalar>
typename SymmetricSystem<Scalar>::Matrix SymmetricSystem<Scalar>::solve(Parity parity,
                                                                        const Matrix& b) const {
  const std::vector<Part>& parts = left_[static_cast<std::size_t>(parity)];
  Matrix x = parts.front().weight * parts.front().factors->solve(b);
  for (std::size_t i = 1; i < parts.size(); ++i) x += parts[i].weight * parts[i].factors->solve(b);
  return x;
}

template <typename Scalar>
typename SymmetricSystem<Scalar>::Matrix SymmetricSystem<Scalar>::solveTransposed(
    Parity parity, const Matrix& b) const {
  const std::vector<Part>& parts = left_[static_cast<std::size_t>(parity)];
  Matrix x = parts.front().weight * parts.front().factors->solveTransposed(b);
  for (std::size_t i = 1; i < parts.size(); ++i)
    x += parts[i].weight * parts[i].factors->solveTransposed(b);
  return x;
}

/// Zeros on the lid below what is given on the hull.
template <typename Scalar>
typename SymmetricSystem<Scalar>::Matrix SymmetricSystem<Scalar>::extended(
    Parity parity, const Matrix& onHull) const {
  const Matrix& right = right_[static_cast<std::size_t>(parity)];
  Matrix all = Matrix::Zero(isSource_ ? right.cols() : right.rows(), onHull.cols());
  all.topRows(onHull.rows()) = onHull;
  return all;
}

template <typename Scalar>
typename SymmetricSystem<Scalar>::Matrix SymmetricSystem<Scalar>::potentials(
    Parity parity, const Matrix& v) const {
  const auto p = static_cast<std::size_t>(parity);
  if (isSource_) return product<Scalar>(right_[p], false, solve(parity, extended(parity, v)));
  return solve(parity, product<Scalar>(right_[p], false, v)).topRows(v.rows());
}

template <typename Scalar>
typename SymmetricSystem<Scalar>::Matrix SymmetricSystem<Scalar>::adjoints(Parity parity,
                                                                           const Matrix& w) const {
  const auto p = static_cast<std::size_t>(parity);
  if (isSource_)
    return solveTransposed(parity, product<Scalar>(right_[p], true, w)).topRows(w.rows());
  return product<Scalar>(right_[p], true, solveTransposed(parity, extended(parity, w)));
}

template <typename Scalar>
typename SymmetricSystem<Scalar>::Matrix SymmetricSystem<Scalar>::xDerivatives(
    Parity parity, const Matrix& v) const {
  const auto p = static_cast<std::size_t>(parity);
  return product<Scalar>(derivative_[p], false, solve(parity, extended(parity, v)));
}

template <typename Scalar>
typename SymmetricSystem<Scalar>::Matrix SymmetricSystem<Scalar>::xAdjoints(Parity parity,
                                                                            const Matrix& w) const {
  const auto p = static_cast<std::size_t>(parity);
  return solveTransposed(parity, product<Scalar>(derivative_[p], true, w)).topRows(w.rows());
}

template <typename Scalar>
typename SymmetricSystem<Scalar>::Matrix SymmetricSystem<Scalar>::bothAdjoints(
    Parity parity, const Matrix& w, const Matrix& wX) const {
  const auto p = static_cast<std::size_t>(parity);
  if (!hasXDerivative()) {
    Matrix both(w.rows(), w.cols() + wX.cols());
    both << w, wX;
    return adjoints(parity, both);
  }
  Matrix sources(right_[p].cols(), w.cols() + wX.cols());
  sources << product<Scalar>(right_[p], true, w), product<Scalar>(derivative_[p], true, wX);
  return solveTransposed(parity, sources).topRows(w.rows());
}

template <typename Scalar>
typename SymmetricSystem<Scalar>::Workspace SymmetricSystem<Scalar>::release() && {
  Workspace workspace;
  for (std::size_t p = 0; p < static_cast<std::size_t>(parities_); ++p) {
    auto [matrix, factors] = std::move(*left_[p].front().factors).release();
    workspace.systems[p] = {std::move(matrix), std::move(right_[p]), std::move(derivative_[p])};
    workspace.factors[p] = std::move(factors);
  }
  return workspace;
}

template <typename Scalar>
double SymmetricSystem<Scalar>::condition(Parity parity) const {
  return left_[static_cast<std::size_t>(parity)].front().factors->condition();
}

template class SymmetricSystem<double>;
template class SymmetricSystem<Complex>;

}  // namespace cutwater
