#include "hydro/green/WaveTermTables.h"

#include <cmath>
#include <numbers>

#include "hydro/green/WaveTermOracle.h"

namespace cutwater::wave_tables {
namespace {

// Interpolation at the N zeros of Chebyshev's T_N on [−1, 1], turned into powers by way of the
// Chebyshev coefficients: these are small where T_m has large coefficients, so no digits are lost.
template <std::size_t N>
struct Interpolation {
  using Values = std::array<double, N>;
  Values point{};
  std::array<Values, N> fromValues{};  // [m][point]: Chebyshev coefficient m
  std::array<Values, N> chebyshev{};   // [m][power]: T_m

  Interpolation() {
    chebyshev[0][0] = 1.0;
    chebyshev[1][1] = 1.0;
    for (std::size_t m = 2; m < N; ++m) {
      for (std::size_t p = 0; p < N; ++p) {
        chebyshev[m][p] = (p > 0 ? 2.0 * chebyshev[m - 1][p - 1] : 0.0) - chebyshev[m - 2][p];
      }
    }
    for (std::size_t k = 0; k < N; ++k) {
      const double angle = std::numbers::pi * (static_cast<double>(k) + 0.5) / N;
      point[k] = std::cos(angle);
      for (std::size_t m = 0; m < N; ++m) {
        fromValues[m][k] = (m == 0 ? 1.0 : 2.0) / N * std::cos(static_cast<double>(m) * angle);
      }
    }
  }

  Values powers(const Values& value) const {
    Values result{};
    for (std::size_t m = 0; m < N; ++m) {
      double coefficient = 0.0;
      for (std::size_t k = 0; k < N; ++k) coefficient += fromValues[m][k] * value[k];
      for (std::size_t p = 0; p <= m; ++p) result[p] += coefficient * chebyshev[m][p];
    }
    return result;
  }
};

struct Interval {
  double from, to;
  double at(double local) const { return 0.5 * (from + to) + 0.5 * (to - from) * local; }
};

// f(a, b) → two values.
template <class Function>
Patch fit(Interval a, Interval b, Function f) {
  static const Interpolation<kPoints> rule;
  using Values = std::array<double, kPoints>;
  std::array<std::array<Values, kPoints>, 2> half{};  // [function][point of a][power of b]
  for (std::size_t k = 0; k < kPoints; ++k) {
    std::array<Values, 2> along{};
    for (std::size_t l = 0; l < kPoints; ++l) {
      const std::array<double, 2> value = f(a.at(rule.point[k]), b.at(rule.point[l]));
      along[0][l] = value[0];
      along[1][l] = value[1];
    }
    for (std::size_t i = 0; i < 2; ++i) half[i][k] = rule.powers(along[i]);
  }
  Patch patch{};
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t q = 0; q < kPoints; ++q) {
      Values across{};
      for (std::size_t k = 0; k < kPoints; ++k) across[k] = half[i][k][q];
      across = rule.powers(across);
      for (std::size_t p = 0; p < kPoints; ++p)
        patch.coefficient[p][q / 2][2 * (q % 2) + i] = across[p];
    }
  }
  return patch;
}

Interval cell(std::size_t i, double width, double from = 0.0) {
  const auto n = static_cast<double>(i);
  return {from + n * width, from + (n + 1.0) * width};
}

std::vector<Patch> makeNear() {
  std::vector<Patch> patches;
  for (std::size_t ring = 0; ring < kRings; ++ring) {
    for (std::size_t column = 0; column < ring + 2; ++column) {
      const Interval alpha = cell(column, 1.0 / static_cast<double>(ring + 2));
      patches.push_back(fit(cell(ring, 1.0), alpha, [](double R, double a) {
        const oracle::Smooth f = oracle::smoothBySeries(R, a);
        return std::array<double, 2>{f.S, f.T};
      }));
    }
  }
  return patches;
}

std::vector<Patch> makeSteep() {
  std::vector<Patch> patches;
  for (std::size_t row = kSteepRow; row < kFarRows; ++row) {
    for (std::size_t column = 0; column < kSteepColumns; ++column) {
      const Interval alpha = cell(column, (1.0 - kSteep) / kSteepColumns, kSteep);
      patches.push_back(fit(cell(row, kRowWidth), alpha, [](double inverse, double a) {
        const oracle::Smooth f = oracle::smoothByIntegrals(1.0 / inverse, a);
        return std::array<double, 2>{f.S, f.T};
      }));
    }
  }
  return patches;
}

std::vector<Patch> makeFar() {
  std::vector<Patch> patches;
  for (std::size_t row = 0; row < kFarRows; ++row) {
    for (std::size_t column = 0; column < kFarColumns; ++column) {
      const Interval alpha = cell(column, 1.0 / kFarColumns);
      if (row >= kSteepRow && alpha.from >= kSteep) {
        patches.push_back({});  // never read: that is the steep region
        continue;
      }
      patches.push_back(fit(cell(row, kRowWidth), alpha, [](double inverse, double a) {
        const double R = 1.0 / inverse, X = R * std::sqrt((1.0 - a) * (1.0 + a));
        const oracle::Valued w = oracle::waveFree(X, R * a);
        return std::array<double, 2>{-0.5 * R * w.value, 0.5 * R * R * R * w.slopeX / X};
      }));
    }
  }
  return patches;
}

std::vector<BesselCell> makeBessel() {
  static const Interpolation<kBesselPoints> rule;
  std::vector<BesselCell> cells(kBesselCells);
  for (std::size_t i = 0; i < kBesselCells; ++i) {
    const bool second = i >= kSecondKindFrom;
    std::array<std::array<double, kBesselPoints>, 4> value{};
    for (std::size_t k = 0; k < kBesselPoints; ++k) {
      const oracle::Bessel b = oracle::bessel(cell(i, 1.0).at(rule.point[k]));
      value[0][k] = b.J0;
      value[1][k] = b.J1;
      value[2][k] = second ? b.Y0 : 0.0;
      value[3][k] = second ? b.Y1 : 0.0;
    }
    for (std::size_t f = 0; f < 4; ++f) {
      value[f] = rule.powers(value[f]);
      for (std::size_t p = 0; p < kBesselPoints; ++p) cells[i].coefficient[p][f] = value[f][p];
    }
  }
  return cells;
}

}  // namespace

const Tables& tables() {
  static const Tables built{makeNear(), makeSteep(), makeFar(), makeBessel()};
  return built;
}

}  // namespace cutwater::wave_tables
