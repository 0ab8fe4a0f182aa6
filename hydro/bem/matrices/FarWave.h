#pragma once
#include "hydro/bem/matrices/FormFactors.h"
#include "hydro/bem/matrices/RankineMatrices.h"
#include "hydro/bem/matrices/WaveTile.h"

namespace cutwater {

/// One parity's system. Potential: L φ = R v, the unknowns the potential at the n hull panels, then
/// the m lid densities. Source: L σ = v (0 on the lid), φ = R σ, ∂φ/∂x = H σ, all n + m panels
/// sources.
template <typename Scalar>
struct InfluenceSystem {
  using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
  Matrix L;  ///< (n + m) × (n + m)
  Matrix R;  ///< potential: (n + m) × n, source: n × (n + m) [m]
  Matrix H;  ///< n × (n + m), or empty
  Formulation formulation = Formulation::Potential;
};

/// Wave parts of all pairs whose free-surface image is not near, from one evaluation of the wave
/// term a pair, at the two centroids: it depends on their horizontal distance h and on z + ζ only,
/// so it serves both directions, unless equations are taken at centroids. What the panels' extent
/// does to it, to second order in size/distance and to all orders in size/wave length:
///     mean of g = g − o + ½⟨(s·∇)²⟩(g − o) + o S_i S_j (1 + c),
///     o = −2πK e^{−Y}[Y₀(X) + iJ₀(X)]
/// o are the waves in g, S form factors of the two panels along the line between them, c what
/// second moments do to a ring wave and not to a plane one; derivatives of g alike. Below X = 1
/// there are no waves yet: o counts from there, fully from X = 2. Where the image is not far, the
/// share of −2/R₁ that g has become is taken from RankineMatrices' exact integral instead. Error of
/// an entry, r.m.s. on a frigate of 433 panels a side: 1e-4 below 1.5 rad/s, 1e-3 at 2.5, 0.4 % at
/// 3.
/// THEORY.md, chapter 5.
class FarWave {
 public:
  using Systems = std::array<InfluenceSystem<Complex>, 2>;

  /// Both must outlive this.
  FarWave(const PanelPairs& pairs, const RankineMatrices& rankine);

  /// Where a system is wanted.
  struct At {
    double K;         ///< ω²/g [1/m]
    double lidShare;  ///< of the lid's equations, InfluenceMatrices::lidShare
    int all;          ///< so many rows and columns: of the hull, or of hull and lid
    double rowShare(int row, int hull) const { return row < hull ? 1.0 : lidShare; }
  };

  /// Fills the systems with these and with what needs no wave term, near pairs included; the lid's
  /// rows without their own densities.
  void fill(const At& at, Systems& systems) const;

 private:
  /// Consecutive panels, all of the hull or all of the lid.
  struct Block {
    int begin, size;
    WaveTile::Panels source;
    std::array<WaveTile::Panels, 2> field;  // [mirrored]
  };
  /// Blocks of the entries to be written: as the tile has them, or exchanged.
  struct Target {
    const Block &field, &source;
    bool exchanged;
  };
  /// Each equation is averaged over its panel, as the sources are: one result serves both ways. At
  /// centroids it does not.
  bool averages() const { return pairs_.settings().galerkinPoints > 1; }
  Block blockOf(int begin, int size) const;
  void fillPair(const FormFactors& form, const Block& field, const Block& source, const At& at,
                std::array<WaveTile, 2>& tiles, Systems& systems) const;
  void place(const Block& field, const Block& source, bool mirrored, double K,
             WaveTile& tile) const;
  void weigh(const FormFactors& form, const Block& field, const Block& source, bool mirrored,
             WaveTile& tile) const;
  void write(const Target& target, const At& at, const WaveTile& tile, Parity parity,
             InfluenceSystem<Complex>& system) const;
  void writeImages(const Target& target, const At& at, const std::array<WaveTile, 2>& tiles,
                   Parity parity, InfluenceSystem<Complex>& system) const;

  const PanelPairs& pairs_;
  const RankineMatrices& rankine_;
  std::vector<Block> blocks_;  // of the hull, then of the lid
  std::vector<double> area_;   // of all panels
};

}  // namespace cutwater
