#pragma once
#include <memory>
#include <string>

#include "hydro/forces/ForceGenerator.h"
#include "plugin/BulletTypes.h"

CUTWATER_PLUGIN_BEGIN

/// One part of a ship's load, and what the ship knows about it.
struct ShipPart {
  std::string name;
  std::unique_ptr<ForceGenerator> force{};  ///< null: Bullet's own, gravity and added_mass
  /// Potential flow of the database. These loads and those added to them are summed apart, so that
  /// an added part changes nothing in how the others are rounded.
  bool potentialFlow = false;
  bool byUser = false;
  bool on = true;            ///< as asked for
  bool replaced = false;     ///< another part stands for it
  double nanoseconds = 0.0;  ///< of all evaluations timed
  std::size_t timed = 0;

  bool active() const noexcept { return on && !replaced; }
};

CUTWATER_PLUGIN_END
