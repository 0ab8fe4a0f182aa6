#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "hydro/forces/FreeResponse.h"
#include "hydro/response/FrequencyResponse.h"
#include "hydro/waves/Wave.h"
#include "tests/support/Results.h"
#include "tests/verification/free_ship/FreeFrigate.h"

// In small waves on a straight course the free ship in Bullet does what the free ship linearised
// does: `rao --free`, at any speed and heading, with and without autopilots.
namespace cutwater::test {
namespace {

constexpr double kRamp = 100.0, kFrom = 250.0, kUntil = 500.0;  // [s]; what is fitted
constexpr std::size_t kEvery = 5;                               // ticks of a sample

struct Passage {
  double speed, heading;  // [m/s], β [rad]
  bool keepers;
};

double metAt(const Passage& passage, double omega) {
  return encounterFrequency(omega, passage.speed, passage.heading, kGravity);
}

ShipSettings settingsOf(const Passage& passage) {
  ShipSettings settings = freeShip(passage.speed);
  if (passage.keepers) settings.model.keepCourse = CourseKeeper{};
  if (passage.keepers && passage.speed > 0.0)
    settings.model.keepSpeed = SpeedKeeper{.speed = passage.speed};
  return settings;
}

struct Samples {
  std::vector<double> time;
  Eigen::Matrix<double, Eigen::Dynamic, 6> motion;
};

/// Place less the nominal way, and attitude.
Samples sample(OneShip& run, double speed) {
  Samples samples;
  std::vector<Vec6> motions;
  for (std::size_t i = 1; run.time() < kUntil - 0.5 * kTick; ++i) {
    run.tick();
    if (run.time() < kFrom || i % kEvery != 0) continue;
    Vec6 motion;
    motion << run.ship.position() - Vec3(speed * run.time(), 0.0, 0.0), run.ship.attitude();
    samples.time.push_back(run.time());
    motions.push_back(motion);
  }
  samples.motion.resize(static_cast<Eigen::Index>(motions.size()), 6);
  for (std::size_t i = 0; i < motions.size(); ++i)
    samples.motion.row(static_cast<Eigen::Index>(i)) = motions[i].transpose();
  return samples;
}

/// What is left of the start beside the harmonic: a constant, a straight line and the ship's own
/// motions in calm water, as it does them after a push ahead, aside and about the vertical.
struct OwnMotions {
  std::array<Samples, 3> after;

  explicit OwnMotions(const Passage& passage) {
    const double mass = coarseFrigate()->ship().mass, length = coarseFrigate()->length();
    for (std::size_t n = 0; n < 3; ++n) {
      OneShip run(coarseFrigate(), SeaState({}, kGravity), settingsOf(passage));
      const auto blow = static_cast<btScalar>(1e-3 * mass);  // 1 mm/s
      while (run.time() < 0.5 * kRamp) run.tick();
      if (n == 0) run.ship.body().applyCentralImpulse(btVector3(blow, 0, 0));
      if (n == 1) run.ship.body().applyCentralImpulse(btVector3(0, blow, 0));
      if (n == 2)
        run.ship.body().applyTorqueImpulse(btVector3(0, 0, static_cast<btScalar>(length) * blow));
      after[n] = sample(run, passage.speed);
    }
  }
};

/// Least squares of one mode; the phase is that of the wave at the ship's mean way.
Complex harmonic(const Samples& samples, const OwnMotions& own, int mode,
                 const std::vector<double>& phase) {
  const auto rows = static_cast<Eigen::Index>(samples.time.size());
  Eigen::MatrixXd basis(rows, 7);
  for (Eigen::Index i = 0; i < rows; ++i) {
    const auto n = static_cast<std::size_t>(i);
    const double middle = (samples.time[n] - 0.5 * (kFrom + kUntil)) / (0.5 * (kUntil - kFrom));
    basis.row(i) << 1.0, middle, std::cos(phase[n]), -std::sin(phase[n]),
        own.after[0].motion(i, mode), own.after[1].motion(i, mode), own.after[2].motion(i, mode);
  }
  const Eigen::VectorXd fit = leastSquares(basis, samples.motion.col(mode));
  return {fit[2], fit[3]};
}

/// Amplitude for which k|η| < 0.01, at the ends of the ship too.
double smallAmplitude(const CVec6& rao, double waveNumber) {
  const double half = 0.5 * coarseFrigate()->length();
  const double most = std::max({std::abs(rao[Surge]), std::abs(rao[Sway]), std::abs(rao[Heave]),
                                half * std::abs(rao[Pitch]), half * std::abs(rao[Yaw])});
  return std::min(0.01, 0.009 / (waveNumber * most));
}

CVec6 inBullet(const Passage& passage, const OwnMotions& own, double omega, const CVec6& rao) {
  const double k = omega * omega / kGravity, amplitude = smallAmplitude(rao, k);
  const SeaState sea({{omega, amplitude, 0.0, passage.heading}}, kGravity, kRamp);
  OneShip run(coarseFrigate(), sea, settingsOf(passage));
  const Samples samples = sample(run, passage.speed);
  std::vector<double> phase(samples.time.size());
  for (std::size_t i = 0; i < phase.size(); ++i) phase[i] = metAt(passage, omega) * samples.time[i];
  // The ship's actual way is a straight line near the nominal one, by which the phase is wrong.
  Eigen::MatrixXd line(samples.motion.rows(), 4);
  for (Eigen::Index i = 0; i < line.rows(); ++i) {
    const auto n = static_cast<std::size_t>(i);
    line.row(i) << 1.0, samples.time[n], std::cos(phase[n]), std::sin(phase[n]);
  }
  const Eigen::MatrixXd way = leastSquares(line, samples.motion.leftCols(2));
  for (std::size_t i = 0; i < phase.size(); ++i) {
    const double x = way(0, 0) + way(1, 0) * samples.time[i];
    const double y = way(0, 1) + way(1, 1) * samples.time[i];
    phase[i] -= k * (x * std::cos(passage.heading) - y * std::sin(passage.heading));
  }
  CVec6 found;
  for (int j = 0; j < 6; ++j) found[j] = harmonic(samples, own, j, phase) / amplitude;
  return found;
}

/// Loads that answer the slow motion, the actual one less w of the linear answer ξ₀
/// (FreeResponse::share): nothing to speak of where ω_e ≥ 0.3, nearly all of the motion at 0.1,
/// where the ship rides the wave. They are those of the autopilots, and the trim of a steady way
/// that is taken off, U²A₃₁. Dξ = F − K(ξ − wξ₀), so (1 + D⁻¹K)ξ = (1 + wD⁻¹K)ξ₀.
CVec6 withSlowLoads(const Passage& passage, double omega, const CVec6& free) {
  const FreeResponse& ship = coarseFrigate()->freeResponse();
  const Coefficients& c = coarseFrigate()->coefficients();
  const Mat6 mass = c.ship.massMatrix() + c.addedMass.atInfinity;
  const SpeedKeeper engine;
  const CourseKeeper helm;
  const Complex s(0.0, metAt(passage, omega));
  CMat6 slow = CMat6::Zero();
  slow(Pitch, Surge) = 2.0 * passage.speed * ship.addedMassAtRest()(Heave, Surge) * s;
  if (passage.keepers) {
    const double stiff = mass(Yaw, Yaw) * helm.rate * helm.rate +
                         passage.speed * passage.speed * 1.5 *
                             (c.addedMass.atZero(Sway, Sway) - c.addedMass.atZero(Surge, Surge));
    if (passage.speed > 0.0)
      slow(Surge, Surge) = mass(Surge, Surge) * engine.rate * (2.0 * s + engine.rate);
    slow(Yaw, Yaw) = stiff + 2.0 * std::sqrt(stiff * mass(Yaw, Yaw)) * s;
  }
  CMat6 answer = CMat6::Zero();
  for (const int mode : {Surge, Yaw})
    answer.col(mode) = ship.at(s.imag(), {passage.speed, 0.0}, slow.col(mode), {}).motion;
  const CMat6 one = CMat6::Identity();
  return (one + answer).partialPivLu().solve((one + ship.share(s.imag()) * answer) * free);
}

/// Largest of each mode where ω_e ≥ 0.3.
Vec6 peaks(const FrequencyResponse& response, const Passage& passage) {
  Vec6 peak = Vec6::Zero();
  for (int i = 6; i <= 32; ++i) {
    const double omega = 0.05 * i;
    if (std::abs(metAt(passage, omega)) < 0.3) continue;
    peak = peak.cwiseMax(response.at(omega, passage.heading, passage.speed).cwiseAbs());
  }
  return peak;
}

/// How far two amplitudes are apart.
struct Apart {
  double size = 0.0, degrees = 0.0;
  Apart() = default;
  Apart(const Complex& found, const Complex& theory)
      : size(std::abs(std::abs(found) - std::abs(theory))),
        degrees(std::abs(std::arg(found / theory)) / kDegree) {}
  void most(double otherSize, double otherDegrees) {
    size = std::max(size, otherSize);
    degrees = std::max(degrees, otherDegrees);
  }
};

/// Worst of all passages, by mode: sizes in % of the peak, in slow waves of the mode's own.
struct Worst {
  std::array<Apart, 6> met{}, slow{}, slowBare{};
  double absent = 0.0;
};

/// Acceptance: 1 % of the mode's peak and 3 degrees, the phase where the amplitude is above 20 % of
/// the peak: below, 1 % of the peak is more than 3 degrees. Where ω_e < 0.3, 3 % of its own and 5
/// degrees.
void compareMode(const Passage& passage, double omega, int mode, const Complex& found,
                 const Complex& free, const Complex& slowed, double peak, Worst& worst) {
  const auto n = static_cast<std::size_t>(mode);
  char where[120];
  std::snprintf(where, sizeof where, "%s: %.2f m/s, heading %.0f, omega %.2f, keepers %s",
                kModeNames[mode], passage.speed, passage.heading / kDegree, omega,
                passage.keepers ? "on" : "off");
  if (peak < 1e-9) {
    worst.absent = std::max(worst.absent, std::abs(found));
  } else if (std::abs(metAt(passage, omega)) < 0.3) {
    const Apart bare(found, free), apart(found, slowed);
    const double size = 100.0 * apart.size / std::abs(slowed);
    EXPECT_LE(size, 3.0) << where;
    EXPECT_LE(apart.degrees, 5.0) << where;
    worst.slow[n].most(size, apart.degrees);
    worst.slowBare[n].most(100.0 * bare.size / std::abs(free), bare.degrees);
  } else {
    const Apart apart(found, free);
    const double degrees = std::abs(free) > 0.2 * peak ? apart.degrees : 0.0;
    EXPECT_LE(100.0 * apart.size / peak, 1.0) << where;
    EXPECT_LE(degrees, 3.0) << where;
    worst.met[n].most(100.0 * apart.size / peak, degrees);
  }
}

void compare(const Passage& passage, const std::vector<double>& omegas, Worst& worst) {
  const FrequencyResponse response(coarseFrigate()->coefficients(), FrequencyResponse::Free{});
  const OwnMotions own(passage);
  const Vec6 peak = peaks(response, passage);
  for (const double omega : omegas) {
    if (std::abs(metAt(passage, omega)) < kLeastEncounterFrequency) continue;
    const CVec6 free = response.at(omega, passage.heading, passage.speed);
    const CVec6 slowed = withSlowLoads(passage, omega, free);
    const CVec6 found = inBullet(passage, own, omega, free);
    for (int j = 0; j < 6; ++j)
      compareMode(passage, omega, j, found[j], free[j], slowed[j], peak[j], worst);
  }
}

void record(const Worst& worst, double knots, bool keepers) {
  char of[80];
  std::snprintf(of, sizeof of, "free ship, %2.0f knots, 12 headings, keepers %s: ", knots,
                keepers ? "on" : "off");
  Apart slow, bare;
  for (std::size_t j = 0; j < 6; ++j) {
    const std::string what = std::string(of) + kModeNames[j] + ", ";
    recordResult(kTopic, what + "amplitude [% of peak]", "rao --free", worst.met[j].size, "1");
    recordResult(kTopic, what + "phase [deg]", "rao --free", worst.met[j].degrees, "3");
    slow.most(worst.slow[j].size, worst.slow[j].degrees);
    bare.most(worst.slowBare[j].size, worst.slowBare[j].degrees);
  }
  const std::string met = std::string(of) + "worst mode met at 0.1 to 0.3 rad/s, ";
  const char* theory = "rao --free and loads of the slow motion";
  recordResult(kTopic, met + "amplitude [%]", theory, slow.size, "3");
  recordResult(kTopic, met + "phase [deg]", theory, slow.degrees, "5");
  recordResult(kTopic, met + "amplitude [%], these left out", "rao --free", bare.size, "stated");
  recordResult(kTopic, met + "phase [deg], these left out", "rao --free", bare.degrees, "stated");
  recordResult(kTopic, std::string(of) + "motion absent by symmetry [m/m, rad/m]", "0",
               worst.absent, "1e-3");
  EXPECT_LE(worst.absent, 1e-3) << of;
}

/// Of one speed, a test of its own: its full size takes a minute.
class FreeShipRaoIdentity : public testing::TestWithParam<double> {};

// Normally one heading a speed; at 20 knots one wave is met at ω_e = 0.13.
TEST_P(FreeShipRaoIdentity, SmallMotionsAreThoseOfTheLinearisedShip) {
  const double knots = GetParam();
  for (const bool keepers : {false, true}) {
    Worst worst;
    const int shortest = knots > 15.0 ? (keepers ? 30 : 0) : keepers ? 240 : 30;
    for (int degrees = 0; degrees < 360; degrees += 30) {
      if (!fullSize() && degrees != shortest) continue;
      const std::vector<double> omegas =
          fullSize() ? std::vector<double>{0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0, 1.3, 1.6}
                     : std::vector<double>{0.4, 0.6, 0.8, 1.2};
      compare({knots * kKnot, degrees * kDegree, keepers}, omegas, worst);
    }
    record(worst, knots, keepers);
  }
}

INSTANTIATE_TEST_SUITE_P(Knots, FreeShipRaoIdentity, testing::Values(0.0, 5.0, 10.0, 20.0));

}  // namespace
}  // namespace cutwater::test
