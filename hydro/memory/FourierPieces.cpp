#include "hydro/memory/FourierPieces.h"

#include <cmath>

namespace cutwater::fourier {

namespace {

constexpr double kEulerGamma = 0.57721566490153286;
constexpr int kLast = kGreatestPower + 4;

/// Ascending series of j_n: θⁿ/(2n+1)!! Σ_k (−θ²/2)^k / (k! (2n+3)(2n+5)…(2n+2k+1)); to θ = 8 no
/// more than three digits cancel.
double besselTerm(int n, double theta) noexcept {
  const double x = -0.5 * theta * theta;
  double lead = 1.0, term = 1.0, sum = 1.0;
  for (int i = 0; i < n; ++i) lead *= theta / (2.0 * i + 3.0);
  for (int k = 1; k < 40 && std::abs(term) > 1e-17; ++k) {
    term *= x / (k * (2.0 * n + 2.0 * k + 1.0));
    sum += term;
  }
  return lead * sum;
}

/// Power series of E_n about z = 0 [DLMF 8.19.8], z = −ia.
Complex tailSeries(int n, double a) noexcept {
  if (a == 0.0) return 1.0 / (n - 1);
  double psi = -kEulerGamma;
  for (int m = 1; m < n; ++m) psi += 1.0 / m;
  const Complex minusZ{0.0, a};
  const Complex lnZ{std::log(a), -0.5 * kPi};
  Complex power = 1.0, sum = 0.0;  // power: (−z)^m / m!
  for (int m = 0; m < 40; ++m) {
    sum += m == n - 1 ? power * (psi - lnZ) : -power / static_cast<double>(m - n + 1);
    power *= minusZ / static_cast<double>(m + 1);
  }
  return sum;
}

/// Continued fraction of E_n [DLMF 8.19.17, even part], by Lentz's method; converges quickly for
/// |z| > 4 off the negative axis.
Complex tailFraction(int n, double a) noexcept {
  const Complex z{0.0, -a};
  Complex b = z + static_cast<double>(n);
  Complex c = 1e300, d = 1.0 / b, h = d;
  for (int i = 1; i < 500; ++i) {
    const double an = -static_cast<double>(i) * (n - 1 + i);
    b += 2.0;
    d = 1.0 / (an * d + b);
    c = b + an / c;
    const Complex step = c * d;
    h *= step;
    if (std::abs(step - 1.0) < 1e-15) break;
  }
  return h * std::polar(1.0, a);
}

}  // namespace

std::array<double, 5> sphericalBessel(double theta) noexcept {
  std::array<double, 5> j{};
  if (theta < 1.0) {
    for (std::size_t n = 0; n < 5; ++n) j[n] = besselTerm(static_cast<int>(n), theta);
    return j;
  }
  j[0] = std::sin(theta) / theta;
  j[1] = (j[0] - std::cos(theta)) / theta;
  for (std::size_t n = 1; n < 4; ++n) {
    j[n + 1] = static_cast<double>(2 * n + 1) / theta * j[n] - j[n - 1];
  }
  return j;
}

std::array<double, 8> sphericalBessel8(double theta) noexcept {
  std::array<double, 8> j{};
  const auto low = sphericalBessel(theta);
  for (std::size_t n = 0; n < 5; ++n) j[n] = low[n];
  for (std::size_t n = 5; n < 8; ++n) {  // upwards where that is stable, n < θ
    const double order = static_cast<double>(n);
    j[n] = theta < 8.0 ? besselTerm(static_cast<int>(n), theta)
                       : (2.0 * order - 1.0) / theta * j[n - 1] - j[n - 2];
  }
  return j;
}

std::array<double, 8> cosineWeights(double a, double b, double tau) noexcept {
  const double width = b - a, centre = 0.5 * (a + b);
  const auto j = sphericalBessel8(0.5 * width * tau);
  const double c = width * std::cos(centre * tau), s = width * std::sin(centre * tau);
  return {j[0] * c, -j[1] * s, -j[2] * c, j[3] * s, j[4] * c, -j[5] * s, -j[6] * c, j[7] * s};
}

CellWeights cellWeights(double a, double b, double tau) noexcept {
  const double width = b - a, centre = 0.5 * (a + b);
  const auto j = sphericalBessel(0.5 * width * tau);
  const double c = width * std::cos(centre * tau), s = width * std::sin(centre * tau);
  return {{j[0] * c, -j[1] * s, -j[2] * c, j[3] * s, j[4] * c},
          {j[0] * s, j[1] * c, -j[2] * s, -j[3] * c}};
}

TailTable tailIntegrals(double a) noexcept {
  TailTable table;
  const Complex z{0.0, -a}, decay = std::polar(1.0, a);  // e^{−z}
  // n E_{n+1} = e^{−z} − z E_n, taken upwards where |z| is small and downwards where it is not, so
  // that errors do not grow.
  if (a <= 4.0) {
    table.front() = tailSeries(kLeastPower, a);
    for (int n = kLeastPower; n < kLast; ++n) {
      const auto i = static_cast<std::size_t>(n - kLeastPower);
      table[i + 1] = (decay - z * table[i]) / static_cast<double>(n);
    }
  } else {
    table.back() = tailFraction(kLast, a);
    for (int n = kLast - 1; n >= kLeastPower; --n) {
      const auto i = static_cast<std::size_t>(n - kLeastPower);
      table[i] = (decay - static_cast<double>(n) * table[i + 1]) / z;
    }
  }
  return table;
}

template <int N>
GaussRule<N>::GaussRule() noexcept {
  for (int i = 0; i < N; ++i) {
    double x = std::cos(kPi * (i + 0.75) / (N + 0.5)), slope = 1.0;
    for (int iteration = 0; iteration < 20; ++iteration) {  // Newton on P_N
      double p = 1.0, before = 0.0;
      for (int n = 0; n < N; ++n) {
        const double next = ((2.0 * n + 1.0) * x * p - n * before) / (n + 1.0);
        before = p;
        p = next;
      }
      slope = N * (x * p - before) / (x * x - 1.0);
      x -= p / slope;
    }
    node[static_cast<std::size_t>(i)] = x;
    weight[static_cast<std::size_t>(i)] = 2.0 / ((1.0 - x * x) * slope * slope);
  }
}
template struct GaussRule<8>;
template struct GaussRule<40>;

}  // namespace cutwater::fourier
