#pragma once
#include <array>
#include <memory>
#include <vector>

#include "hydro/forces/PredictedMotion.h"
#include "hydro/forces/WettedHull.h"
#include "hydro/forces/linear/WaveForce.h"
#include "plugin/BulletTypes.h"

CUTWATER_PLUGIN_BEGIN

/// What a ship is, as far as its sea matters. Holds nothing of the ship itself.
struct ShipSeaOrder {
  bool free = false;
  PredictedMotion::Way way;                  ///< of a free ship
  ActiveParts parts;                         ///< likewise
  WaveForce::Course course;                  ///< of one on a fixed course
  std::shared_ptr<const PressureHull> hull;  ///< nonlinear mode; else null
  bool scaled = true;
};

/// What of a ship belongs to the sea that it sails in. Made for a sea that is to come on any
/// thread, from what the ship was when it was asked for; taken in by Ship::enterSea.
struct ShipSea {
  /// @throws HydroError as PredictedMotion and WaveForce.
  ShipSea(std::shared_ptr<const SeaTables> tables, const ShipSeaOrder& order);

  std::shared_ptr<const SeaTables> tables;
  std::shared_ptr<const CourseForces> onCourse;     // of a fixed course
  std::unique_ptr<PredictedMotion> predicted;       // of a free ship
  std::array<std::unique_ptr<WaveForce>, 2> waves;  // of a fixed course: [WaveLoad]
  std::unique_ptr<WettedHull> wetted;               // nonlinear mode
  std::vector<Phasors4> phasors;
};

CUTWATER_PLUGIN_END
