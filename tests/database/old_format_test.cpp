#include <gtest/gtest.h>

#include <cmath>

#include "hydro/memory/RetardationMatrix.h"
#include "hydro/response/FrequencyResponse.h"
#include "tests/database/FileTest.h"

// hemisphere_0.1.0.h5: a hemisphere of 12 panels a side and 10 frequencies, written by version
// 0.1.0 (file format 2). What follows from it is what the command of 0.1.0 printed, nine digits.
// Databases of a released version are read for ever.
namespace cutwater::test {
namespace {

constexpr const char* kOldFile = CUTWATER_TEST_DATA "/database/hemisphere_0.1.0.h5";
constexpr double kDigits = 1e-8;  // of numbers printed with nine digits

TEST(OldFormatRegression, ADatabaseOfTheFirstVersionGivesItsAnswers) {
  std::string warning = "unset";
  const Coefficients c = readCoefficients(kOldFile, &warning);
  EXPECT_EQ(warning, "");
  EXPECT_EQ(c.provenance.version, "0.1.0");
  EXPECT_EQ(c.status, CoefficientStatus::Finished);
  EXPECT_EQ(c.panelShape, PanelShape::FlattenedOnly);
  EXPECT_NEAR(c.addedMass.atInfinity(2, 2), 107522.348, kDigits * 107522.348);
  EXPECT_NEAR(c.damping[2](2, 2), 71214.2171, kDigits * 71214.2171);
  const CVec6 motion = FrequencyResponse(c).at(0.9, 150.0 * kPi / 180.0, 2.0);
  EXPECT_NEAR(std::abs(motion[Heave]), 1.93343917, kDigits * 1.93343917);
  EXPECT_NEAR(std::arg(motion[Heave]) * 180.0 / kPi, -17.7866186, kDigits * 180.0);
  EXPECT_NEAR(std::abs(motion[Sway]), 0.272006106, kDigits);
  const Mat6 K = RetardationMatrix(c).at(0.5);
  EXPECT_NEAR(K(2, 2), 51975.8105, kDigits * 51975.8105);
  EXPECT_NEAR(K(4, 0), 19370.1212, kDigits * 19370.1212);
}

using OldFormat = FileTest;

// Written again it is of this version, and says the same.
TEST_F(OldFormat, IsWrittenAsThisVersion) {
  const Coefficients c = readCoefficients(kOldFile);
  writeCoefficients(c, path());
  const Coefficients again = readCoefficients(path());
  EXPECT_EQ(again.status, CoefficientStatus::Finished);
  EXPECT_EQ(again.addedMass.values, c.addedMass.values);
  EXPECT_EQ(again.adjointX.values, c.adjointX.values);
  EXPECT_EQ(again.ship.hull.faces.size(), 96u);
}

// Version 5 did not know the file that its hull was read from: hull axes, metres.
TEST_F(OldFormat, WithoutThePlacementOfItsFileItIsInHullAxes) {
  writeCoefficients(sampleShip(), path());
  {
    Edit edit(path());
    for (const char* name : {"rotation", "metres_per_unit", "origin"})
      edit.remove((std::string("cutwater/ship/file/") + name).c_str());
    edit.version(5);
    edit.renewChecksum();
  }
  const FilePlacement file = readCoefficients(path()).ship.file;
  EXPECT_TRUE(file.rotation.isIdentity(0.0));
  EXPECT_EQ(file.metresPerUnit, 1.0);
  EXPECT_TRUE(file.origin.isZero(0.0));
  EXPECT_TRUE(readCoefficients(kOldFile).ship.file.rotation.isIdentity(0.0));
}

// Version 6 knew no drag, engine or rudder: the drag of every ship, and neither of the others.
TEST_F(OldFormat, WithoutAnEngineItHasNone) {
  writeCoefficients(sampleShip(), path());
  {
    Edit edit(path());
    for (const char* name : {"resistance", "engine", "rudder"})
      edit.remove((std::string("cutwater/ship/") + name).c_str());
    edit.version(6);
    edit.renewChecksum();
  }
  const ShipParticulars ship = readCoefficients(path()).ship;
  EXPECT_EQ(ship.drag.crossFlow, HullDrag{}.crossFlow);
  EXPECT_EQ(ship.drag.formFactor, HullDrag{}.formFactor);
  EXPECT_FALSE(ship.engine);
  EXPECT_FALSE(ship.rudder);
}

// Version 2 did not say whether it was finished; without a consistent A(inf) it was not.
TEST_F(OldFormat, WithoutAConsistentLimitItIsUnfinished) {
  Coefficients c = sampleShip();
  c.provenance.version = "0.1.0";
  c.addedMassInfDirect.setZero();
  writeCoefficients(c, path());
  {
    Edit edit(path());  // which takes the seal off
    edit.remove("cutwater/status");
    edit.remove("cutwater/unfinished_because");
    edit.version(2);
    edit.renewChecksum();
  }
  const Coefficients back = readCoefficients(path());
  EXPECT_EQ(back.status, CoefficientStatus::Unfinished);
  EXPECT_NE(back.unfinishedBecause.find("solve again"), std::string::npos);
}

}  // namespace
}  // namespace cutwater::test
