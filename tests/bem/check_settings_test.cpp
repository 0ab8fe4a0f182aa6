#include <gtest/gtest.h>

#include <cmath>

#include "hydro/Errors.h"
#include "hydro/bem/settings/CheckSettings.h"
#include "hydro/geometry/shapes/Shapes.h"

// What is refused before anything is computed, and in which words.
namespace cutwater::test {
namespace {

ShipParticulars anyShip() {
  ShipParticulars ship;
  ship.wetSurface = wetHalfEllipsoid({10.0, 3.0, 2.0}, 4, 2);
  ship.symmetric = true;
  return ship;
}

SolveSettings anySettings() {
  SolveSettings settings;
  settings.omega = {0.4, 0.9};
  return settings;
}

/// Refusal with this fault and all of these words in its one line.
void expectRefused(const ShipParticulars& ship, const SolveSettings& settings, Fault fault,
                   std::initializer_list<const char*> words) {
  try {
    check(ship, settings);
    ADD_FAILURE() << "accepted: " << *words.begin();
  } catch (const HydroError& error) {
    const std::string text = error.what();
    EXPECT_EQ(error.fault(), fault) << text;
    EXPECT_EQ(text.find('\n'), std::string::npos);
    for (const char* word : words)
      EXPECT_NE(text.find(word), std::string::npos) << word << " is missing in: " << text;
  }
}

void expectRefused(const SolveSettings& settings, Fault fault,
                   std::initializer_list<const char*> words) {
  expectRefused(anyShip(), settings, fault, words);
}

TEST(CheckSettings, AcceptsAnOrdinarySweep) {
  SolveSettings settings = anySettings();
  EXPECT_NO_THROW(check(anyShip(), settings));
  settings.headings = {-1.0, 0.0, 6.2};  // any direction, however it is counted
  settings.speeds = {0.0, 12.0};
  settings.waveOmega = {0.3, 0.6};
  for (const Influence influence :
       {Influence::Adjoint, Influence::Direct, Influence::Matrix, Influence::Inverse}) {
    settings.influence = influence;
    EXPECT_NO_THROW(check(anyShip(), settings));
  }
}

TEST(CheckSettings, RefusesFrequenciesThatDoNotRiseFromAboveZero) {
  SolveSettings settings = anySettings();
  settings.omega = {};
  expectRefused(settings, Fault::BadArgument, {"frequencies"});
  settings.omega = {0.4, 0.9, 0.9};
  expectRefused(settings, Fault::FrequenciesNotIncreasing, {"frequency 0.9", "after 0.9", "rise"});
  settings.omega = {0.9, 0.4};
  expectRefused(settings, Fault::FrequenciesNotIncreasing, {"frequency 0.4", "after 0.9"});
  for (const double omega : {0.0, -0.5, std::nan(""), HUGE_VAL}) {
    settings.omega = {omega};
    expectRefused(settings, Fault::ValueOutOfRange, {"frequency", "rad/s"});
  }
}

TEST(CheckSettings, RefusesWavesThatDoNotRiseFromAboveZero) {
  SolveSettings settings = anySettings();
  settings.waveOmega = {0.5, 0.5};
  expectRefused(settings, Fault::ValueOutOfRange, {"wave frequency 0.5", "after 0.5"});
  settings.waveOmega = {std::nan("")};
  expectRefused(settings, Fault::ValueOutOfRange, {"wave frequency"});
  settings.waveOmega = {0.0, 0.5};
  expectRefused(settings, Fault::ValueOutOfRange, {"wave frequency 0.0"});
}

TEST(CheckSettings, RefusesWhatIsNotFinite) {
  SolveSettings settings = anySettings();
  settings.headings = {0.0, std::nan("")};
  expectRefused(settings, Fault::ValueOutOfRange, {"heading", "finite"});
  settings = anySettings();
  settings.speeds = {HUGE_VAL};
  expectRefused(settings, Fault::ValueOutOfRange, {"speed", "finite"});
}

// A table of conditions needs all three of its axes; adjoint vectors need none.
TEST(CheckSettings, RefusesATableWithoutOneOfItsAxes) {
  for (const Influence influence : {Influence::Direct, Influence::Matrix, Influence::Inverse})
    for (int missing = 0; missing < 3; ++missing) {
      SolveSettings settings = anySettings();
      settings.influence = influence;
      if (missing != 0) settings.speeds = {0.0};
      if (missing != 1) settings.headings = {0.0};
      if (missing != 2) settings.waveOmega = {0.5};
      expectRefused(settings, Fault::BadArgument, {"speeds", "headings", "wave frequencies"});
      settings.influence = Influence::Adjoint;
      EXPECT_NO_THROW(check(anyShip(), settings));
    }
}

TEST(CheckSettings, RefusesAShipThatIsNoneOrFloatsInNothing) {
  ShipParticulars ship = anyShip();
  ship.wetSurface.faces.clear();
  expectRefused(ship, anySettings(), Fault::MeshEmpty, {"wet surface"});
  for (const double value : {0.0, -1.0, std::nan("")}) {
    ship = anyShip();
    ship.density = value;
    expectRefused(ship, anySettings(), Fault::ValueOutOfRange, {"density", "gravity"});
    ship = anyShip();
    ship.gravity = value;
    expectRefused(ship, anySettings(), Fault::ValueOutOfRange, {"density", "gravity"});
  }
}

}  // namespace
}  // namespace cutwater::test
