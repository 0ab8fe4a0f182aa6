#pragma once
#include <array>
#include <vector>

#include "hydro/bem/NearWave.h"
#include "hydro/geometry/PanelMesh.h"

namespace cutwater {

/// Even or odd in y. The potentials of modes 1, 3, 5 are even, of 2, 4, 6 odd; a hull solved whole
/// has one system only, stored as Even.
enum class Parity { Even = 0, Odd = 1 };

/// L φ = R v, one parity. Unknowns φ: potential at the n hull panels, then the m lid densities.
template <typename Scalar>
struct InfluencePair {
  using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
  Matrix L;  ///< (n + m) × (n + m)
  Matrix R;  ///< (n + m) × n, [m]
};

/// The two limits of the free-surface condition.
enum class FrequencyLimit {
  Zero,
  Infinite
};  ///< image +1/R₁ (rigid surface) or −1/R₁ (φ = 0 on z = 0)

/// Matrices of the potential formulation for a hull held at rest in deep water, e^{+iωt}:
///     ½φ(x) + ∫ φ ∂G/∂n_ξ dS = ∫ G v dS,   v = ∂φ/∂n
///     G = −(1/4π)[1/R + 1/R₁ + K F(X, Y) − 2πiK e^{−Y}J₀(X)],   K = ω²/g
/// collocated at panel centroids, φ and v constant on each panel. 1/R and 1/R₁ are integrated
/// exactly, once, for all frequencies. The wave term takes n × n points of the source panel, n = 1
/// where waves are long or lie far above, up to 4. In short waves K F becomes −2/R₁; that share is
/// integrated exactly too, so that K → ∞ is atLimit(Infinite) panel by panel. Where the image is
/// near and waves are long, the singular part −2 ln((R + Y)/2) is split off and integrated once.
///
/// Symmetric hulls, [M03] (57)-(60): port panels only, D_even = D_pp + D_ps, D_odd = D_pp − D_ps.
///
/// Lid, the extended boundary integral equations [Lee & Sclavounos 1989, Lee, Newman & Zhu 1996]:
/// derived in the .cpp; the solution outside is that of the hull alone, at every frequency.
/// Immutable; any thread may call. Memory: 8(n + m)² doubles if symmetric, else 4.
class InfluenceMatrices {
 public:
  /// Computes the Rankine parts: about 4(n + m)n panel integrals if symmetric.
  /// @param threads ≥ 1; the result does not depend on it.
  explicit InfluenceMatrices(PanelMesh mesh, int threads = 1);

  const PanelMesh& mesh() const noexcept { return mesh_; }
  /// Number of hull panels n.
  int hullPanels() const noexcept { return hull_; }
  /// The systems to be solved: Even and Odd, or Even alone.
  int parities() const noexcept { return mesh_.symmetric ? 2 : 1; }

  /// Systems at one frequency, indexed by Parity. O((n + m)²) wave terms.
  /// @param K ω²/g [1/m] > 0.
  std::array<InfluencePair<Complex>, 2> atWaveNumber(double K) const;

  /// Systems at ω → 0 or ∞: real, without lid (they have no irregular frequencies).
  InfluencePair<double> atLimit(FrequencyLimit limit, Parity parity) const;

 private:
  /// Source panel and field point, or its mirror image, with the free-surface image near.
  struct NearPair {
    int field;
    bool mirrored;  ///< field point at −y
    NearImage image;
  };
  /// ∫ 1/R dS and ∫ ∂(1/R)/∂n dS of the panels and of their images in z = 0, of one parity.
  struct Rankine {
    Eigen::MatrixXd direct, image, directNormal, imageNormal;
  };

  bool isNear(int i, int j, bool mirrored) const;
  void computeRankine(int source);
  void findNearPairs(int source);
  void addFarWaves(double K, std::array<InfluencePair<Complex>, 2>& systems) const;
  void addFarPair(int i, int j, bool mirrored, double K,
                  std::array<InfluencePair<Complex>, 2>& systems) const;
  void addFarWave(int field, int source, bool mirrored, int n, double K,
                  std::array<InfluencePair<Complex>, 2>& systems) const;
  const std::vector<QuadraturePoint>& points(int source, int n) const;
  int pointsPerSide(int field, int source, double K) const;
  RankineIntegrals imageOf(int field, int source, bool mirrored) const;
  void addNearWaves(double K, std::array<InfluencePair<Complex>, 2>& systems) const;
  void addWave(int field, int source, double K, const WaveIntegral& wave, bool mirrored,
               std::array<InfluencePair<Complex>, 2>& systems) const;

  PanelMesh mesh_;
  int hull_, all_;             // n, n + m
  std::vector<Panel> panels_;  // hull, then lid
  std::vector<double> size_;   // diameter of each panel [m]
  std::vector<double> top_;    // highest z of each panel [m]
  std::array<Rankine, 2> rankine_;
  std::vector<std::vector<NearPair>> near_;  // of each source panel
  // n × n points on each source panel, n = 1 … 4
  std::vector<std::array<std::vector<QuadraturePoint>, 4>> points_;
};

}  // namespace cutwater
