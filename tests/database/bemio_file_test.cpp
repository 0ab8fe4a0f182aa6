#include "hydro/database/BemioLayout.h"
#include "tests/database/FileTest.h"

// The same file without our group, as another code would have written it.
namespace cutwater {
namespace {

using test::Edit, test::sampleShip;
using BemioFile = test::FileTest;

/// The sample ship with damping that takes energy from every mode.
Coefficients dampedShip() {
  Coefficients c = sampleShip();
  for (Mat6& b : c.damping) b.diagonal() = b.diagonal().cwiseAbs();
  return c;
}

double largestDifference(const std::vector<Mat6>& a, const std::vector<Mat6>& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    largest = std::max(largest, (a[i] - b[i]).cwiseAbs().maxCoeff() / a[i].cwiseAbs().maxCoeff());
  }
  return largest;
}

// The way through BEMIO and back divides and multiplies by ρ, ρω, ρg and a phase: round-off
// remains.
TEST_F(BemioFile, GivesTheSameShipAtZeroSpeed) {
  const Coefficients c = sampleShip();
  writeCoefficients(c, path());
  Edit(path()).remove("cutwater");
  std::string warning;
  const Coefficients back = readCoefficients(path(), &warning);
  EXPECT_EQ(warning.find(path()), 0u);
  EXPECT_EQ(warning.find('\n'), std::string::npos);
  for (const char* word : {"hull", "gyradii", "A(0)", "adjoint"}) {
    EXPECT_NE(warning.find(word), std::string::npos) << warning;
  }
  EXPECT_LT(largestDifference(c.addedMass.values, back.addedMass.values), 1e-15);
  EXPECT_LT(largestDifference(c.damping.values, back.damping.values), 1e-15);
  EXPECT_LT((c.addedMass.atInfinity - back.addedMass.atInfinity).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_LT((c.ship.restoring - back.ship.restoring).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_EQ(back.ship.mass, c.ship.density * c.ship.volume);
  EXPECT_EQ(back.addedMass.atZero, back.addedMass.values.front());
  const std::vector<std::size_t> order{3, 0, 1, 2};  // by β
  ASSERT_EQ(back.headings.size(), 4u);
  for (std::size_t h = 0; h < 4; ++h) {
    const double turn = back.headings[h] - c.headings[order[h]];
    EXPECT_NEAR(std::remainder(turn, 2.0 * kPi), 0.0, 1e-14);
  }
}

TEST_F(BemioFile, GivesTheSameExcitation) {
  const Coefficients c = sampleShip();
  writeCoefficients(c, path());
  Edit(path()).remove("cutwater");
  const Coefficients back = readCoefficients(path());
  for (std::size_t h = 0; h < 4; ++h) {
    std::size_t same = 0;
    while (std::abs(std::remainder(back.headings[h] - c.headings[same], 2.0 * kPi)) > 1e-9) ++same;
    for (std::size_t i = 0; i < c.omega.size(); ++i) {
      const double scale = 1e-14 * c.froudeKrylov[same][i].norm();
      EXPECT_LT((back.froudeKrylov[h][i] - c.froudeKrylov[same][i]).norm(), scale);
      EXPECT_LT((back.diffraction[h][i] - c.diffraction[same][i]).norm(), 10.0 * scale);
    }
  }
}

// Another code's author answers for its grid: its file counts as given, whatever the grid.
TEST_F(BemioFile, CountsAsGivenAndSaysWhatItLacks) {
  writeCoefficients(dampedShip(), path());
  Edit(path()).remove("cutwater");
  std::vector<std::string> missing;
  const Coefficients c = readBemio(hdf5::Reader(path()), missing);
  EXPECT_EQ(c.status, CoefficientStatus::Given);
  EXPECT_NO_THROW(requireFinished(c, "time domain"));
  ASSERT_EQ(missing.size(), 3u);
  EXPECT_NE(missing[0].find("gyradii"), std::string::npos);
  EXPECT_NE(missing[1].find("mass"), std::string::npos);
  EXPECT_NE(missing[2].find("A(0)"), std::string::npos);
}

TEST_F(BemioFile, ForeignTrapsAreMet) {
  const Coefficients c = sampleShip();
  writeCoefficients(c, path());
  {
    Edit edit(path());
    edit.remove("cutwater");
    // Froude-Krylov not computed: NaN.  Depth in metres: k h = 0.05 at the lowest frequency.
    edit.set("body1/hydro_coeffs/excitation/froude-krylov/re", std::nan(""));
    edit.set("body1/hydro_coeffs/excitation/scattering/re", std::nan(""));
    edit.remove("simulation_parameters/water_depth");
    edit.newNumbers("simulation_parameters/water_depth", {1, 1}, 50.0);
    // Two bodies: 12 columns; body 1's own are the first six.
    edit.remove("body1/hydro_coeffs/added_mass/inf_freq");
    edit.newNumbers("body1/hydro_coeffs/added_mass/inf_freq", {6, 12}, 2.0);
    edit.newNumbers("body2", {1, 1}, 1.0);
  }
  std::string warning;
  const Coefficients back = readCoefficients(path(), &warning);
  EXPECT_EQ(back.addedMass.atInfinity, Mat6::Constant(2.0 * c.ship.density));
  for (const char* word : {"Froude-Krylov", "water depth 50 m", "body1 alone"}) {
    EXPECT_NE(warning.find(word), std::string::npos) << warning;
  }
  const CVec6 total = back.froudeKrylov[0][1] + back.diffraction[0][1];
  EXPECT_LT((total - c.froudeKrylov[3][1] - c.diffraction[3][1]).norm(), 1e-13 * total.norm());
}

TEST_F(BemioFile, ForeignFilesThatCannotBeRightAreRefused) {
  const auto faultAfter = [&](auto&& change) {
    writeCoefficients(sampleShip(), path());
    {
      Edit edit(path());
      edit.remove("cutwater");
      change(edit);
    }
    return faultOf(path());
  };
  const char* mass = "body1/hydro_coeffs/added_mass/all";
  EXPECT_EQ(faultAfter([](Edit& e) { e.set("simulation_parameters/scaled", 1.0); }),
            Fault::FormatNotSupported);
  EXPECT_EQ(faultAfter([&](Edit& e) { e.set(mass, std::nan("")); }), Fault::ValueOutOfRange);
  EXPECT_EQ(faultAfter([](Edit& e) { e.set("simulation_parameters/w", 1.0); }),
            Fault::FrequenciesNotIncreasing);
  EXPECT_EQ(faultAfter([&](Edit& e) { e.remove(mass); }), Fault::DatabaseIncomplete);
  EXPECT_EQ(faultAfter([&](Edit& e) {
              e.remove(mass);
              e.newNumbers(mass, {6, 6, 4}, 1.0);
            }),
            Fault::FileMalformed);
  // More numbers than the file holds: refused before anything is allocated.
  EXPECT_EQ(faultAfter([&](Edit& e) {
              e.remove("simulation_parameters/w");
              e.newNumbers("simulation_parameters/w", {hsize_t{1} << 40, 1}, 0.0);
            }),
            Fault::FileMalformed);
}

}  // namespace
}  // namespace cutwater
