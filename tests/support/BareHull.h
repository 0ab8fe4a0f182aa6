#pragma once
#include <memory>

#include "hydro/forces/Hydrodynamics.h"
#include "hydro/geometry/SurfaceMesh.h"

/// Ships of a closed hull alone, without a solver: their buoyancy is known on paper.
namespace cutwater::test {

/// A closed hull afloat at its mass, with G over the centre of buoyancy: x of `cog` is not read.
/// Its own mass is added `share` times in each mode, heave and pitch coupled, with a damping that
/// belongs to it. It throws no waves back; F_I is that of the faces below water, the linear one's
/// panels. For tests that look at the pressure alone.
struct BareHull {
  SurfaceMesh closed;
  Vec3 cog = Vec3::Zero();
  Vec3 gyradii = Vec3::Ones();
  double density = 1025.0, gravity = 9.81;
  Vec6 share = (Vec6() << 0.05, 0.5, 0.8, 0.2, 0.9, 0.6).finished();
};
Coefficients bareCoefficients(const BareHull& hull);
std::shared_ptr<const Hydrodynamics> bareShip(const BareHull& hull);

/// Vertices moved from and to the origin by a factor, so that the hull encloses `volume` [m³].
SurfaceMesh scaledToVolume(SurfaceMesh mesh, double volume);

}  // namespace cutwater::test
