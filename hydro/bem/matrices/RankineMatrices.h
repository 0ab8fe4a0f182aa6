#pragma once
#include "hydro/bem/matrices/NearWave.h"
#include "hydro/bem/matrices/PanelPairs.h"

namespace cutwater {

/// What does not depend on frequency, of one parity: integrals over the source panel, averaged over
/// the field panel. [field, source], (n + m)².
/// THEORY.md, chapter 5.
struct RankineParts {
  Eigen::MatrixXd rigid, image;              ///< ∫ 1/R + 1/R₁ dS, ∫ 1/R₁ dS [m]
  Eigen::MatrixXd rigidNormal, imageNormal;  ///< their normal derivatives: ∂/∂n_ξ or ∂/∂n_x [–]
  Eigen::MatrixXd rigidX, imageX;            ///< ∂/∂x; empty without H [–]
};

/// One pair whose free-surface image is near, with the singular part of its wave term.
struct NearPair {
  Pair pair;
  NearImage image;       ///< along PanelPairs::direction
  NearImage alongX;      ///< along −x of the source, +x of the field; of no meaning without H
  std::size_t opposite;  ///< place of the pair seen the other way, among those of `pair.field`
};

/// Rankine and near-image integrals of all pairs: 1/R and 1/R₁ exactly (RankineIntegrals.h) at the
/// Galerkin points of the field panel. Own panel: the normal derivative of 1/R is 0, the jump ±½ is
/// the equation's; the x-derivative is that within the panel.
class RankineMatrices {
 public:
  /// About 4 g (n + m)² panel integrals if symmetric, g Galerkin points.
  explicit RankineMatrices(const PanelPairs& pairs);

  const RankineParts& parts(Parity parity) const {
    return parts_[static_cast<std::size_t>(parity)];
  }
  const std::vector<NearPair>& near(int source) const {
    return near_[static_cast<std::size_t>(source)];
  }
  /// Those of one side with field panels `from` to before `to`, in order.
  std::span<const NearPair> near(int source, bool mirrored, int from, int to) const;
  /// The image part of one pair, from those of the two parities.
  struct Image {
    double potential, normal, x;
  };
  Image imageOf(const Pair& pair) const;

  /// Potential, normal derivative and x-derivative of 1/R or 1/R₁, averaged over the field panel.
  struct Sample {
    double potential = 0.0, normal = 0.0, x = 0.0;
  };

  /// Four points of a field panel, their weights shares of its area.
  struct WeightedPoints4 {
    double x[4], y[4], z[4], weight[4];
  };

 private:
  Sample sample(const RankinePanel& rankine, const Pair& pair, bool image) const;
  void integrate(int source);
  void findNear(int source);
  void findOpposites(int source);

  const PanelPairs& pairs_;
  // Of each field panel; empty if it has not 4, 8, ...
  std::vector<std::vector<WeightedPoints4>> pointBlocks_;
  std::array<RankineParts, 2> parts_;
  // Of each source panel: not mirrored, mirrored, by field.
  std::vector<std::vector<NearPair>> near_;
};

}  // namespace cutwater
