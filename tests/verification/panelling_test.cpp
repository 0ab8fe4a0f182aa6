#include "hydro/geometry/Panelling.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "hydro/bem/BuildCoefficients.h"
#include "hydro/geometry/MeshIntegrals.h"
#include "tests/support/Hulls.h"
#include "tests/support/Results.h"

// Panels laid by Panelling.h and the structured panels of the same hull give the same forces.
namespace cutwater::test {
namespace {

Coefficients solved(const SurfaceMesh& wetPort, const std::vector<double>& omega) {
  ShipParticulars ship;
  ship.wetSurface = wetPort;
  ship.symmetric = true;
  ship.volume = 2 * volumeIntegrals(wetPort).volume;
  ship.mass = ship.density * ship.volume;
  SolveSettings settings;
  settings.omega = omega;
  settings.xDerivatives = false;
  return buildCoefficients(ship, settings);
}

/// Greatest difference over the frequencies, of the structured panels' greatest value.
double difference(const std::vector<Mat6>& laid, const std::vector<Mat6>& structured, int mode) {
  double most = 0.0, off = 0.0;
  for (std::size_t i = 0; i < laid.size(); ++i) {
    most = std::max(most, std::abs(structured[i](mode, mode)));
    off = std::max(off, std::abs(laid[i](mode, mode) - structured[i](mode, mode)));
  }
  return off / most;
}

void compare(const TestHull& hull, int count, const std::vector<double>& omega) {
  const SurfaceMesh panels = panelled(hull.hull, count, hull.name);
  const Coefficients laid = solved(panels, omega);
  const Coefficients structured = solved(hull.structured(count), omega);
  const auto check = [&](const char* name, double reached) {
    // The acceptance line.
    EXPECT_LE(reached, 0.02) << hull.name << ", " << count << " panels, " << name;
    recordResult("Panelling",
                 fmt::format("{}, {} panels a side: {}, greatest difference over 0.2 to 2 rad/s",
                             hull.name, panels.faces.size(), name),
                 "structured panels", reached, "≤ 0.02");
  };
  check("A33", difference(laid.addedMass, structured.addedMass, 2));
  check("B33", difference(laid.damping, structured.damping, 2));
  check("A22", difference(laid.addedMass, structured.addedMass, 1));
  check("B22", difference(laid.damping, structured.damping, 1));
}

TEST(PanellingVerification, AddedMassAndDampingAreThoseOfStructuredPanels) {
  const std::vector<TestHull> hulls = testHulls();
  if (!fullSize()) {
    compare(hulls[0], 224, {0.6, 1.4});
    return;
  }
  std::vector<double> omega;
  for (int i = 0; i <= 9; ++i) omega.push_back(0.2 + 0.2 * i);
  for (const TestHull& hull : hulls)
    for (const int count : {224, 433, 1040}) compare(hull, count, omega);
}

}  // namespace
}  // namespace cutwater::test
