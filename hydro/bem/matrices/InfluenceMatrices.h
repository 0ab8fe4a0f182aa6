#pragma once
#include "hydro/bem/matrices/FarWave.h"

namespace cutwater {

/// The two limits of the free-surface condition.
enum class FrequencyLimit {
  Zero,     ///< image +1/R₁: the surface is rigid
  Infinite  ///< image −1/R₁: φ = 0 on z = 0
};

/// Wave number [1/m] above which the lid works: 0.9 of the least at which water in the box around
/// the hull resonates.
double lidFrom(const PanelMesh& mesh);

/// What becomes of lid rows that are idle (lidShare is 0).
enum class IdleLid {
  Drop,  ///< the system is that of the hull alone
  Keep   ///< they say that the lid's densities are 0: the same size at every frequency
};

/// Matrices of a hull held at rest in deep water, e^{+iωt}, φ, v, σ constant on each panel:
/// potential:  ½φ(x) + ∫ φ ∂G/∂n_ξ dS = ∫ G v dS,  v = ∂φ/∂n
/// source:     ½σ(x) + ∫ σ ∂G/∂n_x dS = v,  φ = ∫ G σ dS,  ∂φ/∂x = ½n_x σ + ∫ σ ∂G/∂x dS
///                                                                         [M03] (49)-(54)
///     G = −(1/4π)[1/R + 1/R₁ + K F(X, Y) − 2πiK e^{−Y}J₀(X)],   K = ω²/g
/// Each equation is averaged over its panel by 4 or 9 points (Galerkin; the wave term by what the
/// wave length asks for), or taken at its centroid. With Galerkin weights the two formulations are
/// transposes of each other to quadrature error. 1/R and 1/R₁ are integrated exactly, once, for all
/// frequencies; the wave term of far pairs by one evaluation and the panels' extent (FarWave.h), of
/// pairs whose image is near by its singular part and points (NearWave.h): −2 ln((R + Y)/2) in long
/// waves, in short ones −2/R₁, which K F becomes, so that K → ∞ is atLimit(Infinite) panel by
/// panel. With settings.sourcePoints = 1, 4, 9 far pairs have that many Gauss points instead.
///
/// Symmetric hulls, [M03] (57)-(60): port panels only, D_even = D_pp + D_ps, D_odd = D_pp − D_ps.
///
/// Lid, the extended boundary integral equations [Lee & Sclavounos 1989, Lee, Newman & Zhu 1996],
/// no more of it than uniqueness needs: derived in the .cpp; the solution outside is that of the
/// hull alone, at every frequency. Immutable; any thread may call. Memory: 8(n + m)² doubles if
/// symmetric, else 4; 12 and 6 with H.
/// THEORY.md, chapter 5.
class InfluenceMatrices {
 public:
  /// Computes the Rankine parts.  @throws HydroError BadArgument, as PanelPairs.
  explicit InfluenceMatrices(PanelMesh mesh, const InfluenceSettings& settings = {});
  InfluenceMatrices(const InfluenceMatrices&) = delete;
  InfluenceMatrices& operator=(const InfluenceMatrices&) = delete;

  const PanelMesh& mesh() const noexcept { return pairs_.mesh(); }
  const InfluenceSettings& settings() const noexcept { return pairs_.settings(); }
  /// Number of hull panels n.
  int hullPanels() const noexcept { return pairs_.hull(); }
  /// The systems to be solved: Even and Odd, or Even alone.
  int parities() const noexcept { return pairs_.parities(); }

  /// Systems at one frequency, indexed by Parity. O((n + m)²) wave terms.
  /// @param K ω²/g [1/m] > 0.
  /// @param workspace matrices to be written over; those of an earlier frequency save the time in
  ///              which the system finds memory.
  std::array<InfluenceSystem<Complex>, 2> atWaveNumber(
      double K, IdleLid idle = IdleLid::Drop,
      std::array<InfluenceSystem<Complex>, 2> workspace = {}) const;

  /// Systems at ω → 0 or ∞: real, without lid (they have no irregular frequencies).
  InfluenceSystem<double> atLimit(FrequencyLimit limit, Parity parity) const;

  /// Share s of the lid at wave number K: 0 where the water inside the hull cannot resonate, then
  /// rising to 1. Inside, the lid makes the wave number (1 − s)K.
  double lidShare(double K) const noexcept;

 private:
  using Systems = std::array<InfluenceSystem<Complex>, 2>;
  void resize(int all, Systems& systems) const;
  void fillRigid(const FarWave::At& at, Systems& systems) const;
  void addDiagonals(Systems& systems) const;
  void addFarWaves(const FarWave::At& at, Systems& systems) const;
  void addFarPair(const Pair& pair, const FarWave::At& at, Systems& systems) const;
  void addFarWave(const Pair& pair, const FarWave::At& at, Systems& systems) const;
  void addNearWaves(const FarWave::At& at, Systems& systems) const;
  void add(const Pair& pair, const FarWave::At& at, const WaveIntegral& wave, Complex x,
           Systems& systems) const;

  PanelPairs pairs_;
  RankineMatrices rankine_;
  FarWave farWave_;
  double lidFrom_;
};

}  // namespace cutwater
