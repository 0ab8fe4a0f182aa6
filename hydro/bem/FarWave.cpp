#include "hydro/bem/FarWave.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "hydro/Vector.h"

namespace cutwater {
namespace {

constexpr int kSide = WaveTile::kSide;
constexpr double kG = -1.0 / (4.0 * kPi);
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
  return FormFactors::kSteps / 4 * (ex < 0.0 ? 2.0 - sine : sine < 0.0 ? 4.0 + sine : sine);
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
      isFar_[near.pair.mirrored ? 1 : 0]
            [all * static_cast<std::size_t>(source) + static_cast<std::size_t>(near.pair.field)] = 0;
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

void FarWave::add(double K, int all, Systems& systems) const {
  const FormFactors form(pairs_, all, K);
  const auto tiles = std::make_unique<std::array<WaveTile, 2>>();
  const std::vector<Block> rows = blocks(all);
  for (std::size_t j = 0; j < rows.size(); ++j)
    for (std::size_t i = 0; i <= j; ++i) {
      for (int m = 0; m < pairs_.parities(); ++m) {
        WaveTile& tile = (*tiles)[static_cast<std::size_t>(m)];
        place(rows[i], rows[j], m == 1, K, tile);
        weigh(form, rows[i], rows[j], m == 1, tile);
        tile.evaluate(K);
      }
      for (int p = 0; p < pairs_.parities(); ++p) {
        InfluenceSystem<Complex>& system = systems[static_cast<std::size_t>(p)];
        const auto parity = static_cast<Parity>(p);
        write({rows[i], rows[j], false}, K, *tiles, parity, system);
        if (i != j) write({rows[j], rows[i], true}, K, *tiles, parity, system);
        if (!(*tiles)[0].takeImages && !(*tiles)[1].takeImages) continue;
        writeImages({rows[i], rows[j], false}, K, *tiles, parity, system);
        if (i != j) writeImages({rows[j], rows[i], true}, K, *tiles, parity, system);
      }
    }
}

CUTWATER_VECTOR void FarWave::place(const Block& field, const Block& source, bool mirrored,
                                    double K, WaveTile& t) const {
  const double side = mirrored ? -1.0 : 1.0;
  t.takeImages = false;
  t.X.fill(0.0);
  t.Y.fill(1.0);
  t.R1.fill(1.0 / K);
  t.active.fill(0.0);
  for (int j = 0; j < source.size; ++j) {
    const auto s = static_cast<std::size_t>(source.begin + j);
    const char* far = &isFar_[mirrored ? 1 : 0][s * x_.size()];
    for (int i = 0; i < field.size; ++i) {
      const auto f = static_cast<std::size_t>(field.begin + i),
                 k = static_cast<std::size_t>(kSide * j + i);
      const double dx = x_[s] - x_[f], dy = y_[s] - side * y_[f], depth = -(z_[f] + z_[s]);
      const double hh = dx * dx + dy * dy, h = std::sqrt(hh), R1 = std::sqrt(hh + depth * depth);
      t.sourceX[k] = nx_[s];
      t.sourceY[k] = ny_[s];
      t.sourceZ[k] = nz_[s];
      t.fieldX[k] = -nx_[f];
      t.fieldY[k] = -side * ny_[f];
      t.fieldZ[k] = nz_[f];
      t.ex[k] = h > 0.0 ? dx / h : 1.0;
      t.ey[k] = h > 0.0 ? dy / h : 0.0;
      if (far[f] == 0) continue;
      t.X[k] = K * h;
      t.Y[k] = K * depth;
      t.R1[k] = R1;
      t.active[k] = 1.0;
      t.takeImages = t.takeImages || R1 < kExactImage * std::max(size_[s], size_[f]);
    }
  }
}

// Horizontally the field panel's points count backwards; of its mirror image y does once more.
CUTWATER_VECTOR void FarWave::weigh(const FormFactors& form, const Block& field,
                                    const Block& source, bool mirrored, WaveTile& t) const {
  const double side = mirrored ? -1.0 : 1.0;
  const double meant = pairs_.settings().galerkinPoints > 1 ? 1.0 : 0.0;
  for (int j = 0; j < source.size; ++j) {
    const auto s = static_cast<std::size_t>(source.begin + j);
    const Complex* formJ = form.of(source.begin + j);
    for (int i = 0; i < field.size; ++i) {
      const auto f = static_cast<std::size_t>(field.begin + i),
                 k = static_cast<std::size_t>(kSide * j + i);
      const double ex = t.ex[k], ey = t.ey[k], at = placeOf(ex, ey);
      const Complex a = between(formJ, at);
      const Complex b =
          meant > 0.0
              ? between(form.of(field.begin + i), mirrored ? FormFactors::kSteps - at : at)
              : Complex(1.0, 0.0);
      t.formRe[k] = a.real() * b.real() + a.imag() * b.imag();
      t.formIm[k] = a.imag() * b.real() - a.real() * b.imag();
      const double xx = xx_[s] + meant * xx_[f], xy = xy_[s] + meant * side * xy_[f],
                   yy = yy_[s] + meant * yy_[f], xz = xz_[s] - meant * xz_[f],
                   yz = yz_[s] - meant * side * yz_[f];
      t.alongAlong[k] = ex * ex * xx + 2.0 * ex * ey * xy + ey * ey * yy;
      t.acrossAcross[k] = ey * ey * xx - 2.0 * ex * ey * xy + ex * ex * yy;
      t.alongAcross[k] = ex * ey * (yy - xx) + (ex * ex - ey * ey) * xy;
      t.alongUp[k] = ex * xz + ey * yz;
      t.acrossUp[k] = ex * yz - ey * xz;
      t.upUp[k] = zz_[s] + meant * zz_[f];
    }
  }
}

// The normal is the source's (potential) or the field's with its horizontal part reversed (source),
// see PanelPairs. Seen the other way round ê is −ê, with y mirrored where the field panel was.
CUTWATER_VECTOR void FarWave::write(const Target& target, double K,
                                    const std::array<WaveTile, 2>& tiles, Parity parity,
                                    InfluenceSystem<Complex>& system) const {
  const auto [field, source, exchanged] = target;
  const bool isSource = pairs_.isSource();
  const bool onLid = (isSource ? field : source).begin >= pairs_.hull();
  const bool ofTileSource = isSource == exchanged, one = pairs_.parities() == 1;
  const double mirror = one ? 0.0 : parity == Parity::Odd ? -1.0 : 1.0;
  const WaveTile &a = tiles[0], &b = tiles[one ? 0 : 1];
  const auto add = [&](const WaveTile::Column WaveTile::*re, const WaveTile::Column WaveTile::*im,
                       double factor, Eigen::MatrixXcd& to) {
    const WaveTile::Column &aRe = a.*re, &aIm = a.*im, &bRe = b.*re, &bIm = b.*im;
    const std::size_t stepRow = exchanged ? WaveTile::kSide : 1,
                      stepColumn = exchanged ? 1 : WaveTile::kSide;
    for (int c = 0; c < source.size; ++c) {
      const double weight = factor * area_[static_cast<std::size_t>(source.begin + c)];
      auto* entry = reinterpret_cast<double*>(&to(field.begin, source.begin + c));
      std::size_t k = stepColumn * static_cast<std::size_t>(c);
      for (int r = 0; r < field.size; ++r, k += stepRow) {
        entry[2 * r] += weight * (aRe[k] + mirror * bRe[k]);
        entry[2 * r + 1] += weight * (aIm[k] + mirror * bIm[k]);
      }
    }
  };
  if (onLid) return add(&WaveTile::valueRe, &WaveTile::valueIm, kG * K, system.L);
  if (ofTileSource)
    add(&WaveTile::sourceRe, &WaveTile::sourceIm, kG, system.L);
  else
    add(&WaveTile::fieldRe, &WaveTile::fieldIm, kG, system.L);
  add(&WaveTile::valueRe, &WaveTile::valueIm, kG, system.R);
  if (system.H.size() > 0)
    add(&WaveTile::xRe, &WaveTile::xIm, exchanged ? kG : -kG, system.H);
}

// With a, b the shares of a panel and of its mirror image, E and O the integrals of the two parities:
// even a(E + O)/2 + b(E − O)/2, odd a(E + O)/2 − b(E − O)/2.
CUTWATER_VECTOR void FarWave::writeImages(const Target& target, double K,
                                          const std::array<WaveTile, 2>& tiles, Parity parity,
                                          InfluenceSystem<Complex>& system) const {
  const auto [field, source, exchanged] = target;
  const bool onLid = (pairs_.isSource() ? field : source).begin >= pairs_.hull();
  const bool one = pairs_.parities() == 1;
  const RankineParts &own = rankine_.parts(parity),
                     &other = rankine_.parts(one || parity == Parity::Odd ? Parity::Even
                                                                          : Parity::Odd);
  for (int c = 0; c < source.size; ++c)
    for (int r = 0; r < field.size; ++r) {
      const auto k = static_cast<std::size_t>(exchanged ? kSide * r + c : kSide * c + r);
      const double a = tiles[0].share[k], b = one ? a : tiles[1].share[k];
      const double same = -0.5 * kG * (a + b), cross = -0.5 * kG * (a - b);
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
