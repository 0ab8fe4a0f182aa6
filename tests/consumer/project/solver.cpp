// Makes the database of a hull from its mesh: consumer_solver MESH OUT.h5
#include <cstdio>
#include <exception>

#include "hydro/database/CoefficientsFile.h"
#include "hydro/files/MeshIO.h"
#include "hydro/geometry/panelling/Panelling.h"
#include "hydro/ship/Afloat.h"
#include "hydro/solve/Solve.h"

int main(int argc, char** argv) try {
  if (argc != 3) return 2;
  const char* mesh = argv[1];
  const cutwater::RepairedHull read = cutwater::readRepaired(mesh);
  for (const std::string& line : read.done) std::fprintf(stderr, "%s\n", line.c_str());
  const cutwater::PanelledHull hull{read.hull.surface, cutwater::panelled(read.hull, 80, mesh),
                                    read.hull.symmetric, read.hull.file};
  const cutwater::Loading loading{
      .cog = {0.0, 0.0, -1.0}, .level = true, .gyradii = cutwater::Vec3(3.0, 3.0, 3.0)};
  cutwater::ShipParticulars ship = cutwater::afloat(hull, loading).ship;
  ship.name = "sphere";

  cutwater::SolveSettings settings;
  for (int i = 1; i <= 12; ++i) settings.omega.push_back(0.3 * i);
  settings.headings = {cutwater::kPi};
  const cutwater::Coefficients made = cutwater::solve(ship, settings);
  for (const std::string& line : cutwater::gridWarnings(made))
    std::fprintf(stderr, "%s\n", line.c_str());
  cutwater::writeCoefficients(made, argv[2]);
  std::printf("A33(inf) = %.3f of the displaced mass\n",
              made.addedMass.atInfinity(2, 2) / ship.mass);
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
