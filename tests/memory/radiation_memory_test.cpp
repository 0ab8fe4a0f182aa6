#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "hydro/Errors.h"
#include "hydro/memory/RadiationMemory.h"
#include "hydro/memory/RadiationModel.h"
#include "tests/memory/CausalShip.h"

// What holds for every memory, whichever way it remembers.
namespace cutwater {
namespace {

constexpr double kTick = 0.05;  // [s]

enum class Memory { Sum, Convolution };

const RadiationModel& model() {
  static const RadiationModel model(test::CausalShip().coefficients(0.1, 20.0),
                                    ForwardSpeedForm::Report);
  return model;
}

class RadiationMemoryIdentity : public ::testing::TestWithParam<Memory> {
 protected:
  std::unique_ptr<RadiationMemory> make(double step = kTick) const {
    return GetParam() == Memory::Sum ? model().makeMemory(step) : model().makeConvolution(step);
  }
};

/// A velocity in all six modes, no two ticks alike.
Vec6 velocityAt(int n) {
  Vec6 v;
  for (int m = 0; m < 6; ++m) v[m] = std::sin(0.31 * n * (m + 1) + m) + 0.05 * m;
  return v;
}

double sizeOfForce(RadiationMemory& memory) {
  double size = 0.0;
  for (int n = 0; n < 100; ++n) size = std::max(size, memory.advance(velocityAt(n), 2.0).norm());
  memory.reset();
  return size;
}

// The force is linear in the past: of a sum of two motions it is the sum of the forces. Round-off
// of sums of some hundred terms that cancel by 1e3.
TEST_P(RadiationMemoryIdentity, ForcesOfTwoMotionsAdd) {
  const auto one = make(), other = make(), both = make();
  const double round = 1e-11 * sizeOfForce(*one);
  for (int n = 0; n < 200; ++n) {
    const Vec6 a = velocityAt(n), b = velocityAt(3 * n + 7), sum = 2.0 * a - b;
    const Vec6 apart = 2.0 * one->advance(a, 2.0) - other->advance(b, 2.0);
    EXPECT_LT((both->advance(sum, 2.0) - apart).norm(), round) << n;
  }
}

// Nothing is felt before it happens, and a motion that begins later is felt later, not otherwise.
TEST_P(RadiationMemoryIdentity, WhatBeginsLaterIsFeltLater) {
  const auto early = make(), late = make();
  const double round = 1e-12 * sizeOfForce(*early);  // sums begin at another place of the ring
  constexpr int kLater = 13;
  for (int n = 0; n < kLater; ++n)
    ASSERT_EQ(late->advance(Vec6::Zero(), 2.0), Vec6::Zero().eval()) << n;
  for (int n = 0; n < 150; ++n) {
    const Vec6 first = early->advance(velocityAt(n), 2.0);
    EXPECT_LT((late->advance(velocityAt(n), 2.0) - first).norm(), round) << n;
  }
}

// The present speed weighs the whole past anew: the three parts of one memory give the force at
// every speed.
TEST_P(RadiationMemoryIdentity, PartsGiveTheForceAtEverySpeed) {
  const auto parts = make();
  const double round = 1e-11 * sizeOfForce(*parts);
  const std::array<double, 4> speeds{0.0, 1.5, 6.0, -2.0};
  std::array<std::unique_ptr<RadiationMemory>, 4> memories;
  for (auto& memory : memories) memory = make();
  for (int n = 0; n < 100; ++n) {
    const RadiationMemory::Parts now = parts->advanceParts(velocityAt(n));
    for (std::size_t i = 0; i < speeds.size(); ++i) {
      const Vec6 force = memories[i]->advance(velocityAt(n), speeds[i]);
      EXPECT_LT((now.at(speeds[i]) - force).norm(), round * (1.0 + speeds[i] * speeds[i])) << n;
    }
  }
}

TEST_P(RadiationMemoryIdentity, WithoutASpeedTheShipIsAtRest) {
  const auto one = make(), other = make();
  for (int n = 0; n < 50; ++n)
    ASSERT_EQ(one->advance(velocityAt(n)), other->advance(velocityAt(n), 0.0)) << n;
}

// The first tick feels ∫K over itself: a memory of any kind begins with −K(0) h η̇, and
// K(0) = (2/π)∫B dω resists. These kernels begin flat, so that a tick leaves (h/2)² of them, 1e-4;
// the fit leaves 1e-3.
TEST_P(RadiationMemoryIdentity, FirstTickIsResistedByTheKernelAtZero) {
  const Mat6 K = model().retardation().at(0.0);
  const double h = 0.01;
  for (int k = 0; k < 6; ++k) {
    const Vec6 force = make(h)->advance(Vec6::Unit(k), 0.0);
    EXPECT_LT((force + h * K.col(k)).norm(), 3e-3 * h * K.col(k).norm()) << k;
    EXPECT_LT(force[k], 0.0) << k;
  }
}

/// A(0) − A(∞) of both memories.
Mat6 rest() { return model().retardation().momentumIntegral(0.0, HUGE_VAL); }

// A ship that has always had a velocity moves the water of A(0); it goes on doing so, tick after
// tick of any length that the memory takes.
TEST_P(RadiationMemoryIdentity, ASteadyVelocityHasTheMomentumOfAddedMassAtRest) {
  const auto memory = make();
  Vec6 velocity = velocityAt(1);
  memory->addSteady(velocity);
  const Vec6 expected = rest() * velocity;
  for (int n = 0; n < 40; ++n) {
    const Vec6 found = memory->momentum(velocity, kTick);
    ASSERT_LT((found - expected).norm(), 1e-10 * expected.norm()) << n;  // of cancelling terms
    if (GetParam() == Memory::Sum) memory->setStep(kTick * (1.0 + 0.3 * (n % 3)));
  }
  // A steady velocity beside it is felt as if it had always been there.
  const Vec6 more = velocityAt(2), both = velocity + more;
  memory->addSteady(more);
  EXPECT_LT((memory->momentum(both, kTick) - rest() * both).norm(), 1e-10 * expected.norm());
}

// From rest the same is reached as the memory fades. The slowest pole of the fit, whose share is
// small, dies as e^{−t/50 s} or so.
TEST_P(RadiationMemoryIdentity, AVelocityThatLastsComesToTheMomentumOfAddedMassAtRest) {
  const auto memory = make();
  const Vec6 velocity = velocityAt(1), expected = rest() * velocity;
  Vec6 found;
  for (int n = 0; n < 24000; ++n) found = memory->momentum(velocity, kTick);
  EXPECT_LT((found - expected).norm(), 1e-9 * expected.norm());
  memory->reset();
  EXPECT_EQ(memory->momentum(Vec6::Zero(), kTick), Vec6::Zero().eval());
}

/// Largest distance, of smooth motions at rest, between the force and the rate of the momentum that
/// is left half a tick before and after.
double rateError(RadiationMemory& force, RadiationMemory& momentum, double h) {
  double error = 0.0;
  Vec6 before = Vec6::Zero();
  for (int n = 1; n * h < 20.0; ++n) {
    const auto place = [h](double tick) {  // 1 − cos: at rest at the start
      return Vec6(Vec6::NullaryExpr([&](Eigen::Index m) {
        const double w = 0.5 + 0.1 * static_cast<double>(m);
        return 1.0 - std::cos(w * tick * h);
      }));
    };
    const Vec6 mean = (place(n) - place(n - 1)) / h;
    const Vec6 after = momentum.momentum(mean, h);
    error = std::max(error, (force.advance(mean) + (after - before) / h).norm());
    before = after;
  }
  return error;
}

// F = −dq/dt, at second order in the tick.
TEST_P(RadiationMemoryIdentity, ForceIsTheRateOfTheMomentum) {
  const double coarse = rateError(*make(0.1), *make(0.1), 0.1),
               fine = rateError(*make(0.05), *make(0.05), 0.05);
  EXPECT_NEAR(std::log2(coarse / fine), 2.0, 0.3);
  EXPECT_LT(fine, 5e-3 * sizeOfForce(*make()));
}

// Of momenta too: linear in the past.
TEST_P(RadiationMemoryIdentity, MomentaOfTwoMotionsAdd) {
  const auto one = make(), other = make(), both = make();
  for (int n = 0; n < 200; ++n) {
    const Vec6 a = velocityAt(n), b = velocityAt(3 * n + 7), sum = 2.0 * a - b;
    const Vec6 apart = 2.0 * one->momentum(a, kTick) - other->momentum(b, kTick);
    EXPECT_LT((both->momentum(sum, kTick) - apart).norm(), 1e-11 * rest().norm()) << n;
  }
}

TEST_P(RadiationMemoryIdentity, FitsItsOwnStateAndNoOther) {
  const auto memory = make(), finer = make(0.5 * kTick);
  EXPECT_EQ(memory->step(), kTick);
  for (int n = 0; n < 40; ++n) memory->advance(velocityAt(n), 2.0);
  std::vector<double> state(memory->stateSize()), ofFiner(finer->stateSize());
  memory->save(state);
  finer->save(ofFiner);
  EXPECT_TRUE(memory->fits(state));
  // The past of the sum of exponentials is the same at any length of tick.
  EXPECT_EQ(memory->fits(ofFiner), GetParam() == Memory::Sum);
  EXPECT_FALSE(memory->fits({}));
  std::vector<double> longer = state;
  longer.push_back(0.0);
  EXPECT_FALSE(memory->fits(longer));
  try {
    memory->restore(longer);
    FAIL() << "a state of another size was taken";
  } catch (const HydroError& error) {
    EXPECT_EQ(error.fault(), Fault::BadArgument);
  }
  // What was refused has changed nothing.
  std::vector<double> after(memory->stateSize());
  memory->save(after);
  EXPECT_EQ(after, state);
}

// The two memories have the same momentum but for the fit, 1e-3 of the largest K, and what lies
// beyond the convolution's duration.
TEST(RadiationMemoryVerification, SumAndConvolutionHaveTheSameMomentum) {
  const auto sum = model().makeMemory(kTick), convolution = model().makeConvolution(kTick);
  double worst = 0.0, largest = 0.0;
  for (int n = 0; n < 600; ++n) {
    const Vec6 v = velocityAt(n);
    const Vec6 a = sum->momentum(v, kTick), b = convolution->momentum(v, kTick);
    worst = std::max(worst, (a - b).norm());
    largest = std::max(largest, b.norm());
  }
  EXPECT_LT(worst, 3e-3 * largest);
}

INSTANTIATE_TEST_SUITE_P(Both, RadiationMemoryIdentity,
                         ::testing::Values(Memory::Sum, Memory::Convolution),
                         [](const auto& memory) {
                           return memory.param == Memory::Sum ? "Exponential" : "Convolution";
                         });

}  // namespace
}  // namespace cutwater
