#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

#include "hydro/waves/SeaState.h"
#include "tests/excitation/BoxShip.h"

namespace cutwater::test {

/// The box with adjoint vectors that differ from panel to panel and smoothly over ω, as a hull's
/// do.
inline Coefficients tableBox(bool symmetric = true) {
  Coefficients c = boxShip();
  if (!symmetric) {
    c.ship.wetSurface = welded(joined(c.ship.wetSurface, mirroredInY(c.ship.wetSurface)), 1e-9);
    c.ship.symmetric = false;
  }
  const SurfaceMesh& wet = c.ship.wetSurface;
  const auto vectors = [&](double w, double factor) {
    Coefficients::AdjointVectors b(6, static_cast<Eigen::Index>(wet.faces.size()));
    for (Eigen::Index i = 0; i < b.cols(); ++i) {
      Vec3 x = Vec3::Zero();
      const Face& face = wet.faces[static_cast<std::size_t>(i)];
      for (int n = 0; n < face.size(); ++n) x += wet.corner(face, n) / face.size();
      for (int j = 0; j < 6; ++j) {
        // Of one side's port half modes 2, 4, 6 are odd in y, and so is what is given for the
        // whole.
        const double side = j % 2 == 1 && x.y() < 0.0 ? -1.0 : 1.0;
        const double shape = 1.0 + 0.1 * j * x.x() + 0.2 * std::abs(x.y()) - 0.3 * x.z();
        b(j, i) = side * factor * kBoxDensity * shape *
                  Complex(0.3 * w * std::exp(-0.5 * w), (1.0 + 0.1 * x.x() * w) / (1.0 + w * w));
      }
    }
    return b;
  };
  for (std::size_t i = 0; i < c.omega.size(); ++i) {
    c.adjoint[i] = vectors(c.omega[i], 1.0);
    c.adjointX.values.push_back(vectors(c.omega[i], 0.3));
  }
  c.adjoint.atZero = vectors(0.0, 1.0);
  c.adjointX.atZero = vectors(0.0, 0.3);
  c.adjoint.atInfinity = 0.05 * vectors(4.0, 1.0);
  c.adjointX.atInfinity = 0.05 * vectors(4.0, 0.3);
  return c;
}

inline SeaState tableSea(int count = 40, double from = 0.4, double to = 2.4) {
  std::vector<WaveComponent> waves;
  for (int i = 0; i < count; ++i)
    waves.push_back({from + (to - from) * i / std::max(1, count - 1), 0.1, 1.7 * i, 0.02 * i});
  return {waves, kBoxGravity};
}

}  // namespace cutwater::test
