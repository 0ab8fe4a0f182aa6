#include "hydro/bem/FarWave.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "hydro/Vector.h"

namespace cutwater {
namespace {

constexpr int kSide = WaveTile::kSide;
/// Beyond this many panel diameters the second moments leave less than 1e-4 of −2/R₁.
constexpr double kExactImage = 6.0;

/// Linear between tabulated form factors.
CUTWATER_INLINE Complex between(const Complex* values, double place) {
  const int cell = std::min(static_cast<int>(place), FormFactors::kSteps - 1);
  return values[cell] + (place - cell) * (values[cell + 1] - values[cell]);
}

/// Place of the unit vector e in the table of form factors.
CUTWATER_INLINE double placeOf(double ex, double ey) {
  const double sine = ey / (std::abs(ex) + std::abs(ey));
  constexpr double kQuadrant = 0.25 * FormFactors::kSteps;
  return kQuadrant * (ex < 0.0 ? 2.0 - sine : sine < 0.0 ? 4.0 + sine : sine);
}

}  // namespace

FarWave::FarWave(const PanelPairs& pairs, const RankineMatrices& rankine)
    : pairs_(pairs), rankine_(rankine) {
  for (int i = 0; i < pairs.all(); ++i) {
    const Panel& panel = pairs.panel(i);
    const PanelMoments& moments = pairs.moments(i);
    const auto [uu, uv2, vv] = moments.second;
    const Vec3 &u = moments.u, &v = moments.v;
    const Eigen::Matrix3d M = uu * u * u.transpose() + vv * v * v.transpose() +
                              0.5 * uv2 * (u * v.transpose() + v * u.transpose());
    x_.push_back(panel.centroid.x());
    y_.push_back(panel.centroid.y());
    z_.push_back(panel.centroid.z());
    nx_.push_back(panel.normal.x());
    ny_.push_back(panel.normal.y());
    nz_.push_back(panel.normal.z());
    area_.push_back(panel.area);
    size_.push_back(pairs.size(i));
    xx_.push_back(M(0, 0));
    xy_.push_back(M(0, 1));
    yy_.push_back(M(1, 1));
    xz_.push_back(M(0, 2));
    yz_.push_back(M(1, 2));
    zz_.push_back(M(2, 2));
  }
  const auto all = static_cast<std::size_t>(pairs.all());
  for (std::vector<char>& far : isFar_) far.assign(all * all, 1);
  for (int source = 0; source < pairs.all(); ++source)
    for (const NearPair& near : rankine.near(source))
      isFar_[near.pair.mirrored ? 1 : 0][all * static_cast<std::size_t>(source) +
                                         static_cast<std::size_t>(near.pair.field)] = 0;
}

std::vector<FarWave::Block> FarWave::blocks(int all) const {
  std::vector<Block> result;
  const int hull = pairs_.hull();
  for (int begin = 0; begin < hull; begin += kSide)
    result.push_back({begin, std::min(kSide, hull - begin)});
  for (int begin = hull; begin < all; begin += kSide)
    result.push_back({begin, std::min(kSide, all - begin)});
  return result;
}

// Blocks in groups, so that what is written with field and source exchanged goes to the same columns,
// and pages of memory, a few times running.
void FarWave::fill(double K, int all, Systems& systems) const {
  constexpr std::size_t kGroup = 8;
  const FormFactors form(pairs_, all, K);
  const auto tiles = std::make_unique<std::array<WaveTile, 2>>();
  const std::vector<Block> rows = blocks(all);
  for (std::size_t group = 0; group < rows.size(); group += kGroup) {
    const std::size_t end = std::min(group + kGroup, rows.size());
    for (std::size_t i = 0; i < end; ++i)
      for (std::size_t j = std::max(group, i); j < end; ++j)
        fillPair(form, rows[i], rows[j], K, *tiles, systems);
  }
}

void FarWave::fillPair(const FormFactors& form, const Block& field, const Block& source, double K,
                       std::array<WaveTile, 2>& tiles, Systems& systems) const {
  for (int m = 0; m < pairs_.parities(); ++m) {
    WaveTile& tile = tiles[static_cast<std::size_t>(m)];
    place(field, source, m == 1, K, tile);
    weigh(form, field, source, m == 1, tile);
    addMoments(field, source, m == 1, tile);
    tile.evaluate(K);
  }
  const bool two = pairs_.parities() == 2;
  const bool images = tiles[0].takeImages || (two && tiles[1].takeImages);
  if (two) WaveTile::toParities(tiles[0], tiles[1]);
  for (int p = 0; p < pairs_.parities(); ++p) {
    const auto parity = static_cast<Parity>(p);
    InfluenceSystem<Complex>& system = systems[static_cast<std::size_t>(p)];
    for (const Target& target : {Target{field, source, false}, Target{source, field, true}}) {
      if (target.exchanged && field.begin == source.begin) continue;
      write(target, K, tiles[static_cast<std::size_t>(p)], parity, system);
      if (images) writeImages(target, K, tiles, parity, system);
    }
  }
}

CUTWATER_VECTOR void FarWave::place(const Block& field, const Block& source, bool mirrored,
                                    double K, WaveTile& t) const {
  const double side = mirrored ? -1.0 : 1.0;
  if (field.size < kSide || source.size < kSide) t.clear(K);
  int exact = 0;
  for (int j = 0; j < source.size; ++j) {
    const auto s = static_cast<std::size_t>(source.begin + j);
    const char* far = &isFar_[mirrored ? 1 : 0][s * x_.size()];
    const double x = x_[s], y = y_[s], z = z_[s], size = size_[s];
    const double nx = nx_[s], ny = ny_[s], nz = nz_[s];
    for (int i = 0; i < field.size; ++i) {
      const auto f = static_cast<std::size_t>(field.begin + i),
                 k = static_cast<std::size_t>(kSide * j + i);
      const double dx = x - x_[f], dy = y - side * y_[f], depth = -(z_[f] + z);
      const double hh = dx * dx + dy * dy, h = std::sqrt(hh), R1 = std::sqrt(hh + depth * depth);
      const double perH = 1.0 / (h > 0.0 ? h : 1.0), active = far[f] != 0 ? 1.0 : 0.0;
      t.ex[k] = h > 0.0 ? dx * perH : 1.0;
      t.ey[k] = dy * perH;
      t.X[k] = active * K * h;
      t.Y[k] = active * K * depth + 1.0 - active;
      t.R1[k] = active * R1 + (1.0 - active) / K;
      t.active[k] = active;
      t.sourceX[k] = nx;
      t.sourceY[k] = ny;
      t.sourceZ[k] = nz;
      t.fieldX[k] = -nx_[f];
      t.fieldY[k] = -side * ny_[f];
      t.fieldZ[k] = nz_[f];
      exact += R1 < kExactImage * std::max(size, size_[f]) ? 1 : 0;
    }
  }
  t.takeImages = exact > 0;
}

CUTWATER_VECTOR void FarWave::weigh(const FormFactors& form, const Block& field,
                                    const Block& source, bool mirrored, WaveTile& t) const {
  const bool meant = pairs_.settings().galerkinPoints > 1;
  for (int j = 0; j < source.size; ++j) {
    const Complex* formJ = form.of(source.begin + j);
    for (int i = 0; i < field.size; ++i) {
      const auto k = static_cast<std::size_t>(kSide * j + i);
      const double at = placeOf(t.ex[k], t.ey[k]);
      const Complex a = between(formJ, at);
      const Complex b =
          meant ? between(form.of(field.begin + i), mirrored ? FormFactors::kSteps - at : at) : 1.0;
      t.formRe[k] = a.real() * b.real() + a.imag() * b.imag();
      t.formIm[k] = a.imag() * b.real() - a.real() * b.imag();
    }
  }
}

// Horizontally the field panel's points count backwards; of its mirror image y does once more.
CUTWATER_VECTOR void FarWave::addMoments(const Block& field, const Block& source, bool mirrored,
                                         WaveTile& t) const {
  const double meant = pairs_.settings().galerkinPoints > 1 ? 1.0 : 0.0;
  const double side = mirrored ? -meant : meant;
  for (int j = 0; j < source.size; ++j) {
    const auto s = static_cast<std::size_t>(source.begin + j);
    for (int i = 0; i < field.size; ++i) {
      const auto f = static_cast<std::size_t>(field.begin + i),
                 k = static_cast<std::size_t>(kSide * j + i);
      const double ex = t.ex[k], ey = t.ey[k];
      const double xx = xx_[s] + meant * xx_[f], xy = xy_[s] + side * xy_[f],
                   yy = yy_[s] + meant * yy_[f], xz = xz_[s] - meant * xz_[f],
                   yz = yz_[s] - side * yz_[f];
      t.alongAlong[k] = ex * ex * xx + 2.0 * ex * ey * xy + ey * ey * yy;
      t.acrossAcross[k] = ey * ey * xx - 2.0 * ex * ey * xy + ex * ex * yy;
      t.alongAcross[k] = ex * ey * (yy - xx) + (ex * ex - ey * ey) * xy;
      t.alongUp[k] = ex * xz + ey * yz;
      t.acrossUp[k] = ex * yz - ey * xz;
      t.upUp[k] = zz_[s] + meant * zz_[f];
    }
  }
}

namespace {

/// kG × (rigid + ΔS·wave) of one tile into a matrix. `step` from row to row of the matrix in the tile:
/// 1, or WaveTile::kSide if field and source are exchanged.
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
CUTWATER_VECTOR void FarWave::write(const Target& target, double K, const WaveTile& tile,
                                    Parity parity, InfluenceSystem<Complex>& system) const {
  const Block &field = target.field, &source = target.source;
  const bool exchanged = target.exchanged;
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
    put(tile.valueRe, tile.valueIm, part.rigid, kG * K, 1.0, system.L);
    return;
  }
  if (pairs_.isSource() == exchanged)
    put(tile.sourceRe, tile.sourceIm, part.rigidNormal, kG, 1.0, system.L);
  else
    put(tile.fieldRe, tile.fieldIm, part.rigidNormal, kG, 1.0, system.L);
  put(tile.valueRe, tile.valueIm, part.rigid, kG, 1.0, system.R);
  if (system.H.size() > 0)
    put(tile.xRe, tile.xIm, part.rigidX, kG, exchanged ? 1.0 : -1.0, system.H);
}

// With a, b the shares of a panel and of its mirror image, E and O the integrals of the two parities:
// even a(E + O)/2 + b(E − O)/2, odd a(E + O)/2 − b(E − O)/2. The tiles hold a + b and a − b.
CUTWATER_VECTOR void FarWave::writeImages(const Target& target, double K,
                                          const std::array<WaveTile, 2>& tiles, Parity parity,
                                          InfluenceSystem<Complex>& system) const {
  const auto [field, source, exchanged] = target;
  const bool onLid = (pairs_.isSource() ? field : source).begin >= pairs_.hull();
  const bool one = pairs_.parities() == 1;
  const RankineParts &own = rankine_.parts(parity),
                     &other =
                         rankine_.parts(one || parity == Parity::Odd ? Parity::Even : Parity::Odd);
  for (int c = 0; c < source.size; ++c)
    for (int r = 0; r < field.size; ++r) {
      const auto k = static_cast<std::size_t>(exchanged ? kSide * r + c : kSide * c + r);
      const double same = one ? -kG * tiles[0].share[k] : -0.5 * kG * tiles[0].share[k],
                   cross = one ? 0.0 : -0.5 * kG * tiles[1].share[k];
      const int row = field.begin + r, column = source.begin + c;
      const auto integral = [&](const Eigen::MatrixXd RankineParts::*image) {
        return same * (own.*image)(row, column) + cross * (other.*image)(row, column);
      };
      const double value = integral(&RankineParts::image);
      system.L(row, column) += onLid ? K * value : integral(&RankineParts::imageNormal);
      if (onLid) continue;
      system.R(row, column) += value;
      if (system.H.size() > 0) system.H(row, column) += integral(&RankineParts::imageX);
    }
}

}  // namespace cutwater
