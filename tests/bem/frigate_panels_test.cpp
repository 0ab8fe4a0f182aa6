#include <gtest/gtest.h>

#include <algorithm>

#include "hydro/base/ParallelFor.h"
#include "hydro/bem/linear/Factorization.h"
#include "tests/bem/Bodies.h"
#include "tests/support/Results.h"

// The frigate of equal-girth strips at 433 panels a side against 1040, all entries of A and B that
// symmetry leaves. Full size: a minute.
namespace cutwater::test {
namespace {

using Bands = std::array<double, 4>;
constexpr std::array kEdges{0.2, 0.5, 1.0, 2.0, 3.0};  // [rad/s]

/// A and B of unit density at the frequencies.
struct Curves {
  std::vector<double> omega;
  std::vector<Mat6> A, B;
  Mat6 zeroA;
};

Curves solved(int along, int girth, PanelShape shape) {
  const SurfaceMesh wet = wetFrigate(along, girth, 0.0);
  const InfluenceMatrices matrices(panels(wet, true, true, shape), {.threads = 2});
  const ModeNormals normals(matrices.mesh(), Vec3(-2.4165, 0.0, 1.29), wet);
  Curves c;
  for (int i = 2; i <= 30; i += 2) c.omega.push_back(0.1 * i);
  c.omega.insert(c.omega.begin() + 2, 0.5);
  c.A.resize(c.omega.size());
  c.B.resize(c.omega.size());
  c.zeroA = impulse(matrices, normals, FrequencyLimit::Zero);
  const OneBlasThread oneBlasThread;
  parallelFor(c.omega.size(), 2, [&](std::size_t i, std::size_t) {
    const CMat6 Z = impulse(matrices, normals, c.omega[i] * c.omega[i] / kGravity);
    c.A[i] = addedMass(Z);
    c.B[i] = damping(Z, c.omega[i]);
  });
  return c;
}

/// Largest difference of one entry in each band, % of the curve's maximum.
Bands differences(const std::vector<double>& omega, const std::vector<Mat6>& got,
                  const std::vector<Mat6>& truth, int j, int k) {
  double most = 0.0;
  for (const Mat6& m : truth) most = std::max(most, std::abs(m(j, k) + m(k, j)));
  Bands worst{};
  for (std::size_t i = 0; i < omega.size(); ++i)
    for (std::size_t b = 0; b < worst.size(); ++b)
      if (omega[i] > kEdges[b] - 1e-9 && omega[i] < kEdges[b + 1] + 1e-9)
        worst[b] = std::max(
            worst[b],
            100.0 / most * std::abs(got[i](j, k) + got[i](k, j) - truth[i](j, k) - truth[i](k, j)));
  return worst;
}

double meanOfAll(const Curves& got, const Curves& truth) {
  double sum = 0.0;
  int count = 0;
  for (int j = 0; j < 6; ++j)
    for (int k = j; k < 6; k += 2)
      for (const Bands& bands : {differences(got.omega, got.A, truth.A, j, k),
                                 differences(got.omega, got.B, truth.B, j, k)})
        for (const double worst : bands) {
          sum += worst;
          ++count;
        }
  return sum / count;
}

// 0.40 % is asked; the best of other codes has 0.485 % by the same measure. Heave and sway at
// ω → 0 within 0.1 %, as flat panels have them. With the areas of the flattened panels, as up to
// 0.1.0, the mean is 0.67 %.
TEST(FrigatePanelsVerification, At433PanelsAllCoefficientsAreNearThoseOf1040) {
  if (!fullSize()) GTEST_SKIP() << "full size only";
  const Curves truth = solved(80, 13, PanelShape::Flat);
  const Curves got = solved(48, 9, PanelShape::Auto);
  const double mean = meanOfAll(got, truth);
  EXPECT_LT(mean, 0.40);
  EXPECT_NEAR(got.zeroA(Heave, Heave) / truth.zeroA(Heave, Heave), 1.0, 1e-3);
  EXPECT_NEAR(got.zeroA(Sway, Sway) / truth.zeroA(Sway, Sway), 1.0, 1e-3);
  EXPECT_GT(meanOfAll(solved(48, 9, PanelShape::FlattenedOnly), truth), 0.55);
  recordResult("solver",
               "frigate of equal strips, 433 panels, A and B, mean of worst in four bands",
               "1040 panels", mean, "≤ 0.40");
}

}  // namespace
}  // namespace cutwater::test
