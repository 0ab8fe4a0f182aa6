// cutwater_bench [-o FILE.csv]: times the solver and the time domain, one row each:
//   name,panels,threads,seconds,floor_seconds,budget_seconds,checksum,ratio_to_floor,
//   processor_seconds
// A database's floor is the LU factorizations it contains, timed here as the solver does them, in
// single precision; a tick's and a fleet's is Bullet's own step without hydrodynamics. Floors are
// processor time, and so is what is compared with them: a busy machine does not change the ratio
// much, and threads do not. A fleet's seconds are for one second of its life. Budgets are the
// project's for one core of a 2.6 to 3.5 GHz server (two for the databases). The checksum is the
// sum of the answers: a speed-up that changes physics shows.
#include <cstdio>
#include <string>

#include "hydro/base/AtomicFile.h"
#include "hydro/geometry/shapes/Shapes.h"
#include "hydro/ship/Afloat.h"
#include "hydro/solve/Solve.h"
#include "tests/bench/Rows.h"

namespace cutwater::bench {

ShipParticulars frigate(int panels) {
  const FrigateDivision division = frigateDivision(panels);
  const PanelledHull hull{closedFrigate(division.along, division.girth),
                          wetFrigate(division.along, division.girth), true};
  Loading loading{.cog = {0.0, 0.0, 1.29}, .level = true, .gyradii = Vec3(5.82, 28.8, 28.8)};
  loading.supplementary.damping[Roll] = 2e7;
  loading.supplementary.stiffness[Yaw] = 2e9;
  ShipParticulars ship = afloat(hull, loading).ship;
  ship.name = "frigate";
  return ship;
}

SolveSettings sweep(int frequencies, int threads) {
  SolveSettings settings;
  settings.forwardSpeed = ForwardSpeedForm::Report;
  for (int i = 1; i <= frequencies; ++i) settings.omega.push_back(6.0 * i / frequencies);
  for (const double degrees : {30.0, 150.0, 165.0, 180.0})
    settings.headings.push_back(degrees * kPi / 180.0);
  settings.threads = threads;
  return settings;
}

void add(std::string& csv, const Row& row) {
  char line[256], ratio[32] = "";
  if (row.floor > 0.0) std::snprintf(ratio, sizeof ratio, "%.3g", row.processor / row.floor);
  std::snprintf(line, sizeof line, "\"%s\",%zu,%d,%.6g,%.6g,%.6g,%.10g,%s,%.6g\n", row.name.c_str(),
                row.panels, row.threads, row.seconds, row.floor, row.budget, row.checksum, ratio,
                row.processor);
  csv += line;
  std::fputs(line, stderr);
}

}  // namespace cutwater::bench

int main(int argc, char** argv) try {
  const std::string option = argc > 1 ? argv[1] : "";
  if (argc != 1 && !(argc == 3 && option == "-o"))
    return std::puts("usage: cutwater_bench [-o FILE.csv]"), 2;
  using namespace cutwater;
  using namespace cutwater::bench;
  std::string csv =
      "name,panels,threads,seconds,floor_seconds,budget_seconds,checksum,ratio_to_floor,"
      "processor_seconds\n";
  const Coefficients coefficients = solve(frigate(224), sweep(60, 0));
  benchTimeDomain(csv, coefficients);
  benchHulls(csv);
  benchSolver(csv);
  if (argc == 3) {
    writeWhole(argv[2], csv);
  } else {
    std::fputs(csv.c_str(), stdout);
  }
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "cutwater_bench: %s\n", error.what());
  return 1;
}
