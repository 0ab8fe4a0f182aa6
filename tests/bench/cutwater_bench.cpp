// cutwater_bench [-o FILE.csv]: times the solver and the time domain, one row each:
//   name,panels,threads,seconds,floor_seconds,checksum
// `seconds` of a solve is per frequency (radiation, 4 headings, adjoint vectors, x-derivatives; lid
// on), its floor the LU factorizations it contains, timed here; of a tick per ship and tick, its
// floor Bullet's own step without hydrodynamics. The checksum is the sum of the answers: a speed-up
// that changes physics shows.
#include <btBulletDynamicsCommon.h>
#include <lapacke.h>

#include <chrono>
#include <cstdio>
#include <string>

#include "demos/BulletWorld.h"
#include "hydro/Errors.h"
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

SolveSettings sweep(int frequencies, int threads) {
  SolveSettings settings;
  for (int i = 1; i <= frequencies; ++i) settings.omega.push_back(6.0 * i / frequencies);
  for (const double degrees : {30.0, 150.0, 165.0, 180.0})
    settings.headings.push_back(degrees * kPi / 180.0);
  settings.threads = threads;
  return settings;
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

void benchSolve(std::FILE* csv) {
  for (const auto& [panels, frequencies] :
       {std::pair{224, 12}, std::pair{433, 8}, std::pair{1040, 4}}) {
    const ShipParticulars ship = frigate(panels);
    const auto unknowns =
        static_cast<int>(ship.wetSurface.faces.size() + makeLid(ship.wetSurface, true).size());
    for (const int threads : {1, 2}) {
      Coefficients result;
      const double seconds =
          secondsOf([&] { result = buildCoefficients(ship, sweep(frequencies, threads)); });
      double checksum = 0.0;
      for (const Mat6& a : result.addedMass) checksum += a.trace() / ship.mass;
      for (const Mat6& b : result.damping) checksum += b.trace() / ship.mass;
      std::fprintf(csv, "solve_per_frequency,%d,%d,%.6g,%.6g,%.10g\n", panels, threads,
                   seconds / frequencies, luFloor(unknowns) / threads, checksum);
      std::fflush(csv);
    }
  }
}

// Time per ship and tick, and a checksum of where the ships are.
void benchTicks(std::FILE* csv, const char* name, const Coefficients& coefficients, int ships,
                int components) {
  constexpr int kTicks = 600;
  const btScalar tick = btScalar(1) / 60;
  SeaStateSettings settings;
  settings.components = components;
  double seconds[2], checksum = 0.0;
  for (const bool wet : {false, true}) {
    BulletWorld bullet;
    Seaway seaway(bullet.world, wet ? makeSeaState(Spectrum{}, settings) : SeaState{});
    btSphereShape shape(5);
    std::vector<std::unique_ptr<btRigidBody>> dry;
    for (int i = 0; i < ships; ++i) {
      if (wet) {
        seaway.addShip(coefficients, {.y = 100.0 * i});
        continue;
      }
      dry.push_back(
          std::make_unique<btRigidBody>(btScalar(1), nullptr, &shape, btVector3(1, 1, 1)));
      dry.back()->setWorldTransform(
          btTransform(btQuaternion::getIdentity(), btVector3(0, btScalar(100 * i), 0)));
      bullet.world.addRigidBody(dry.back().get());
    }
    bullet.world.stepSimulation(tick, 1, tick);
    seconds[wet ? 1 : 0] = secondsOf([&] {
      for (int i = 0; i < kTicks; ++i) bullet.world.stepSimulation(tick, 1, tick);
    });
    for (const auto& ship : seaway.ships()) checksum += ship->position().z();
    for (const auto& body : dry) bullet.world.removeRigidBody(body.get());
  }
  std::fprintf(csv, "%s,%zu,1,%.6g,%.6g,%.10g\n", name, coefficients.ship.wetSurface.faces.size(),
               seconds[1] / kTicks / ships, seconds[0] / kTicks / ships, checksum);
}

}  // namespace

int main(int argc, char** argv) try {
  const std::string option = argc > 1 ? argv[1] : "";
  if (argc != 1 && !(argc == 3 && option == "-o"))
    return std::puts("usage: cutwater_bench [-o FILE.csv]"), 2;
  const std::string path = argc == 3 ? argv[2] : "", temporary = path + ".tmp";
  std::FILE* csv = path.empty() ? stdout : std::fopen(temporary.c_str(), "w");
  if (csv == nullptr) return std::perror(temporary.c_str()), 1;
  std::fprintf(csv, "name,panels,threads,seconds,floor_seconds,checksum\n");
  benchSolve(csv);
  const Coefficients coefficients = buildCoefficients(frigate(224), sweep(30, 0));
  benchTicks(csv, "linear_ship_tick_200_components", coefficients, 1, 200);
  benchTicks(csv, "linear_ship_tick_1_component", coefficients, 1, 1);
  benchTicks(csv, "fleet_of_100_ships_tick_20_components", coefficients, 100, 20);
  if (!path.empty()) {
    if (std::fclose(csv) != 0 || std::rename(temporary.c_str(), path.c_str()) != 0) {
      return std::perror(path.c_str()), 1;
    }
  }
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "cutwater_bench: %s\n", error.what());
  return 1;
}
