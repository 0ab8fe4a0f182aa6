#include "hydro/database/BemioContradictions.h"
#include "tests/database/FileTest.h"

// Files of other codes whose numbers contradict each other, and messages that say where.
namespace cutwater {
namespace {

using test::Edit, test::sampleShip;
using Contradictions = test::FileTest;

/// Added mass and damping that a ship of 4795 m³ may have.
Coefficients plainShip() {
  Coefficients c = sampleShip();
  for (std::size_t i = 0; i < c.omega.size(); ++i) {
    c.addedMass[i].diagonal() = Vec6(1, 2, 3, 40, 500, 600) * 1e6;
    c.damping[i].diagonal() = Vec6(1, 2, 3, 40, 500, 600) * 1e5;
  }
  c.addedMass.atInfinity.diagonal() = Vec6(1, 2, 3, 40, 500, 600) * 1e6;
  return c;
}

TEST_F(Contradictions, AreNoneInSoundNumbers) {
  EXPECT_TRUE(bemioContradictions(plainShip()).empty());
}

TEST_F(Contradictions, ALimitOfZeroNamesItsModes) {
  Coefficients c = plainShip();
  c.addedMass.atInfinity(Heave, Heave) = c.addedMass.atInfinity(Yaw, Yaw) = 0.0;
  const auto lines = bemioContradictions(c);
  ASSERT_EQ(lines.size(), 1u);
  for (const char* word : {"added_mass/inf_freq", "A_33, A_66", "not computed"})
    EXPECT_NE(lines[0].find(word), std::string::npos) << lines[0];
  // The yaw of a body of revolution has no added mass at any frequency: nothing is missing.
  for (Mat6& a : c.addedMass.values) a(Yaw, Yaw) = 1e-9;
  c.addedMass.atInfinity(Heave, Heave) = 1.0;
  EXPECT_TRUE(bemioContradictions(c).empty());
}

TEST_F(Contradictions, NegativeDampingNamesModeAndFrequencies) {
  Coefficients c = plainShip();
  c.damping[1](Heave, Heave) = c.damping[3](Heave, Heave) = -2e4;
  c.damping[2](Sway, Heave) = -9e9;             // outside the diagonal a sign says nothing
  c.damping[2](Pitch, Pitch) = -0.009 * 500e5;  // less than 1 % of its largest
  const auto lines = bemioContradictions(c);
  ASSERT_EQ(lines.size(), 1u);
  for (const char* word : {"radiation_damping/all", "B_33 < 0", "0.25, 0.9 rad/s"})
    EXPECT_NE(lines[0].find(word), std::string::npos) << lines[0];
}

TEST_F(Contradictions, LeaveAFileToTheFrequencyDomain) {
  Coefficients c = plainShip();
  c.damping[1](Heave, Heave) = -2e4;
  writeCoefficients(c, path());
  Edit(path()).remove("cutwater");
  std::string warning;
  const Coefficients back = readCoefficients(path(), &warning);
  EXPECT_EQ(back.status, CoefficientStatus::Unfinished);
  EXPECT_NE(warning.find("B_33 < 0 at omega = 0.25 rad/s"), std::string::npos) << warning;
  EXPECT_THROW(requireFinished(back, "time domain"), HydroError);
}

TEST_F(Contradictions, NumbersThatAreNoneNameModesAndFrequency) {
  const auto said = [&](auto&& change) -> std::string {
    Coefficients c = plainShip();
    change(c);
    try {
      writeCoefficients(c, path());
    } catch (const HydroError& error) {
      return error.what();
    }
    return "written";
  };
  const auto has = [](const std::string& text, const char* word) {
    EXPECT_NE(text.find(word), std::string::npos) << text;
  };
  const double nan = std::nan("");
  const std::string mass = said([&](auto& c) { c.addedMass[2](Pitch, Heave) = nan; });
  has(mass, "added_mass[2, 4, 2] at omega = 0.5 rad/s (j = 5, k = 3) is nan");
  has(said([&](auto& c) { c.addedMass.atInfinity(0, 5) = nan; }), "added_mass_inf[0, 5] (j = 1, k");
  has(said([&](auto& c) { c.omega[3] = nan; }), "omega[3] is nan");
  has(said([&](auto& c) { c.ship.mass = nan; }), "ship/mass is nan");
  has(said([](auto& c) { c.omega[3] = 0.5; }),
      "omega[3] = 0.5 rad/s: must be above the one before, 0.5");
  has(said([](auto& c) { c.omega[0] = 0.0; }), "omega[0] = 0 rad/s: the first must be above 0");
}

}  // namespace
}  // namespace cutwater
