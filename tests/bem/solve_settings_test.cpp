#include <gtest/gtest.h>

#include "hydro/Errors.h"
#include "hydro/bem/settings/CheckSettings.h"
#include "hydro/bem/settings/SolveSettings.h"
#include "tests/bem/Frigate.h"

namespace cutwater {
namespace {

// A user sets frequencies; the rest is chosen.
TEST(SolveSettings, OnlyFrequenciesMustBeSet) {
  const ShipParticulars ship = test::frigateAfloat(frigateDivision(224));
  SolveSettings settings;
  EXPECT_THROW(check(ship, settings), HydroError);
  settings.omega = {0.5};
  EXPECT_NO_THROW(check(ship, settings));
  EXPECT_TRUE(settings.lid);
  EXPECT_EQ(settings.forwardSpeed, ForwardSpeedForm::Tuck);
  EXPECT_FALSE(settings.xDerivatives());  // what the report's form needs, a file twice as large
  EXPECT_EQ(settings.influence, Influence::Adjoint);
}

}  // namespace
}  // namespace cutwater
