#include <gtest/gtest.h>

#include <cmath>

#include "hydro/excitation/WaveExcitation.h"
#include "hydro/forces/FreeResponse.h"
#include "hydro/memory/RadiationModel.h"
#include "hydro/response/FrequencyResponse.h"
#include "tests/forces/FreeBox.h"

namespace cutwater {
namespace {

using test::freeBox, test::kBoxGravity;

struct Box {
  Coefficients coefficients = freeBox();
  RadiationModel model{coefficients, ForwardSpeedForm::Tuck};
  Coefficients fitted = asFitted();
  FreeResponse response{fitted, model};

  /// With A(ω) and B(ω) as the fit has them, exact at the grid's frequencies.
  Coefficients asFitted() const {
    Coefficients c = coefficients;
    model.sum();
    for (std::size_t i = 0; i < c.omega.size(); ++i) {
      const CMat6 water = model.waterMass(c.omega[i]);
      c.addedMass[i] = water.real();
      c.damping[i] = -c.omega[i] * water.imag();
    }
    c.addedMass.atZero = model.waterMass(0.0).real();
    return c;
  }
  CVec6 force(double omega, double heading, double speed) const {
    CVec6 force =
        WaveExcitation(coefficients, ForwardSpeedForm::Tuck).at(omega, heading, speed).total();
    const auto water = response.lift().orbital(omega, omega * omega / kBoxGravity, heading);
    force[Sway] += std::abs(speed) * response.lift().side * water.side;
    force[Yaw] += std::abs(speed) * response.lift().turn * water.turn;
    return force;
  }
};

const Box& box() {
  static const Box box;
  return box;
}

/// A wave that is met at ω′ by a ship of this speed.
double waveMetAt(double omegaMet, double speed, double heading) {
  const double c = speed * std::cos(heading) / kBoxGravity;  // ω − cω² = ω′
  if (std::abs(c) < 1e-12) return omegaMet;
  const double root = std::sqrt(1.0 - 4.0 * c * omegaMet);
  return omegaMet < 0.0 ? (1.0 + root) / (2.0 * c) : (1.0 - root) / (2.0 * c);
}

// The free ship linearised, of the frequency domain and of the time domain's own fit, where the
// database holds what the fit says: the same equations, solved twice. 1e-7: the frequency domain
// takes the mean of A_jk and A_kj, which were fitted apart and are 1e-8 apart; roll at resonance
// magnifies that.
TEST(FreeResponseIdentity, IsTheFreeShipOfTheFrequencyDomain) {
  const Coefficients& fitted = box().fitted;
  int overtaken = 0;
  for (const bool lift : {true, false}) {
    const FrequencyResponse frequency(fitted, FrequencyResponse::Free{.hullLift = lift});
    for (const double speed : {0.0, 3.0, 6.0}) {
      for (const double heading : {0.0, 0.4, kPi / 2, 2.2, kPi}) {
        for (const double met : {0.5, 1.2, -0.6}) {
          const double omega = waveMetAt(met, speed, heading);
          if (!(omega > 0.3 && omega < 2.4)) continue;
          const double signedMet = encounterFrequency(omega, speed, heading, kBoxGravity);
          ASSERT_NEAR(signedMet, met, 1e-12);
          ActiveParts parts;
          parts.hullLift = lift;
          CVec6 force = box().force(omega, heading, speed);
          if (!lift)
            force =
                WaveExcitation(fitted, ForwardSpeedForm::Tuck).at(omega, heading, speed).total();
          const auto answer = box().response.at(signedMet, {speed, 0.0}, force, parts);
          const CVec6 expected = frequency.at(omega, heading, speed);
          EXPECT_LT((answer.motion - expected).norm(), 1e-7 * expected.norm())
              << speed << ' ' << heading << ' ' << met << '\n'
              << answer.motion.transpose() << '\n'
              << expected.transpose();
          overtaken += met < 0.0 ? 1 : 0;
        }
      }
    }
  }
  EXPECT_GE(overtaken, 4);
}

// Against the database itself: the fit's error of B or ωA, 2e-3, at frequencies away from the
// grid's and from resonance.
TEST(FreeResponseVerification, FollowsTheDatabaseAsCloselyAsTheFit) {
  const FrequencyResponse frequency(box().coefficients, FrequencyResponse::Free{});
  for (const double heading : {0.8, kPi / 2, 2.6}) {
    const double omega = waveMetAt(0.95, 3.0, heading);
    const CVec6 expected = frequency.at(omega, heading, 3.0);
    const CVec6 found =
        box().response.at(0.95, {3.0, 0.0}, box().force(omega, heading, 3.0), {}).motion;
    EXPECT_LT((found - expected).norm(), 1e-2 * expected.norm()) << heading;
  }
}

// A ship that is pushed for long: the fit keeps A(0) of the data's own memory exactly.
TEST(FreeResponseIdentity, AddedMassAtRestIsThatOfTheMemory) {
  const Mat6 expected =
      box().model.addedMassInf() + box().model.retardation().momentumIntegral(0.0, HUGE_VAL);
  EXPECT_LT((box().response.addedMassAtRest() - expected).norm(), 1e-10 * expected.norm());
}

TEST(FreeResponseIdentity, MomentumIsThatOfTheWaterAtTheAnswersVelocities) {
  const CVec6 force = box().force(1.1, 2.2, 4.0);
  const SteadyWay way{4.0, 0.3};
  const auto answer = box().response.at(1.3, way, force, {});
  const CVec6 expected =
      box().model.waterMass(1.3) * (ownVelocities(Complex(0.0, 1.3), way) * answer.motion);
  EXPECT_LT((answer.momentum - expected).norm(), 1e-13 * expected.norm());
}

// A mode that is held has no part in the answer, but for round-off of one equation among larger
// ones, nor in the others' equations.
TEST(FreeResponse, RestrainedModesDoNotMove) {
  ActiveParts parts;
  parts.restrained[Surge] = parts.restrained[Yaw] = true;
  const auto answer = box().response.at(1.1, {2.0, 0.0}, box().force(1.0, 0.8, 2.0), parts);
  EXPECT_LT(std::abs(answer.motion[Surge]) + std::abs(answer.motion[Yaw]), 1e-13);
  EXPECT_GT(std::abs(answer.motion[Sway]), 0.0);
  const FrequencyResponse frequency(box().fitted, FrequencyResponse::Free{}, parts.restrained);
  const double omega = waveMetAt(1.1, 2.0, 0.8);
  const CVec6 expected = frequency.at(omega, 0.8, 2.0);
  const CVec6 found =
      box().response.at(1.1, {2.0, 0.0}, box().force(omega, 0.8, 2.0), parts).motion;
  EXPECT_LT((found - expected).norm(), 1e-7 * expected.norm());
}

// w = ω⁴/(ω⁴ + ω₀⁴): a half at ω₀ = 0.53 √(g/L), 0.15 rad/s of a ship of 124 m; even in ω.
TEST(FreeResponseClosedForm, SlowWavesAreRiddenFastOnesAreMetAbout) {
  const double slow = 0.53 * std::sqrt(kBoxGravity / 20.0);
  EXPECT_NEAR(box().response.share(slow), 0.5, 1e-14);
  EXPECT_NEAR(box().response.share(-2.0 * slow), 16.0 / 17.0, 1e-14);
  EXPECT_EQ(box().response.share(0.0), 0.0);
  EXPECT_NEAR(0.53 * std::sqrt(9.81 / 124.0), 0.15, 1e-3);
}

}  // namespace
}  // namespace cutwater
