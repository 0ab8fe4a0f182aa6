#include "hydro/bem/matrices/WaveTile.h"

#include <algorithm>
#include <cmath>

#include "hydro/Conventions.h"
#include "hydro/base/SimdMath.h"
#include "hydro/bem/matrices/NearWave.h"
#include "hydro/green/WaveTerm.h"

namespace cutwater {
namespace {

constexpr double kTwoPi = 2.0 * kPi;
constexpr double kFrom = 1.0, kFully = 2.0;  // X: the waves o count

CUTWATER_INLINE Double4 load(const WaveTile::Column& column, std::size_t k) {
  return load4(column.data() + k);
}
CUTWATER_INLINE void store(WaveTile::Column& column, std::size_t k, Double4 value) {
  store4(column.data() + k, value);
}

/// Derivatives, by X and Y, of a function that is harmonic in space. The others follow:
/// bend = (∂/∂X)/X, XX = −bend − YY.
struct Jet {
  Double4 X, XY, YY, XYY, YYY;
};

/// K² times mean products of distances from the centroids, sum over both panels, along ê and
/// across.
struct Moments {
  Double4 along, across, mixed, alongUp, acrossUp, up;
};

/// Of source panel j and the field panels from i on.
CUTWATER_INLINE Moments moments(const WaveTile::Panels& source, std::size_t j,
                                const WaveTile::Panels& field, std::size_t i, Double4 ex,
                                Double4 ey, double KK) {
  const auto both = [&](const WaveTile::Edge WaveTile::Panels::*product) -> Double4 {
    return KK * ((source.*product)[j] + load4((field.*product).data() + i));
  };
  using Panels = WaveTile::Panels;
  const Double4 xx = both(&Panels::xx), xy = both(&Panels::xy), yy = both(&Panels::yy),
                xz = both(&Panels::xz), yz = both(&Panels::yz);
  return {ex * ex * xx + 2.0 * ex * ey * xy + ey * ey * yy,
          ey * ey * xx - 2.0 * ex * ey * xy + ex * ex * yy,
          ex * ey * (yy - xx) + (ex * ex - ey * ey) * xy,
          ex * xz + ey * yz,
          ex * yz - ey * xz,
          both(&Panels::zz)};
}

/// ½⟨(s·∇)²⟩ of a function and of its derivatives along ê, across it and by Y.
struct Second {
  Double4 value, slope, across, byY;
};

CUTWATER_INLINE Second second(const Jet& a, Double4 X, const Moments& m) {
  constexpr double kSmall = 1e-2;  // X; from there to 0 the limit
  const auto clear = X > kSmall;
  const Double4 zero = X * 0.0, perX = 1.0 / atLeast(X, kSmall);
  const Double4 bend = clear ? a.X * perX : -0.5 * a.YY;
  const Double4 XX = -bend - a.YY;
  const Double4 bendX = clear ? (XX - bend) * perX : zero;
  const Double4 bendY = clear ? a.XY * perX : -0.5 * a.YYY;
  const Double4 XXX = -bendX - a.XYY, XXY = -bendY - a.YYY;
  return {0.5 * (m.along * XX + m.across * bend + m.up * a.YY) - m.alongUp * a.XY,
          0.5 * (m.along * XXX + m.across * bendX + m.up * a.XYY) - m.alongUp * XXY,
          m.mixed * bendX - m.acrossUp * bendY,
          0.5 * (m.along * XXY + m.across * bendY + m.up * a.YYY) - m.alongUp * a.XYY};
}

/// 2π e^{−Y} times the Bessel functions.
struct Waves {
  Double4 J0, J1, Y0, Y1;
};

/// What the panels' extent makes of the waves o = −(Y₀ + iJ₀), less o: by value, slope and across.
struct WaveChange {
  ComplexDouble4 value, slope, across;
};

// Outgoing waves go as H₀ = J₀ − iY₀ along ê. With d = H₀′/H₀ = −H₁/H₀ and Bessel's equation, their
// second moments are ½[a(−1 − d/X) + c d/X + u] + t d, a along, c across, u up, t along and up;
// those of a plane wave, which are in the form factor, ½[−a + u] − it. H₀′ has
// e = H₀″/H₀′ + 1/X = −1/d.
CUTWATER_INLINE WaveChange change(const Waves& w, Double4 X, Double4 count,
                                  const ComplexDouble4& form, const Moments& m) {
  const Double4 same = w.J0 * w.J1 + w.Y0 * w.Y1, cross = w.J1 * w.Y0 - w.Y1 * w.J0;
  const Double4 per0 = 1.0 / (w.J0 * w.J0 + w.Y0 * w.Y0 + 1e-300);
  const Double4 per1 = 1.0 / (w.J1 * w.J1 + w.Y1 * w.Y1 + 1e-300);
  const ComplexDouble4 d{-same * per0, -cross * per0}, e{same * per1, -cross * per1};
  const Double4 perX = 1.0 / atLeast(X, 0.5 * kFrom);
  const Double4 front = 0.5 * (m.across - m.along) * perX;
  const auto ofForm = [&form](const ComplexDouble4& c) {
    const ComplexDouble4 cc = c * c;
    return form * ComplexDouble4{1.0 + c.re + 0.9 * cc.re, c.im + 0.9 * cc.im};
  };
  const ComplexDouble4 byValue =
      ofForm({(front + m.alongUp) * d.re, front * d.im + m.alongUp * (d.im + 1.0)});
  const ComplexDouble4 bySlope = ofForm({front * (e.re - 2.0 * perX) + m.alongUp * (e.re - perX),
                                         front * e.im + m.alongUp * (e.im + 1.0)});
  const ComplexDouble4 turn =
      form * ComplexDouble4{m.mixed * perX * (e.re - 2.0 * perX) + m.acrossUp * perX,
                            m.mixed * perX * e.im};
  const ComplexDouble4 o{-count * w.Y0, -count * w.J0}, slope{count * w.Y1, count * w.J1};
  return {o * ComplexDouble4{byValue.re - 1.0, byValue.im},
          slope * ComplexDouble4{bySlope.re - 1.0, bySlope.im}, slope * turn};
}

/// 1/R and its derivatives by X and Y.
struct Inverse {
  Double4 r, X, Y, XY, YY, XYY, YYY;
};
CUTWATER_INLINE Inverse inverse(Double4 r, Double4 X, Double4 Y) {
  const Double4 r2 = r * r, r3 = r * r2, r5 = 3.0 * r3 * r2, r7 = 5.0 * r5 * r2;
  return {r,
          -X * r3,
          -Y * r3,
          X * Y * r5,
          Y * Y * r5 - r3,
          X * r5 - X * Y * Y * r7,
          3.0 * Y * r5 - Y * Y * Y * r7};
}

/// F + share/R without the part w of the waves. F_Y = −F − 2/R; w = −Y₀ falls as e^{−Y}.
CUTWATER_INLINE Jet rest(Double4 F, Double4 FX, const Inverse& r, Double4 share, Double4 w0,
                         Double4 w1) {
  const Double4 FY = -F - 2.0 * r.r, FXY = -FX - 2.0 * r.X, FYY = -FY - 2.0 * r.Y;
  const Double4 FXYY = -FXY - 2.0 * r.XY, FYYY = -FYY - 2.0 * r.YY;
  return {FX + share * r.X - w1, FXY + share * r.XY + w1, FYY + share * r.YY + w0,
          FXYY + share * r.XYY - w1, FYYY + share * r.YYY - w0};
}

}  // namespace

CUTWATER_VECTOR double WaveTile::place(double K) {
  Double4 nearest = Double4{} + 1e300;
  for (std::size_t j = 0; j < kSide; ++j)
    for (std::size_t i = 0; i < kSide; i += 4) {
      const std::size_t k = kSide * j + i;
      const Double4 dx = source->x[j] - load4(&field->x[i]),
                    dy = source->y[j] - load4(&field->y[i]);
      const Double4 depth = -(load4(&field->z[i]) + source->z[j]), hh = dx * dx + dy * dy;
      const Double4 h = squareRoot(hh), toImage = squareRoot(hh + depth * depth);
      const auto apart = h > 0.0;
      const Double4 perH = 1.0 / (apart ? h : h + 1.0);
      store(ex, k, apart ? dx * perH : h + 1.0);
      store(ey, k, dy * perH);
      store(X, k, K * h);
      store(Y, k, K * depth);
      store(R1, k, toImage);
      store(active, k, h * 0.0 + 1.0);
      const Double4 ratio = toImage / atLeast(load4(&field->size[i]), source->size[j]);
      nearest = ratio < nearest ? ratio : nearest;
    }
  return std::min({nearest[0], nearest[1], nearest[2], nearest[3]});
}

void WaveTile::drop(std::size_t fieldPlace, std::size_t sourcePlace, double K) {
  const std::size_t k = kSide * sourcePlace + fieldPlace;
  active[k] = X[k] = 0.0;
  Y[k] = 1.0;
  R1[k] = 1.0 / K;
}

void WaveTile::evaluate(double K) {
  waveTerms(X.data(), Y.data(), kPairs,
            {f_.data(), fx_.data(), j0_.data(), j1_.data(), y0_.data(), y1_.data()});
  combine(K);
}

CUTWATER_VECTOR void WaveTile::combine(double K) {
  const double KK = K * K, images = takeImages ? 2.0 : 0.0;
  for (std::size_t k = 0; k < kPairs; k += 4) {
    const std::size_t j = k / kSide, i = k % kSide;
    const Double4 x = load(X, k), f = load(f_, k), fx = load(fx_, k), use = load(active, k);
    const Double4 ramp = atLeast((x - kFrom) / (kFully - kFrom), 0.0);
    const Double4 place = 1.0 - atLeast(1.0 - ramp, 0.0);
    const Double4 count = place * place * (3.0 - 2.0 * place);
    const Waves w{kTwoPi * load(j0_, k), kTwoPi * load(j1_, k), kTwoPi * load(y0_, k),
                  kTwoPi * load(y1_, k)};
    const Double4 ax = load(ex, k), ay = load(ey, k);
    const Moments m = moments(*source, j, *field, i, ax, ay, KK);
    const WaveChange waves = change(w, x, count, {load(formRe, k), load(formIm, k)}, m);

    const Inverse r = inverse(1.0 / (K * load(R1, k)), x, load(Y, k));
    const Double4 part = images * inverseShare(r.r);
    const Second real = second(rest(f, fx, r, part, count * w.Y0, count * w.Y1), x, m);
    const Double4 left0 = (1.0 - count) * w.J0, left1 = (1.0 - count) * w.J1;
    const Second imaginary = second({left1, -left1, -left0, left1, left0}, x, m);

    store(share, k, use * part);
    store(valueRe, k, use * K * (f + part * r.r + waves.value.re + real.value));
    store(valueIm, k, use * K * (waves.value.im - w.J0 + imaginary.value));
    const ComplexDouble4 slope{use * KK * (fx + part * r.X + waves.slope.re + real.slope),
                               use * KK * (w.J1 + waves.slope.im + imaginary.slope)};
    const ComplexDouble4 across{use * KK * (waves.across.re + real.across),
                                use * KK * (waves.across.im + imaginary.across)};
    const ComplexDouble4 rise{use * KK * (part * r.Y - f - 2.0 * r.r - waves.value.re + real.byY),
                              use * KK * (w.J0 - waves.value.im + imaginary.byY)};
    const ComplexDouble4 byX{ax * slope.re - ay * across.re, ax * slope.im - ay * across.im};
    const ComplexDouble4 byY{ay * slope.re + ax * across.re, ay * slope.im + ax * across.im};
    const auto derivative = [&](Double4 nx, Double4 ny, Double4 nz) {
      return ComplexDouble4{nx * byX.re + ny * byY.re - nz * rise.re,
                            nx * byX.im + ny * byY.im - nz * rise.im};
    };
    const ComplexDouble4 atSource =
        derivative(x * 0.0 + source->nx[j], x * 0.0 + source->ny[j], x * 0.0 + source->nz[j]);
    const ComplexDouble4 atField =
        derivative(load4(&field->nx[i]), load4(&field->ny[i]), load4(&field->nz[i]));
    store(sourceRe, k, atSource.re);
    store(sourceIm, k, atSource.im);
    store(fieldRe, k, atField.re);
    store(fieldIm, k, atField.im);
    store(xRe, k, byX.re);
    store(xIm, k, byX.im);
  }
}

CUTWATER_VECTOR void WaveTile::toParities(WaveTile& a, WaveTile& b) {
  for (Column WaveTile::*column :
       {&WaveTile::valueRe, &WaveTile::valueIm, &WaveTile::sourceRe, &WaveTile::sourceIm,
        &WaveTile::fieldRe, &WaveTile::fieldIm, &WaveTile::xRe, &WaveTile::xIm, &WaveTile::share})
    for (std::size_t k = 0; k < kPairs; k += 4) {
      const Double4 one = load(a.*column, k), other = load(b.*column, k);
      store(a.*column, k, one + other);
      store(b.*column, k, one - other);
    }
}

}  // namespace cutwater
