// Makes the database of a floating sphere: consumer_solver OUT.h5
#include <cstdio>
#include <exception>

#include "hydro/database/CoefficientsFile.h"
#include "hydro/geometry/shapes/Shapes.h"
#include "hydro/ship/Afloat.h"
#include "hydro/solve/Solve.h"

int main(int argc, char** argv) try {
  if (argc != 2) return 2;
  const double radius = 5.0;  // [m]
  const cutwater::PanelledHull hull{cutwater::closedSphere(radius, 12, 8),
                                    cutwater::wetHemisphere(radius, 12, 8), true};
  cutwater::ShipParticulars ship =
      cutwater::afloat(hull, {.cog = {0.0, 0.0, -1.0}, .gyradii = cutwater::Vec3(3.0, 3.0, 3.0)})
          .ship;
  ship.name = "sphere";

  cutwater::SolveSettings settings;
  for (int i = 1; i <= 12; ++i) settings.omega.push_back(0.3 * i);
  settings.headings = {cutwater::kPi};
  const cutwater::Coefficients made = cutwater::solve(ship, settings);
  for (const std::string& line : cutwater::gridWarnings(made))
    std::fprintf(stderr, "%s\n", line.c_str());
  cutwater::writeCoefficients(made, argv[1]);
  std::printf("A33(inf) = %.3f of the displaced mass\n",
              made.addedMass.atInfinity(2, 2) / ship.mass);
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
