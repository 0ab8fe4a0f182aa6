// Makes the database of a floating sphere: consumer_solver OUT.h5
#include <cstdio>
#include <exception>

#include "hydro/bem/BuildCoefficients.h"
#include "hydro/database/CoefficientsFile.h"
#include "hydro/geometry/shapes/Shapes.h"

int main(int argc, char** argv) try {
  if (argc != 2) return 2;
  const double radius = 5.0;  // [m]
  cutwater::ShipParticulars ship;
  ship.name = "sphere";
  ship.hull = cutwater::closedSphere(radius, 12, 8);
  ship.wetSurface = cutwater::wetHemisphere(radius, 12, 8);
  ship.symmetric = true;
  ship.volume = 2.0 / 3.0 * cutwater::kPi * radius * radius * radius;
  ship.mass = ship.density * ship.volume;
  ship.cog = {0.0, 0.0, -1.0};
  ship.gyradii = {3.0, 3.0, 3.0};
  ship.centreOfBuoyancy = {0.0, 0.0, -0.375 * radius};
  ship.restoring(2, 2) = ship.density * ship.gravity * cutwater::kPi * radius * radius;
  ship.restoring(3, 3) = ship.restoring(4, 4) = ship.mass * ship.gravity * 1.0;

  cutwater::SolveSettings settings;
  for (int i = 1; i <= 12; ++i) settings.omega.push_back(0.3 * i);
  settings.headings = {cutwater::kPi};
  const cutwater::Coefficients made = cutwater::buildCoefficients(ship, settings);
  cutwater::writeCoefficients(made, argv[1]);
  std::printf("A33(inf) = %.3f of the displaced mass\n",
              made.addedMass.atInfinity(2, 2) / ship.mass);
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
