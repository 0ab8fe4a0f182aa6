#include <gtest/gtest.h>

#include <cmath>

#include "hydro/memory/RadiationModel.h"
#include "tests/memory/CausalShip.h"

namespace cutwater {
namespace {

const RadiationModel& model() {
  static const RadiationModel model(test::CausalShip().coefficients(0.1, 20.0),
                                    ForwardSpeedForm::Report);
  return model;
}

TEST(RadiationModel, MakesEitherMemoryAndFitsOnce) {
  EXPECT_NE(dynamic_cast<ExponentialMemory*>(model().makeMemory(0.1).get()), nullptr);
  EXPECT_NE(dynamic_cast<Convolution*>(model().makeConvolution(0.1).get()), nullptr);
  EXPECT_EQ(&model().sum(), &model().sum());
}

// The convolution is the oracle of the sum. The fit is good to 2e-3 of B and ωA in their band
// (exponential_memory_test.cpp); a motion of many frequencies meets them at once, hence 5e-3.
TEST(RadiationModelIdentity, BothRememberTheSame) {
  for (const double U : {0.0, 3.0}) {
    const auto a = model().makeMemory(0.05), b = model().makeConvolution(0.05);
    double error = 0.0, size = 0.0;
    for (int n = 0; n < 400; ++n) {
      Vec6 v;
      for (int m = 0; m < 6; ++m) v[m] = std::sin(0.02 * n * (m + 1)) * std::cos(0.07 * n);
      const Vec6 x = a->advance(v, U), y = b->advance(v, U);
      error = std::max(error, (x - y).norm());
      size = std::max(size, y.norm());
    }
    EXPECT_LT(error, 5e-3 * size) << U;
    EXPECT_GT(error, 0.0) << U;  // they are two programs
  }
}

}  // namespace
}  // namespace cutwater
