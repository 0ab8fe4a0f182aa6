#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "hydro/base/Simd.h"

namespace cutwater::wave_tables {

// Polynomials in cells, read by WaveTerm.cpp and filled once from WaveTermOracle.h (about 30 ms).
// Coefficients are powers of the coordinate that runs from −1 to 1 over a cell, interleaved by
// function, so that the Horner steps of neighbouring coefficients and functions go side by side.

inline constexpr std::size_t kPoints = 10;        ///< points per direction of a cell in the plane
inline constexpr std::size_t kBesselPoints = 12;  ///< points of a Bessel cell

/// Two functions of two variables in one cell.
/// THEORY.md, chapter 4.
struct alignas(64) Patch {
  static constexpr std::size_t kBlocks = kPoints / 2;  ///< of a row
  /// [power of a][power of b, two by two]: (b²ⁱ of function 0, of 1, b²ⁱ⁺¹ of 0, of 1)
  Double4 coefficient[kPoints][kBlocks];

  CUTWATER_INLINE std::array<double, 2> at(double a, double b) const noexcept {
    // Even and odd powers apart: half the steps that wait for each other.
    const double aa = a * a, bb = b * b;
    Double4 even[kBlocks], odd[kBlocks];
    for (std::size_t k = 0; k < kBlocks; ++k) {
      even[k] = coefficient[kPoints - 2][k];
      odd[k] = coefficient[kPoints - 1][k];
    }
    for (std::size_t i = kPoints - 2; i > 0; i -= 2)
      for (std::size_t k = 0; k < kBlocks; ++k) {
        even[k] = even[k] * aa + coefficient[i - 2][k];
        odd[k] = odd[k] * aa + coefficient[i - 1][k];
      }
    for (std::size_t k = 0; k < kBlocks; ++k) even[k] += odd[k] * a;
    const Double4 sum =
        (even[0] + even[1] * bb) + (bb * bb) * ((even[2] + even[3] * bb) + even[4] * (bb * bb));
    return {sum[0] + b * sum[2], sum[1] + b * sum[3]};
  }
};

/// J₀, J₁, Y₀, Y₁ in one cell of unit length.
struct alignas(32) BesselCell {
  Double4 coefficient[kBesselPoints];
};

// The quarter plane, in R = √(X²+Y²), α = Y/R, s = 1/R:
//   near:  R < 8; rings of width 1, ring i cut into i + 2 equal cells of α in [0, 1]; holds S, T.
//   steep: 8 ≤ R ≤ 36, α ≥ 3/4; rows of width 1/72 in s, 4 columns of α; holds S, T.
//   far:   the rest; the same rows, 8 columns of α in [0, 1]; holds −W R/2 and ∂W/∂X R³/2X.
inline constexpr double kNear = 8.0, kSteep = 0.75, kRowWidth = 1.0 / 72.0;
inline constexpr std::size_t kRings = 8, kFarRows = 9, kFarColumns = 8;
inline constexpr std::size_t kSteepRow = 2, kSteepColumns = 4;  // rows before: R > 36
inline constexpr std::size_t kBesselCells = 36;                 // X < 36
inline constexpr std::size_t kSecondKindFrom = 1;  // cells before hold 0 for Y₀, Y₁

/// Ring i begins behind Σ_{m<i} (m + 2) patches.
inline constexpr std::size_t ringBegin(std::size_t i) { return i * (i + 3) / 2; }

struct Tables {
  std::vector<Patch> near, steep, far;
  std::vector<BesselCell> bessel;
};

/// Built on the first call; thread-safe, immutable afterwards. 250 kB.
const Tables& tables();

}  // namespace cutwater::wave_tables
