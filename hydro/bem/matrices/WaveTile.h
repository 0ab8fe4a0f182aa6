#pragma once
#include <array>
#include <cstddef>

namespace cutwater {

/// Pairs of two blocks of panels whose wave terms are worked out together, member by member; all of
/// it stays in the processor's nearest caches. Place kSide·source + field.
/// THEORY.md, chapter 5.
struct WaveTile {
  static constexpr std::size_t kSide = 16, kPairs = kSide * kSide;
  struct alignas(64) Column : std::array<double, kPairs> {};
  struct alignas(64) Edge : std::array<double, kSide> {};

  /// The panels of one block: centroids, diameters, normals, mean products of the distances from
  /// the centroid. Horizontally the points of field panels count backwards: their nx, ny, xz, yz
  /// have the other sign. Places behind the last panel hold it again.
  struct Panels {
    Edge x, y, z, size, nx, ny, nz, xx, xy, yy, xz, yz, zz;
  };

  // In.
  const Panels *source = nullptr, *field = nullptr;  ///< field panels, or their mirror images
  // By place(), and what the caller makes of it: ê horizontal unit vector from the field panel to
  // the source panel.
  Column ex, ey;
  Column X, Y, R1;  ///< K·(distance along ê), −K(z + ζ), distance to the image in z = 0 [m]
  Column active;    ///< 1, or 0: the results are 0
  Column formRe, formIm;  ///< product of the panels' form factors (FormFactors.h)
  /// Take −2/R₁ out of K F as far as it has become that: its exact integral is at hand.
  bool takeImages = false;

  // Out: g = K F − 2πiK e^{−Y}J₀, averaged over both panels as FarWave.h says.
  Column valueRe, valueIm;    ///< g [1/m]
  Column sourceRe, sourceIm;  ///< derivative by the source along its normal [1/m²]
  Column fieldRe, fieldIm;    ///< by the source along the field panel's reversed normal
  Column xRe, xIm;            ///< by the source along x
  Column share;               ///< of −1/R₁ taken out, 0 … 2

  /// Distances and directions, of all pairs active.  @param K ω²/g [1/m].
  /// @returns of R₁ by the greater of the two diameters, the least.
  double place(double K);
  /// Without this pair.
  void drop(std::size_t fieldPlace, std::size_t sourcePlace, double K);
  void evaluate(double K);

  /// From a hull and its mirror image to even and odd: (a, b) → (a + b, a − b) of every result.
  static void toParities(WaveTile& a, WaveTile& b);

 private:
  void combine(double K);
  Column f_, fx_, j0_, j1_, y0_, y1_;  // waveTerms of the pairs
};

}  // namespace cutwater
