#pragma once
#include <array>
#include <cstddef>
#include <vector>

namespace cutwater::wave_tables {

// Polynomials in cells, read by WaveTerm.cpp and filled once from WaveTermOracle.h (about 30 ms).
// Coefficients are powers of the coordinate that runs from −1 to 1 over a cell, interleaved by
// function, so that the Horner steps of neighbouring coefficients and functions go side by side.

inline constexpr std::size_t kPoints = 10;        ///< points per direction of a cell in the plane
inline constexpr std::size_t kBesselPoints = 12;  ///< points of a Bessel cell

/// Two functions of two variables in one cell.
struct Patch {
  alignas(64) double coefficient[kPoints][kPoints][2];  ///< [power of a][power of b][function]

  std::array<double, 2> at(double a, double b) const noexcept {
    double row[2 * kPoints] = {};
    for (std::size_t i = kPoints; i-- > 0;) {
      const double* c = &coefficient[i][0][0];
      for (std::size_t k = 0; k < 2 * kPoints; ++k) row[k] = row[k] * a + c[k];
    }
    // Even and odd powers apart: half the length of the chain of dependent steps.
    const double bb = b * b;
    double even0 = 0.0, even1 = 0.0, odd0 = 0.0, odd1 = 0.0;
    for (std::size_t j = kPoints; j > 0; j -= 2) {
      odd0 = odd0 * bb + row[2 * j - 2];
      odd1 = odd1 * bb + row[2 * j - 1];
      even0 = even0 * bb + row[2 * j - 4];
      even1 = even1 * bb + row[2 * j - 3];
    }
    return {even0 + b * odd0, even1 + b * odd1};
  }
};

/// J₀, J₁, Y₀, Y₁ in one cell of unit length.
struct BesselCell {
  alignas(32) double coefficient[kBesselPoints][4];
};

// The quarter plane, in R = √(X²+Y²), α = Y/R, s = 1/R:
//   near:  R < 8; rings of width 1, ring i cut into i + 2 equal cells of α in [0, 1]; holds S, T.
//   steep: 8 ≤ R ≤ 36, α ≥ 3/4; rows of width 1/72 in s, 4 columns of α; holds S, T.
//   far:   the rest; the same rows, 8 columns of α in [0, 1]; holds −W R/2 and ∂W/∂X R³/2X.
inline constexpr double kNear = 8.0, kSteep = 0.75, kRowWidth = 1.0 / 72.0;
inline constexpr std::size_t kRings = 8, kFarRows = 9, kFarColumns = 8;
inline constexpr std::size_t kSteepRow = 2, kSteepColumns = 4;  // rows before: R > 36
inline constexpr std::size_t kBesselCells = 36;                 // X < 36
inline constexpr std::size_t kSecondKindFrom = 5;  // cells before hold 0 for Y₀, Y₁; none is read

/// Ring i begins behind Σ_{m<i} (m + 2) patches.
inline constexpr std::size_t ringBegin(std::size_t i) { return i * (i + 3) / 2; }

struct Tables {
  std::vector<Patch> near, steep, far;
  std::vector<BesselCell> bessel;
};

/// Built on the first call; thread-safe, immutable afterwards. 250 kB.
const Tables& tables();

}  // namespace cutwater::wave_tables
