#include "hydro/forces/linear/Radiation.h"

#include <gtest/gtest.h>

#include <cmath>

#include "hydro/memory/RadiationModel.h"
#include "tests/memory/CausalShip.h"

namespace cutwater {
namespace {

std::shared_ptr<const RadiationModel> modelOf(ForwardSpeedForm form) {
  return std::make_shared<RadiationModel>(test::CausalShip().coefficients(0.2, 20.0), form);
}

/// Ready for ticks of 0.05 s.
Radiation radiation(const std::shared_ptr<const RadiationModel>& model) {
  Radiation part(model);
  part.prepare(0.05);
  return part;
}

TickInput anyMotion() {
  TickInput motion;
  motion.step = motion.lastStep = 0.05;
  motion.speed = 6.0;
  motion.eta << 0.3, -0.2, 0.5, 0.1, -0.15, 0.07;
  motion.etaDot << 0.1, 0.4, -0.3, 0.2, 0.25, -0.1;
  motion.etaDotNow << 0.12, 0.41, -0.28, 0.22, 0.23, -0.12;
  return motion;
}

TEST(RadiationIdentity, IsTheMemorysForceLessTheDampingAndStiffnessOfSpeed) {
  for (const auto form : {ForwardSpeedForm::Report, ForwardSpeedForm::Tuck}) {
    const auto model = modelOf(form);
    Radiation force = radiation(model);
    const auto memory = model->makeMemory(0.05);
    TickInput motion = anyMotion();
    for (int n = 0; n < 20; ++n) {
      motion.etaDot *= -0.9;
      const Vec6 found = force.evaluate(motion).load;
      const Vec6 expected = memory->advance(motion.etaDot, 6.0) -
                            6.0 * (model->retardation().speedDamping() * motion.etaDotNow) -
                            36.0 * (model->retardation().speedStiffness() * motion.eta);
      EXPECT_LT((found - expected).norm(), 1e-13 * expected.norm());
    }
  }
}

// On a steady straight course b of Tuck's form does no work at all, c none over a period.
TEST(RadiationIdentity, TucksDampingOfSpeedIsGyroscopic) {
  const auto model = modelOf(ForwardSpeedForm::Tuck);
  const Vec6 v = anyMotion().etaDotNow;
  const Mat6& b = model->retardation().speedDamping();
  EXPECT_NEAR(v.dot(b * v), 0.0, 1e-13 * b.norm() * v.squaredNorm());
}

}  // namespace
}  // namespace cutwater
