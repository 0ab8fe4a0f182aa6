#include "tests/support/BareHull.h"

#include <cmath>

#include "hydro/geometry/MeshIntegrals.h"
#include "hydro/memory/RetardationFunction.h"
#include "hydro/ship/Afloat.h"

namespace cutwater::test {

namespace {

constexpr double kCoupling = 0.3;  // of heave and pitch, of what would make them one

// B = A(∞) 0.4(2ω)⁴/(1 + ω²)⁴, which is positive and vanishes at both ends; A follows from it.
void addRadiation(Coefficients& c, const Vec6& share) {
  Mat6& added = c.addedMass.atInfinity;
  added = share.asDiagonal() * c.ship.massMatrix();
  added(Heave, Pitch) = added(Pitch, Heave) =
      kCoupling * std::sqrt(added(Heave, Heave) * added(Pitch, Pitch));
  std::vector<double> law;
  for (int i = 1; i <= 60; ++i) {
    const double omega = 0.1 * i;
    c.omega.push_back(omega);
    law.push_back(0.4 * std::pow(2.0 * omega / (1.0 + omega * omega), 4));
  }
  const RetardationFunction memory(c.omega, law);
  for (std::size_t i = 0; i < c.omega.size(); ++i) {
    const double part = memory.sineTransform(c.omega[i]) / c.omega[i];
    c.damping.values.push_back(law[i] * c.addedMass.atInfinity);
    c.addedMass.values.push_back((1.0 - part) * c.addedMass.atInfinity);
  }
  c.addedMass.atZero = (1.0 + memory.remaining(0.0)) * c.addedMass.atInfinity;
}

// No diffraction for any wave, and so F_I of the panels for each.
void addNoDiffraction(Coefficients& c) {
  const auto count = static_cast<Eigen::Index>(c.ship.wetSurface.faces.size());
  const CoefficientTables::AdjointVectors none = CoefficientTables::AdjointVectors::Zero(6, count);
  for (auto* vectors : {&c.adjoint, &c.adjointX}) {
    vectors->values.assign(c.omega.size(), none);
    vectors->atZero = vectors->atInfinity = none;
  }
}

}  // namespace

Coefficients bareCoefficients(const BareHull& bare) {
  Coefficients c;
  c.forwardSpeed = ForwardSpeedForm::Tuck;
  const Hull hull = makeHull(bare.closed, "bare", Symmetry::Auto);
  const Loading loading{.cog = bare.cog, .level = true, .gyradii = bare.gyradii};
  c.ship = afloat(panelledAsItIs(hull), loading, {bare.density, bare.gravity}).ship;
  c.ship.name = "bare";
  addRadiation(c, bare.share);
  addNoDiffraction(c);
  return c;
}

std::shared_ptr<const Hydrodynamics> bareShip(const BareHull& hull) {
  return std::make_shared<const Hydrodynamics>(bareCoefficients(hull));
}

SurfaceMesh scaledToVolume(SurfaceMesh mesh, double volume) {
  const double factor = std::cbrt(volume / volumeIntegrals(mesh).volume);
  for (Vec3& p : mesh.vertices) p *= factor;
  return mesh;
}

}  // namespace cutwater::test
