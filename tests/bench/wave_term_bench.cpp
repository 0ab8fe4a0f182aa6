// Cost of one Green function pair: the wave term in the ranges a ship at each frequency makes of
// it, and the Rankine integrals of one panel. The label is the sum of the answers, so that a change
// of them shows.
#include <benchmark/benchmark.h>

#include <random>
#include <string>
#include <vector>

#include "hydro/green/RankineIntegrals.h"
#include "hydro/green/WaveTerm.h"

namespace cutwater {
namespace {

constexpr std::size_t kCount = 4096;

// Arguments: greatest X, greatest Y times 10. For a 120 m ship 5 m deep X reaches 120 K, Y 10 K.
void waveTermPair(benchmark::State& state) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> X(0.0, static_cast<double>(state.range(0)));
  std::uniform_real_distribution<double> Y(0.0, 0.1 * static_cast<double>(state.range(1)));
  std::vector<std::pair<double, double>> points(kCount);
  for (auto& [x, y] : points) x = X(random), y = Y(random);
  double checksum = 0.0;
  waveTerm(1.0, 1.0);  // tables
  for (auto _ : state) {
    checksum = 0.0;
    for (const auto& [x, y] : points) {
      const WaveTerm w = waveTerm(x, y);
      checksum += w.F + w.FX + w.FY + w.J0 + w.J1;
    }
    benchmark::DoNotOptimize(checksum);
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(kCount));
  state.SetLabel("checksum " + std::to_string(checksum));
}
BENCHMARK(waveTermPair)->Args({1, 1})->Args({10, 8})->Args({50, 40})->Args({200, 160});

void rankinePair(benchmark::State& state) {
  const Vec3 corner[] = {{0, 0, 0}, {2, 0.1, 0}, {2, 1, 0.5}, {0, 0.9, 0.5}};
  const RankinePanel panel(corner);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  std::vector<Vec3> points(kCount);
  for (Vec3& x : points) {
    x = static_cast<double>(state.range(0)) *
        Vec3(unit(random), 0.15 * unit(random), 0.05 * unit(random));
  }
  double checksum = 0.0;
  for (auto _ : state) {
    checksum = 0.0;
    for (const Vec3& x : points) {
      const RankineIntegrals r = panel.at(x);
      checksum += r.potential + r.gradient.sum() + r.doubleLayer;
    }
    benchmark::DoNotOptimize(checksum);
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(kCount));
  state.SetLabel("checksum " + std::to_string(checksum));
}
BENCHMARK(rankinePair)->Arg(10)->Arg(60);

}  // namespace
}  // namespace cutwater

BENCHMARK_MAIN();
