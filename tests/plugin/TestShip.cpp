#include "tests/plugin/TestShip.h"

#include <cmath>

#include "tests/support/CsvTable.h"

namespace cutwater::test {

namespace {

constexpr double kRadius = 5.0, kDensity = 1000.0;
constexpr double kDisplaced = kDensity * 2.0 / 3.0 * kPi * kRadius * kRadius * kRadius;  // ρV

Mat6 translations(double surge, double heave) {
  Vec6 diagonal;
  diagonal << surge, surge, heave, Vec3::Zero();
  return kDisplaced * Mat6(diagonal.asDiagonal());
}

void addWaveForces(Coefficients& c) {
  for (int i = 0; i <= 6; ++i) c.headings.push_back(i * kPi / 6);
  for (const double beta : c.headings) {
    std::vector<CVec6> incident, scattered;
    for (const double omega : c.omega) {
      const double k = omega * omega / kSphereGravity;
      const double heave = c.ship.restoring(2, 2) * std::exp(-k * kRadius);
      CVec6 f = CVec6::Zero();
      f[Surge] = Complex(0, 0.6 * heave * k * kRadius * std::cos(beta));
      f[Sway] = Complex(0, -0.6 * heave * k * kRadius * std::sin(beta));
      f[Heave] = heave;
      incident.push_back(f);
      scattered.push_back(Complex(-0.4, 0.2) * (k * kRadius / (1.0 + k * kRadius)) * f);
    }
    c.froudeKrylov.push_back(incident);
    c.diffraction.push_back(scattered);
  }
}

}  // namespace

Coefficients hemisphere() {
  Coefficients c;
  c.ship.name = "hemisphere";
  c.ship.mass = 261800.0;
  c.ship.cog = Vec3(0, 0, -2);
  c.ship.gyradii = Vec3(2.5, 2.5, 2.5);
  c.ship.volume = kDisplaced / kDensity;
  c.ship.symmetric = true;
  c.ship.density = kDensity;
  c.ship.gravity = kSphereGravity;
  c.ship.restoring(2, 2) = 7.695e5;
  // The metacentre of a sphere is its centre, 2 m above G.
  c.ship.restoring(3, 3) = c.ship.restoring(4, 4) = c.ship.mass * kSphereGravity * 2.0;
  const CsvTable table("memory/hemisphere_hulme.csv");
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const double omega = std::sqrt(table.number(i, "Ka") * kSphereGravity / kRadius);
    c.omega.push_back(omega);
    c.addedMass.push_back(translations(table.number(i, "surge_A"), table.number(i, "heave_A")));
    c.damping.push_back(omega *
                        translations(table.number(i, "surge_B"), table.number(i, "heave_B")));
  }
  c.addedMassZero = translations(0.5, 0.8310);
  c.addedMassInf = translations(0.2732, 0.5);
  addWaveForces(c);
  return c;
}

}  // namespace cutwater::test
