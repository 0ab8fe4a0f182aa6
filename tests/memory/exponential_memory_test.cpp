#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>

#include "hydro/Errors.h"
#include "hydro/base/SymmetricEigen.h"
#include "hydro/memory/RadiationModel.h"
#include "tests/memory/CausalShip.h"

namespace cutwater {
namespace {

const Coefficients& causalShip() {
  static const Coefficients c = test::CausalShip().coefficients(0.1, 20.0);
  return c;
}

const RadiationModel& causalModel(ForwardSpeedForm form) {
  static const RadiationModel report(causalShip(), ForwardSpeedForm::Report);
  static const RadiationModel tuck(causalShip(), ForwardSpeedForm::Tuck);
  return form == ForwardSpeedForm::Report ? report : tuck;
}

constexpr ForwardSpeedForm kBothForms[] = {ForwardSpeedForm::Report, ForwardSpeedForm::Tuck};

Vec6 shaking(int n) {
  Vec6 v;
  for (int m = 0; m < 6; ++m) v(m) = std::sin(0.37 * n * (m + 1)) + 0.1 * m;
  return v;
}

/// −Σ_i K̄_i η̇_{n−i} with the sum's own K̄_i = Re Σ R (e^{s(i+1)h} − e^{sih})/s.
Vec6 convolved(const ExponentialSum& sum, double h, double U, int last) {
  Vec6 force = Vec6::Zero();
  for (int i = 0; i <= last; ++i) {
    const Vec6 velocity = shaking(last - i);
    for (const auto& p : sum.pairs()) {
      double K = 0.0;
      for (std::size_t m = 0; m < sum.size(); ++m) {
        const Complex s = sum.poles()[m];
        const Complex R = p.atRest[m] + U * (p.linear[m] + U * p.squared[m]);
        K += (R * std::exp(s * (i * h)) * (std::exp(s * h) - 1.0) / s).real();
      }
      force[p.j] -= K * velocity[p.k];
    }
  }
  return force;
}

// Round-off: residues are up to 10³ times the functions they add up to.
TEST(ExponentialMemoryIdentity, IsTheConvolutionOfItsOwnFunctionsAtEveryTick) {
  for (const auto form : kBothForms) {
    const ExponentialSum& sum = causalModel(form).sum();
    for (const double h : {0.01, 1.0 / 60.0, 0.04, 0.1}) {
      for (const double U : {0.0, 2.0}) {
        ExponentialMemory memory(sum, h);
        Vec6 force;
        for (int n = 0; n <= 200; ++n) force = memory.advance(shaking(n), U);
        const Vec6 exact = convolved(sum, h, U, 200);
        EXPECT_LT((force - exact).norm(), 1e-11 * exact.norm()) << h << ' ' << U;
      }
    }
  }
}

// error() is the largest error of a part over the largest of B(U) or ωA(U) in its band; these
// kernels have four poles each, in one place, which distinct ones approach.
TEST(ExponentialSumClosedForm, HasTheTransformsItWasMadeFrom) {
  for (const auto form : kBothForms) {
    const RadiationModel& model = causalModel(form);
    EXPECT_LT(model.sum().error(), 2e-3);
    for (const double U : {0.0, 1.0, 5.0}) {
      double error = 0.0, size = 0.0;
      for (double omega = 0.1; omega < 20.0; omega *= 1.3) {
        const CMat6 exact = model.retardation().transforms(omega).at(U);
        error = std::max(error, (model.sum().transform(omega, U) - exact).cwiseAbs().maxCoeff());
        size = std::max(size, exact.cwiseAbs().maxCoeff());
      }
      EXPECT_LT(error, 2e-3 * size) << U;
    }
  }
}

// Round-off of 20 terms up to 10³ times their sum's parts.
TEST(ExponentialSumIdentity, IntegralsOverAllTimeAreKeptExactly) {
  for (const auto form : kBothForms) {
    const RadiationModel& model = causalModel(form);
    const double size = model.retardation().integral(1.0).cwiseAbs().maxCoeff();
    for (const auto& p : model.sum().pairs()) {
      double atRest = 0.0, linear = 0.0;
      for (std::size_t m = 0; m < model.sum().size(); ++m) {
        atRest -= (p.atRest[m] / model.sum().poles()[m]).real();
        linear -= (p.linear[m] / model.sum().poles()[m]).real();
      }
      EXPECT_NEAR(atRest, 0.0, 1e-11 * size) << p.j << p.k;
      EXPECT_NEAR(linear, model.retardation().linearTotal()(p.j, p.k), 1e-11 * size) << p.j << p.k;
    }
  }
}

// B of the causal ship is positive definite, so its memory takes energy at every ω; what the fit
// may add is its error of B in its band.
TEST(ExponentialSumIdentity, MemoryAtRestTakesEnergyAtEveryFrequency) {
  const ExponentialSum& sum = causalModel(ForwardSpeedForm::Report).sum();
  double largest = 0.0, least = 0.0;
  for (double omega = 1e-3; omega < 300.0; omega *= 1.05) {
    const Mat6 B = sum.transform(omega, 0.0).real();
    const Vec6 values = symmetricEigenvalues(0.5 * (B + B.transpose()));
    least = std::min(least, values.minCoeff());
    largest = std::max(largest, values.maxCoeff());
  }
  EXPECT_GT(least, -2e-4 * largest);
}

// Velocities that are constant over spans: one tick a span or many, of any lengths, the state at
// its end is the same, as each exponential is known in between. To round-off of 100 ticks.
TEST(ExponentialMemoryIdentity, AnyStepsGiveTheSamePast) {
  const ExponentialSum& sum = causalModel(ForwardSpeedForm::Report).sum();
  ExponentialMemory whole(sum, 0.1), parts(sum, 0.1);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  double largest = 0.0;
  for (int span = 0; span < 40; ++span) {
    const double length = 0.05 + 0.04 * (span % 7);
    Vec6 velocity;
    for (int k = 0; k < 6; ++k) velocity[k] = any(random);
    ASSERT_TRUE(whole.setStep(length));
    const Vec6 expected = whole.advance(velocity, 3.0);
    Vec6 found;
    for (const double share : {0.1, 0.25, 0.65}) {
      ASSERT_TRUE(parts.setStep(share * length));
      found = parts.advance(velocity, 3.0);
    }
    largest = std::max(largest, expected.norm());
    EXPECT_LT((found - expected).norm(), 1e-12 * largest);
  }
  EXPECT_FALSE(whole.setStep(0.0));
  EXPECT_FALSE(whole.setStep(std::nan("")));
}

// |F_j| ≤ Σ_k ∫|K_jk|: a million ticks of velocities as bad as can be, then silence.
TEST(ExponentialMemory, StaysBoundedForAMillionTicksAndForgets) {
  const ExponentialSum& sum = causalModel(ForwardSpeedForm::Report).sum();
  constexpr double h = 0.05, U = 3.0;
  Mat6 integral = Mat6::Zero();
  for (double tau = 0.5 * h; tau < 200.0; tau += h) integral += h * sum.at(tau, U).cwiseAbs();
  const double bound = integral.rowwise().sum().maxCoeff();
  ExponentialMemory memory(sum, h);
  std::mt19937 random(3);
  double worst = 0.0;
  Vec6 velocity;
  for (int n = 0; n < 1000000; ++n) {
    for (int m = 0; m < 6; ++m) velocity[m] = random() % 2 == 0 ? 1.0 : -1.0;
    worst = std::max(worst, memory.advance(velocity, U).cwiseAbs().maxCoeff());
  }
  EXPECT_LT(worst, 1.01 * bound);  // 1 %: the integral's midpoint rule
  EXPECT_GT(worst, 0.05 * bound);
  double slowest = -1.0;
  for (const Complex& s : sum.poles()) {
    EXPECT_LT(s.real(), 0.0);
    slowest = std::max(slowest, s.real());
  }
  const int silence = static_cast<int>(-40.0 / slowest / h);
  for (int n = 0; n < silence; ++n) velocity = memory.advance(Vec6::Zero(), U);
  EXPECT_LT(velocity.norm(), 1e-12 * bound);
}

TEST(ExponentialMemory, RestoredStateGivesTheSameBits) {
  const ExponentialSum& sum = causalModel(ForwardSpeedForm::Report).sum();
  ExponentialMemory one(sum, 0.02), other(sum, 0.02);
  const auto speed = [](int n) { return 4.0 + std::sin(0.01 * n); };
  for (int n = 0; n < 300; ++n) one.advance(shaking(n), speed(n));
  std::vector<double> snapshot(one.stateSize());
  one.save(snapshot);
  std::vector<Vec6> first;
  for (int n = 0; n < 500; ++n) first.push_back(one.advance(shaking(3 * n), speed(2 * n)));
  one.restore(snapshot);
  other.restore(snapshot);
  for (int n = 0; n < 500; ++n) {
    const Vec6 again = one.advance(shaking(3 * n), speed(2 * n)),
               elsewhere = other.advance(shaking(3 * n), speed(2 * n));
    const Vec6& then = first[static_cast<std::size_t>(n)];
    ASSERT_EQ(std::memcmp(again.data(), then.data(), sizeof then), 0) << n;
    ASSERT_EQ(std::memcmp(elsewhere.data(), then.data(), sizeof then), 0) << n;
  }
  // A memory of other ticks takes it too, and their length with it.
  ExponentialMemory finer(sum, 0.01);
  finer.restore(snapshot);
  EXPECT_EQ(finer.step(), 0.02);
  EXPECT_EQ(finer.advance(shaking(0), speed(0)), first[0]);
  EXPECT_THROW(one.restore(std::span(snapshot).first(3)), HydroError);
}

TEST(ExponentialMemory, ForgetsOnResetAndRecoversFromNonsense) {
  const ExponentialSum& sum = causalModel(ForwardSpeedForm::Report).sum();
  ExponentialMemory memory(sum, 0.05), fresh(sum, 0.05);
  memory.advance(shaking(1), std::nan(""));  // a speed spoils one tick, not the memory
  fresh.advance(shaking(1), 2.0);
  EXPECT_EQ(memory.advance(shaking(2), 2.0), fresh.advance(shaking(2), 2.0));
  memory.advance(Vec6::Constant(std::nan("")), 2.0);
  memory.reset();
  EXPECT_EQ(memory.advance(Vec6::Zero(), 2.0), Vec6::Zero().eval());
  for (const double step : {0.0, -1.0, std::nan(""), HUGE_VAL})
    EXPECT_THROW(ExponentialMemory(sum, step), HydroError) << step;
}

/// Both memories shaken alike: largest distance over the largest force.
double distanceOfModels(const Coefficients& c, ForwardSpeedForm form, double U) {
  const RadiationModel model(c, form);
  const auto a = model.makeMemory(0.05), b = model.makeConvolution(0.05);
  double error = 0.0, size = 1e-300;
  for (int n = 0; n < 400; ++n) {
    const Vec6 x = a->advance(shaking(n), U), y = b->advance(shaking(n), U);
    EXPECT_TRUE(x.allFinite());
    error = std::max(error, (x - y).norm());
    size = std::max(size, y.norm());
  }
  return error / size;
}

// Ships that lack something. 1 %: the fit, and what the convolution cuts off.
TEST(RadiationModel, LivesWithPoorDatabases) {
  const Coefficients& whole = causalShip();
  for (const auto form : kBothForms) {
    Coefficients still = whole;  // no damping: no memory
    for (auto* matrices : {&still.damping, &still.dampingX})
      for (Mat6& m : *matrices) m.setZero();
    EXPECT_EQ(distanceOfModels(still, form, 3.0), 0.0);

    Coefficients heave = whole;  // one mode alone, as a body of revolution's other modes
    for (auto* matrices : {&heave.damping, &heave.dampingX})
      for (Mat6& m : *matrices) {
        const double b = m(2, 2);
        m.setZero();
        m(2, 2) = b;
      }
    EXPECT_LT(distanceOfModels(heave, form, 3.0), 0.01);

    Coefficients noRoll = whole;  // a sphere's: damped in translation only
    for (auto* matrices : {&noRoll.damping, &noRoll.dampingX})
      for (Mat6& m : *matrices) {
        m.row(Roll).setZero();
        m.col(Roll).setZero();
      }
    EXPECT_LT(distanceOfModels(noRoll, form, 3.0), 0.01);

    Coefficients two = whole;
    two.omega = {whole.omega[9], whole.omega[29]};
    for (auto* matrices : {&two.damping, &two.dampingX, &two.addedMass, &two.addedMassX})
      matrices->values = {(*matrices)[9], (*matrices)[29]};
    // The convolution is cut off at 2π/Δω = 3 s, beyond which two points say nothing.
    EXPECT_LT(distanceOfModels(two, form, 3.0), 0.2);
  }
  Coefficients plain = whole;  // no ∂A, ∂B: the report's form at rest only
  plain.addedMassX = {};
  plain.dampingX = {};
  EXPECT_FALSE(RadiationModel(plain, ForwardSpeedForm::Report).hasSpeedTerms());
  EXPECT_LT(distanceOfModels(plain, ForwardSpeedForm::Report, 3.0), 0.01);
}

}  // namespace
}  // namespace cutwater
