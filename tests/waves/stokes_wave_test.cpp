#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "hydro/Errors.h"
#include "hydro/waves/SeaState.h"
#include "hydro/waves/StokesWave.h"
#include "hydro/waves/WaterMotion.h"
#include "hydro/waves/WaterPressure.h"
#include "tests/support/CsvTable.h"

namespace cutwater {
namespace {

constexpr double kG = 9.81;

struct Row {
  std::string model;
  double length, height, crest, trough, uCrest, uTrough, uMean, uDeep, wDeep;
  double eighth, quarter, threeEighths, period;
};

std::vector<Row> table() {
  const test::CsvTable csv("waves/stokes_values.csv");
  std::vector<Row> rows;
  for (std::size_t i = 0; i < csv.rows(); ++i) {
    const auto n = [&](const char* column) { return csv.number(i, column); };
    rows.push_back({csv.text(i, "model"), n("lambda_m"), n("H_m"), n("eta_crest_m"),
                    n("eta_trough_m"), n("u_crest_surface"), n("u_trough_surface"), n("u_crest_z0"),
                    n("u_crest_zmH"), n("w_quarter_z_mH"), n("eta_x_lam8"), n("eta_x_lam4"),
                    n("eta_x_3lam8"), n("period_s")});
  }
  return rows;
}

/// Largest difference of a wave from a row: of heights [m], and of speeds [m/s].
std::array<double, 2> distance(const StokesWave::Series& s, const Row& row) {
  const auto at = [&](double share) { return s.elevationAt(2.0 * kPi * share); };
  double heights = 0.0, speeds = 0.0;
  for (const auto& [ours, theirs] : {std::pair{at(0.0), row.crest},
                                     {at(0.5), row.trough},
                                     {at(0.125), row.eighth},
                                     {at(0.25), row.quarter},
                                     {at(0.375), row.threeEighths}})
    heights = std::max(heights, std::abs(ours - theirs));
  for (const auto& [ours, theirs] : {std::pair{s.velocityAt(0.0, at(0.0))[0], row.uCrest},
                                     {-s.velocityAt(kPi, at(0.5))[0], -row.uTrough * -1.0},
                                     {s.velocityAt(0.0, 0.0)[0], row.uMean},
                                     {s.velocityAt(0.0, -row.height)[0], row.uDeep},
                                     {s.velocityAt(-0.5 * kPi, -row.height)[1], row.wDeep}})
    speeds = std::max(speeds, std::abs(std::abs(ours) - std::abs(theirs)));
  return {heights, speeds};
}

// Ten digits are printed.
TEST(StokesWaveClosedForm, IsTheSeriesThatOthersPrint) {
  int compared = 0;
  for (const Row& row : table()) {
    if (row.model == "fenton50") continue;
    const StokesWave wave(2.0 * kPi / row.period, 0.5 * row.height, kG,
                          row.model == "stokes2" ? 2 : 5);
    EXPECT_NEAR(wave.waveNumber() * row.length / (2.0 * kPi), 1.0, 2e-9) << row.model;
    const auto [heights, speeds] = distance(wave.series(1.0), row);
    EXPECT_LT(heights, 1e-8 * row.height) << row.model << row.height;
    EXPECT_LT(speeds, 1e-8) << row.model << row.height;
    ++compared;
  }
  EXPECT_EQ(compared, 12);
}

// What the next order would add: ε³ of second order, ε⁶ of fifth; its factor is below 3 for all
// that is compared. The stream function was solved to some 1e-6: its lowest crests lack the term
// ⅔ε⁴ that its higher ones have.
TEST(StokesWaveConvergence, ErrorsFallWithTheOrder) {
  for (const Row& row : table()) {
    if (row.model != "fenton50") continue;
    for (const int order : {2, 5}) {
      const double k = 2.0 * kPi / row.length, steepness = 0.5 * k * row.height;
      const double stretch =
          1.0 + 0.5 * steepness * steepness + (order == 5 ? 0.125 * std::pow(steepness, 4) : 0.0);
      const StokesWave wave(std::sqrt(kG * k) * stretch, 0.5 * row.height, kG, order);
      const auto [heights, speeds] = distance(wave.series(1.0), row);
      const double rest = 3.0 * std::pow(steepness, order + 1);
      EXPECT_LT(heights, rest / k + 1e-6) << order << ' ' << row.height;
      EXPECT_LT(speeds, rest * std::sqrt(kG / k) + 1e-6) << order << ' ' << row.height;
    }
  }
}

// Bernoulli's pressure of the potential is 0 on the surface but for the next order; so is what the
// surface moves away from the water.
TEST(StokesWaveConvergence, BothConditionsHoldOnTheSurface) {
  for (const int order : {2, 5}) {
    double before = 0.0;
    for (const double steepness : {0.2, 0.1, 0.05}) {
      const double omega = 1.0, amplitude = steepness * kG;  // k = ω²/g but for ε²
      const StokesWave wave(omega, amplitude, kG, order);
      const StokesWave::Series s = wave.series(1.0);
      double worst = 0.0;
      for (int i = 0; i < 64; ++i) {
        const double theta = 2.0 * kPi * i / 64.0, zeta = s.elevationAt(theta);
        const auto [along, up] = s.velocityAt(theta, zeta);
        const double leaves = (s.phaseSpeed - along) * s.slopeAt(theta) + up;
        worst = std::max({worst, wave.waveNumber() * std::abs(s.headAt(theta, zeta) - zeta),
                          std::abs(leaves) / s.phaseSpeed});
      }
      // Halved, a rest of order n + 1 falls by 2^{n+1}; a fifth less for the orders beyond.
      if (before > 0.0) {
        EXPECT_GT(before / worst, 0.8 * std::pow(2.0, order + 1)) << order;
      }
      before = worst;
    }
  }
}

// The acceleration at a place is the velocity's difference, and Euler's equation holds: the
// pressure's slope is what accelerates the water.
TEST(StokesWaveIdentity, PressureAcceleratesTheWater) {
  const double omega = 0.8, k = StokesWave(omega, 3.0, kG, 5).waveNumber(), h = 1e-5;
  const StokesWave::Series s = StokesWave(omega, 3.0, kG, 5).series(1.0);
  for (const double theta : {0.3, 1.4, 2.9, 4.6}) {
    const double z = -1.7;
    const auto rate = s.velocityRateAt(theta, z), v = s.velocityAt(theta, z);
    const auto later = s.velocityAt(theta + omega * h, z),
               earlier = s.velocityAt(theta - omega * h, z);
    const auto upper = s.velocityAt(theta, z + h), lower = s.velocityAt(theta, z - h);
    const auto ahead = s.velocityAt(theta - k * h, z), behind = s.velocityAt(theta + k * h, z);
    const double slopeX = (s.headAt(theta - k * h, z) - s.headAt(theta + k * h, z)) / (2.0 * h);
    const double slopeZ = (s.headAt(theta, z + h) - s.headAt(theta, z - h)) / (2.0 * h);
    for (std::size_t j = 0; j < 2; ++j) {
      EXPECT_NEAR(rate[j], (later[j] - earlier[j]) / (2.0 * h), 1e-8);
      const double carried =
          v[0] * (ahead[j] - behind[j]) / (2.0 * h) + v[1] * (upper[j] - lower[j]) / (2.0 * h);
      EXPECT_NEAR(rate[j] + carried, -kG * (j == 0 ? slopeX : slopeZ), 1e-8);
    }
  }
}

TEST(StokesWave, WavesThatBreakAndOtherOrdersAreRefused) {
  EXPECT_THROW(StokesWave(1.0, 5.5, kG, 2), HydroError);
  EXPECT_NO_THROW(StokesWave(1.0, 3.5, kG, 5));
  EXPECT_THROW(StokesWave(1.0, 1.0, kG, 3), HydroError);
  EXPECT_THROW(SeaState::steep({.omega = 1.0, .amplitude = 1.0}, kG, 4), HydroError);
}

// The sea, and what hulls and pictures ask of it, say the same as the series.
TEST(StokesWaveIdentity, TheSeaIsItsSeries) {
  const WaveComponent wave{0.9, 2.0, 0.4, 2.1};
  const SeaState sea = SeaState::steep(wave, kG, 5, 20.0);
  for (const double t : {8.0, 50.0}) {
    const StokesWave::Series s = sea.stokes()->series(sea.ramp(t));
    std::vector<double> x, y, z, zeta(16), head(16), surface(16), p(16), vx(16), vz(16);
    for (int i = 0; i < 16; ++i) {
      x.push_back(7.0 * i - 40.0);
      y.push_back(3.0 * (i % 5));
      z.push_back(-6.0 + 0.5 * i);
    }
    WaterPressure(sea).at(t, 10.0, 5.0, {x, y, z}, 100.0, {zeta, head, surface});
    WaterMotion(sea).at(t, 10.0, 5.0, {x, y, z},
                        {.velocityX = vx, .velocityZ = vz, .pressureHead = p});
    for (std::size_t i = 0; i < 16; ++i) {
      const double X = 10.0 + x[i], Y = 5.0 + y[i];
      const double theta =
          wave.omega * t + wave.phase -
          sea.waveNumber(0) * (X * std::cos(wave.heading) - Y * std::sin(wave.heading));
      const double exact = s.elevationAt(theta), level = std::min(z[i], exact);
      EXPECT_NEAR(sea.elevation(t, X, Y), exact, 1e-12);
      EXPECT_NEAR(zeta[i], exact, 1e-12);
      EXPECT_NEAR(head[i], s.headAt(theta, level), 1e-12);
      EXPECT_NEAR(surface[i], s.headAt(theta, exact), 1e-12);
      EXPECT_NEAR(p[i], z[i] < exact ? s.headAt(theta, z[i]) - z[i] : 0.0, 1e-12);
      const Vec3 v = sea.velocity(t, {X, Y, z[i]});
      EXPECT_NEAR(v.x(), s.velocityAt(theta, level)[0] * std::cos(wave.heading), 1e-12);
      EXPECT_NEAR(vx[i], v.x(), 1e-12);
      EXPECT_NEAR(vz[i], v.z(), 1e-12);
      std::vector<Phasors4> phasors(sea.phasorBlocks());
      sea.phasors(t, X, Y, phasors);
      EXPECT_NEAR(sea.elevation(phasors, t), exact, 1e-12);
    }
  }
}

}  // namespace
}  // namespace cutwater
