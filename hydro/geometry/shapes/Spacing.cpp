#include "hydro/geometry/shapes/Spacing.h"

#include <cmath>
#include <string>

#include "hydro/Errors.h"

namespace cutwater {
namespace {

std::vector<double> checkedCount(int n, const char* function) {
  if (n < 1)
    throw HydroError(Fault::BadArgument,
                     std::string(function) + ": " + std::to_string(n) + " divisions");
  return std::vector<double>(static_cast<std::size_t>(n) + 1);
}

}  // namespace

std::vector<double> uniform(int n) { return spacedAtEnds(n, 0.0); }

std::vector<double> spacedAtEnds(int n, double c) {
  std::vector<double> u = checkedCount(n, "spacedAtEnds");
  for (int i = 0; i < n; ++i) {
    const double t = static_cast<double>(i) / n;
    u[static_cast<std::size_t>(i)] = t - c * std::sin(2 * kPi * t) / (2 * kPi);
  }
  u.back() = 1.0;
  return u;
}

std::vector<double> spacedAtStart(int n, double c) {
  std::vector<double> u = checkedCount(n, "spacedAtStart");
  for (int i = 0; i < n; ++i) {
    const double t = static_cast<double>(i) / n;
    u[static_cast<std::size_t>(i)] = t - c * std::sin(kPi * t) / kPi;
  }
  u.back() = 1.0;
  return u;
}

std::vector<double> equalArcs(int n, const std::function<Vec3(double)>& curve) {
  return arcsAt(uniform(n), curve);
}

std::vector<double> arcsAt(const std::vector<double>& fractions,
                           const std::function<Vec3(double)>& curve) {
  constexpr int kFine =
      4000;  // the polyline is then short of the curve by about 1e-7 of its length
  std::vector<double> length{0.0};
  Vec3 last = curve(0.0);
  for (int i = 1; i <= kFine; ++i) {
    const Vec3 p = curve(static_cast<double>(i) / kFine);
    length.push_back(length.back() + (p - last).norm());
    last = p;
  }
  if (length.back() <= 0.0) return fractions;  // the curve is a point
  std::vector<double> t = fractions;
  std::size_t k = 0;
  for (std::size_t i = 1; i + 1 < t.size(); ++i) {
    const double wanted = length.back() * fractions[i];
    while (length[k + 1] < wanted) ++k;
    const double part = (wanted - length[k]) / (length[k + 1] - length[k]);
    t[i] = (static_cast<double>(k) + part) / kFine;
  }
  return t;
}

}  // namespace cutwater
