// The report's frequency domain and still water ([M03] sections 4 to 7, 10) for our frigate:
// report_figures OUT_DIR [--panels N] [--every K]
// Look for: the meshes' damping on one line and their U dA/dx close (figures 15-20); one source
// point spoils U dA33 at high frequency (6); condition numbers peak where A and B do, with lid
// nowhere (7-12); interpolated inverses leave the direct curves where omega_e is 2 to 3 rad/s (22,
// differences.csv); buoyancy leaves its tangent as the deck goes under or the keel comes out (34 to
// 36).
#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>

#include "demos/report_figures/Report.h"

int main(int argc, char** argv) try {
  using namespace cutwater::report;
  CLI::App app(
      "Tables 2-4 and figures 6-12, 15-30, 34-36 of DRDC Atlantic TM 2003-104, as CSV files");
  Job job;
  std::string ship = CUTWATER_MESHES "/frigate/ship.toml";
  int panels = 0;
  app.add_option("out_dir", job.folder, "folder for the CSV files and databases")->required();
  app.add_option("--panels", panels, "one mesh only")->check(CLI::IsMember({224, 433, 1040}));
  app.add_option("--every", job.every, "every K-th frequency only")->check(CLI::Range(1, 10));
  app.add_option("--ship", ship, "the frigate's SHIP.toml");
  CLI11_PARSE(app, argc, argv);

  std::filesystem::create_directories(job.folder);
  job.meshes = readMeshes(ship, panels);
  const auto say = [](const char* what) { std::fprintf(stderr, "report_figures: %s\n", what); };
  say("tables 2 and 3");
  writeTable2(job);
  writeTable3(job);
  say("table 4, figures 7 to 12 and 15 to 20");
  const std::vector<Sweeps> sweeps = writeTable4(job);
  writeFigures7To12(job, sweeps);
  writeFigures15To20(job, sweeps);
  say("figure 6");
  const Sweeps& medium = sweeps[sweeps.size() / 2];
  writeFigure6(job, medium);
  say("figures 21 to 24");
  writeFigures21To24(job, medium);
  say("figures 25 to 30");
  writeFigures25To30(job, medium);
  say("figures 34 to 36");
  writeFigures34To36(job);
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "report_figures: %s\n", error.what());
  return 1;
}
