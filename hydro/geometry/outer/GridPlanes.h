#pragma once
#include "hydro/geometry/SurfaceMesh.h"
#include "hydro/geometry/outer/WaterGrid.h"

namespace cutwater {

/// Planes of a grid around a body: where its panels' corners will lie between.
struct GridPlan {
  Bounds body;                   ///< of the body's wet and dry part [m]
  double length = 1.0;           ///< between planes [m]
  bool half = false;             ///< only y ≥ 0
  SpaceGrid::Planes extra = {};  ///< planes that thin parts need, by axis
};

/// Planes about `length` apart below calm water, all of them outside every face: they are set off
/// by some 1e-6 of the length, since faces like to lie at round numbers. The last of z is calm
/// water, with narrower rows below it. Of y the planes lie alike on both sides; of a half the first
/// is the centreplane.
SpaceGrid::Planes coarsePlanes(const GridPlan& plan);

/// Each interval of the planes divided into `step`, and z continued to above the body, all of them
/// an odd number of planes for an even step. Plane `top` of z is calm water.
struct FinePlanes {
  SpaceGrid::Planes planes;
  int top = 0;
};
FinePlanes finePlanes(const SpaceGrid::Planes& coarse, int step, double highest);

/// Planes through the middle of parts that are thinner than `length` along an axis, with water on
/// both sides, so that a grid of that length meets them. At the centreplane of a half it lies at a
/// quarter of the thickness.
SpaceGrid::Planes planesOfThinParts(const WaterGrid& water, const GridCrossings& crossings,
                                    double length, bool half);

}  // namespace cutwater
