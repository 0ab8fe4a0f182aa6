#pragma once
#include "hydro/bem/FormFactors.h"
#include "hydro/bem/RankineMatrices.h"

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
/// term a pair, at the two centroids: it depends on their horizontal distance h and on z + ζ only, so
/// it serves both directions. What the panels' extent does to it:
///     ∫∫ g dS dS′/A = A [ g − o + o S_i S_j (1 − c) ],
///     o = −2πK e^{−Y}[Y₀(X) + iJ₀(X)]  the waves in g, S form factors of the two panels along the
/// line between them. A ring wave's front is curved and its height falls as h^{−½}:
///     c = iK(q_i + q_j)/2h + K(r_j − r_i)/2h,  q = ⟨across² − along²⟩, r = ⟨along·vertical⟩.
/// What is left is O((KL)²/X²) of g. The rest g − o varies like 1/R₁; in short waves it is −2/R₁, and
/// that share of it is taken from RankineMatrices' integral instead. Below X = 2 there are no waves
/// yet: o counts from there, fully from X = 4.
class FarWave {
 public:
  using Systems = std::array<InfluenceSystem<Complex>, 2>;

  /// Both must outlive this.
  FarWave(const PanelPairs& pairs, const RankineMatrices& rankine);

  /// Adds them to the first `all` rows and columns.  @param K [1/m].
  void add(double K, int all, Systems& systems) const;

 private:
  struct Tile;
  struct Block {
    int begin, size;
  };
  std::vector<Block> blocks(int all) const;
  void place(const Block& field, const Block& source, bool mirrored, double K, Tile& tile) const;
  void factors(const FormFactors& form, const Block& field, const Block& source, bool mirrored,
               Tile& tile) const;
  void combine(double K, Tile& tile) const;
  void derive(const Block& field, const Block& source, bool mirrored, Tile& tile) const;
  struct Direction;
  void write(const Direction& direction, double K, const std::array<Tile, 2>& tiles, int parity,
             InfluenceSystem<Complex>& system) const;

  const PanelPairs& pairs_;
  const RankineMatrices& rankine_;
  /// Of all panels, in order: centroid, normal, area, diameter, mean products of the distances from
  /// the centroid.
  std::vector<double> x_, y_, z_, nx_, ny_, nz_, area_, size_, xx_, xy_, yy_, xz_, yz_, zz_;
  std::array<std::vector<char>, 2> isFar_;  // [mirrored][all·source + field]
};

}  // namespace cutwater
