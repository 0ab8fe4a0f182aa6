#include "hydro/bem/matrices/RankineMatrices.h"

#include <algorithm>

#include "hydro/base/ParallelFor.h"
#include "hydro/base/SimdMath.h"

namespace cutwater {
namespace {

using Sample = RankineMatrices::Sample;

RankinePanel rankineOf(const Panel& panel) {
  return RankinePanel(std::span(panel.corner.data(), static_cast<std::size_t>(panel.corners)));
}

/// @param n of the field point, or of its image: only for the source formulation.
void add(const RankineIntegrals& at, const Vec3& n, bool source, double weight, Sample& sum) {
  sum.potential += weight * at.potential;
  sum.normal += weight * (source ? n.dot(at.gradient) : at.doubleLayer);
  sum.x += weight * at.gradient.x();
}

void add(const NearImage& one, double weight, NearImage& sum) {
  sum.log += weight * one.log;
  sum.inverse += weight * one.inverse;
  sum.inverseAlong += weight * one.inverseAlong;
  sum.logAlong += weight * one.logAlong;
}

}  // namespace

namespace {

/// Four Galerkin points together, if their number allows.
std::vector<RankineMatrices::WeightedPoints4> blocksOf(const std::vector<QuadraturePoint>& points,
                                                       double area) {
  std::vector<RankineMatrices::WeightedPoints4> blocks;
  if (points.size() % 4 != 0) return blocks;
  for (std::size_t from = 0; from < points.size(); from += 4) {
    RankineMatrices::WeightedPoints4& block = blocks.emplace_back();
    for (std::size_t i = 0; i < 4; ++i) {
      const QuadraturePoint& point = points[from + i];
      block.x[i] = point.x.x();
      block.y[i] = point.x.y();
      block.z[i] = point.x.z();
      block.weight[i] = point.weight / area;
    }
  }
  return blocks;
}

}  // namespace

RankineMatrices::RankineMatrices(const PanelPairs& pairs)
    : pairs_(pairs), near_(static_cast<std::size_t>(pairs.all())) {
  const int all = pairs.all();
  for (int i = 0; i < all; ++i)
    pointBlocks_.push_back(blocksOf(pairs.galerkin(i), pairs.panel(i).area));
  for (int p = 0; p < pairs.parities(); ++p) {
    RankineParts& part = parts_[static_cast<std::size_t>(p)];
    for (Eigen::MatrixXd* m : {&part.rigid, &part.image, &part.rigidNormal, &part.imageNormal})
      m->resize(all, all);
    if (!pairs.settings().xDerivative) continue;
    part.rigidX.resize(all, all);
    part.imageX.resize(all, all);
  }
  parallelFor(static_cast<std::size_t>(all), pairs.settings().threads, [this](std::size_t source) {
    integrate(static_cast<int>(source));
    findNear(static_cast<int>(source));
  });
  for (int source = 0; source < all; ++source) findOpposites(source);
}

namespace {

/// What `add` sums over all points, four at a time by the far form.
CUTWATER_VECTOR Sample farSample(const RankinePanel& rankine,
                                 const std::vector<RankineMatrices::WeightedPoints4>& points,
                                 bool mirrored, bool image, const Vec3& n, bool source) {
  const double sideY = mirrored ? -1.0 : 1.0, sideZ = image ? -1.0 : 1.0;
  Double4 potential{}, normal{}, x{};
  for (const RankineMatrices::WeightedPoints4& block : points) {
    const Double4 weight = load4(block.weight);
    const RankinePanel::Integrals4 at =
        rankine.farAt({load4(block.x), sideY * load4(block.y), sideZ * load4(block.z)});
    potential += weight * at.potential;
    normal += weight * (source ? n.x() * at.gradientX + n.y() * at.gradientY + n.z() * at.gradientZ
                               : at.doubleLayer);
    x += weight * at.gradientX;
  }
  return {sumOf(potential), sumOf(normal), sumOf(x)};
}

}  // namespace

/// 1/R of one source panel (or its image in z = 0) and a field panel, mean over the latter.
RankineMatrices::Sample RankineMatrices::sample(const RankinePanel& rankine, const Pair& pair,
                                                bool image) const {
  const Panel& panel = pairs_.panel(pair.field);
  const auto seen = [&](const Vec3& x) {
    const Vec3 y = imageInY(x, pair.mirrored);
    return image ? imageInZ(y) : y;
  };
  const Vec3 n = seen(panel.normal);
  const auto& points = pairs_.galerkin(pair.field);
  const auto& blocks = pointBlocks_[static_cast<std::size_t>(pair.field)];
  const double reach = RankinePanel::kFarRatio * rankine.radius() + pairs_.size(pair.field);
  if (!blocks.empty() && (seen(panel.centroid) - rankine.centroid()).squaredNorm() > reach * reach)
    return farSample(rankine, blocks, pair.mirrored, image, n, pairs_.isSource());
  Sample sum;
  for (const QuadraturePoint& point : points) {
    RankineIntegrals at = rankine.at(seen(point.x));
    if (pair.field == pair.source && !pair.mirrored && !image) {
      at.gradient -= n.dot(at.gradient) * n;
      at.doubleLayer = 0.0;
    }
    add(at, n, pairs_.isSource(), point.weight / panel.area, sum);
  }
  return sum;
}

void RankineMatrices::integrate(int source) {
  const RankinePanel rankine = rankineOf(pairs_.panel(source));
  for (int field = 0; field < pairs_.all(); ++field) {
    std::array<Sample, 2> direct{}, image{};  // of the port and the starboard field panel
    for (int m = 0; m < pairs_.parities(); ++m) {
      const Pair pair{field, source, m == 1};
      direct[static_cast<std::size_t>(m)] = sample(rankine, pair, false);
      image[static_cast<std::size_t>(m)] = sample(rankine, pair, true);
    }
    for (int p = 0; p < pairs_.parities(); ++p) {
      RankineParts& part = parts_[static_cast<std::size_t>(p)];
      const auto put = [&](Eigen::MatrixXd& rigid, Eigen::MatrixXd& ofImage, double Sample::*what) {
        const double odd = p == 0 ? 1.0 : -1.0;
        const double mirrored = image[0].*what + odd * image[1].*what;
        ofImage(field, source) = mirrored;
        rigid(field, source) = direct[0].*what + odd * direct[1].*what + mirrored;
      };
      put(part.rigid, part.image, &Sample::potential);
      put(part.rigidNormal, part.imageNormal, &Sample::normal);
      if (pairs_.settings().xDerivative) put(part.rigidX, part.imageX, &Sample::x);
    }
  }
}

void RankineMatrices::findNear(int source) {
  const Panel& panel = pairs_.panel(source);
  const RankinePanel rankine = rankineOf(panel);
  QuarteredPanel quartered(panel);
  for (int m = 0; m < pairs_.parities(); ++m)
    for (int field = 0; field < pairs_.all(); ++field) {
      NearPair near{{field, source, m == 1}, {}, {}, 0};
      if (!pairs_.isNear(near.pair)) continue;
      const Panel& seen = pairs_.panel(field);
      const Vec3 along = pairs_.direction(near.pair);
      for (const QuadraturePoint& point : pairs_.galerkin(field)) {
        const Vec3 x = imageInY(point.x, m == 1);
        const double weight = point.weight / seen.area;
        add(nearImage(x, quartered, rankine, along), weight, near.image);
        if (pairs_.settings().xDerivative)
          add(nearImage(x, quartered, rankine, -Vec3::UnitX()), weight, near.alongX);
      }
      near.image.distance = near.alongX.distance =
          (imageInZ(imageInY(seen.centroid, m == 1)) - panel.centroid).norm();
      near_[static_cast<std::size_t>(source)].push_back(near);
    }
}

void RankineMatrices::findOpposites(int source) {
  for (NearPair& pair : near_[static_cast<std::size_t>(source)]) {
    const auto& [field, of, mirrored] = pair.pair;
    pair.opposite =
        static_cast<std::size_t>(&near(field, mirrored, of, of + 1).front() - near(field).data());
  }
}

std::span<const NearPair> RankineMatrices::near(int source, bool mirrored, int from, int to) const {
  const std::vector<NearPair>& all = near(source);
  const auto isBefore = [mirrored](const NearPair& near, int field) {
    return near.pair.mirrored == mirrored ? near.pair.field < field : mirrored;
  };
  const auto first = std::lower_bound(all.begin(), all.end(), from, isBefore);
  auto last = first;
  while (last != all.end() && isBefore(*last, to)) ++last;
  return {first, last};
}

RankineMatrices::Image RankineMatrices::imageOf(const Pair& pair) const {
  const auto part = [&](const Eigen::MatrixXd RankineParts::*matrix) {
    const double even = (parts_[0].*matrix)(pair.field, pair.source);
    if (pairs_.parities() == 1) return even;
    const double odd = (parts_[1].*matrix)(pair.field, pair.source);
    return 0.5 * (pair.mirrored ? even - odd : even + odd);
  };
  return {part(&RankineParts::image), part(&RankineParts::imageNormal),
          pairs_.settings().xDerivative ? part(&RankineParts::imageX) : 0.0};
}

}  // namespace cutwater
