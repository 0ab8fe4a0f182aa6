#include <gtest/gtest.h>

#include <cmath>

#include "hydro/forces/RadiationForce.h"
#include "tests/memory/CausalShip.h"

namespace cutwater {
namespace {

std::shared_ptr<const RadiationModel> modelOf(ForwardSpeedForm form) {
  return std::make_shared<RadiationModel>(test::CausalShip().coefficients(0.2, 20.0),
                                          MemoryModel::Exponential, form);
}

ShipMotion anyMotion() {
  ShipMotion motion;
  motion.speed = 6.0;
  motion.turnRate = 0.04;
  motion.eta << 0.3, -0.2, 0.5, 0.1, -0.15, 0.07;
  motion.etaDot << 0.1, 0.4, -0.3, 0.2, 0.25, -0.1;
  motion.etaDotNow << 0.12, 0.41, -0.28, 0.22, 0.23, -0.12;
  return motion;
}

TEST(RadiationForceIdentity, IsTheMemorysForceLessTheDampingAndStiffnessOfSpeed) {
  for (const auto form : {ForwardSpeedForm::Report, ForwardSpeedForm::Tuck}) {
    const auto model = modelOf(form);
    RadiationForce force(model, 0.05);
    const auto memory = model->makeMemory(0.05);
    ShipMotion motion = anyMotion();
    for (int n = 0; n < 20; ++n) {
      motion.etaDot *= -0.9;
      const Vec6 found = force.at(motion);
      const Vec6 expected = memory->advance(motion.etaDot, 6.0) -
                            6.0 * (model->retardation().speedDamping() * motion.etaDotNow) -
                            36.0 * (model->retardation().speedStiffness() * motion.eta);
      EXPECT_LT((found - expected).norm(), 1e-13 * expected.norm());
    }
    motion.speed = 0.0;
    force.at(motion);
    EXPECT_TRUE(force.speedTerms().isZero(0.0));
  }
}

// A free ship goes at U + η̇ along and turns at r̄ + η̇₆; of second order, the work of b, c and the surge reaction is
// F₁U + F·w. It vanishes: what turns her is taken out of her way. Round-off.
TEST(RadiationForceIdentity, WorkOfSpeedTermsOnAFreeShipComesOutOfHerWay) {
  RadiationForce force(modelOf(ForwardSpeedForm::Tuck), 0.05, true),
      held(modelOf(ForwardSpeedForm::Tuck), 0.05, false);
  const ShipMotion motion = anyMotion();
  force.at(motion);
  held.at(motion);
  const Vec6 reaction = force.speedTerms() - held.speedTerms();
  EXPECT_TRUE(reaction.tail<5>().isZero(0.0));
  Vec6 w = motion.etaDotNow;
  w[Yaw] += motion.turnRate;
  const double work = held.speedTerms().dot(w);
  EXPECT_NEAR(work + reaction[Surge] * motion.speed, 0.0,
              1e-13 * held.speedTerms().norm() * w.norm());
  EXPECT_GT(std::abs(work), 1e-3 * held.speedTerms().norm() * w.norm());  // it was not nothing
}

// On a steady straight course b of Tuck's form does no work at all, c none over a period.
TEST(RadiationForceIdentity, TucksDampingOfSpeedIsGyroscopic) {
  const auto model = modelOf(ForwardSpeedForm::Tuck);
  const Vec6 v = anyMotion().etaDotNow;
  const Mat6& b = model->retardation().speedDamping();
  EXPECT_NEAR(v.dot(b * v), 0.0, 1e-13 * b.norm() * v.squaredNorm());
}

}  // namespace
}  // namespace cutwater
