#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <thread>

#include "hydro/green/WaveTermOracle.h"
#include "hydro/green/WaveTermTables.h"

// The tables cell by cell, against the slow forms that they were filled from.
namespace cutwater::wave_tables {
namespace {

// What WaveTerm.h promises of F and F_X, absolute: S and T X/R are summands of them.
constexpr double kTableError = 1e-11;

/// The same places in every cell: corners, the middle, and twenty at random.
std::vector<std::array<double, 2>> placesInACell() {
  std::vector<std::array<double, 2>> places{{-1, -1}, {-1, 1}, {1, -1}, {1, 1}, {0, 0}};
  std::mt19937 random(5);
  std::uniform_real_distribution<double> local(-1.0, 1.0);
  for (int i = 0; i < 20; ++i) {
    const double a = local(random);
    places.push_back({a, local(random)});
  }
  return places;
}

double between(double from, double width, double local) {
  return from + 0.5 * width * (1.0 + local);
}

// One coefficient at a time is its monomial aᵖ b^q of its function: the interleaving, and Horner's
// steps. Powers of a half are exact.
TEST(WaveTermTablesClosedForm, PatchIsThePolynomialOfItsCoefficients) {
  const double a = 0.5, b = -0.5;
  for (std::size_t p = 0; p < kPoints; ++p)
    for (std::size_t q = 0; q < kPoints; ++q)
      for (std::size_t function = 0; function < 2; ++function) {
        Patch patch{};
        patch.coefficient[p][q / 2][2 * (q % 2) + function] = 3.0;
        const std::array<double, 2> value = patch.at(a, b);
        const double exact =
            3.0 * std::pow(a, static_cast<double>(p)) * std::pow(b, static_cast<double>(q));
        EXPECT_EQ(value[function], exact) << p << ' ' << q;
        EXPECT_EQ(value[1 - function], 0.0) << p << ' ' << q;
      }
}

// Ring i of the near region has i + 2 cells.
TEST(WaveTermTablesClosedForm, CellsAreCountedAsTheHeaderSays) {
  std::size_t before = 0;
  for (std::size_t ring = 0; ring <= kRings; ++ring) {
    EXPECT_EQ(ringBegin(ring), before);
    before += ring + 2;
  }
  const Tables& all = tables();
  EXPECT_EQ(all.near.size(), ringBegin(kRings));
  EXPECT_EQ(all.steep.size(), (kFarRows - kSteepRow) * kSteepColumns);
  EXPECT_EQ(all.far.size(), kFarRows * kFarColumns);
  EXPECT_EQ(all.bessel.size(), kBesselCells);
  // Rows end where the near region begins, and the steep ones begin at R = 36.
  EXPECT_DOUBLE_EQ(static_cast<double>(kFarRows) * kRowWidth, 1.0 / kNear);
  EXPECT_DOUBLE_EQ(static_cast<double>(kSteepRow) * kRowWidth, 1.0 / 36.0);
}

// e^8·1e-16 of the series is 3e-13.
TEST(WaveTermTablesIdentity, NearCellsHoldTheSmoothPart) {
  for (std::size_t ring = 0; ring < kRings; ++ring)
    for (std::size_t column = 0; column < ring + 2; ++column)
      for (const auto& [a, b] : placesInACell()) {
        const double width = 1.0 / static_cast<double>(ring + 2);
        const double R = between(static_cast<double>(ring), 1.0, a);
        const double alpha = between(static_cast<double>(column) * width, width, b);
        const oracle::Smooth exact = oracle::smoothBySeries(R, alpha);
        const auto [S, T] = tables().near[ringBegin(ring) + column].at(a, b);
        EXPECT_NEAR(S, exact.S, kTableError) << R << ' ' << alpha;
        EXPECT_NEAR(T, exact.T, kTableError) << R << ' ' << alpha;
      }
}

TEST(WaveTermTablesIdentity, SteepCellsHoldTheSmoothPart) {
  constexpr double width = (1.0 - kSteep) / kSteepColumns;
  for (std::size_t row = kSteepRow; row < kFarRows; ++row)
    for (std::size_t column = 0; column < kSteepColumns; ++column)
      for (const auto& [a, b] : placesInACell()) {
        const double R = 1.0 / between(static_cast<double>(row) * kRowWidth, kRowWidth, a);
        const double alpha = between(kSteep + static_cast<double>(column) * width, width, b);
        if (alpha == 1.0) continue;  // the integrals have X = 0 there
        const oracle::Smooth exact = oracle::smoothByIntegrals(R, alpha);
        const auto [S, T] = tables().steep[(row - kSteepRow) * kSteepColumns + column].at(a, b);
        EXPECT_NEAR(S, exact.S, kTableError) << R << ' ' << alpha;
        EXPECT_NEAR(T, exact.T, kTableError) << R << ' ' << alpha;
      }
}

// What is held are numbers near 1: the image's part is 1 itself, of its slope as well. F has 2/R of
// it.
TEST(WaveTermTablesIdentity, FarCellsHoldTheWaveFreePart) {
  for (std::size_t row = 0; row < kFarRows; ++row)
    for (std::size_t column = 0; column < kFarColumns; ++column) {
      constexpr double width = 1.0 / kFarColumns;
      if (row >= kSteepRow && static_cast<double>(column) * width >= kSteep) continue;  // steep
      for (const auto& [a, b] : placesInACell()) {
        const double inverse = between(static_cast<double>(row) * kRowWidth, kRowWidth, a);
        const double alpha = between(static_cast<double>(column) * width, width, b);
        if (inverse == 0.0 || alpha == 1.0) continue;
        const double R = 1.0 / inverse, X = R * std::sqrt((1.0 - alpha) * (1.0 + alpha));
        const oracle::Valued w = oracle::waveFree(X, R * alpha);
        const auto [value, slope] = tables().far[row * kFarColumns + column].at(a, b);
        EXPECT_NEAR(value, -0.5 * R * w.value, kTableError) << R << ' ' << alpha;
        EXPECT_NEAR(slope, 0.5 * R * R * R * w.slopeX / X, kTableError) << R << ' ' << alpha;
      }
    }
}

// 1e-14: twelve points leave 1e-15 of a wave over a cell of unit length, the oracle
// 1e-15·(1 + 1/x).
TEST(WaveTermTablesIdentity, BesselCellsHoldAllFour) {
  for (std::size_t cell = 0; cell < kBesselCells; ++cell)
    for (const double t : {-0.9, -0.3, 0.1, 0.7, 1.0}) {
      const Double4* const c = tables().bessel[cell].coefficient;
      Double4 sum{};
      for (std::size_t p = kBesselPoints; p > 0; --p) sum = sum * t + c[p - 1];
      const double x = between(static_cast<double>(cell), 1.0, t);
      const oracle::Bessel b = oracle::bessel(x);
      EXPECT_NEAR(sum[0], b.J0, 1e-14) << x;
      EXPECT_NEAR(sum[1], b.J1, 1e-14) << x;
      // From 1 to 2 a pole at 0 is near: twelve points leave 1e-9 of Y₁. Read from X = 2 on.
      const double second = cell == 1 ? 1e-8 : cell < 4 ? 1e-10 : 1e-13;
      EXPECT_NEAR(sum[2], cell < kSecondKindFrom ? 0.0 : b.Y0, second) << x;
      EXPECT_NEAR(sum[3], cell < kSecondKindFrom ? 0.0 : b.Y1, second) << x;
    }
}

TEST(WaveTermTables, AreBuiltOnceForAllThreads) {
  const Tables* other = nullptr;
  std::thread([&other] { other = &tables(); }).join();
  EXPECT_EQ(other, &tables());
  for (const Patch& patch : tables().near)
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(&patch) % alignof(Patch), 0u);
}

}  // namespace
}  // namespace cutwater::wave_tables
