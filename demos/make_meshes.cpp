// The hull files under meshes/, made from their formulas, S-175's from its offsets in that folder:
// `make_meshes FOLDER` writes them anew. Their wet faces are the solver's panels
// (panels = "as-is"), S-175's and the boat's are divided anew; the whole is closed, for buoyancy
// and collision.
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "demos/make_meshes/Boat.h"
#include "hydro/Errors.h"
#include "hydro/base/AtomicFile.h"
#include "hydro/files/MeshIO.h"
#include "hydro/geometry/Hydrostatics.h"
#include "hydro/geometry/MeshCut.h"
#include "hydro/geometry/shapes/Loft.h"
#include "hydro/geometry/shapes/Shapes.h"

namespace {

using namespace cutwater;
namespace fs = std::filesystem;

void printHydrostatics(const std::string& file, const SurfaceMesh& mesh) {
  const Hydrostatics h = hydrostatics(cutBelow(mesh), Vec3::Zero(), 1000.0, 9.81);
  std::printf("%-32s V %10.4f m3  S %9.4f m2  LCB %8.4f m  CB %8.4f m\n", file.c_str(), h.volume,
              h.wettedArea, h.buoyancy.x(), h.buoyancy.z());
}

void write(const fs::path& root, const std::string& file, const SurfaceMesh& mesh,
           const std::string& about) {
  const fs::path path = root / file;
  fs::create_directories(path.parent_path());
  writeObj(path.string(), mesh,
           about + "\nmetres; x forward, y to port, z up from calm water; made by make_meshes");
  printHydrostatics(file, mesh);
}

/// The boat's first part is its hull.
void writeBoat(const fs::path& root) {
  const std::string file = "boat/boat.glb";
  const meshes::Model model = meshes::boat();
  SurfaceMesh hull;
  for (const meshes::Surface& surface : model.parts.front().surfaces)
    hull = joined(hull, surface.mesh);
  fs::create_directories((root / file).parent_path());
  writeWhole((root / file).string(), meshes::glb(model, "Cutwater, zlib licence"));
  printHydrostatics(file, welded(hull, 1e-9));
}

/// Scaled about its centre until the panels enclose what the sphere does.
SurfaceMesh sphereOfEqualVolume(double radius, int around, int down) {
  SurfaceMesh mesh = closedSphere(radius, around, down);
  const Hydrostatics h = hydrostatics(cutBelow(mesh), Vec3::Zero(), 1000.0, 9.81);
  const double scale = std::cbrt(2.0 / 3.0 * kPi * std::pow(radius, 3) / h.volume);
  for (Vec3& p : mesh.vertices) p *= scale;
  return mesh;
}

/// The table of offsets beside the mesh: x aft of midships, half breadth, height above the
/// baseline.
std::vector<Vec3> offsets(const fs::path& file, double draught) {
  std::ifstream in(file);
  std::vector<Vec3> points;
  double x = 0.0, y = 0.0, z = 0.0;
  for (std::string line; std::getline(in, line);)
    if (std::sscanf(line.c_str(), "%lf,%lf,%lf", &x, &y, &z) == 3)
      points.emplace_back(-x, y, z - draught);
  if (points.empty()) throw HydroError(Fault::FileNotReadable, file.string() + ": no offsets");
  return points;
}

void writeAll(const fs::path& root) {
  for (int panels : {224, 433, 1040}) {
    const FrigateDivision d = frigateDivision(panels);
    write(root, "frigate/frigate_" + std::to_string(panels) + ".obj",
          closedFrigate(d.along, d.girth),
          "FRIGATE-124, " + std::to_string(panels) + " panels a side");
  }
  write(root, "hemisphere/hemisphere_432.obj", closedSphere(10.0, 27, 16),
        "Floating hemisphere, radius 10 m, 432 panels a side, inscribed");
  write(root, "hemisphere/hemisphere_1040.obj", closedSphere(10.0, 40, 26),
        "Floating hemisphere, radius 10 m, 1040 panels a side, inscribed");
  write(root, "half_ellipsoid/half_ellipsoid_400.obj",
        closedHalfEllipsoid({62.25, 7.4, 4.97}, 5.0, 50, 8),
        "Half ellipsoid 62.25 x 7.4 x 4.97 m, 400 panels a side, inscribed");
  write(root, "wigley/wigley_iii_400.obj", closedWigley(wigley(3), 0.1, 40, 10),
        "Wigley hull III, L = 3 m, 400 panels a side");
  write(root, "barge/barge_196.obj", closedBox({60.0, 16.0, 4.0, 4.0}, 30, 4, 2),
        "Barge 60 x 16 x 4 m, 196 panels a side");
  write(root, "sphere_oes/sphere_432.obj", sphereOfEqualVolume(5.0, 27, 16),
        "Sphere of radius 5 m, half immersed, 432 panels a side, panelled volume exact");
  write(root, "s175/s175.obj", LoftedHull(offsets(root / "s175/offsets.csv", 9.5)).closed(120, 24),
        "S-175 container ship, lofted through offsets.csv, draught 9.5 m; to be panelled (panels = "
        "N)");
  writeBoat(root);
}

}  // namespace

int main(int count, char** words) try {
  if (count != 2) {
    std::fprintf(stderr, "usage: make_meshes FOLDER\n");
    return 2;
  }
  writeAll(words[1]);
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "make_meshes: %s\n", error.what());
  return 1;
}
