#include "hydro/waves/Spectrum.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>

#include "hydro/Errors.h"
#include "hydro/waves/SeaStatistics.h"
#include "tests/support/CsvTable.h"

namespace cutwater {
namespace {

using test::CsvTable;

// Nine or ten digits are printed: half of the last one is 5e-9 of a number that begins with 1.
constexpr double kPrinted = 6e-9;

void expectPrinted(double found, double printed, const std::string& of) {
  EXPECT_NEAR(found, printed, kPrinted * std::abs(printed)) << of;
}

Spectrum jonswapOf(double gamma, JonswapNormalisation normalisation = JonswapNormalisation::Exact) {
  return {.hs = 4.0, .tp = 8.0, .gamma = gamma, .normalisation = normalisation};
}

TEST(SpectrumVerification, ValuesAreThoseOfOtherCodes) {
  const CsvTable values("waves/spectra_values.csv"), family("waves/ochi_hubble_family.csv");
  int ochiHubble = 0;
  for (std::size_t row = 0; row < values.rows(); ++row) {
    const std::string& model = values.text(row, "model");
    Spectrum spectrum{.hs = values.number(row, "Hs_m")};
    double published = 1.0;  // what the published shares of Ochi and Hubble add up to
    if (model == "ochi_hubble") {
      ++ochiHubble;
      spectrum.shape = SpectrumShape::OchiHubble;
      spectrum.member = static_cast<int>(values.number(row, "gamma_or_member"));
      const auto of = static_cast<std::size_t>(spectrum.member);
      published = std::pow(family.number(of, "h1"), 2.0) + std::pow(family.number(of, "h2"), 2.0);
    } else {
      spectrum.tp = values.number(row, "Tp_s");
      spectrum.gamma = values.number(row, "gamma_or_member");
      if (model == "bretschneider_ittc_pm") spectrum.shape = SpectrumShape::Bretschneider;
      if (model == "jonswap_dnv") spectrum.normalisation = JonswapNormalisation::Dnv;
    }
    const double omega = values.number(row, "omega_rad_s");
    expectPrinted(published * spectrum(omega), values.number(row, "S"),
                  model + " at " + std::to_string(omega));
  }
  EXPECT_GE(values.rows(), 1000U);
  EXPECT_GE(ochiHubble, 11 * 2 * 24);
}

TEST(SpectrumVerification, MomentsOfJonswapOverItsPeakedness) {
  const CsvTable table("waves/spectra_moments.csv");
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const double gamma = table.number(row, "gamma");
    const Spectrum s = jonswapOf(gamma);
    const double m0 = s.moment(0), of = 2.0 * kPi / s.tp;
    const auto near = [&](double found, const char* column) {
      // Eight decimals are printed.
      EXPECT_NEAR(found, table.number(row, column), 6e-9) << column << " of gamma " << gamma;
    };
    near(of * m0 / s.moment(1), "Tm01_over_Tp");
    near(of * std::sqrt(m0 / s.moment(2)), "Tz_over_Tp");
    near(of * s.moment(-1) / m0, "Te_over_Tp");
    near(s(of) * of / 16.0, "S_peak_times_wp_over_Hs2");
    const double dnv = jonswapOf(gamma, JonswapNormalisation::Dnv).significantHeight();
    EXPECT_NEAR(100.0 * (dnv / 4.0 - 1.0), table.number(row, "Hs_error_of_dnv_percent"), 6e-5);
    EXPECT_NEAR(m0, 1.0, 1e-12);  // quadrature against itself
  }
  EXPECT_EQ(table.rows(), 11U);
}

// m_n = (hs²/16) (5 ω_p⁴/4)^{n/4} Γ(1 − n/4).
TEST(SpectrumClosedForm, MomentsOfBretschneider) {
  const Spectrum s{.shape = SpectrumShape::Bretschneider, .hs = 3.0, .tp = 9.0};
  const double tp = 9.0, m0 = 9.0 / 16.0;
  EXPECT_NEAR(s.moment(0), m0, 1e-15);
  EXPECT_NEAR(2.0 * kPi * m0 / s.moment(1) / tp, 1.0 / (std::pow(1.25, 0.25) * std::tgamma(0.75)),
              1e-14);
  EXPECT_NEAR(2.0 * kPi * std::sqrt(m0 / s.moment(2)) / tp, std::pow(1.25 * kPi, -0.25), 1e-14);
  EXPECT_EQ(s.moment(4), HUGE_VAL);
  // The tail of this member of Ochi and Hubble's is ω^{−2.6} in 7 m: m1 is finite, m2 is not.
  const Spectrum flat{.shape = SpectrumShape::OchiHubble, .hs = 7.0, .member = 4};
  EXPECT_LT(flat.moment(1), HUGE_VAL);
  EXPECT_EQ(flat.moment(2), HUGE_VAL);
}

TEST(SpectrumIdentity, SharesOfAllFrequenciesAddUpToOne) {
  for (int member = 0; member <= 10; ++member) {
    const Spectrum s{.shape = SpectrumShape::OchiHubble, .hs = 5.0, .member = member};
    // Quadrature of 2 % cells, and 1e-8 of the energy beyond its end for λ = 0.38.
    EXPECT_NEAR(shareOfEnergy(s, 0.0, 1e9), 1.0, 2e-8) << member;
    EXPECT_NEAR(4.0 * std::sqrt(s.moment(0)), 5.0, 1e-12);
    EXPECT_NEAR(shareOfEnergy(s, 0.0, 0.8) + shareOfEnergy(s, 0.8, 1e9), 1.0, 2e-8);
  }
}

TEST(SpreadingVerification, DensitiesAndWidths) {
  const CsvTable table("waves/spreading_values.csv");
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const auto law = table.text(row, "form") == "cosn" ? SpreadingLaw::CosN : SpreadingLaw::Cos2s;
    const double exponent = table.number(row, "parameter"),
                 degrees = table.number(row, "theta_deg");
    const double printed = table.number(row, "D");
    const std::string of =
        table.text(row, "form") + " " + std::to_string(exponent) + " at " + std::to_string(degrees);
    // At the law's end D is the round-off of a cosine, to some power, there.
    const double found = spreadingDensity(law, exponent, degrees * (kPi / 180.0));
    EXPECT_NEAR(found, printed, kPrinted * printed + 1e-15) << of;
    EXPECT_NEAR(spreadingWidth(law, exponent) * 180.0 / kPi, table.number(row, "sigma_deg"), 6e-6)
        << of;
  }
  EXPECT_GT(table.rows(), 90U);
}

// A component's direction is one draw of D: √(2(1 − mean cos)) is σ.
TEST(SpreadingIdentity, DirectionsOfASeaAreSpreadAsTheLawSays) {
  for (const auto law : {SpreadingLaw::Cos2s, SpreadingLaw::CosN}) {
    for (const double exponent : {1.0, 2.0, 10.0}) {
      const int count = 20000;
      const SeaState sea = makeSeaState(
          Spectrum{}, {.heading = 1.0, .spreading = exponent, .components = count, .law = law});
      double cosine = 0.0, square = 0.0, sine = 0.0;
      for (const WaveComponent& wave : sea.components()) {
        const double c = std::cos(wave.heading - 1.0);
        cosine += c / count, square += c * c / count, sine += std::sin(wave.heading - 1.0) / count;
        EXPECT_GE(c, law == SpreadingLaw::CosN ? 0.0 : -1.0);
      }
      const double width = spreadingWidth(law, exponent);
      // Four standard errors of the mean.
      const double error = 4.0 * std::sqrt((square - cosine * cosine) / count);
      EXPECT_NEAR(cosine, 1.0 - 0.5 * width * width, error);
      EXPECT_NEAR(sine, 0.0, 4.0 * std::sqrt((1.0 - square) / count));
    }
  }
}

SpectrumTable anyTable() { return {{0.3, 0.5, 0.9, 2.0}, {0.0, 2.0, 0.7, 0.0}}; }

std::vector<Spectrum> oneOfEach() {
  return {{.shape = SpectrumShape::Jonswap, .hs = 2.0, .tp = 9.0},
          {.hs = 2.0, .gamma = 7.0, .normalisation = JonswapNormalisation::Dnv},
          {.shape = SpectrumShape::Bretschneider, .hs = 2.0},
          {.shape = SpectrumShape::PiersonMoskowitz, .hs = 2.0, .tp = 0.0},
          {.shape = SpectrumShape::OchiHubble, .hs = 2.0, .member = 4},
          {.shape = SpectrumShape::Table, .table = anyTable()}};
}

// 1e-12: round-off of 10 000 squares.
TEST(RealisedSeaIdentity, HeightIsWhatWasAskedForWhateverTheNumberOfWaves) {
  for (const Spectrum& spectrum : oneOfEach()) {
    for (const int count : {1, 2, 7, 200, 10000}) {
      for (const double last : {0.0, 1.1}) {
        const SeaState sea = makeSeaState(spectrum, {.components = count, .omegaMax = last});
        EXPECT_NEAR(momentsOf(sea).significantHeight(), spectrum.significantHeight(), 1e-12);
        EXPECT_EQ(sea.components().size(), static_cast<std::size_t>(count));
      }
    }
    if (spectrum.shape != SpectrumShape::Table &&
        spectrum.normalisation == JonswapNormalisation::Exact) {
      EXPECT_NEAR(spectrum.significantHeight(), 2.0, 1e-12);
    }
  }
}

// Between the same limits the components' moments are the spectrum's, to the width of a bin: a
// place is drawn within it, so that the error is of the order of width/√count.
TEST(RealisedSeaIdentity, MomentsAreThoseOfTheSpectrum) {
  const Spectrum s{.hs = 2.0};
  const SeaState sea = makeSeaState(s, {.components = 20000, .omegaMin = 0.2, .omegaMax = 20.0});
  const SeaMoments found = momentsOf(sea);
  EXPECT_NEAR(found.m1, s.moment(1), 1e-4 * s.moment(1));
  // The tail beyond 20 rad/s: 2 (ω_p/20)² 5/16 · … of m2, 0.1 %.
  EXPECT_NEAR(found.m2, s.moment(2), 2e-3 * s.moment(2));
}

TEST(SeaSystemsIdentity, HeightsAddUpInSquares) {
  const SeaSystem wind{{.hs = 2.0, .tp = 6.0}, {.heading = 3.0, .spreading = 4.0}};
  const SeaSystem swell{{.hs = 1.5, .tp = 14.0, .gamma = 7.0}, {.heading = 2.0, .components = 50}};
  const SeaState both = makeSeaState(std::vector{wind, swell});
  EXPECT_NEAR(momentsOf(both).significantHeight(), 2.5, 1e-12);
  ASSERT_EQ(both.components().size(), 250U);
  const SeaState alone = makeSeaState(wind.spectrum, wind.settings);
  for (std::size_t i = 0; i < 200; ++i) {
    EXPECT_EQ(both.components()[i].omega, alone.components()[i].omega);
    EXPECT_EQ(both.components()[i].phase, alone.components()[i].phase);
  }
  EXPECT_EQ(both.components()[249].heading, 2.0);
  // Two alike draw different numbers, or their heights would add up.
  const SeaState twice = makeSeaState(std::vector{wind, wind});
  EXPECT_NE(twice.components()[0].phase, twice.components()[200].phase);
}

TEST(SeaSystems, RefuseWhatOneSeaCannotHaveTwiceOver) {
  const auto refusal = [](const std::vector<SeaSystem>& systems) -> std::string {
    try {
      makeSeaState(systems);
    } catch (const HydroError& error) {
      EXPECT_EQ(error.fault(), Fault::BadArgument);
      return error.what();
    }
    return {};
  };
  EXPECT_NE(refusal({}).find("no system"), std::string::npos);
  SeaSystem other;
  other.settings.ramp = 5.0;
  EXPECT_NE(refusal({{}, other}).find("system 1: ramp"), std::string::npos);
}

TEST(RepeatTimeClosedForm, OfOneWaveAndOfEqualSteps) {
  // To √(1e-16) of the place: the top of a maximum is flat.
  const SeaState one({{.omega = 0.7, .amplitude = 2.0}}, kStandardGravity);
  EXPECT_NEAR(repeatTime(one).time, 2.0 * kPi / 0.7, 1e-6);
  std::vector<WaveComponent> waves;
  for (int i = 0; i < 60; ++i)
    waves.push_back({.omega = 0.4 + 0.02 * i, .amplitude = 1.0 / (1 + i % 7), .phase = 1.0 * i});
  EXPECT_NEAR(repeatTime(SeaState(waves, kStandardGravity)).time, 2.0 * kPi / 0.02, 1e-5);
  EXPECT_EQ(repeatTime(SeaState()).time, HUGE_VAL);
}

TEST(RepeatTime, ASeaOfTheDefaultDoesNotRepeatWithinADay) {
  const RepeatTime found = repeatTime(makeSeaState(Spectrum{}, {}));
  EXPECT_EQ(found.time, HUGE_VAL);
  EXPECT_EQ(found.searched, 86400.0);
  // Of two waves the beat comes again, and is found.
  const SeaState two = makeSeaState(Spectrum{}, {.components = 2});
  const double again = repeatTime(two).time;
  ASSERT_LT(again, 86400.0);
  double correlation = 0.0, all = 0.0;
  for (const WaveComponent& wave : two.components()) {
    correlation += wave.amplitude * wave.amplitude * std::cos(wave.omega * again);
    all += wave.amplitude * wave.amplitude;
  }
  EXPECT_GE(correlation, kRepeated * all);
}

// Golden numbers of two components: mt19937_64 and our own uniform numbers are the same everywhere;
// 1e-9 is for the last bits of other libraries' exp and pow, and for the twelve digits here.
TEST(SeaStateRegression, TheSameSeedIsTheSameSeaOnEveryMachine) {
  const SeaState sea = makeSeaState(Spectrum{}, {.heading = 1.0, .spreading = 2.0, .seed = 42});
  const WaveComponent &first = sea.components()[3], &last = sea.components()[150];
  const auto near = [](double found, double golden) {
    EXPECT_NEAR(found, golden, 1e-9 * std::abs(golden));
  };
  near(first.omega, 0.392985281794);
  near(first.amplitude, 0.00205493283699);
  near(first.phase, 0.628613612148);
  near(first.heading, 1.1895089973);
  near(last.omega, 2.18767545987);
  near(last.amplitude, 0.0145438784426);
}

class TableFile : public testing::Test {
 protected:
  std::string refusal(const std::string& text) {
    const std::string path = testing::TempDir() + "spectrum_table.csv";
    std::ofstream(path) << text;
    try {
      table = readSpectrumTable(path);
    } catch (const HydroError& error) {
      const std::string said = error.what();
      EXPECT_EQ(said.rfind(path + ": ", 0), 0U) << said;
      EXPECT_EQ(said.find('\n'), std::string::npos);
      return said.substr(path.size() + 2);
    }
    return {};
  }
  SpectrumTable table;
};

TEST_F(TableFile, IsReadWithCommentsBlanksAndLineEndsOfOtherSystems) {
  EXPECT_EQ(refusal("# measured\r\n omega , S \r\n0.3, 0\r\n\r\n0.6,2.5e-1\r\n"), "");
  EXPECT_EQ(table.omega, (std::vector{0.3, 0.6}));
  EXPECT_EQ(table.density, (std::vector{0.0, 0.25}));
}

TEST_F(TableFile, IsRefusedWithLineAndValue) {
  const std::string head = "omega,S\n0.5,1.0\n";
  EXPECT_EQ(refusal("0.5,1.0\n"), "line 1: \"0.5,1.0\": must be the names of the columns, omega,S");
  EXPECT_EQ(refusal(head + "0.4,1.0\n"),
            "line 3: \"0.4,1.0\": omega must be above that of the line before");
  EXPECT_EQ(refusal(head + "0.5,1.0\n"),
            "line 3: \"0.5,1.0\": omega must be above that of the line before");
  EXPECT_EQ(refusal(head + "0.6,-1\n"), "line 3: \"0.6,-1\": S must be finite and 0 or more");
  EXPECT_EQ(refusal(head + "0.6,nan\n"), "line 3: \"0.6,nan\": S must be finite and 0 or more");
  EXPECT_EQ(refusal(head + "inf,1\n"), "line 3: \"inf,1\": omega must be finite and 0 or more");
  EXPECT_EQ(refusal(head + "0.6;1\n"),
            "line 3: \"0.6;1\": must be two numbers, omega [rad/s] and S [m2 s]");
  EXPECT_EQ(refusal(head), "line 2: ends; a spectrum needs two points or more");
  EXPECT_EQ(refusal("omega,S\n0.5,0\n0.6,0\n"), "line 3: ends; all S are 0");
  EXPECT_THROW(readSpectrumTable("/no/such/table.csv"), HydroError);
}

// Straight lines: area of triangles and trapezoids.
TEST(SpectrumTableClosedForm, HasItsOwnHeightPeakAndEnds) {
  const Spectrum s{.shape = SpectrumShape::Table, .table = anyTable()};
  const double m0 = 0.2 + 0.4 * 1.35 + 1.1 * 0.35;
  EXPECT_NEAR(s.moment(0), m0, 1e-15);
  EXPECT_NEAR(s.significantHeight(), 4.0 * std::sqrt(m0), 1e-14);
  EXPECT_EQ(s.peakFrequency(), 0.5);
  EXPECT_NEAR(s(0.4), 1.0, 1e-15);
  EXPECT_EQ(s(0.2), 0.0);
  EXPECT_EQ(s(2.1), 0.0);
  EXPECT_EQ(cutOffs(s, {}), std::pair(0.3, 2.0));
  EXPECT_NEAR(shareOfEnergy(s, 0.0, 0.5), 0.2 / m0, 1e-15);
  // ∫ ω S of the rise from (0.3, 0) to (0.5, 2): ∫₀^0.2 (0.3 + x) 10 x dx.
  Spectrum rise = s;
  rise.table = {{0.3, 0.5}, {0.0, 2.0}};
  EXPECT_NEAR(rise.moment(1), 0.3 * 0.2 + 10.0 * 0.008 / 3.0, 1e-15);
  rise.table = {{0.5, 0.5}, {0.0, 2.0}};
  EXPECT_THROW(makeSeaState(rise, {}), HydroError);
}

TEST(SpectrumTable, NoEnergyBetweenTheCutOffsIsRefused) {
  const Spectrum s{.shape = SpectrumShape::Table, .table = anyTable()};
  EXPECT_THROW(makeSeaState(s, {.omegaMin = 2.5, .omegaMax = 3.0}), HydroError);
}

}  // namespace
}  // namespace cutwater
