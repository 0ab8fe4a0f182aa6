#pragma once
#include <cmath>

#include "hydro/database/Coefficients.h"

namespace cutwater::test {

/// A made-up ship with every field filled, no two numbers alike, G off the origin and the headings
/// in an order that BEMIO must change.
inline Coefficients sampleShip() {
  double x = 0.7;
  const auto next = [&x] { return x = std::fmod(x * 3.7 + 0.13, 1.9) - 0.4; };
  const auto any6 = [&] { return Mat6(Mat6::NullaryExpr([&] { return 1e6 * next(); })); };
  const auto vectors = [&] {
    return Coefficients::AdjointVectors(
        Coefficients::AdjointVectors::NullaryExpr(6, 2, [&] { return Complex(next(), next()); }));
  };
  Coefficients c;
  c.ship.name = "sample";
  c.ship.hull.vertices = {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1.0 / 3.0}};
  c.ship.hull.faces = {{{0, 1, 2, -1}}, {{0, 1, 2, 3}}};
  c.ship.wetSurface.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, -1}};
  c.ship.wetSurface.faces = {{{0, 1, 2, -1}}, {{2, 1, 0, -1}}};
  c.ship.symmetric = true;
  c.ship.file.rotation << 0, 0, -1, -1, 0, 0, 0, 1, 0;
  c.ship.file.metresPerUnit = 0.01;
  c.ship.file.origin = {0.0, 0.0, -3.7};
  c.ship.mass = 4.9e6;
  c.ship.cog = {-2.42, 0.3, 1.29};
  c.ship.gyradii = {5.82, 28.8, 28.9};
  c.ship.volume = 4795.0;
  c.ship.centreOfBuoyancy = {-2.4, 0.0, -1.9};
  c.ship.restoring = any6();
  c.ship.restoring = (c.ship.restoring + c.ship.restoring.transpose()).eval();
  c.ship.supplementary.damping(Roll) = 2e7;
  c.ship.supplementary.stiffness(Yaw) = 2e9;
  c.ship.supplementary.rollDampingQuadratic = 3e5;
  c.ship.drag = {0.8, 0.13};
  c.ship.engine = {4.1e5, 0.6, {}, 3.5, 3.1, Vec3(-55.0, 0.0, -2.5)};
  c.ship.rudder = {14.0, {}, 1.7, 0.6, 0.05, 0.5, 0.3, 0.6};
  c.provenance = {"Cutwater", "0.1.0", "0123456789abcdef", "[solve]\nlid = true\n"};
  c.headings = {0.0, kPi / 4.0, kPi, -kPi / 2.0};
  c.waveOmega = {0.3, 0.5};
  c.omega = {0.1, 0.25, 0.5, 0.9, 1.4};
  for (std::size_t i = 0; i < c.omega.size(); ++i) {
    c.addedMass.values.push_back(any6());
    c.damping.values.push_back(any6());
    c.addedMassX.values.push_back(any6());
    c.dampingX.values.push_back(any6());
    c.conditionEven.push_back(10.0 + next());
    c.conditionOdd.push_back(20.0 + next());
    c.adjoint.values.push_back(vectors());
    c.adjointX.values.push_back(vectors());
    c.masked.push_back(i % 2 == 0 ? 0 : 1);
  }
  for (auto* limit :
       {&c.adjoint.atZero, &c.adjointX.atZero, &c.adjoint.atInfinity, &c.adjointX.atInfinity})
    *limit = vectors();
  c.forwardSpeed = ForwardSpeedForm::Tuck;
  c.conditionLimitEven = {{0.0, 30.0}, {1.0, 40.0}};
  c.conditionLimitOdd = {{0.5, 50.0}};
  c.diffractionTable = {{0.0, 5.0}, {kPi}, {0.3, 0.4, 0.6}, {}};
  for (int i = 0; i < 6; ++i) c.diffractionTable.values.emplace_back(vectors().col(0));
  c.addedMass.atZero = any6();
  c.addedMass.atInfinity = any6();
  c.addedMassX.atZero = any6();
  c.addedMassX.atInfinity = any6();
  for (auto* part : {&c.froudeKrylov, &c.diffraction}) {
    part->assign(c.headings.size(), std::vector<CVec6>(c.omega.size()));
    for (auto& heading : *part) {
      for (CVec6& f : heading)
        f = CVec6::NullaryExpr([&] { return 1e5 * Complex(next(), next()); });
    }
  }
  return c;
}

}  // namespace cutwater::test
