#pragma once
#include <filesystem>
#include <stdexcept>
#include <string>

namespace cutwater {

/// Where the boat's database is: the first that is there of the places that CMake lists.
/// @throws std::runtime_error naming them.
inline std::string boatDatabase() {
  std::string none = "no boat's database; make it with ./run build, or name a DATABASE.h5; not at";
  for (const char* const place : {CUTWATER_BOAT_PLACES}) {
    if (std::filesystem::exists(place)) return place;
    none += std::string(" ") + place;
  }
  throw std::runtime_error(none);
}

}  // namespace cutwater
