#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "hydro/files/MeshIO.h"
#include "hydro/geometry/shapes/Shapes.h"
#include "tests/support/CsvTable.h"
#include "tests/support/Results.h"
#include "tests/verification/WigleyHull.h"

// Forward speed on Wigley III in head waves: both forms beside another 3-D code and Journée's
// experiments. Frequencies solved are exactly those met, so nothing is interpolated.
namespace cutwater::test {
namespace {

constexpr ForwardSpeedForm kReport = ForwardSpeedForm::Report, kTuck = ForwardSpeedForm::Tuck;
const char* const kTopic = "forward speed";

/// By the name of a quantity.
using Values = std::map<std::string, double>;

std::string at(double froude) { return "Fn " + std::to_string(froude).substr(0, 3); }

/// Below it the water inside the hull has no standing wave: inside the box around it (L 3, B 0.3,
/// d 0.1875 m), which holds the hull, the lowest has K = κ coth κd, κ = π√(1/L² + 1/B²). As
/// ω√(L/g), 5.73. A code without lid is not to be trusted above.
double firstInnerResonance() {
  const double kappa = kPi * std::hypot(1.0 / 3.0, 1.0 / 0.3);
  return std::sqrt(kWigleyLength * kappa / std::tanh(kappa * 0.1875));
}

struct OtherCode {
  HeadWave wave;
  double frequency;  // ω_e √(L/g)
  Values values;
};

std::vector<OtherCode> otherCode() {
  const CsvTable table("verification/wigley3_capytaine.csv");
  std::vector<OtherCode> rows;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    OtherCode row{
        {table.number(i, "Fn"), table.number(i, "lambda_over_L")},
        table.number(i, "omega_e_nd"),
        {{"heave", table.number(i, "heave_RAO")}, {"pitch", table.number(i, "pitch_over_ka")}}};
    for (const char* name : {"a33", "b33", "a55", "b55", "a35", "b35", "a53", "b53", "X3", "X5"})
      row.values[name] = table.number(i, name);
    rows.push_back(row);
  }
  return rows;
}

/// Greatest value of each curve of the other code, over all its waves at one Froude number.
Values peaks(const std::vector<OtherCode>& rows, double froude) {
  Values peak;
  for (const OtherCode& row : rows)
    if (row.wave.froude == froude)
      for (const auto& [name, value] : row.values)
        peak[name] = std::max(peak[name], std::abs(value));
  return peak;
}

/// Worst distance of the report's form from the other code's, per cent of each curve's peak at that
/// Froude number. Couplings at rest are 0 on this hull and left out.
Values distances(const SurfaceMesh& wet, const std::vector<OtherCode>& all,
                 const std::vector<OtherCode>& rows, const SolveSettings& settings) {
  std::vector<double> omega;
  for (const OtherCode& row : rows) omega.push_back(row.wave.omegaE());
  const SolverOutput solved = solveWigley(wet, omega, settings);
  Values worst;
  for (const OtherCode& row : rows) {
    const Values got = response(solved, row.wave, kReport);
    const Values peak = peaks(all, row.wave.froude);
    for (const auto& [name, value] : row.values)
      if (peak.at(name) > 1e-3)
        worst[name] = std::max(worst[name], 100.0 * std::abs(got.at(name) - value) / peak.at(name));
  }
  return worst;
}

SolveSettings twoThreads() {
  SolveSettings settings;
  settings.threads = 2;
  return settings;
}

/// How the other code solves: sources, collocated, without lid, ∂φ/∂x = Hσ.
SolveSettings asTheOtherCode() {
  SolveSettings settings = twoThreads();
  settings.formulation = Formulation::Source;
  settings.derivatives = Derivatives::Source;
  settings.galerkinPoints = 1;
  settings.panelShape = PanelShape::Flat;
  settings.lid = false;
  return settings;
}

SurfaceMesh shippedMesh() {
  return wetSurface(readHull(std::string(CUTWATER_MESHES) + "/wigley/wigley_iii_400.obj"));
}

/// The other code's panels: 40 × 10, x = (0.6 cos + 0.4 linear) L/2, z = −d sin.
SurfaceMesh meshOfTheOtherCode() {
  constexpr int kAlong = 40, kGirth = 10;
  SurfaceMesh mesh;
  for (int i = 0; i <= kAlong; ++i)
    for (int j = 0; j <= kGirth; ++j) {
      const double u = static_cast<double>(i) / kAlong;
      const double xi = -0.6 * std::cos(kPi * u) + 0.4 * (2.0 * u - 1.0);
      const double zeta = j == kGirth ? 1.0 : std::sin(0.5 * kPi * j / kGirth);
      const double y = (1.0 - zeta * zeta) * (1.0 - xi * xi) * (1.0 + 0.2 * xi * xi);
      const bool ends = i == 0 || i == kAlong || j == kGirth;
      mesh.vertices.emplace_back(1.5 * xi, ends ? 0.0 : 0.15 * y, -0.1875 * zeta);
    }
  const int row = kGirth + 1;
  for (int i = 0; i < kAlong; ++i)
    for (int j = 0; j < kGirth; ++j) {
      const int corner = i * row + j;
      mesh.faces.push_back({{corner, corner + row, corner + row + 1, corner + 1}});
    }
  return mesh;
}

// 5 % of each curve's peak is the acceptance line; 3.4 % is reached, in a53. Potentials against
// sources on these panels make up to 1.5 % (a33, in which speed has no part), ∂φ/∂x by Stokes'
// theorem against the source layer's gradient up to 3 % (a53, b53); heave and pitch multiply both
// near resonance. The next test takes both away. With more panels the other code's method comes
// towards ours: at Fn 0.3, λ/L 1.25 on 784 and 1600 a33 is 0.4065 and 0.4043 by it, 0.3983 and
// 0.3988 by ours, heave 1.746 and 1.739 against 1.724 and 1.725 (flat panels). Left out are the
// waves met beyond the first irregular frequency, λ/L 0.5 at speed and 0.75 at Fn 0.4; why is a
// test below.
TEST(WigleyVerification, ReportsFormIsTheOtherCodesBelowItsIrregularFrequencies) {
  const std::vector<OtherCode> all = otherCode();
  std::vector<OtherCode> rows;
  for (const OtherCode& row : all) {
    EXPECT_NEAR(reducedFrequency(row.wave.omegaE()), row.frequency, 6e-5);  // as printed
    if (row.frequency > firstInnerResonance()) continue;
    const bool some = (row.wave.froude == 0.2 || row.wave.froude == 0.3) &&
                      row.wave.lambda >= 1.0 && row.wave.lambda <= 2.0 && row.wave.lambda != 1.384;
    if (some || fullSize()) rows.push_back(row);
  }
  std::vector<std::pair<std::string, SurfaceMesh>> meshes{{"400 a side", shippedMesh()}};
  if (fullSize()) meshes.emplace_back("432 a side", wetWigley(wigley(3), 54, 8));
  for (const auto& [size, wet] : meshes)
    for (const auto& [name, percent] : distances(wet, all, rows, twoThreads())) {
      const std::string what = "Wigley III, " + size + ", report's form, Fn 0 to 0.4, " + name;
      recordResult(kTopic, what + ", worst, % of the curve's peak", "Capytaine, direct", percent,
                   "<= 5");
      EXPECT_LE(percent, 5.0) << what;
    }
}

// On the other code's panels, solved as it does, nothing is left that could hide an error in the
// formulas of speed: 1 %, its four printed digits being 0.05 % of most peaks and its quadrature of
// the wave term not ours.
TEST(WigleyVerification, OtherCodesMethodGivesItsNumbers) {
  const std::vector<OtherCode> all = otherCode();
  std::vector<OtherCode> rows;
  for (const OtherCode& row : all)
    if (row.frequency < firstInnerResonance() && (fullSize() || row.wave.froude == 0.3))
      rows.push_back(row);
  double worst = 0.0;
  for (const auto& [name, percent] : distances(meshOfTheOtherCode(), all, rows, asTheOtherCode())) {
    EXPECT_LE(percent, 1.0) << name;
    worst = std::max(worst, percent);
  }
  recordResult(
      kTopic,
      "Wigley III, sources, collocated, no lid, H, all quantities, Fn 0 to 0.4, worst, % of "
      "the curve's peak",
      "Capytaine, direct", worst, "<= 1");
}

// At Fn 0.2, λ/L 0.5, ω_e√(L/g) = 6.058, the other code is far off: b33 by 10 %, b53 by 39 % of the
// peak. Its first irregular frequency is at 6.11: without lid the condition number of the even
// system is there over ten times that at 5.4, and solved on its panels as it does we get its
// outlier, to 0.9 %; 5 % as everywhere.
TEST(WigleyVerification, OutlierOfTheOtherCodeIsAnIrregularFrequency) {
  const std::vector<OtherCode> all = otherCode();
  const auto outlier = std::find_if(all.begin(), all.end(), [](const OtherCode& row) {
    return row.wave.froude == 0.2 && row.wave.lambda == 0.5;
  });
  ASSERT_NE(outlier, all.end());
  ASSERT_GT(outlier->frequency, firstInnerResonance());
  const double ours = distances(shippedMesh(), all, {*outlier}, twoThreads()).at("b53");
  const SurfaceMesh wet = meshOfTheOtherCode();
  const double itsOwn = distances(wet, all, {*outlier}, asTheOtherCode()).at("b53");
  recordResult(kTopic, "Wigley III, Fn 0.2, lambda/L 0.5, b53, % of the peak",
               "Capytaine beside its irregular frequency", ours, "none");
  recordResult(kTopic, "the same, solved by sources, collocated, no lid, H",
               "Capytaine beside its irregular frequency", itsOwn, "<= 5");
  EXPECT_GT(ours, 30.0);
  EXPECT_LE(itsOwn, 5.0);
  const SolverOutput without = solveWigley(wet, {omegaOf(5.4), omegaOf(6.1)}, asTheOtherCode());
  EXPECT_GT(without.conditionEven[1], 10.0 * without.conditionEven[0]);
}

/// The greatest of a column's values at one Froude number.
double greatest(const CsvTable& table, const std::string& column, double froude) {
  double most = 0.0;
  for (std::size_t row = 0; row < table.rows(); ++row)
    if (table.number(row, "Fn") == froude)
      most = std::max(most, std::abs(table.number(row, column)));
  return most;
}

// 5 % is the acceptance line, of the greatest of the few values at a Froude number, as these are no
// whole curves; 1.9 % is reached, by b35 = U A33 in which A33 is 2 % of itself lower than by
// sources. The other code's motions have the exciting force of the report's form, and so have ours
// here.
TEST(WigleyVerification, TucksFormIsTheOtherCodes) {
  const CsvTable table("verification/wigley3_formulations.csv");
  std::vector<HeadWave> waves;
  std::vector<double> omega;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    waves.push_back({table.number(i, "Fn"), table.number(i, "lambda_over_L")});
    omega.push_back(waves.back().omegaE());
  }
  const SolverOutput solved = solveWigley(shippedMesh(), omega, twoThreads());
  Values worst;
  for (std::size_t i = 0; i < waves.size(); ++i) {
    const HeadWave& wave = waves[i];
    Values got;
    for (const auto& [name, value] :
         reducedCoefficients(solved, wave.omegaE(), wave.speed(), kTuck))
      if (name == "a35" || name == "a53" || name == "b35" || name == "b53")
        got[name + "_STF"] = value;
    for (const auto& [form, ending] : {std::pair{kReport, "direct"}, {kTuck, "STF"}}) {
      const Values motions = mixedMotions(solved, wave, form, kReport);
      got["heave_" + std::string(ending)] = motions.at("heave");
      got["pitch_ka_" + std::string(ending)] = motions.at("pitch");
    }
    for (const auto& [column, value] : got)
      worst[column] = std::max(worst[column], 100.0 * std::abs(value - table.number(i, column)) /
                                                  greatest(table, column, wave.froude));
  }
  ASSERT_EQ(worst.size(), 8u);
  for (const auto& [column, percent] : worst) {
    const std::string what = "Wigley III, 400 a side, Fn 0.2 and 0.3, " + column;
    recordResult(kTopic, what + ", worst, % of the greatest", "Capytaine", percent, "<= 5");
    EXPECT_LE(percent, 5.0) << what;
  }
}

struct Measured {
  std::string quantity;
  double froude, lambda, frequency, value;
  bool inWaves() const { return !std::isnan(lambda); }
  HeadWave wave() const { return {froude, lambda}; }
  double omegaE() const { return inWaves() ? wave().omegaE() : omegaOf(frequency); }
  std::string label() const {
    const double at = inWaves() ? lambda : frequency;
    return "Wigley III, " + test::at(froude) + (inWaves() ? ", lambda/L " : ", omega' ") +
           std::to_string(at).substr(0, 5) + ", " + quantity;
  }
};

std::vector<Measured> experiment() {
  const CsvTable table("verification/wigley3_experiment.csv");
  std::vector<Measured> rows;
  for (std::size_t i = 0; i < table.rows(); ++i)
    rows.push_back({table.text(i, "quantity"), table.number(i, "Fn"),
                    table.number(i, "lambda_over_L"), table.number(i, "w"),
                    table.number(i, "value")});
  return rows;
}

double computed(const SolverOutput& solved, const Measured& point, ForwardSpeedForm form) {
  const Values values =
      point.inWaves()
          ? response(solved, point.wave(), form)
          : reducedCoefficients(solved, point.omegaE(), HeadWave{point.froude, 1.0}.speed(), form);
  return values.at(point.quantity);
}

/// Of A33, B33 and all at rest both forms have the same: one line.
void record(const Measured& point, double report, double tuck) {
  if (point.inWaves() && point.lambda < 0.99) return;
  const std::string measured = "Journee: " + std::to_string(point.value).substr(0, 5);
  const bool same = std::abs(report - tuck) < 1e-6;
  recordResult(kTopic, point.label() + (same ? "" : ", report's form"), measured, report, "none");
  if (!same) recordResult(kTopic, point.label() + ", Tuck's form", measured, tuck, "none");
}

// The evidence between the forms is which is nearer. Heave: Tuck's at every measured point at
// speed. Pitch damping at Fn 0.3: the report's, Tuck's is 44 % too high; at Fn 0.2 they lie 8 %
// below and 9 % above. Bounds: wave loads within 10 % in both forms, twice the scatter of Journée's
// measured coefficients; at rest, where the two are one, heave within 0.05 in waves as long as the
// hull: measured amplitudes are printed to 0.01 and scatter by several of it (0.04 between 0.22 and
// 0.19).
TEST(WigleyVerification, ExperimentsFavourTucksFormInHeaveAndTheReportsInPitchDamping) {
  std::vector<Measured> points;
  std::vector<double> omega;
  for (const Measured& point : experiment()) {
    const bool some =
        point.froude > 0.0 && (point.inWaves() ? point.lambda < 1.9 : point.quantity == "b55");
    if (!some && !fullSize()) continue;
    points.push_back(point);
    omega.push_back(point.omegaE());
  }
  const SolverOutput solved = solveWigley(shippedMesh(), omega, twoThreads());
  for (const Measured& point : points) {
    SCOPED_TRACE(point.label());
    const double report = computed(solved, point, kReport), tuck = computed(solved, point, kTuck);
    record(point, report, tuck);
    const double reportOff = std::abs(report - point.value), tuckOff = std::abs(tuck - point.value);
    if (point.quantity == "heave" && point.froude > 0.0) {
      EXPECT_LT(tuckOff, reportOff);
    } else if (point.quantity == "heave" && point.lambda > 0.99) {
      EXPECT_LT(tuckOff, 0.05);
    } else if (point.quantity == "b55" && point.froude == 0.3) {
      EXPECT_LT(reportOff, tuckOff);
    } else if (point.quantity[0] == 'X') {
      EXPECT_LT(std::max(reportOff, tuckOff), 0.1 * point.value);
    }
  }
}

}  // namespace
}  // namespace cutwater::test
