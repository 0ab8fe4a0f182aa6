#pragma once
#include <chrono>
#include <ctime>
#include <string>

#include "hydro/bem/BuildCoefficients.h"

namespace cutwater::bench {

/// One line of out/bench.csv.
struct Row {
  std::string name;
  std::size_t panels = 0;
  int threads = 1;
  double seconds = 0.0, floor = 0.0, budget = 0.0, checksum = 0.0;
  double processor = 0.0;  ///< seconds of all threads; as `floor` is
};

/// Adds it to `csv` and prints it at once, as some take a while.
void add(std::string& csv, const Row& row);

struct Time {
  double seconds, processor;  ///< by the wall, and of all threads together
};
Time timeOf(const auto& work) {
  const auto start = std::chrono::steady_clock::now();
  const std::clock_t processor = std::clock();
  work();
  return {std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(),
          static_cast<double>(std::clock() - processor) / CLOCKS_PER_SEC};
}
double secondsOf(const auto& work) { return timeOf(work).seconds; }

/// The frigate with so many panels a side.
ShipParticulars frigate(int panels);
/// The grid of [M03] Table 4: 0.1 to 6.0 rad/s, four headings; adjoint vectors, which serve all its
/// speeds and wave frequencies, and x-derivatives.
SolveSettings sweep(int frequencies, int threads);

/// Databases of Table 4, with and without lid; what a frequency takes, part by part; how both grow
/// with panels and threads.
void benchSolver(std::string& csv);
/// A ship's tick, whole and by part; how it grows with components, ships, memory; fleets.
void benchTimeDomain(std::string& csv, const Coefficients& coefficients);

/// Hulls of 9000 and 100 000 triangles, with panels by sections and by surface.
void benchHulls(std::string& csv);

}  // namespace cutwater::bench
