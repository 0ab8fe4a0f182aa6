// cutwater: the command. Reads arguments; each subcommand is a function of its own (Commands.h).
#include <fcntl.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <iostream>
#include <sstream>

#include "demos/cutwater/commands/Commands.h"
#include "demos/cutwater/commands/Precision.h"
#include "demos/cutwater/input/HullFile.h"
#include "demos/cutwater/output/OutputFile.h"
#include "hydro/Errors.h"
#include "hydro/geometry/panelling/Panelling.h"
#include "hydro/ship/Righting.h"

namespace {

using namespace cutwater;

struct Arguments {
  std::string input, out;
  command::WaveOptions waves;
  command::LoadingOptions loading;
  double step = 0.05, duration = 30.0;
  MeshReadOptions mesh;
  std::string heel, trim = "free";
  std::vector<std::string> runs;
  command::PoseOptions poses;
  int threads = 0, panels = 0;
  std::string panelsBy = "auto";
  bool free = false;
  command::RunColumns columns;
  command::NewOptions made;
  bool force = false;
  bool moments = false;
};

CLI::App* command(CLI::App& app, const std::string& name, const std::string& what,
                  const std::string& example) {
  CLI::App* sub = app.add_subcommand(name, what);
  sub->footer("Example:\n  cutwater " + example);
  return sub;
}

void output(CLI::App* sub, Arguments& a) {
  sub->add_option("-o,--output", a.out, "CSV file to write; stdout if absent");
}

void threads(CLI::App* sub, Arguments& a) {
  sub->add_option("--threads", a.threads, "threads; 0 (default): one per core")
      ->check(CLI::Range(0, 1024));
}

// No command may write over what it reads; files that a TOML names are checked where they are read.
void checkFiles(const Arguments& a) {
  command::setOutput(a.out);
  if (command::isOutput(a.input))
    throw HydroError(Fault::FileNotWritable, "-o " + a.out + ": is the file that is read");
}

void speed(CLI::App* sub, Arguments& a) {
  sub->add_option("--speed", a.waves.moving.speed, "forward speed U [m/s], 0 to 100");
  sub->add_option("--form", a.waves.moving.formName,
                  "forward-speed terms; default: the database's own (SHIP.toml forward_speed)")
      ->check(CLI::IsMember(
          std::vector<std::string>(kForwardSpeedNames.begin(), kForwardSpeedNames.end())));
}

void wave(CLI::App* sub, Arguments& a) {
  speed(sub, a);
  sub->add_option("--heading", a.waves.headingDeg,
                  "beta [deg]: 180 head seas, 0 following, 90 from port")
      ->required();
  sub->add_option("--omega", a.waves.omegaRange,
                  "wave frequencies A:B:N [rad/s]: N values with both ends");
}

void loading(CLI::App* sub, Arguments& a) {
  sub->add_option("--mass", a.loading.mass, "another mass [kg]; the waterline must stay");
  sub->add_option("--cog", a.loading.cog, "another centre of gravity X,Y,Z [m], hull axes");
  sub->add_option("--gyradii", a.loading.gyradii, "other gyradii of roll, pitch, yaw A,B,C [m]");
}

void addPanel(CLI::App& app, Arguments& a) {
  CLI::App* sub =
      command(app, "panel", "Any hull mesh, repaired and divided into about N wet panels a side",
              "panel hull.obj -n 433 --up y --forward z -o panels.obj");
  const auto axes = CLI::IsMember(command::kAxisNames);
  sub->add_option("hull", a.input, "mesh, or SHIP.toml for its [hull] section")->required();
  sub->add_option("-n,--panels", a.panels, "panels a side")
      ->required()
      ->check(CLI::Range(kFewestPanels, kMostPanels));
  sub->add_option("-o,--output", a.out, "OBJ file to write, metres, hull axes")->required();
  sub->add_option("--up", a.mesh.up, "the mesh's axis that points up; default z")->check(axes);
  sub->add_option("--forward", a.mesh.forward, "its axis to the bow; default x")->check(axes);
  sub->add_option("--unit", a.mesh.unit, "its unit: m (default), mm, cm, ft or in")
      ->check(CLI::IsMember(command::kUnitNames));
  sub->add_option("--waterline", a.mesh.waterline, "height of calm water in it; default 0");
  sub->add_option("--symmetric", a.mesh.symmetric, "auto (default), none or half")
      ->check(CLI::IsMember(command::kSymmetryNames));
  sub->add_flag("--any-format", a.mesh.anyFormat, "any other format that Assimp reads");
  sub->add_option("--by", a.panelsBy, "auto (default), sections (ships) or surface (anything)")
      ->check(
          CLI::IsMember(std::vector<std::string>(kPanelsByNames.begin(), kPanelsByNames.end())));
  sub->callback([&a] {
    checkFiles(a);
    command::panel(a.input, a.panels, a.mesh, *fromName<PanelsBy>(kPanelsByNames, a.panelsBy),
                   a.out);
  });
}

void addNewHull(CLI::App* sub, command::NewOptions& o) {
  const auto axes = CLI::IsMember(command::kAxisNames);
  sub->add_option("--up", o.up, "the mesh's axis that points up")->check(axes);
  sub->add_option("--forward", o.forward, "its axis to the bow")->check(axes);
  sub->add_option("--unit", o.unit, "its unit: m, mm, cm, ft or in")
      ->check(CLI::IsMember(command::kUnitNames));
  CLI::Option_group* water = sub->add_option_group("water", "at most one of these");
  water->add_option("--waterline", o.waterline, "height of calm water in it, in its unit");
  water->add_option("--draught", o.draught, "of the lowest point [m]");
  water->add_option("--displacement", o.displacement, "[kg]: the waterline is found for it");
  water->require_option(0, 1);
  sub->add_option("--trim", o.trimDeg, "[deg] bow down, about the file's origin at calm water");
  sub->add_option("--heel", o.heelDeg, "[deg] starboard down, about the same point");
  sub->add_option("--symmetric", o.symmetric, "auto (default), none or half")
      ->check(CLI::IsMember(command::kSymmetryNames));
  sub->add_flag("--any-format", o.anyFormat, "read any format that Assimp knows");
}

void addNew(CLI::App& app, Arguments& a) {
  CLI::App* sub = command(
      app, "new",
      "A ship of any hull mesh: says what it takes the mesh for (axes, unit, waterline, mass,\n"
      "stability), writes a ship.toml that `cutwater solve` takes, and beside it a picture of the\n"
      "hull with its waterline, as SVG. Each guess is marked, and one option says otherwise",
      "new boat.glb --draught 0.8 -o boat/ship.toml");
  sub->add_option("hull", a.input, "mesh: glTF, OBJ, STL, PLY, OFF, COLLADA, GDF")->required();
  sub->add_option("-o,--output", a.out,
                  "SHIP.toml to write, default ship.toml; NAME.toml gets NAME.svg");
  addNewHull(sub, a.made);
  sub->add_option("--mass", a.made.mass,
                  "[kg]: written into the file; finds the waterline if none is given");
  sub->add_option("--cog-height", a.made.cogHeight,
                  "of the centre of gravity above calm water [m]");
  sub->add_option("-n,--panels", a.made.panels, "panels a side; 250 for boats, 433 for ships")
      ->check(CLI::Range(kFewestPanels, kMostPanels));
  sub->add_option("--density", a.made.density, "of the water [kg/m3]; default 1025");
  sub->add_flag("--force", a.force, "write over files that are there");
  sub->callback([&a] {
    if (a.out.empty()) a.out = "ship.toml";
    command::newShipFile(a.input, a.made, a.force, a.out);
  });
}

void addGeometryAndSolver(CLI::App& app, Arguments& a) {
  CLI::App* sub =
      command(app, "hydrostatics", "Volume, areas, centres, stiffness of a hull at rest",
              "hydrostatics meshes/frigate/ship.toml");
  sub->add_option("ship", a.input, "SHIP.toml")->required();
  output(sub, a);
  sub->callback([&a] {
    checkFiles(a);
    command::hydrostatics(a.input, a.out);
  });

  sub = command(app, "solve",
                "Hydrodynamic coefficients of a hull by panel method: added mass, damping, wave\n"
                "excitation over frequency, into a database that alone makes a ship in Bullet",
                "solve meshes/frigate/ship.toml -o frigate.h5");
  sub->add_option("ship", a.input, "SHIP.toml")->required();
  sub->add_option("-o,--output", a.out, "database to write (HDF5, BEMIO layout)")->required();
  threads(sub, a);
  sub->callback([&a] {
    checkFiles(a);
    command::solve(a.input, a.out, a.threads);
  });
}

void addStillWater(CLI::App& app, Arguments& a) {
  CLI::App* sub = command(
      app, "righting",
      "Righting levers of the closed hull at constant mass; heel is positive to starboard.\n"
      "gz > 0 rights a ship heeled to starboard; height is that of the hull file's origin above\n"
      "calm water; trim is positive bow down. Of several equilibria in trim, the one that a ship\n"
      "heeled slowly from upright comes to. On stderr: greatest gz, where it vanishes, loll",
      "righting meshes/frigate/ship.toml --heel 0:180:37");
  sub->add_option("ship", a.input, "SHIP.toml")->required();
  sub->add_option("--heel", a.heel, "heels A:B:N [deg]: N values with both ends")->required();
  sub->add_option("--trim", a.trim, "free (default), or fixed at 0")
      ->check(CLI::IsMember(
          std::vector<std::string>(kRightingTrimNames.begin(), kRightingTrimNames.end())));
  output(sub, a);
  sub->callback([&a] {
    checkFiles(a);
    command::righting(a.input, a.heel, a.trim, a.out);
  });

  sub = command(
      app, "buoyancy",
      "Pressure of calm water on the closed hull held in a pose, weight not included, beside its\n"
      "linearisation about the pose of the hull file. Force [N] in level axes: forward, port, up;\n"
      "moment about the centre of gravity [N m] by its parts about the ship's own x, the level y\n"
      "and the vertical. Heave is positive up, roll starboard down, pitch bow down",
      "buoyancy meshes/frigate/ship.toml --heave -8:6:29");
  sub->add_option("ship", a.input, "SHIP.toml")->required();
  CLI::Option_group* poses = sub->add_option_group("pose", "one of these");
  poses->add_option("--heave", a.poses.heave, "A:B:N [m]: N values with both ends");
  poses->add_option("--roll", a.poses.roll, "A:B:N [deg], about the centre of gravity");
  poses->add_option("--pitch", a.poses.pitch, "A:B:N [deg], about the centre of gravity");
  poses->require_option(1);
  output(sub, a);
  sub->callback([&a] {
    checkFiles(a);
    command::buoyancy(a.input, a.poses, a.out);
  });
}

void addTables(CLI::App& app, Arguments& a) {
  CLI::App* sub = command(app, "info", "What is in a database: ship, grid, settings, checks",
                          "info frigate.h5");
  sub->add_option("database", a.input, "DB.h5")->required();
  output(sub, a);
  sub->callback([&a] {
    checkFiles(a);
    command::info(a.input, a.out);
  });

  sub =
      command(app, "coefficients", "Added mass and damping over frequency, 0 and infinity included",
              "coefficients frigate.h5 --speed 10 -o coefficients.csv");
  sub->add_option("database", a.input, "DB.h5")->required();
  speed(sub, a);
  output(sub, a);
  sub->callback([&a] {
    checkFiles(a);
    command::coefficients(a.input, a.waves.moving, a.out);
  });

  sub = command(app, "excitation", "Froude-Krylov and diffraction forces per metre of wave",
                "excitation frigate.h5 --heading 150 --omega 0.2:2:37");
  sub->add_option("database", a.input, "DB.h5")->required();
  wave(sub, a);
  output(sub, a);
  sub->callback([&a] {
    checkFiles(a);
    command::excitation(a.input, a.waves, a.out);
  });

  sub = command(app, "rao", "Motions in regular waves by the frequency domain",
                "rao frigate.h5 --speed 10 --heading 180 --omega 0.2:2:37");
  sub->add_option("database", a.input, "DB.h5")->required();
  wave(sub, a);
  loading(sub, a);
  sub->add_flag("--free", a.free, "of the free ship (mean = \"free\") instead of a fixed course");
  output(sub, a);
  sub->callback([&a] {
    checkFiles(a);
    command::rao(a.input, a.waves, a.loading, a.free, a.out);
  });

  sub = command(app, "retardation", "Memory functions K(tau) of the radiated waves",
                "retardation frigate.h5 --dt 0.05 --duration 30");
  sub->add_option("database", a.input, "DB.h5")->required();
  sub->add_option("--dt", a.step, "step in tau [s]")->required();
  sub->add_option("--duration", a.duration, "last tau [s]")->required();
  output(sub, a);
  sub->callback([&a] {
    checkFiles(a);
    command::retardation(a.input, a.step, a.duration, a.out);
  });
}

void addRuns(CLI::App& app, Arguments& a) {
  CLI::App* sub = command(
      app, "simulate", "One ship in Bullet, headless, motions as CSV; free unless mean = \"fixed\"",
      "simulate run.toml --forces -o run.csv");
  sub->add_option("run", a.input, "RUN.toml")->required();
  sub->add_flag("--forces", a.columns.forces, "add the parts of the load as columns");
  sub->add_flag("--wetted", a.columns.wetted,
                "add wetted area, submerged volume, centre of buoyancy and immersion as columns;\n"
                "nonlinear mode only");
  output(sub, a);
  sub->callback([&a] {
    checkFiles(a);
    command::simulate(a.input, a.columns, a.out);
  });

  sub = command(app, "sweep",
                "Regular waves one by one in Bullet, amplitude and phase of the motions fitted,\n"
                "beside the frequency domain",
                "sweep sweep.toml -o sweep.csv");
  sub->add_option("run", a.input, "RUN.toml with several wave frequencies")->required();
  threads(sub, a);
  output(sub, a);
  sub->callback([&a] {
    checkFiles(a);
    command::sweep(a.input, a.threads, a.out);
  });
}

void addSea(CLI::App& app, Arguments& a) {
  CLI::App* sub = command(
      app, "sea",
      "The waves that a run's sea is made of, as CSV; on stderr each system in words, and when "
      "the\n"
      "sea repeats. Phases are about the crest at the origin at t = 0; headings are relative to "
      "the\n"
      "ship's first course. Rows are what type = \"components\" takes, with direction_deg for\n"
      "heading_deg. Deep water is the theory. The run file needs no database",
      "sea run.toml --moments");
  sub->add_option("run", a.input, "RUN.toml")->required();
  sub->add_flag(
      "--moments", a.moments,
      "instead: hs, m0, m1, m2, tz, tm01 of these waves, repeat_time, and share_outside,\n"
      "the share of m0 that the cut-offs leave out");
  output(sub, a);
  sub->callback([&a] {
    checkFiles(a);
    command::sea(a.input, a.moments, a.out);
  });
}

void addReport(CLI::App& app, Arguments& a) {
  CLI::App* sub = command(
      app, "report",
      "One HTML file that shows a database and what was run with it: the ship in its sea,\n"
      "motions, coefficients, checks. It needs no server and no network. Of each RUN.toml the CSV\n"
      "of the same stem beside it is its run; a body that is no ship has [body] size and no\n"
      "database",
      "report frigate.h5 run.toml sweep.toml -o page.html");
  sub->add_option("database", a.input, "DB.h5")->required();
  sub->add_option("runs", a.runs, "RUN.toml of runs of `simulate` and `sweep`");
  sub->add_option("-o,--output", a.out, "page to write; of a name in .json its data alone")
      ->required();
  sub->callback([&a] {
    checkFiles(a);
    command::report(a.input, a.runs, a.out);
  });
}

// A descriptor that the caller has closed would be given to the next file that is opened, and
// messages would go into it. What is written to a closed stdout fails, as it should.
void keepStandardFiles() {
  for (const int file : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(file, F_GETFD) != -1) continue;
    if (::open("/dev/null", file == STDERR_FILENO ? O_WRONLY : O_RDONLY) < 0) return;
  }
  std::signal(SIGPIPE, SIG_IGN);  // a reader of stderr that has gone ends no run
}

// CLI11 reads an empty text as the number 0.
void refuseEmpty(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    const bool emptyValue = argument.starts_with("--") && argument.ends_with('=');
    if (!argument.empty() && !emptyValue) continue;
    const std::string before = emptyValue ? argument.substr(0, argument.size() - 1)
                               : i > 1    ? argv[i - 1]
                                          : "cutwater";
    throw command::UsageError(command::shortened(before) + " \"\": a value is missing");
  }
}

int refused(const std::exception& error, int code) {
  command::say(std::string("cutwater: ") + error.what());
  return code;
}

int usage(const CLI::App& app, const CLI::ParseError& error) {
  std::ostringstream out, lines;
  const int code = app.exit(error, out, lines) == 0 ? 0 : 2;
  if (code == 0) std::cout << out.str() << std::flush;
  std::istringstream read(out.str() + lines.str());
  for (std::string line; code != 0 && std::getline(read, line);) command::say(line);
  return code;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{
      "Ships with seakeeping hydrodynamics for the Bullet physics engine.\n"
      "Axes: x forward, y port, z up. Heading beta: 180 head seas, 0 following, 90 from port.\n"
      "SI units; angles in degrees where the name ends in _deg. CSV to stdout or -o FILE.",
      "cutwater"};
  app.set_version_flag("--version", CUTWATER_VERSION);
  app.require_subcommand(1);
  app.footer("`cutwater COMMAND --help` explains one command. Exit: 0 done, 1 failed, 2 usage.");
  keepStandardFiles();
  command::rememberArguments(argv);
  Arguments arguments;
  addNew(app, arguments);
  addGeometryAndSolver(app, arguments);
  addPanel(app, arguments);
  addStillWater(app, arguments);
  addTables(app, arguments);
  addRuns(app, arguments);
  addSea(app, arguments);
  addReport(app, arguments);
  try {
    refuseEmpty(argc, argv);
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return usage(app, error);
  } catch (const command::UsageError& error) {
    return refused(error, 2);
  } catch (const std::bad_alloc&) {
    return refused(std::runtime_error("not enough memory"), 1);
  } catch (const std::exception& error) {
    return refused(error, 1);
  }
  return 0;
}
