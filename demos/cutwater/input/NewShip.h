#pragma once
#include <optional>
#include <string>
#include <vector>

#include "hydro/files/MeshIO.h"
#include "hydro/ship/Afloat.h"

/// A ship made of a hull file and of guesses for all that the user does not say.
namespace cutwater::command {

/// What the user says; what is absent is guessed.
struct NewOptions {
  std::optional<std::string> up, forward, unit, symmetric;
  std::optional<double> waterline;     ///< height in the file, in its unit
  std::optional<double> draught;       ///< of the lowest point [m]
  std::optional<double> displacement;  ///< [kg]: the waterline is found for it
  std::optional<double> mass;          ///< [kg]: the same, and written into the file
  std::optional<double> cogHeight;     ///< of G above calm water [m]
  std::optional<int> panels;
  double trimDeg = 0.0, heelDeg = 0.0;
  double density = kSeaWaterDensity;  ///< [kg/m³]
  bool anyFormat = false;
};

/// One thing that was settled, and how.
struct NewFact {
  std::string name, value;
  std::string word;    ///< "given", "clear", "likely", "a guess", "chosen"
  std::string reason;  ///< in words
  std::string option;  ///< that says otherwise
};

struct NewShip {
  std::string mesh;  ///< the hull file
  MeshReadOptions options;
  bool directed = true;  ///< it has a bow; else any horizontal axis is called forward
  std::vector<NewFact> facts;
  PanelledHull hull;  ///< its panels may be missing: see `problem`
  Hydrostatics hydrostatics;
  std::optional<double> givenMass;                  ///< [kg]
  double mass = 0.0;                                ///< [kg]
  Vec3 cog = Vec3::Zero(), gyradii = Vec3::Ones();  ///< [m], hull axes
  int panels = 0;                                   ///< a side
  double density = kSeaWaterDensity;                ///< [kg/m³]
  std::string problem;  ///< why panels cannot be laid, or the hull not be repaired; or empty
};

/// Reads the mesh, guesses, lets the hull float. What was repaired is said on stderr.
/// @throws HydroError, one line: what readSurface throws; ValueOutOfRange for a hull without a
///   sensible unit, or one that cannot carry the mass; what the repair says where no volume of the
///   mesh can be trusted.
NewShip newShip(const std::string& mesh, const NewOptions& options);

}  // namespace cutwater::command
