#include "hydro/bem/matrices/InfluenceMatrices.h"

#include <algorithm>
#include <cmath>

// Signs. Green's second identity in the water, whose outward normal on the hull is −n, for φ and
// the unit source G = −1/(4πR) + ...: φ(x) + ∫ φ ∂G/∂n_ξ dS = ∫ G v dS off the hull, ½φ(x) on a
// smooth point of it. Sources of strength σ on the hull: ∂φ/∂n = ½σ + ∫ σ ∂G/∂n_x dS outside.
//
// Lid (extended boundary integral equations). Let W(x) = −∫ φ ∂G/∂n dS + ∫ G v dS − ∫_lid μ ∂G/∂ζ
// dS, n = +z on the lid. Outside the hull W is the potential we want; across the hull its double
// layer jumps by φ = W_ext − W_int. The hull equation, ½φ + ∫ φ ∂G/∂n + ∫_lid μ ∂G/∂ζ = ∫ G v, says
// W_ext = φ and hence W_int = 0 on the hull's inner side. On ζ = 0 source and image coincide: the
// derivatives of 1/R and 1/R₁ cancel for every x below, the wave part gives
//     ∂G/∂ζ = K G          (the free-surface condition of the source point),
// so the lid is a layer of sources −Kμ with 1/R + 1/R₁ = 2/R. No jump on approaching it from below,
// but a layer of strength σ on z = 0 breaks the free-surface condition, ∂W/∂z − K W = −σ = +Kμ:
// half of the unit flux for each of the two coinciding sources. The lid equation
//     −μ + s[∫ φ ∂G/∂n dS + ∫_lid μ K G dS] = s ∫ G v dS      (x on the lid, 0 ≤ s ≤ 1)
// says sW = −μ there, hence ∂W/∂z = (1 − s)K W. Inside, W is harmonic, zero on the hull, with that
// condition on the lid: W = 0 as long as (1 − s)K is below the least K₁ at which the water inside
// resonates, ∫|∇W|² = (1 − s)K ∫_lid W². So μ = 0 and φ is the true potential. Sources (lid
// equation −σ + sK ∫ G σ dS = 0) have the same condition inside, with W continuous across the hull.
//
// K₁ is not less than that of any larger basin, as a motion of the smaller one, 0 outside it, is a
// motion of the larger; for the box L × B × T around the hull K₁ = κ coth κT, κ² = (π/L)² + (π/B)².
// In the discrete system μ is of the size of the discretisation error, and the lid's own error
// comes on top: on a hemisphere of 432 panels s = 1 doubles the errors of surge. Hence s is 0 up to
// 0.9 K₁ and (1 − s)K falls as 1/K from there.

namespace cutwater {
namespace {

constexpr double kLidFrom = 0.9;  // of the least resonance; see above

}  // namespace

double lidFrom(const PanelMesh& mesh) {
  Vec3 low = Vec3::Constant(1e300), high = -low;
  for (const Panel& panel : mesh.panels)
    for (const Vec3& corner : panel.corner) {
      low = low.cwiseMin(corner);
      high = high.cwiseMax(corner);
      if (mesh.symmetric) low.y() = std::min(low.y(), -corner.y());
    }
  const Vec3 size = high - low;
  const double kappa = std::hypot(kPi / size.x(), kPi / size.y());
  return kLidFrom * kappa / std::tanh(-kappa * low.z());
}

InfluenceMatrices::InfluenceMatrices(PanelMesh mesh, const InfluenceSettings& settings)
    : pairs_(std::move(mesh), settings),
      rankine_(pairs_),
      farWave_(pairs_, rankine_),
      lidFrom_(cutwater::lidFrom(pairs_.mesh())) {}

double InfluenceMatrices::lidShare(double K) const noexcept {
  if (mesh().lid.empty()) return 0.0;
  const double ratio = lidFrom_ / K;
  return ratio >= 1.0 ? 0.0 : 1.0 - ratio * ratio;
}

std::array<InfluenceSystem<Complex>, 2> InfluenceMatrices::atWaveNumber(
    double K, IdleLid idle, std::array<InfluenceSystem<Complex>, 2> workspace) const {
  const double share = lidShare(K);
  const bool drop = share == 0.0 && idle == IdleLid::Drop;
  const int all = drop ? pairs_.hull() : pairs_.all();
  Systems systems = std::move(workspace);
  resize(all, systems);
  const FarWave::At at{K, share, all};
  if (settings().sourcePoints == 0) {
    farWave_.fill(at, systems);
  } else {
    fillRigid(at, systems);
    addFarWaves(at, systems);
  }
  addNearWaves(at, systems);
  addDiagonals(systems);
  return systems;
}

void InfluenceMatrices::resize(int all, Systems& systems) const {
  const int hull = pairs_.hull();
  for (int p = 0; p < parities(); ++p) {
    auto& [L, R, H, formulation] = systems[static_cast<std::size_t>(p)];
    formulation = settings().formulation;
    L.resize(all, all);
    R.resize(pairs_.isSource() ? hull : all, pairs_.isSource() ? all : hull);
    if (settings().xDerivative) H.resize(hull, all);
  }
}

/// What needs no wave term, the lid's rows without their own densities.
void InfluenceMatrices::fillRigid(const FarWave::At& at, Systems& systems) const {
  const auto [K, share, all] = at;
  const int hull = pairs_.hull(), lid = all - hull;
  for (int p = 0; p < parities(); ++p) {
    const RankineParts& part = rankine_.parts(static_cast<Parity>(p));
    auto& [L, R, H, formulation] = systems[static_cast<std::size_t>(p)];
    const auto G = [](const Eigen::MatrixXd& rigid, int rows, int columns) {
      return kG * rigid.topLeftCorner(rows, columns).cast<Complex>();
    };
    L = G(part.rigidNormal, all, all);
    if (pairs_.isSource())
      L.bottomRows(lid) = K * kG * part.rigid.block(hull, 0, lid, all).cast<Complex>();
    else
      L.rightCols(lid) = K * kG * part.rigid.block(0, hull, all, lid).cast<Complex>();
    R = G(part.rigid, static_cast<int>(R.rows()), static_cast<int>(R.cols()));
    if (H.size() > 0) H = G(part.rigidX, hull, all);
    L.bottomRows(lid) *= share;
    if (!pairs_.isSource()) R.bottomRows(lid) *= share;
  }
}

/// Jumps of the layers: ½ on the hull's diagonal, and of ∂φ/∂x in H. The lid's densities.
void InfluenceMatrices::addDiagonals(Systems& systems) const {
  const int hull = pairs_.hull();
  for (int p = 0; p < parities(); ++p) {
    auto& [L, R, H, formulation] = systems[static_cast<std::size_t>(p)];
    L.diagonal().head(hull).array() += 0.5;
    L.diagonal().tail(L.rows() - hull).array() -= 1.0;
    for (int i = 0; i < hull && H.size() > 0; ++i) H(i, i) += 0.5 * pairs_.panel(i).normal.x();
  }
}

void InfluenceMatrices::add(const Pair& pair, const FarWave::At& at, const WaveIntegral& wave,
                            Complex x, Systems& systems) const {
  const int hull = pairs_.hull();
  const bool onLid = pairs_.isSource() ? pair.field >= hull : pair.source >= hull;
  for (int p = 0; p < parities(); ++p) {
    auto& [L, R, H, formulation] = systems[static_cast<std::size_t>(p)];
    const double factor = (pair.mirrored && p == 1 ? -kG : kG) * at.rowShare(pair.field, hull);
    L(pair.field, pair.source) += factor * (onLid ? at.K * wave.value : wave.along);
    if (onLid) continue;
    R(pair.field, pair.source) += factor * wave.value;
    if (H.size() > 0) H(pair.field, pair.source) += factor * x;
  }
}

void InfluenceMatrices::addFarWaves(const FarWave::At& at, Systems& systems) const {
  for (int j = 0; j < at.all; ++j)
    for (int i = 0; i <= j; ++i)
      for (int m = 0; m < parities(); ++m) {
        const Pair pair{i, j, m == 1}, back{j, i, m == 1};
        if (pairs_.isNear(pair)) continue;
        if (settings().sourcePoints == 1) {
          addFarPair(pair, at, systems);
        } else {
          addFarWave(pair, at, systems);
          if (i != j) addFarWave(back, at, systems);
        }
      }
}

// The wave term of two centroids serves both directions: it depends on the horizontal distance and
// on z + ζ only. With mirrored, x_i at −y_i seen from j is the mirror image of x_j at −y_j seen
// from i.
void InfluenceMatrices::addFarPair(const Pair& pair, const FarWave::At& at,
                                   Systems& systems) const {
  const double K = at.K;
  const Pair back{pair.source, pair.field, pair.mirrored};
  const auto apart = [&](const Pair& p) -> Vec3 {
    return pairs_.panel(p.source).centroid - imageInY(pairs_.panel(p.field).centroid, p.mirrored);
  };
  const Vec3 d = apart(pair);
  const double h = std::sqrt(d.x() * d.x() + d.y() * d.y()), perH = h > 0.0 ? 1.0 / h : 0.0;
  const double depth =
      -(pairs_.panel(pair.field).centroid.z() + pairs_.panel(pair.source).centroid.z());
  const WavePoint w(K, K * h, K * depth);
  // In place of −2/R₁ of the centroids goes the panel's own, as far as K F has become that. With
  // more points than one the two are the same.
  const double R1 = std::hypot(h, depth);
  const double perR1 = 1.0 / R1, perCube = std::pow(perR1, 3);
  const double share = 2.0 * inverseShare(perR1 / K);
  const auto put = [&](const Pair& p, const Vec3& between) {
    const double area = pairs_.panel(p.source).area;
    const RankineMatrices::Image image = rankine_.imageOf(p);
    const auto derivative = [&](const Vec3& e, double exact) {
      const double towards = (e.x() * between.x() + e.y() * between.y()) * perH, up = e.z();
      return area *
                 (towards * w.slope - up * w.rise - share * (towards * h - up * depth) * perCube) -
             share * exact;
    };
    const Complex value = area * (w.value + share * perR1) - share * image.potential;
    const Complex x =
        settings().xDerivative ? derivative(-Vec3::UnitX(), image.x) : Complex(0.0, 0.0);
    add(p, at, {value, derivative(pairs_.direction(p), image.normal)}, x, systems);
  };
  put(pair, d);
  if (pair.field != pair.source) put(back, apart(back));
}

void InfluenceMatrices::addFarWave(const Pair& pair, const FarWave::At& at,
                                   Systems& systems) const {
  const double K = at.K;
  const Vec3 e = pairs_.direction(pair);
  const double fieldArea = pairs_.panel(pair.field).area;
  WaveIntegral sum{};
  Complex sumX = 0.0;
  const int n = pairs_.pointsPerSide(pair.field, pair.source, K);
  for (const QuadraturePoint& seen :
       pairs_.points(pair.field, pairs_.fieldPointsPerSide(pair, K))) {
    const Vec3 x = imageInY(seen.x, pair.mirrored);
    for (const QuadraturePoint& point : pairs_.points(pair.source, n)) {
      const double dx = point.x.x() - x.x(), dy = point.x.y() - x.y();
      const double h = std::sqrt(dx * dx + dy * dy), perH = h > 0.0 ? 1.0 / h : 0.0;
      const WavePoint w(K, K * h, -K * (x.z() + point.x.z()));
      const double weight = point.weight * seen.weight / fieldArea;
      sum.value += weight * w.value;
      sum.along += weight * ((e.x() * dx + e.y() * dy) * perH * w.slope - e.z() * w.rise);
      sumX -= weight * dx * perH * w.slope;
    }
  }
  add(pair, at, sum, sumX, systems);
}

// Averaged equations have as many points on the field as on the source panel, so that both
// directions share them; others, and settings.sourcePoints, take each direction by itself.
void InfluenceMatrices::addNearWaves(const FarWave::At& at, Systems& systems) const {
  const double K = at.K;
  const bool share = settings().sourcePoints == 0 && settings().galerkinPoints > 1;
  const auto give = [&](const NearPair& near, const NearSums& sums) {
    const double area = pairs_.panel(near.pair.field).area;
    const WaveIntegral wave = nearWave(sums, area, near.image, pairs_.direction(near.pair), K);
    const Complex x = settings().xDerivative
                          ? nearWave(sums, area, near.alongX, -Vec3::UnitX(), K).along
                          : Complex(0.0, 0.0);
    add(near.pair, at, wave, x, systems);
  };
  for (int source = 0; source < at.all; ++source) {
    for (const NearPair& near : rankine_.near(source)) {
      const auto& [field, of, mirrored] = near.pair;
      if (field >= at.all || (share && field > source)) continue;
      if (!share) {
        const int n = pairs_.pointsPerSide(field, source, K);
        const auto& on = pairs_.points(source, settings().sourcePoints == 0 ? std::max(2, n) : n);
        const auto& seen = pairs_.points(field, pairs_.fieldPointsPerSide(near.pair, K));
        give(near, NearSums(seen, mirrored, on, K));
        continue;
      }
      const NearSums sums(pairs_.fewPoints(source, field, K), mirrored,
                          pairs_.fewPoints(field, source, K), K);
      give(near, sums);
      if (field < source) give(rankine_.near(field)[near.opposite], sums.exchanged(mirrored));
    }
  }
}

InfluenceSystem<double> InfluenceMatrices::atLimit(FrequencyLimit limit, Parity parity) const {
  const RankineParts& part = rankine_.parts(parity);
  const int hull = pairs_.hull();
  const double images = limit == FrequencyLimit::Zero ? 0.0 : 2.0;  // of the two in `rigid`
  const auto both = [&](const Eigen::MatrixXd& rigid,
                        const Eigen::MatrixXd& image) -> Eigen::MatrixXd {
    return kG * (rigid.topLeftCorner(hull, hull) - images * image.topLeftCorner(hull, hull));
  };
  InfluenceSystem<double> system;
  system.formulation = settings().formulation;
  system.L = both(part.rigidNormal, part.imageNormal);
  system.L.diagonal().array() += 0.5;
  system.R = both(part.rigid, part.image);
  if (!settings().xDerivative) return system;
  system.H = both(part.rigidX, part.imageX);
  for (int i = 0; i < hull; ++i) system.H(i, i) += 0.5 * pairs_.panel(i).normal.x();
  return system;
}

}  // namespace cutwater
