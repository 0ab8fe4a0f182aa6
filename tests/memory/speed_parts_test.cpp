#include <gtest/gtest.h>

#include "hydro/Conventions.h"
#include "hydro/memory/SpeedParts.h"

// What grows with the speed as a polynomial of second degree: of numbers and of matrices.
namespace cutwater {
namespace {

// Small whole numbers: every sum and product is exact.
TEST(SpeedPartsClosedForm, IsAPolynomialOfTheSpeed) {
  const SpeedParts<double> parts{2.0, -3.0, 5.0};
  EXPECT_EQ(parts.at(0.0), 2.0);
  EXPECT_EQ(parts.at(1.0), 4.0);
  EXPECT_EQ(parts.at(4.0), 2.0 - 3.0 * 4.0 + 5.0 * 16.0);
  EXPECT_EQ(parts.at(-4.0), 2.0 + 3.0 * 4.0 + 5.0 * 16.0);  // astern: only the odd part turns
}

TEST(SpeedPartsClosedForm, HoldsMatricesAndComplexNumbers) {
  SpeedParts<CMat6> parts{CMat6::Identity(), CMat6::Zero(), CMat6::Zero()};
  parts.linear(0, 4) = Complex(0.0, 2.0);
  parts.squared(4, 4) = -1.0;
  const CMat6 at3 = parts.at(3.0);
  EXPECT_EQ(at3(0, 0), Complex(1.0));
  EXPECT_EQ(at3(0, 4), Complex(0.0, 6.0));
  EXPECT_EQ(at3(4, 4), Complex(1.0 - 9.0));
  EXPECT_EQ(at3(4, 0), Complex(0.0));
}

// parts[p] is what the p-th power of the speed multiplies, for reading and for writing.
TEST(SpeedPartsIdentity, AreNumberedByThePowerOfTheSpeed) {
  SpeedParts<double> parts{0.0, 0.0, 0.0};
  for (std::size_t power = 0; power < 3; ++power) parts[power] = 1.0 + static_cast<double>(power);
  EXPECT_EQ(parts.atRest, 1.0);
  EXPECT_EQ(parts.linear, 2.0);
  EXPECT_EQ(parts.squared, 3.0);
  const SpeedParts<double>& read = parts;
  const double speed = 7.0;
  EXPECT_EQ(read[0] + speed * read[1] + speed * speed * read[2], parts.at(speed));
}

}  // namespace
}  // namespace cutwater
