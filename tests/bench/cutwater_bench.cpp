// cutwater_bench [-o FILE.csv]: times the solver and the time domain, one row each:
//   name,panels,threads,seconds,floor_seconds,budget_seconds,checksum
// A database's floor is the LU factorizations it contains, timed here and shared out to the threads; a
// tick's and a fleet's is Bullet's own step without hydrodynamics. A fleet's seconds are for one
// second of its life. Budgets are the project's for one core of a 2.6 to 3.5 GHz server (two for the
// databases). The checksum is the sum of the answers: a speed-up that changes physics shows.
#include <btBulletDynamicsCommon.h>
#include <lapacke.h>

#include <chrono>
#include <cstdio>
#include <string>

#include "demos/BulletWorld.h"
#include "hydro/AtomicFile.h"
#include "hydro/bem/BuildCoefficients.h"
#include "hydro/geometry/Hydrostatics.h"
#include "hydro/geometry/Lid.h"
#include "hydro/geometry/Shapes.h"
#include "hydro/waves/Spectrum.h"
#include "plugin/Seaway.h"

extern "C" void openblas_set_num_threads(int);

namespace {

using namespace cutwater;

double secondsOf(const auto& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

ShipParticulars frigate(int panels) {
  const FrigateDivision division = frigateDivision(panels);
  ShipParticulars ship;
  ship.name = "frigate";
  ship.hull = closedFrigate(division.along, division.girth);
  ship.wetSurface = wetFrigate(division.along, division.girth);
  ship.symmetric = true;
  const SurfaceMesh whole = joined(ship.wetSurface, mirroredInY(ship.wetSurface));
  ship.cog = hydrostatics(whole, Vec3::Zero(), ship.density, ship.gravity).buoyancy;
  ship.cog.z() = 1.29;
  const Hydrostatics afloat = hydrostatics(whole, ship.cog, ship.density, ship.gravity);
  ship.mass = afloat.displacement;
  ship.volume = afloat.volume;
  ship.centreOfBuoyancy = afloat.buoyancy;
  ship.restoring = afloat.restoring;
  ship.gyradii = Vec3(5.82, 28.8, 28.8);
  ship.supplementary.damping[Roll] = 2e7;
  ship.supplementary.stiffness[Yaw] = 2e9;
  return ship;
}

// The grid of [M03] Table 4: 0.1 to 6.0 rad/s, four headings; adjoint vectors, x-derivatives, lid.
SolveSettings sweep(int frequencies, int threads) {
  SolveSettings settings;
  for (int i = 1; i <= frequencies; ++i) settings.omega.push_back(6.0 * i / frequencies);
  for (const double degrees : {30.0, 150.0, 165.0, 180.0})
    settings.headings.push_back(degrees * kPi / 180.0);
  settings.threads = threads;
  return settings;
}

struct Row {
  std::string name;
  std::size_t panels = 0;
  int threads = 1;
  double seconds = 0.0, floor = 0.0, budget = 0.0, checksum = 0.0;
};

// Written at once as well as in the end, as the databases take a while.
void add(std::string& csv, const Row& row) {
  char line[256];
  std::snprintf(line, sizeof line, "\"%s\",%zu,%d,%.6g,%.6g,%.6g,%.10g\n", row.name.c_str(),
                row.panels, row.threads, row.seconds, row.floor, row.budget, row.checksum);
  csv += line;
  std::fputs(line, stderr);
}

// Two complex LU factorizations (even, odd) of n unknowns, one thread [s].
double luFloor(int n) {
  openblas_set_num_threads(1);
  Eigen::MatrixXcd matrix = Eigen::MatrixXcd::Random(n, n);
  std::vector<lapack_int> pivots(static_cast<std::size_t>(n));
  const double one = secondsOf([&] {
    LAPACKE_zgetrf(LAPACK_COL_MAJOR, n, n, reinterpret_cast<lapack_complex_double*>(matrix.data()),
                   n, pivots.data());
  });
  return 2.0 * one;
}

void benchDatabase(std::string& csv, const std::string& name, int panels, int threads,
                   double budget) {
  constexpr int kFrequencies = 60;
  const ShipParticulars ship = frigate(panels);
  const auto unknowns =
      static_cast<int>(ship.wetSurface.faces.size() + makeLid(ship.wetSurface, true).size());
  Coefficients result;
  Row row{name, ship.wetSurface.faces.size(), threads};
  row.seconds = secondsOf([&] { result = buildCoefficients(ship, sweep(kFrequencies, threads)); });
  row.floor = kFrequencies * luFloor(unknowns) / threads;
  row.budget = budget;
  for (const Mat6& a : result.addedMass) row.checksum += a.trace() / ship.mass;
  for (const Mat6& b : result.damping) row.checksum += b.trace() / ship.mass;
  add(csv, row);
}

// Seconds that `ticks` of a world with so many ships take, or with as many plain bodies, and the sum
// of where the ships are then.
std::pair<double, double> runWorld(const Coefficients& coefficients, int ships, int ticks,
                                   int components, bool wet) {
  const btScalar tick = btScalar(1) / 60;
  SeaStateSettings settings;
  settings.components = components;
  BulletWorld bullet;
  Seaway seaway(bullet.world, wet ? makeSeaState(Spectrum{}, settings) : SeaState{});
  btSphereShape shape(5);
  std::vector<std::unique_ptr<btRigidBody>> dry;
  for (int i = 0; i < ships; ++i) {
    if (wet) {
      seaway.addShip(coefficients, {.y = 100.0 * i});
      continue;
    }
    dry.push_back(std::make_unique<btRigidBody>(btScalar(1), nullptr, &shape, btVector3(1, 1, 1)));
    dry.back()->setWorldTransform(
        btTransform(btQuaternion::getIdentity(), btVector3(0, btScalar(100 * i), 0)));
    bullet.world.addRigidBody(dry.back().get());
  }
  bullet.world.stepSimulation(tick, 1, tick);
  const double seconds = secondsOf([&] {
    for (int i = 0; i < ticks; ++i) bullet.world.stepSimulation(tick, 1, tick);
  });
  double checksum = 0.0;
  for (const auto& ship : seaway.ships()) checksum += ship->position().z();
  for (const auto& body : dry) bullet.world.removeRigidBody(body.get());
  return {seconds, checksum};
}

// One tick of one ship.
void benchTick(std::string& csv, const std::string& name, const Coefficients& coefficients,
               int components, double budget) {
  constexpr int kTicks = 6000;
  const auto [dry, nothing] = runWorld(coefficients, 1, kTicks, components, false);
  const auto [wet, checksum] = runWorld(coefficients, 1, kTicks, components, true);
  add(csv, {name, coefficients.ship.wetSurface.faces.size(), 1, wet / kTicks, dry / kTicks, budget,
            checksum});
}

// One second of a fleet at 60 Hz.
void benchFleet(std::string& csv, const std::string& name, const Coefficients& coefficients,
                int ships, int components) {
  constexpr int kTicks = 60;
  const auto [dry, nothing] = runWorld(coefficients, ships, kTicks, components, false);
  const auto [wet, checksum] = runWorld(coefficients, ships, kTicks, components, true);
  add(csv, {name, coefficients.ship.wetSurface.faces.size(), 1, wet, dry, 1.0, checksum});
}

}  // namespace

int main(int argc, char** argv) try {
  const std::string option = argc > 1 ? argv[1] : "";
  if (argc != 1 && !(argc == 3 && option == "-o"))
    return std::puts("usage: cutwater_bench [-o FILE.csv]"), 2;
  std::string csv = "name,panels,threads,seconds,floor_seconds,budget_seconds,checksum\n";
  const Coefficients coefficients = buildCoefficients(frigate(224), sweep(30, 0));
  benchTick(csv, "linear ship, one tick, 6 modes, 200 wave components", coefficients, 200, 2e-6);
  benchTick(csv, "linear ship, one tick, 6 modes, regular wave", coefficients, 1, 2e-6);
  benchFleet(csv, "1000 linear ships at 60 Hz, one core", coefficients, 1000, 20);
  benchDatabase(csv, "medium mesh (433/side)", 433, 1, 0.0);
  benchDatabase(csv, "medium mesh (433/side)", 433, 2, 2.0);
  benchDatabase(csv, "database of Table 4, fine mesh (1040/side)", 1040, 2, 10.0);
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
