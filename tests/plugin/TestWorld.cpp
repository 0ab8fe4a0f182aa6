#include "tests/plugin/TestWorld.h"

#include "tests/support/Matrices.h"

namespace cutwater::test {

Mat6 randomAddedMass(const Mat6& mass, const Vec6& ratios, std::mt19937& random) {
  std::normal_distribution<double> normal;
  const Mat6 any = Mat6::NullaryExpr([&] { return normal(random); });
  const Mat6 q = orthogonal(Eigen::MatrixXd(any));
  const Mat6 root = mass.cwiseSqrt();
  return root * q * ratios.asDiagonal() * q.transpose() * root;
}

}  // namespace cutwater::test
