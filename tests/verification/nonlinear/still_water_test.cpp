#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "hydro/forces/SeaTables.h"
#include "hydro/forces/WettedHull.h"
#include "hydro/geometry/MeshCut.h"
#include "hydro/geometry/MeshIntegrals.h"
#include "hydro/geometry/shapes/Shapes.h"
#include "hydro/geometry/wetted/PressureMesh.h"
#include "hydro/geometry/wetted/SymmetricTriangles.h"
#include "tests/support/Hulls.h"
#include "tests/support/Meshes.h"
#include "tests/support/Results.h"
#include "tests/verification/nonlinear/NonlinearShip.h"

// Still water on a real hull: Archimedes, and no force along the surface, however the hull lies and
// is divided.
namespace cutwater::test {
namespace {

constexpr double kTick = 0.02;  // [s]

struct NamedMesh {
  const char* name;
  SurfaceMesh mesh;
};

std::vector<NamedMesh> frigates() {
  const SurfaceMesh coarse = symmetricTriangles(closedFrigate(32, 7));
  return {{"coarse", coarse},
          {"shaken by 0.2 m and shuffled", shuffled(shaken(coarse, 0.2))},
          {"refined to 1.5 m", refined(coarse, 1.5, 100000).mesh},
          {"fine", symmetricTriangles(closedFrigate(90, 24))}};
}

Mat3 randomAttitude(std::mt19937& random) {
  std::normal_distribution<double> normal;
  const Eigen::Quaterniond q(normal(random), normal(random), normal(random), normal(random));
  return q.normalized().toRotationMatrix();
}

// Volume under the water of the hull there, by cutting the mesh at the plane, which is other code.
double volumeUnder(const SurfaceMesh& mesh, const Vec3& cog, const WettedHull::Place& place) {
  SurfaceMesh there = symmetricTriangles(mesh);  // as the pressure hull divides twisted faces
  for (Vec3& p : there.vertices) p = place.position + place.attitude * (p - cog);
  SurfaceMesh wet = cutBelow(there, {Vec3::UnitZ(), 0.0}, 0.0);
  return volumeIntegrals(wet).volume;  // what is open lies in z = 0, and adds nothing
}

// Acceptance: zero to round-off. Some thousand terms of up to ρg times the area times the depth
// are added, and the vertices' places themselves are rounded, which are up to some 100 m from G:
// 1e-13 of the weight of the whole hull's water.
TEST(StillWaterIdentity, AFrigateInAnyAttitudeAndDivision) {
  std::mt19937 random(16);
  std::uniform_real_distribution<double> height(-8.0, 8.0), place(-1e4, 1e4);
  const int attitudes = fullSize() ? 2000 : 200;
  for (const NamedMesh& each : frigates()) {
    const BareHull bare{.closed = each.mesh, .cog = Vec3(0.0, 0.0, 1.29)};
    const auto ship = bareShip(bare);
    const Vec3 cog = ship->ship().cog;
    const auto tables = std::make_shared<SeaTables>(ship, std::make_shared<const SeaState>());
    const auto hull = tables->pressureHull(100000);
    WettedHull wetted(hull, tables, false);
    const double rhoG = bare.density * bare.gravity;
    const double unit = rhoG * hull->triangles().volume();
    double along = 0.0, turning = 0.0, floating = 0.0, lever = 0.0, apart = 0.0;
    for (int i = 0; i < attitudes; ++i) {
      const WettedHull::Place here{Vec3(place(random), place(random), height(random)),
                                   randomAttitude(random)};
      wetted.look(0.0, here);
      const Vec6 load = wetted.load();
      const Vec3 force = load.head<3>(), moment = load.tail<3>();
      along = std::max(along, force.head<2>().norm() / unit);
      turning = std::max(turning, std::abs(moment.z()) / (unit * 100.0));
      floating = std::max(floating, std::abs(force.z() - rhoG * wetted.volume()) / unit);
      const Vec3 arm = wetted.centre() - here.position;
      lever = std::max(lever, (moment - arm.cross(force)).norm() / (unit * 100.0));
      apart = std::max(apart,
                       std::abs(wetted.volume() - volumeUnder(each.mesh, cog, here)) * rhoG / unit);
    }
    for (const double error : {along, turning, floating, lever, apart})
      EXPECT_LT(error, 1e-13) << each.name;
    recordResult(kTopic,
                 std::string("frigate, ") + each.name +
                     ", random attitudes in still water: force along the surface, of ρgV",
                 "0", along, "1e-13");
    recordResult(kTopic,
                 std::string("frigate, ") + each.name +
                     ", random attitudes in still water: yaw moment, of ρgV 100 m",
                 "0", turning, "1e-13");
  }
}

// As it lies in its file a ship floats to the digits of its file and the triangles that its twisted
// faces are divided into, some millimetres off. It is let settle, and begun anew where it came to.
void settle(OneShip& run) {
  for (int round = 0; round < 4; ++round) {
    for (int i = 0; i < 5000; ++i) run.tick(kTick);
    Vec6 offset = run.ship.motion();
    offset[Surge] = offset[Sway] = offset[Yaw] = 0.0;
    run.ship.placeAt(0.0, 0.0, 0.0, offset);
  }
}

// A free ship with all its parts, for 2000 s. A force of 1e-15 of the weight, a fiftieth of the
// bound above, would move it by 20 nm if it never changed; a micrometre is asked for.
TEST(StillWaterIdentity, AShipAtRestStaysThere) {
  const auto frigate = readHydrodynamics(CUTWATER_SOLVED "/frigate.h5");
  ShipSettings settings;
  settings.model.mode = HullPressure::Nonlinear;
  OneShip run(frigate, {}, settings);
  settle(run);
  const int ticks = fullSize() ? 100000 : 5000;
  const Vec6 begins = run.ship.motion();
  double drift = 0.0, turn = 0.0, moved = 0.0;
  for (int i = 0; i < ticks; ++i) {
    run.tick(kTick);
    const Vec6 motion = run.ship.motion();
    drift = std::max(drift, run.ship.position().head<2>().norm());
    turn = std::max(turn, std::abs(run.ship.attitude().z()));
    moved = std::max(moved, std::abs(motion[Heave] - begins[Heave]));
  }
  EXPECT_EQ(run.seaway.faults(), kStepOk);
  EXPECT_LT(moved, 1e-9);
  recordResult(kTopic, "frigate at rest, " + std::to_string(ticks) + " ticks: drift [m]", "0",
               drift, "1e-6");
  recordResult(kTopic, "frigate at rest, " + std::to_string(ticks) + " ticks: yaw [rad]", "0", turn,
               "1e-9");
  EXPECT_LT(drift, 1e-6);
  EXPECT_LT(turn, 1e-9);
}

}  // namespace
}  // namespace cutwater::test
