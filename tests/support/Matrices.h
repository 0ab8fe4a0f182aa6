#pragma once
#include "hydro/Conventions.h"

/// Algebra that tests check others' by: plain loops. Eigen's factorizations take seconds to compile
/// in each test that names them.
namespace cutwater::test {

/// m⁻¹ right, by Gauss's elimination with row exchanges.
Eigen::MatrixXd solved(const Eigen::MatrixXd& m, const Eigen::MatrixXd& right);
Eigen::MatrixXcd solved(const Eigen::MatrixXcd& m, const Eigen::MatrixXcd& right);
Mat6 inverse(const Mat6& m);

/// Unit columns, at right angles to one another to round-off: those of `any`, each without what
/// the ones before it have of it.
Eigen::MatrixXd orthogonal(Eigen::MatrixXd any);
Eigen::MatrixXcd orthogonal(Eigen::MatrixXcd any);

}  // namespace cutwater::test
