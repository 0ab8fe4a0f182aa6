#include "hydro/bem/matrices/FarWave.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "hydro/base/Simd.h"

namespace cutwater {
namespace {

constexpr int kSide = WaveTile::kSide;
/// Beyond this many panel diameters the second moments leave less than 1e-4 of −2/R₁.
constexpr double kExactImage = 6.0;

/// One panel's part of a block.
void put(const PanelPairs& pairs, int panel, std::size_t place, WaveTile::Panels& to) {
  const Panel& of = pairs.panel(panel);
  const auto& [u, v, second, third, fourth] = pairs.moments(panel);
  const auto [uu, uv2, vv] = second;
  const Eigen::Matrix3d M = uu * u * u.transpose() + vv * v * v.transpose() +
                            0.5 * uv2 * (u * v.transpose() + v * u.transpose());
  to.x[place] = of.centroid.x();
  to.y[place] = of.centroid.y();
  to.z[place] = of.centroid.z();
  to.size[place] = pairs.size(panel);
  to.nx[place] = of.normal.x();
  to.ny[place] = of.normal.y();
  to.nz[place] = of.normal.z();
  to.xx[place] = M(0, 0);
  to.xy[place] = M(0, 1);
  to.yy[place] = M(1, 1);
  to.xz[place] = M(0, 2);
  to.yz[place] = M(1, 2);
  to.zz[place] = M(2, 2);
}

/// As field panels: of their mirror images if so; of points without extent unless the equation is
/// averaged over them.
WaveTile::Panels asField(WaveTile::Panels panels, bool mirrored, bool averaged) {
  const double side = mirrored ? -1.0 : 1.0, extent = averaged ? 1.0 : 0.0;
  for (std::size_t i = 0; i < WaveTile::kSide; ++i) {
    panels.y[i] *= side;
    panels.nx[i] *= -1.0;
    panels.ny[i] *= -side;
    panels.xx[i] *= extent;
    panels.xy[i] *= extent * side;
    panels.yy[i] *= extent;
    panels.xz[i] *= -extent;
    panels.yz[i] *= -extent * side;
    panels.zz[i] *= extent;
  }
  return panels;
}

}  // namespace

FarWave::FarWave(const PanelPairs& pairs, const RankineMatrices& rankine)
    : pairs_(pairs), rankine_(rankine) {
  const int hull = pairs.hull(), all = pairs.all();
  for (int begin = 0; begin < hull; begin += kSide)
    blocks_.push_back(blockOf(begin, std::min(kSide, hull - begin)));
  for (int begin = hull; begin < all; begin += kSide)
    blocks_.push_back(blockOf(begin, std::min(kSide, all - begin)));
  for (int i = 0; i < all; ++i) area_.push_back(pairs.panel(i).area);
}

FarWave::Block FarWave::blockOf(int begin, int size) const {
  Block block{begin, size, {}, {}};
  for (int i = 0; i < kSide; ++i)
    put(pairs_, begin + std::min(i, size - 1), static_cast<std::size_t>(i), block.source);
  block.field = {asField(block.source, false, averages()), asField(block.source, true, averages())};
  return block;
}

// Blocks in groups, so that what is written with field and source exchanged goes to the same
// columns, and pages of memory, a few times running.
void FarWave::fill(const At& at, Systems& systems) const {
  constexpr std::size_t kGroup = 8;
  const FormFactors form(pairs_, at.all, at.K);
  const auto tiles = std::make_unique<std::array<WaveTile, 2>>();
  std::size_t count = 0;
  while (count < blocks_.size() && blocks_[count].begin < at.all) ++count;
  for (std::size_t group = 0; group < count; group += kGroup) {
    const std::size_t end = std::min(group + kGroup, count);
    for (std::size_t i = 0; i < end; ++i)
      for (std::size_t j = std::max(group, i); j < end; ++j) {
        fillPair(form, blocks_[i], blocks_[j], at, *tiles, systems);
        if (!averages() && j != i) fillPair(form, blocks_[j], blocks_[i], at, *tiles, systems);
      }
  }
}

void FarWave::fillPair(const FormFactors& form, const Block& field, const Block& source,
                       const At& at, std::array<WaveTile, 2>& tiles, Systems& systems) const {
  for (int m = 0; m < pairs_.parities(); ++m) {
    WaveTile& tile = tiles[static_cast<std::size_t>(m)];
    place(field, source, m == 1, at.K, tile);
    weigh(form, field, source, m == 1, tile);
    tile.evaluate(at.K);
  }
  const bool two = pairs_.parities() == 2;
  const bool images = tiles[0].takeImages || (two && tiles[1].takeImages);
  if (two) WaveTile::toParities(tiles[0], tiles[1]);
  for (int p = 0; p < pairs_.parities(); ++p) {
    const auto parity = static_cast<Parity>(p);
    InfluenceSystem<Complex>& system = systems[static_cast<std::size_t>(p)];
    for (const Target& target : {Target{field, source, false}, Target{source, field, true}}) {
      if (target.exchanged && (field.begin == source.begin || !averages())) continue;
      write(target, at, tiles[static_cast<std::size_t>(p)], parity, system);
      if (images) writeImages(target, at, tiles, parity, system);
    }
  }
}

/// Without pairs whose image is near, and without the places behind the last panels.
void FarWave::place(const Block& field, const Block& source, bool mirrored, double K,
                    WaveTile& tile) const {
  tile.source = &source.source;
  tile.field = &field.field[mirrored ? 1 : 0];
  tile.takeImages = tile.place(K) < kExactImage;
  const auto drop = [&](int i, int j) {
    tile.drop(static_cast<std::size_t>(i), static_cast<std::size_t>(j), K);
  };
  for (int j = 0; j < source.size; ++j)
    for (const NearPair& near :
         rankine_.near(source.begin + j, mirrored, field.begin, field.begin + field.size))
      drop(near.pair.field - field.begin, j);
  for (int j = 0; j < kSide; ++j)
    for (int i = j < source.size ? field.size : 0; i < kSide; ++i) drop(i, j);
}

CUTWATER_VECTOR void FarWave::weigh(const FormFactors& form, const Block& field,
                                    const Block& source, bool mirrored, WaveTile& t) const {
  const bool averaged = averages();
  WaveTile::Column at;
  for (std::size_t k = 0; k < WaveTile::kPairs; ++k) at[k] = FormFactors::placeOf(t.ex[k], t.ey[k]);
  for (int j = 0; j < source.size; ++j) {
    const Complex* formJ = form.of(source.begin + j);
    for (int i = 0; i < field.size; ++i) {
      const auto k = static_cast<std::size_t>(kSide * j + i);
      const Complex a = FormFactors::between(formJ, at[k]);
      const Complex b = averaged
                            ? FormFactors::between(form.of(field.begin + i),
                                                   mirrored ? FormFactors::kSteps - at[k] : at[k])
                            : 1.0;
      t.formRe[k] = a.real() * b.real() + a.imag() * b.imag();
      t.formIm[k] = a.imag() * b.real() - a.real() * b.imag();
    }
  }
}

namespace {

/// kG × (rigid + ΔS·wave) of one tile into a matrix. `step` from row to row of the matrix in the
/// tile: 1, or WaveTile::kSide if field and source are exchanged.
template <std::size_t step>
CUTWATER_INLINE void writeColumns(const WaveTile::Column& re, const WaveTile::Column& im,
                                  const Eigen::MatrixXd& rigid, const double* area, double factor,
                                  double wave, int row, int rows, int column, int columns,
                                  Eigen::MatrixXcd& to) {
  for (int c = 0; c < columns; ++c) {
    const double weight = factor * wave * area[column + c];
    const double* fixed = &rigid(row, column + c);
    auto* entry = reinterpret_cast<double*>(&to(row, column + c));
    const auto first = static_cast<std::size_t>(c) * (step == 1 ? WaveTile::kSide : 1);
    const double *wRe = re.data() + first, *wIm = im.data() + first;
    for (int r = 0; r < rows; ++r) {
      entry[2 * r] = factor * fixed[r] + weight * wRe[step * static_cast<std::size_t>(r)];
      entry[2 * r + 1] = weight * wIm[step * static_cast<std::size_t>(r)];
    }
  }
}

}  // namespace

// The normal is the source's (potential) or the field's with its horizontal part reversed (source),
// see PanelPairs. Seen the other way round ê is −ê, with y mirrored where the field panel was.
CUTWATER_VECTOR void FarWave::write(const Target& target, const At& at, const WaveTile& tile,
                                    Parity parity, InfluenceSystem<Complex>& system) const {
  const Block &field = target.field, &source = target.source;
  const bool exchanged = target.exchanged;
  const double G = kG * at.rowShare(field.begin, pairs_.hull());
  const RankineParts& part = rankine_.parts(parity);
  const auto put = [&](const WaveTile::Column& re, const WaveTile::Column& im,
                       const Eigen::MatrixXd& rigid, double factor, double wave,
                       Eigen::MatrixXcd& to) {
    if (exchanged)
      writeColumns<WaveTile::kSide>(re, im, rigid, area_.data(), factor, wave, field.begin,
                                    field.size, source.begin, source.size, to);
    else
      writeColumns<1>(re, im, rigid, area_.data(), factor, wave, field.begin, field.size,
                      source.begin, source.size, to);
  };
  if ((pairs_.isSource() ? field : source).begin >= pairs_.hull()) {
    put(tile.valueRe, tile.valueIm, part.rigid, G * at.K, 1.0, system.L);
    return;
  }
  if (pairs_.isSource() == exchanged)
    put(tile.sourceRe, tile.sourceIm, part.rigidNormal, G, 1.0, system.L);
  else
    put(tile.fieldRe, tile.fieldIm, part.rigidNormal, G, 1.0, system.L);
  put(tile.valueRe, tile.valueIm, part.rigid, G, 1.0, system.R);
  if (system.H.size() > 0)
    put(tile.xRe, tile.xIm, part.rigidX, G, exchanged ? 1.0 : -1.0, system.H);
}

// With a, b the shares of a panel and of its mirror image, E and O the integrals of the two
// parities: even a(E + O)/2 + b(E − O)/2, odd a(E + O)/2 − b(E − O)/2. The tiles hold a + b and
// a − b.
CUTWATER_VECTOR void FarWave::writeImages(const Target& target, const At& at,
                                          const std::array<WaveTile, 2>& tiles, Parity parity,
                                          InfluenceSystem<Complex>& system) const {
  const auto& [field, source, exchanged] = target;
  const bool onLid = (pairs_.isSource() ? field : source).begin >= pairs_.hull();
  const bool one = pairs_.parities() == 1;
  const double G = (one ? -kG : -0.5 * kG) * at.rowShare(field.begin, pairs_.hull());
  const RankineParts &own = rankine_.parts(parity),
                     &other =
                         rankine_.parts(one || parity == Parity::Odd ? Parity::Even : Parity::Odd);
  for (int c = 0; c < source.size; ++c)
    for (int r = 0; r < field.size; ++r) {
      const auto k = static_cast<std::size_t>(exchanged ? kSide * r + c : kSide * c + r);
      const double same = G * tiles[0].share[k], cross = one ? 0.0 : G * tiles[1].share[k];
      const int row = field.begin + r, column = source.begin + c;
      const auto integral = [&](const Eigen::MatrixXd RankineParts::*image) {
        return same * (own.*image)(row, column) + cross * (other.*image)(row, column);
      };
      const double value = integral(&RankineParts::image);
      system.L(row, column) += onLid ? at.K * value : integral(&RankineParts::imageNormal);
      if (onLid) continue;
      system.R(row, column) += value;
      if (system.H.size() > 0) system.H(row, column) += integral(&RankineParts::imageX);
    }
}

}  // namespace cutwater
