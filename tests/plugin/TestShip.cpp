#include "tests/plugin/TestShip.h"

#include <cmath>

#include "hydro/memory/RetardationFunction.h"
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
  c.forwardSpeed = ForwardSpeedForm::Report;
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
    c.addedMass.values.push_back(
        translations(table.number(i, "surge_A"), table.number(i, "heave_A")));
    c.damping.values.push_back(
        omega * translations(table.number(i, "surge_B"), table.number(i, "heave_B")));
  }
  c.addedMass.atZero = translations(0.5, 0.8310);
  c.addedMass.atInfinity = translations(0.2732, 0.5);
  addWaveForces(c);
  return c;
}

// B_jk = b_jk (2ω)⁴/(1 + ω²)⁴ is positive for every ω where b is; A follows from it.
Coefficients slenderShip() {
  Coefficients c;
  ShipParticulars& ship = c.ship;
  ship.name = "slender";
  ship.mass = 4.0e6;
  ship.cog = Vec3(0, 0, 1);
  ship.gyradii = Vec3(6, 28, 28);
  ship.volume = ship.mass / kDensity;
  ship.density = kDensity;
  ship.gravity = kSphereGravity;
  ship.symmetric = true;
  ship.restoring(2, 2) = 1.2e7;
  ship.restoring(3, 3) = 5e7;
  ship.restoring(4, 4) = 9e9;
  ship.supplementary.damping[Roll] = 2e7;
  Vec6 mass;
  mass << 1e5, 1.5e6, 4e6, 3e7, 3e9, 1e9;
  c.addedMass.atInfinity = mass.asDiagonal();
  c.addedMass.atInfinity(Sway, Yaw) = c.addedMass.atInfinity(Yaw, Sway) = -2e6;
  c.addedMass.atInfinity(Heave, Pitch) = c.addedMass.atInfinity(Pitch, Heave) = 1e7;
  const Mat6 b = 0.5 * c.addedMass.atInfinity;
  std::vector<double> law;
  for (int i = 1; i <= 60; ++i) {
    c.omega.push_back(0.1 * i);
    law.push_back(std::pow(2.0 * c.omega.back() / (1.0 + c.omega.back() * c.omega.back()), 4));
  }
  const RetardationFunction memory(c.omega, law);
  for (std::size_t i = 0; i < c.omega.size(); ++i) {
    c.damping.values.push_back(law[i] * b);
    c.addedMass.values.push_back(c.addedMass.atInfinity -
                                 memory.sineTransform(c.omega[i]) / c.omega[i] * b);
  }
  c.addedMass.atZero = c.addedMass.atInfinity + memory.remaining(0.0) * b;
  c.forwardSpeed = ForwardSpeedForm::Tuck;
  for (const double x : {-55.0, 55.0}) {
    for (const double y : {-7.0, 7.0}) {
      for (const double z : {-5.0, 6.0}) ship.hull.vertices.emplace_back(x, y, z);
    }
  }
  addWaveForces(c);
  return c;
}

}  // namespace cutwater::test
