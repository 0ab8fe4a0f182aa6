#include <gtest/gtest.h>

#include <cmath>

#include "hydro/Errors.h"
#include "hydro/waves/SeaState.h"
#include "hydro/waves/Spectrum.h"
#include "hydro/waves/Wave.h"

namespace cutwater {
namespace {

constexpr double kG = 9.81;

TEST(AiryWaveIdentity, VelocityIsTheGradientOfThePotential) {
  const AiryWave wave{0.9, 0.7, kG};
  const Vec3 x(3.0, -2.0, -4.0);
  const double h = 1e-4;  // central differences: error k³h²/6 ≈ 1e-12, round-off 1e-16·φ/h ≈ 1e-11
  for (int axis = 0; axis < 3; ++axis) {
    Vec3 step = Vec3::Zero();
    step[axis] = h;
    const Complex slope = (wave.potential(x + step) - wave.potential(x - step)) / (2.0 * h);
    EXPECT_LT(std::abs(slope - wave.velocity(x)[axis]), 1e-9);
  }
}

TEST(AiryWaveIdentity, SatisfiesTheFreeSurfaceCondition) {
  const AiryWave wave{1.3, 2.1, kG};
  const Vec3 x(5.0, 1.0, 0.0);
  // −ω²φ + gφ_z = 0 to round-off.
  EXPECT_LT(std::abs(-1.69 * wave.potential(x) + kG * wave.velocity(x).z()), 1e-12);
}

TEST(AiryWaveIdentity, ElevationIsThePressureOfThePotential) {
  // ζ = −(1/g) ∂φ/∂t = −(iω/g) φ: the crest is at the origin at t = 0.
  const AiryWave wave{0.8, 0.3, kG};
  const Complex zeta = -Complex(0, 0.8) / kG * wave.potential(Vec3::Zero());
  EXPECT_NEAR(zeta.real(), 1.0, 1e-14);
  EXPECT_NEAR(zeta.imag(), 0.0, 1e-14);
}

TEST(SeaStateClosedForm, CrestRunsTowardsItsHeadingAtPhaseSpeed) {
  const double omega = 0.7, beta = 150.0 * kPi / 180.0, t = 11.0;
  const SeaState sea({{omega, 2.0, 0.0, beta}}, kG);
  const double travelled = kG / omega * t;
  EXPECT_NEAR(sea.elevation(t, travelled * std::cos(beta), -travelled * std::sin(beta)), 2.0,
              1e-12);
}

TEST(SeaStateClosedForm, HeadSeaComesFromTheBowAndNinetyDegreesFromPort) {
  // β = 180°: travels to −x; β = 90°: towards −y, that is from port (+y).
  const SeaState head({{1.0, 1.0, 0.0, kPi}}, kG), beam({{1.0, 1.0, 0.0, kPi / 2}}, kG);
  const double step = 0.1, run = kG * step;
  EXPECT_NEAR(head.elevation(step, -run, 0.0), 1.0, 1e-12);
  EXPECT_NEAR(beam.elevation(step, 0.0, -run), 1.0, 1e-12);
}

/// Five components, so that the last block of four is not full, and none is alike.
SeaState anySea(double ramp = 0.0) {
  std::vector<WaveComponent> waves;
  for (int i = 0; i < 5; ++i) waves.push_back({0.5 + 0.3 * i, 1.0 / (1 + i), 0.7 * i, 1.3 * i});
  return {waves, kG, ramp};
}

TEST(SeaStateIdentity, ElevationIsTheSumOfItsWaves) {
  const SeaState sea = anySea();
  for (const double t : {0.0, 7.3, 4000.0}) {
    double sum = 0.0;
    for (const WaveComponent& w : sea.components()) {
      const double along = 31.0 * std::cos(w.heading) + 17.0 * std::sin(w.heading);
      sum += w.amplitude * std::cos(w.omega * t - w.omega * w.omega / kG * along + w.phase);
    }
    EXPECT_NEAR(sea.elevation(t, 31.0, -17.0), sum, 1e-11);  // round-off of phases up to 7000
  }
  EXPECT_EQ(SeaState().elevation(1.0, 2.0, 3.0), 0.0);
  EXPECT_EQ(SeaState().velocity(1.0, Vec3(1.0, 2.0, -3.0)), Vec3::Zero().eval());
}

// Central differences with h = 1e-4: error (k h)²/6 or (ω h)²/6 of values of order 1, round-off
// 1e-16/h.
TEST(SeaStateIdentity, WaterAtTheSurfaceRisesWithIt) {
  const SeaState sea = anySea();
  const double h = 1e-4;
  for (const double t : {0.5, 3.1, 50.0}) {
    const double rise =
        (sea.elevation(t + h, 4.0, -9.0) - sea.elevation(t - h, 4.0, -9.0)) / (2 * h);
    EXPECT_NEAR(sea.velocity(t, Vec3(4.0, -9.0, 0.0)).z(), rise, 1e-8);
  }
  EXPECT_EQ(sea.velocity(1.0, Vec3(4.0, -9.0, 2.0)), sea.velocity(1.0, Vec3(4.0, -9.0, 0.0)));
}

TEST(SeaStateIdentity, WaterTurnsNowhereAndKeepsItsVolume) {
  const SeaState sea = anySea();
  const Vec3 place(4.0, -9.0, -3.0);
  const double h = 1e-4, t = 2.2;
  Eigen::Matrix3d slope;  // ∂v_i/∂x_j
  for (int j = 0; j < 3; ++j) {
    const Vec3 step = h * Vec3::Unit(j);
    slope.col(j) = (sea.velocity(t, place + step) - sea.velocity(t, place - step)) / (2 * h);
  }
  EXPECT_LT((slope - slope.transpose()).norm(), 1e-8);
  EXPECT_NEAR(slope.trace(), 0.0, 1e-8);
  EXPECT_GT(slope.norm(), 0.1);
}

TEST(SeaState, GrowsFromRestOverTheRamp) {
  const SeaState sea({{1.0, 1.0, 0.0, 0.0}}, kG, 10.0);
  EXPECT_EQ(sea.ramp(0.0), 0.0);
  EXPECT_NEAR(sea.ramp(5.0), 0.5, 1e-15);
  EXPECT_EQ(sea.ramp(10.0), 1.0);
}

TEST(SeaState, RefusesNonsenseNamingComponentAndValue) {
  try {
    SeaState({{1.0, 1.0, 0.0, 0.0}, {-2.0, 1.0, 0.0, 0.0}}, kG);
    FAIL();
  } catch (const HydroError& error) {
    EXPECT_EQ(error.fault(), Fault::ValueOutOfRange);
    EXPECT_NE(std::string(error.what()).find("component 1: omega = -2"), std::string::npos);
  }
}

double zerothMoment(const Spectrum& spectrum) {
  double sum = 0.0;
  const double step = 5e-3;  // trapezoid on a smooth density that vanishes at both ends
  for (int i = 1; i < 8000; ++i) sum += step * spectrum(step * i);
  return sum;
}

TEST(SpectrumIdentity, EnergyGivesTheSignificantHeight) {
  for (const auto shape : {SpectrumShape::Jonswap, SpectrumShape::Bretschneider}) {
    const Spectrum spectrum{shape, 4.0, 10.0, 3.3, kG};
    // 1e-5: the energy above 40 rad/s is (5/4)(ω_p/ω)⁴/5 < 1e-7, the rest is the trapezoid's.
    EXPECT_NEAR(4.0 * std::sqrt(zerothMoment(spectrum)), 4.0, 1e-5 * 4.0);
  }
}

TEST(SpectrumClosedForm, JonswapPeakIsGammaTimesBretschneider) {
  // Same shape at ω_p but for the common normalisation, which is the ratio far from the peak.
  const Spectrum jonswap{SpectrumShape::Jonswap, 3.0, 9.0, 3.3, kG};
  const Spectrum plain{SpectrumShape::Bretschneider, 3.0, 9.0, 1.0, kG};
  const double peak = plain.peakFrequency(), far = 3.0 * peak;
  EXPECT_NEAR(jonswap(peak) / plain(peak) / (jonswap(far) / plain(far)), 3.3, 1e-12);
}

TEST(SpectrumClosedForm, FullyDevelopedSeaHasItsPeakAtFourTenthsRootGOverHs) {
  const Spectrum sea{SpectrumShape::PiersonMoskowitz, 4.0, 0.0, 1.0, kG};
  EXPECT_NEAR(sea.peakFrequency(), 0.4 * std::sqrt(kG / 4.0), 1e-15);
}

TEST(SpectrumClosedForm, SpreadingFollowsCosineToTheTwoS) {
  // For D ∝ cos^{2s}(θ/2), E[cos θ] = s/(s+1).
  SeaStateSettings settings;
  settings.spreading = 4.0;
  settings.components = 20000;
  const SeaState sea = makeSeaState(Spectrum{}, settings);
  double mean = 0.0;
  for (const auto& c : sea.components()) mean += std::cos(c.heading) / settings.components;
  EXPECT_NEAR(mean, 0.8, 0.006);  // three standard errors: σ(cos θ) ≈ 0.24, /√20000, × 3
}

TEST(SpectrumRegression, TheSameSeedIsTheSameSea) {
  const SeaState a = makeSeaState(Spectrum{}, {}), b = makeSeaState(Spectrum{}, {});
  EXPECT_EQ(a.elevation(12.3, 4.0, 5.0), b.elevation(12.3, 4.0, 5.0));
}

// Bretschneider: ∫_0^ω S = (hs²/16) e^{−(5/4)(ω_p/ω)⁴}.
TEST(SpectrumClosedForm, ShareOfEnergyBetweenTwoFrequencies) {
  const Spectrum spectrum{.shape = SpectrumShape::Bretschneider, .hs = 2.5, .tp = 7.0};
  const double peak = spectrum.peakFrequency();
  const auto below = [](double ratio) { return std::exp(-1.25 * std::pow(ratio, -4.0)); };
  for (const auto& [from, to] : {std::pair{0.5, 4.0}, {0.9, 1.1}, {2.0, 2.001}, {3.3, 29.0}}) {
    const double share = shareOfEnergy(spectrum, from * peak, to * peak);
    EXPECT_NEAR(share, below(to) - below(from), 1e-9);  // five Gauss points in cells of 0.02 ω_p
  }
  EXPECT_EQ(shareOfEnergy(spectrum, 3.0, 2.0), 0.0);
  EXPECT_NEAR(shareOfEnergy(spectrum, 0.0, 1e9), 1.0, 1e-9);
}

TEST(Spectrum, RefusesNonsenseNamingTheField) {
  using Change = void (*)(Spectrum&, SeaStateSettings&, double);
  const struct {
    const char* name;
    Change set;
    double absurd;
  } fields[] = {
      {"hs", [](auto& s, auto&, double x) { s.hs = x; }, 1e6},
      {"tp", [](auto& s, auto&, double x) { s.tp = x; }, -1.0},
      {"gamma", [](auto& s, auto&, double x) { s.gamma = x; }, 1e3},
      {"gravity", [](auto& s, auto&, double x) { s.gravity = x; }, 0.0},
      {"heading", [](auto&, auto& s, double x) { s.heading = x; }, std::nan("")},
      {"spreading", [](auto&, auto& s, double x) { s.spreading = x; }, -1.0},
      {"components", [](auto&, auto& s, double) { s.components = 0; }, 0.0},
      {"omega_min", [](auto&, auto& s, double x) { s.omegaMin = x; }, -1.0},
      {"omega_max", [](auto&, auto& s, double x) { s.omegaMax = x; }, 1e-3},
      {"ramp", [](auto&, auto& s, double x) { s.ramp = x; }, -1.0},
      {"member", [](auto& s, auto&, double) { s.member = 11; }, 0.0},
  };
  for (const auto& field : fields) {
    for (const double value : {std::nan(""), HUGE_VAL, -HUGE_VAL, field.absurd}) {
      Spectrum spectrum;
      SeaStateSettings settings;
      field.set(spectrum, settings, value);
      try {
        makeSeaState(spectrum, settings);
        ADD_FAILURE() << field.name << " = " << value << " was accepted";
      } catch (const HydroError& error) {
        EXPECT_NE(std::string(error.what()).find(std::string(field.name) + " = "),
                  std::string::npos)
            << error.what();
      }
    }
  }
}

std::string refusalOf(const std::function<void()>& make) {
  try {
    make();
  } catch (const HydroError& error) {
    EXPECT_EQ(error.fault(), Fault::ValueOutOfRange);
    return error.what();
  }
  return {};
}

// Headings beyond a turn are degrees.
TEST(WaveHeadings, DegreesAreRefused) {
  const auto component = [](double heading) {
    return refusalOf([&] { SeaState({{.omega = 1.0, .heading = heading}}, kG); });
  };
  const auto spectrum = [](double heading) {
    return refusalOf([&] { makeSeaState(Spectrum{}, {.heading = heading}); });
  };
  for (const double heading : {150.0, -90.0, 6.4}) {
    for (const std::string& said : {component(heading), spectrum(heading)}) {
      EXPECT_NE(said.find("radians; did you mean degrees?"), std::string::npos) << said;
      EXPECT_NE(said.find("heading = "), std::string::npos) << said;
    }
  }
  EXPECT_NE(component(180.0).find("component 0: heading = 180"), std::string::npos);
  for (const double heading : {360.0 * (kPi / 180.0), -2.0 * kPi}) {
    EXPECT_EQ(component(heading), "");
    EXPECT_EQ(spectrum(heading), "");
  }
}

// A short-crested sea on a mean heading of a turn is that on a mean heading of 0.
TEST(WaveHeadingsIdentity, SpreadingDoesNotLeaveTheTurn) {
  const SeaStateSettings settings{.spreading = 1.0};
  SeaStateSettings turned = settings;
  turned.heading = 2.0 * kPi;
  const SeaState a = makeSeaState(Spectrum{}, settings), b = makeSeaState(Spectrum{}, turned);
  for (std::size_t i = 0; i < a.components().size(); ++i) {
    const double between = a.components()[i].heading - b.components()[i].heading;
    EXPECT_LT(std::abs(std::remainder(between, 2.0 * kPi)), 4e-15);
    EXPECT_LE(std::abs(b.components()[i].heading), 2.0 * kPi);
  }
}

}  // namespace
}  // namespace cutwater
