#pragma once
#include <string>

#include "demos/cutwater/input/NewShip.h"

namespace cutwater::command {

/// The SHIP.toml of a new ship: every key that it needs, each guess with a comment.
/// @param meshName  the hull file, relative to the file's own folder.
std::string shipToml(const NewShip& ship, const std::string& meshName);

}  // namespace cutwater::command
