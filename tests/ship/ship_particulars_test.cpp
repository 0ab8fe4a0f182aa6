#include <gtest/gtest.h>

#include "hydro/ship/ShipParticulars.h"

namespace cutwater {
namespace {

TEST(ShipParticulars, MassMatrixIsThatOfTheGyradii) {
  ShipParticulars ship;
  ship.mass = 3.0;
  ship.gyradii = {1.0, 2.0, 4.0};
  Vec6 diagonal;
  diagonal << 3.0, 3.0, 3.0, 3.0, 12.0, 48.0;
  EXPECT_EQ(ship.massMatrix(), Mat6(diagonal.asDiagonal()));
}

TEST(ShipParticulars, WithoutAHullTheSizeIsThatOfTheVolume) {
  ShipParticulars ship;
  ship.volume = 8.0;
  EXPECT_DOUBLE_EQ(ship.length(), 10.0);  // five times the cube root
  EXPECT_DOUBLE_EQ(ship.beam(), 10.0 / 7.0);
  EXPECT_EQ(ship.lengthOverall(), ship.length());
}

}  // namespace
}  // namespace cutwater
