#include "hydro/bem/FarWave.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "hydro/Vector.h"
#include "hydro/green/WaveTerm.h"

namespace cutwater {
namespace {

constexpr int kSide = 16;               // panels a side of a tile
constexpr int kPairs = kSide * kSide;  // their arrays stay in the nearest cache
constexpr double kG = -1.0 / (4.0 * kPi);
constexpr double kTwoPi = 2.0 * kPi;
constexpr double kFrom = 1.0, kFully = 2.0;  // X: o counts
/// Beyond this many panel diameters one point on −2/R₁ is off by less than 1/(24·12²) = 3e-4.
constexpr double kExactImage = 12.0;

using Column = std::array<double, kPairs>;

}  // namespace

/// All pairs of two blocks, place 16·source + field. Vectors ê from the (mirrored) field panel to the
/// source panel.
struct FarWave::Tile {
  Column ex, ey, perH, h, depth, R1, X, Y, active;  // active: 0 for near pairs
  Column F, FX, J0, J1, Y0, Y1;
  Column formRe, formIm;  // S_i S_j
  Column alongAlong, acrossAcross, alongAcross, alongUp, acrossUp, upUp;  // ⟨ss⟩ of both [m²]
  Column acrossRe, acrossIm;       // derivative at right angles to ê
  Column valueRe, valueIm, slopeRe, slopeIm, riseRe, riseIm;  // of g, panels' extent included
  Column sourceRe, sourceIm, fieldRe, fieldIm;      // derivative along either normal
  Column share;  // of −2/R₁ to be replaced by the exact integral
  bool exactImages = false;
};

/// Field and source of the entries to be written: as the tile has them, or exchanged.
struct FarWave::Direction {
  Block field, source;
  bool exchanged;
};

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
  const auto tiles = std::make_unique<std::array<Tile, 2>>();
  const std::vector<Block> rows = blocks(all);
  for (std::size_t j = 0; j < rows.size(); ++j)
    for (std::size_t i = 0; i <= j; ++i) {
      for (int m = 0; m < pairs_.parities(); ++m) {
        Tile& tile = (*tiles)[static_cast<std::size_t>(m)];
        place(rows[i], rows[j], m == 1, K, tile);
        waveTerms(tile.X.data(), tile.Y.data(), kPairs,
                  {tile.F.data(), tile.FX.data(), tile.J0.data(), tile.J1.data(), tile.Y0.data(),
                   tile.Y1.data()});
        factors(form, rows[i], rows[j], m == 1, tile);
        combine(K, tile);
        derive(rows[i], rows[j], m == 1, tile);
      }
      for (int p = 0; p < pairs_.parities(); ++p) {
        InfluenceSystem<Complex>& system = systems[static_cast<std::size_t>(p)];
        write({rows[i], rows[j], false}, K, *tiles, p, system);
        if (i != j) write({rows[j], rows[i], true}, K, *tiles, p, system);
      }
    }
}

CUTWATER_VECTOR void FarWave::place(const Block& field, const Block& source, bool mirrored,
                                    double K, Tile& t) const {
  const double side = mirrored ? -1.0 : 1.0;
  t.exactImages = false;
  t.X.fill(0.0);
  t.Y.fill(1.0);
  t.active.fill(0.0);
  for (int j = 0; j < source.size; ++j) {
    const auto s = static_cast<std::size_t>(source.begin + j);
    const double xj = x_[s], yj = y_[s], zj = z_[s], sizeJ = size_[s];
    const char* far = &isFar_[mirrored ? 1 : 0][s * x_.size()];
    for (int i = 0; i < field.size; ++i) {
      const auto f = static_cast<std::size_t>(field.begin + i),
                 k = static_cast<std::size_t>(kSide * j + i);
      const double dx = xj - x_[f], dy = yj - side * y_[f], depth = -(z_[f] + zj);
      const double hh = dx * dx + dy * dy, h = std::sqrt(hh);
      const double perH = 1.0 / std::max(h, 1e-300);
      const double R1 = std::sqrt(hh + depth * depth);
      const double active = far[f];
      t.ex[k] = h > 0.0 ? dx * perH : 1.0;
      t.ey[k] = dy * perH;
      t.perH[k] = perH;
      t.h[k] = h;
      t.depth[k] = depth;
      t.R1[k] = R1;
      t.active[k] = active;
      t.X[k] = active * K * h;
      t.Y[k] = active * K * depth + (1.0 - active);
      t.exactImages = t.exactImages || R1 < kExactImage * std::max(sizeJ, size_[f]);
    }
  }
}

void FarWave::factors(const FormFactors& form, const Block& field, const Block& source,
                      bool mirrored, Tile& t) const {
  const double side = mirrored ? -1.0 : 1.0;
  const bool galerkin = pairs_.settings().galerkinPoints > 1;
  constexpr double kQuadrant = FormFactors::kSteps / 4;
  for (int j = 0; j < source.size; ++j) {
    const auto s = static_cast<std::size_t>(source.begin + j);
    const Complex* formJ = form.of(source.begin + j);
    for (int i = 0; i < field.size; ++i) {
      const auto f = static_cast<std::size_t>(field.begin + i),
                 k = static_cast<std::size_t>(kSide * j + i);
      const double ex = t.ex[k], ey = t.ey[k];
      const double sine = ey / std::max(std::abs(ex) + std::abs(ey), 1e-300);
      double angle = ex < 0.0 ? 2.0 - sine : sine < 0.0 ? 4.0 + sine : sine;
      angle *= kQuadrant;
      const auto at = [](const Complex* values, double place) {
        const int cell = std::min(static_cast<int>(place), FormFactors::kSteps - 1);
        return values[cell] + (place - cell) * (values[cell + 1] - values[cell]);
      };
      Complex S = at(formJ, angle);
      // Horizontally the field panel's points count backwards.
      double xx = xx_[s], xy = xy_[s], yy = yy_[s], xz = xz_[s], yz = yz_[s], zz = zz_[s];
      if (galerkin) {
        const Complex c = std::conj(at(form.of(field.begin + i), mirrored ? 4.0 * kQuadrant - angle : angle));
        S = {S.real() * c.real() - S.imag() * c.imag(), S.real() * c.imag() + S.imag() * c.real()};
        xx += xx_[f];
        xy += side * xy_[f];
        yy += yy_[f];
        xz -= xz_[f];
        yz -= side * yz_[f];
        zz += zz_[f];
      }
      t.formRe[k] = S.real();
      t.formIm[k] = S.imag();
      t.alongAlong[k] = ex * ex * xx + 2.0 * ex * ey * xy + ey * ey * yy;
      t.acrossAcross[k] = ey * ey * xx - 2.0 * ex * ey * xy + ex * ex * yy;
      t.alongAcross[k] = ex * ey * (yy - xx) + (ex * ex - ey * ey) * xy;
      t.alongUp[k] = ex * xz + ey * yz;
      t.acrossUp[k] = ex * yz - ey * xz;
      t.upUp[k] = zz;
    }
  }
}

namespace {

/// Derivatives of a function of X and Y that is harmonic in space, from which the others follow:
/// bend = (∂/∂X)/X, XX = −bend − YY.
struct Jet {
  double X, XY, YY, XYY, YYY;
};

/// ½⟨(s·∇)²⟩ of the function and of its derivatives along, across and by Y.
struct Second {
  double value, slope, across, byY;
};

CUTWATER_INLINE Second second(const Jet& a, double X, double along, double across, double mixed,
                              double alongUp, double acrossUp, double up) {
  constexpr double kSmall = 1e-2;  // X; from there to 0 the limit
  const double perX = 1.0 / std::max(X, kSmall);
  const double bend = X > kSmall ? a.X * perX : -0.5 * a.YY;
  const double XX = -bend - a.YY;
  const double bendX = X > kSmall ? (XX - bend) * perX : 0.0;
  const double bendY = X > kSmall ? a.XY * perX : -0.5 * a.YYY;
  const double XXX = -bendX - a.XYY, XXY = -bendY - a.YYY;
  return {0.5 * (along * XX + across * bend + up * a.YY) - alongUp * a.XY,
          0.5 * (along * XXX + across * bendX + up * a.XYY) - alongUp * XXY,
          mixed * bendX - acrossUp * bendY,
          0.5 * (along * XXY + across * bendY + up * a.YYY) - alongUp * a.XYY};
}

}  // namespace

/// g and its derivatives, the panels' extent included; −2/R₁ left out as far as its exact integral
/// will take its place.
CUTWATER_VECTOR void FarWave::combine(double K, Tile& t) const {
  const double KK = K * K;
  const bool exact = t.exactImages;
  for (std::size_t k = 0; k < kPairs; ++k) {
    const double X = t.X[k], Y = t.Y[k], F = t.F[k], FX = t.FX[k];
    const double place = std::clamp((X - kFrom) / (kFully - kFrom), 0.0, 1.0);
    const double count = place * place * (3.0 - 2.0 * place);
    const double J0 = kTwoPi * t.J0[k], J1 = kTwoPi * t.J1[k], Y0 = kTwoPi * t.Y0[k],
                 Y1 = kTwoPi * t.Y1[k];
    const double along = KK * t.alongAlong[k], across = KK * t.acrossAcross[k],
                 mixed = KK * t.alongAcross[k], alongUp = KK * t.alongUp[k],
                 acrossUp = KK * t.acrossUp[k], up = KK * t.upUp[k];
    // Waves o. H = J − iY: d = H₀′/H₀ = −H₁/H₀, e = −1/d
    const double perH0 = 1.0 / (J0 * J0 + Y0 * Y0 + 1e-300),
                 perH1 = 1.0 / (J1 * J1 + Y1 * Y1 + 1e-300);
    const double same = J0 * J1 + Y0 * Y1, cross = J1 * Y0 - Y1 * J0;
    const double dRe = -same * perH0, dIm = -cross * perH0, eRe = same * perH1,
                 eIm = -cross * perH1;
    const double perX = 1.0 / std::max(X, 0.5);
    const double front = 0.5 * (across - along) * perX;
    const double vRe = 1.0 + front * dRe + alongUp * dRe,
                 vIm = front * dIm + alongUp * (dIm + 1.0);
    const double sRe = 1.0 + front * (eRe - 2.0 * perX) + alongUp * (eRe - perX),
                 sIm = front * eIm + alongUp * (eIm + 1.0);
    const double formRe = t.formRe[k], formIm = t.formIm[k];
    const double re = count * (formRe * vRe - formIm * vIm - 1.0),
                 im = count * (formRe * vIm + formIm * vRe);
    const double slopeRe = count * (formRe * sRe - formIm * sIm - 1.0),
                 slopeIm = count * (formRe * sIm + formIm * sRe);
    // o = −(Y₀ + iJ₀), ∂o/∂X = Y₁ + iJ₁, ∂o/∂Y = −o; times 2πK e^{−Y}
    const double waveRe = -(Y0 * re - J0 * im), waveIm = -(Y0 * im + J0 * re);
    const double bend = count * mixed * perX;
    const double turnRe = bend * (eRe - 2.0 * perX) + count * acrossUp * perX, turnIm = bend * eIm;
    const double sideRe = turnRe * formRe - turnIm * formIm,
                 sideIm = turnRe * formIm + turnIm * formRe;
    // The rest: F + share/R without what counts of o.
    const double R = K * t.R1[k], r = 1.0 / R, r2 = r * r, r3 = r * r2, r5 = r3 * r2, r7 = r5 * r2;
    const double fourth = 1.0 / (r2 * r2 * 256.0);
    const double share = exact ? 2.0 * fourth / (1.0 + fourth) : 0.0;
    const double rX = -X * r3, rY = -Y * r3, rXY = 3.0 * X * Y * r5,
                 rYY = 3.0 * Y * Y * r5 - r3;
    const double rXYY = 3.0 * X * r5 - 15.0 * X * Y * Y * r7,
                 rYYY = 9.0 * Y * r5 - 15.0 * Y * Y * Y * r7;
    const double FY = -F - 2.0 * r, FXY = -FX - 2.0 * rX, FYY = -FY - 2.0 * rY,
                 FXYY = -FXY - 2.0 * rXY, FYYY = -FYY - 2.0 * rYY;
    const double w0 = count * Y0, w1 = count * Y1;
    const Second real = second({FX + share * rX - w1, FXY + share * rXY + w1,
                                FYY + share * rYY + w0, FXYY + share * rXYY - w1,
                                FYYY + share * rYYY - w0},
                               X, along, across, mixed, alongUp, acrossUp, up);
    const double j0 = (count - 1.0) * J0, j1 = (count - 1.0) * J1;
    const Second imaginary = second({-j1, j1, j0, -j1, -j0}, X, along, across, mixed, alongUp,
                                    acrossUp, up);
    const double active = t.active[k];
    const double K2 = active * KK, K1 = active * K;
    t.share[k] = active * share;
    t.valueRe[k] = K1 * (F + share * r + waveRe + real.value);
    t.valueIm[k] = K1 * (waveIm - J0 + imaginary.value);
    t.slopeRe[k] = K2 * (FX + share * rX + Y1 * slopeRe - J1 * slopeIm + real.slope);
    t.slopeIm[k] = K2 * (J1 + Y1 * slopeIm + J1 * slopeRe + imaginary.slope);
    t.acrossRe[k] = K2 * (Y1 * sideRe - J1 * sideIm + real.across);
    t.acrossIm[k] = K2 * (Y1 * sideIm + J1 * sideRe + imaginary.across);
    t.riseRe[k] = K2 * (FY + share * rY - waveRe + real.byY);
    t.riseIm[k] = K2 * (J0 - waveIm + imaginary.byY);
  }
}

/// Along the source's normal, and, with the roles changed, along the field's.
CUTWATER_VECTOR void FarWave::derive(const Block& field, const Block& source, bool mirrored,
                                     Tile& t) const {
  const double side = mirrored ? -1.0 : 1.0;
  for (int j = 0; j < source.size; ++j) {
    const auto s = static_cast<std::size_t>(source.begin + j);
    const double nxj = nx_[s], nyj = ny_[s], nzj = nz_[s];
    for (int i = 0; i < field.size; ++i) {
      const auto f = static_cast<std::size_t>(field.begin + i),
                 k = static_cast<std::size_t>(kSide * j + i);
      const double towards = nxj * t.ex[k] + nyj * t.ey[k];
      const double back = -nx_[f] * t.ex[k] - side * ny_[f] * t.ey[k];
      const double across = nyj * t.ex[k] - nxj * t.ey[k];
      const double backAcross = nx_[f] * t.ey[k] - side * ny_[f] * t.ex[k];
      t.sourceRe[k] = towards * t.slopeRe[k] + across * t.acrossRe[k] - nzj * t.riseRe[k];
      t.sourceIm[k] = towards * t.slopeIm[k] + across * t.acrossIm[k] - nzj * t.riseIm[k];
      t.fieldRe[k] = back * t.slopeRe[k] + backAcross * t.acrossRe[k] - nz_[f] * t.riseRe[k];
      t.fieldIm[k] = back * t.slopeIm[k] + backAcross * t.acrossIm[k] - nz_[f] * t.riseIm[k];
    }
  }
}

CUTWATER_VECTOR void FarWave::write(const Direction& direction, double K,
                                    const std::array<Tile, 2>& tiles, int parity,
                                    InfluenceSystem<Complex>& system) const {
  const auto [field, source, exchanged] = direction;
  const bool isSource = pairs_.isSource();
  const bool onLid = (isSource ? field : source).begin >= pairs_.hull();
  const bool ofSource = isSource == exchanged;  // the tile's own source panel has the normal
  const RankineParts& rankine = rankine_.parts(static_cast<Parity>(parity));
  const RankineParts& other = rankine_.parts(pairs_.parities() == 1 ? Parity::Even : Parity::Odd);
  const RankineParts& even = rankine_.parts(Parity::Even);
  (void)rankine;
  const int mirrors = pairs_.parities();
  for (int c = 0; c < source.size; ++c) {
    const int column = source.begin + c;
    const double area = area_[static_cast<std::size_t>(column)];
    Complex* L = &system.L(field.begin, column);
    Complex* R = onLid ? nullptr : &system.R(field.begin, column);
    Complex* H = onLid || system.H.size() == 0 ? nullptr : &system.H(field.begin, column);
    for (int r = 0; r < field.size; ++r) {
      const auto k = static_cast<std::size_t>(exchanged ? kSide * r + c : kSide * c + r);
      double valueRe = 0.0, valueIm = 0.0, alongRe = 0.0, alongIm = 0.0, xRe = 0.0, xIm = 0.0;
      for (int m = 0; m < mirrors; ++m) {
        const Tile& t = tiles[static_cast<std::size_t>(m)];
        const double sign = m == 1 && parity == 1 ? kG * -1.0 : kG;
        double image = 0.0, imageN = 0.0, imageX = 0.0;
        if (t.exactImages) {
          const auto part = [&](const Eigen::MatrixXd RankineParts::*matrix) {
            const double e = (even.*matrix)(field.begin + r, column);
            if (mirrors == 1) return e;
            const double o = (other.*matrix)(field.begin + r, column);
            return 0.5 * (m == 1 ? e - o : e + o);
          };
          image = t.share[k] * part(&RankineParts::image);
          imageN = t.share[k] * part(&RankineParts::imageNormal);
          if (H != nullptr) imageX = t.share[k] * part(&RankineParts::imageX);
        }
        valueRe += sign * (area * t.valueRe[k] - image);
        valueIm += sign * area * t.valueIm[k];
        alongRe += sign * (area * (ofSource ? t.sourceRe[k] : t.fieldRe[k]) - imageN);
        alongIm += sign * area * (ofSource ? t.sourceIm[k] : t.fieldIm[k]);
        if (H == nullptr) continue;
        const double away = exchanged ? area : -area;
        xRe += sign * (away * (t.ex[k] * t.slopeRe[k] - t.ey[k] * t.acrossRe[k]) - imageX);
        xIm += sign * away * (t.ex[k] * t.slopeIm[k] - t.ey[k] * t.acrossIm[k]);
      }
      L[r] += onLid ? Complex(K * valueRe, K * valueIm) : Complex(alongRe, alongIm);
      if (R != nullptr) R[r] += Complex(valueRe, valueIm);
      if (H != nullptr) H[r] += Complex(xRe, xIm);
    }
  }
}

}  // namespace cutwater
