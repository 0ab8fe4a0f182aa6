// Makes the database of a hull from its mesh: consumer_solver MESH OUT.h5
#include <cstdio>
#include <exception>

#include "hydro/database/CoefficientsFile.h"
#include "hydro/files/MeshIO.h"
#include "hydro/ship/Afloat.h"
#include "hydro/solve/Solve.h"

int main(int argc, char** argv) try {
  if (argc != 3) return 2;
  const char* mesh = argv[1];
  const cutwater::AnyHull made = cutwater::readAnyHull(mesh, 80);
  for (const std::string& line : made.done) std::fprintf(stderr, "%s\n", line.c_str());
  const cutwater::PanelledHull hull{made.hull.surface, made.panels, made.hull.symmetric,
                                    made.hull.file};
  const cutwater::Loading loading{
      .cog = {0.0, 0.0, -1.0}, .level = true, .gyradii = cutwater::Vec3(3.0, 3.0, 3.0)};
  cutwater::ShipParticulars ship = cutwater::afloat(hull, loading).ship;
  ship.name = "sphere";

  cutwater::SolveSettings settings;
  if (made.by == cutwater::PanelsBy::Surface) settings.panelShape = cutwater::PanelShape::Flat;
  for (int i = 1; i <= 12; ++i) settings.omega.push_back(0.3 * i);
  settings.headings = {cutwater::kPi};
  const cutwater::Coefficients solved = cutwater::solve(ship, settings);
  for (const std::string& line : cutwater::gridWarnings(solved))
    std::fprintf(stderr, "%s\n", line.c_str());
  cutwater::writeCoefficients(solved, argv[2]);
  std::printf("A33(inf) = %.3f of the displaced mass\n",
              solved.addedMass.atInfinity(2, 2) / ship.mass);
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
