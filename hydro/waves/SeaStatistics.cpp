#include "hydro/waves/SeaStatistics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace cutwater {

namespace {

constexpr double kWork = 2e9;   // cosines that a search may take: some seconds
constexpr double kStep = 0.25;  // of a search [rad] of the mean frequency √(m2/m0)

// R(τ), as the elevation of a sea in the origin.
SeaState correlationOf(const SeaState& sea, double m0) {
  std::vector<WaveComponent> waves;
  for (const WaveComponent& wave : sea.components()) {
    if (wave.amplitude == 0.0) continue;
    waves.push_back({.omega = wave.omega, .amplitude = 0.5 * wave.amplitude * wave.amplitude / m0});
  }
  return SeaState(std::move(waves), sea.gravity());
}

// Where R is greatest between two lags, to 1e-9 of their distance, by golden sections.
double greatestBetween(const SeaState& correlation, double a, double b) {
  constexpr double kGolden = 0.6180339887498949;
  for (int i = 0; i < 45; ++i) {
    const double left = b - kGolden * (b - a), right = a + kGolden * (b - a);
    if (correlation.elevation(left, 0, 0) > correlation.elevation(right, 0, 0)) {
      b = right;
    } else {
      a = left;
    }
  }
  return 0.5 * (a + b);
}

}  // namespace

double SeaMoments::significantHeight() const { return 4.0 * std::sqrt(m0); }

double SeaMoments::zeroCrossingPeriod() const {
  return m2 > 0.0 ? 2.0 * kPi * std::sqrt(m0 / m2) : 0.0;
}

double SeaMoments::meanPeriod() const { return m1 > 0.0 ? 2.0 * kPi * m0 / m1 : 0.0; }

namespace {

void addWave(double omega, double amplitude, SeaMoments& sum) {
  const double variance = 0.5 * amplitude * amplitude;
  sum.m0 += variance;
  sum.m1 += omega * variance;
  sum.m2 += omega * omega * variance;
}

}  // namespace

SeaMoments momentsOf(const SeaState& sea) {
  SeaMoments sum;
  for (const WaveComponent& wave : sea.components()) addWave(wave.omega, wave.amplitude, sum);
  return sum;
}

SeaMoments momentsOf(const SeaState& sea, double t) {
  SeaMoments sum;
  const SeaState::Growths growths = sea.growths(t);
  for (std::size_t i = 0; i < sea.components().size(); ++i)
    addWave(sea.components()[i].omega, sea.amplitude(i, growths), sum);
  return sum;
}

// About a return R falls like 1 − (m2/m0) δ²/2: half a step beside it no more than 1/128 is
// lost, the square of kStep over 8.
RepeatTime repeatTime(const SeaState& sea, double longest) {
  constexpr double kNever = std::numeric_limits<double>::infinity();
  const SeaMoments moments = momentsOf(sea);
  if (!(moments.m0 > 0.0)) return {kNever, longest};
  const SeaState correlation = correlationOf(sea, moments.m0);
  const double step = kStep / std::sqrt(moments.m2 / moments.m0);
  const double affordable = kWork / static_cast<double>(correlation.components().size());
  const double last = std::min(longest, step * affordable);
  const auto at = [&](double lag) { return correlation.elevation(lag, 0.0, 0.0); };
  bool fallen = false;
  double before = 1.0, now = at(step);
  for (double lag = step; lag < last; lag += step) {
    const double after = at(lag + step);
    fallen = fallen || now < 0.5;
    const bool top = now >= before && now >= after;
    if (fallen && top && now >= kRepeated - kStep * kStep / 8.0) {
      const double best = greatestBetween(correlation, lag - step, lag + step);
      if (at(best) >= kRepeated) return {best, longest};
    }
    before = now;
    now = after;
  }
  return {kNever, last};
}

}  // namespace cutwater
