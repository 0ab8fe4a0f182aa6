#pragma once
#include <optional>
#include <string>

#include "hydro/geometry/SurfaceMesh.h"

/// What a mesh is taken for, from its shape alone: which way is up, where the bow is, what its unit
/// is, where the water stands.
///     const AxesGuess axes = guessAxes(mesh, {.conventional = {"y", "z", "glTF"}});
///     std::puts(("up is " + axes.up.value + ": " + axes.up.reason).c_str());
/// Nothing here is certain. Each guess has a confidence and a reason, and the caller lets the user
/// say otherwise.
namespace cutwater {

/// A guess, the probability that the weights behind it give it (0.5 to 1), its reason in words.
template <typename Value>
struct Guess {
  Value value{};
  double confidence = 1.0;
  std::string reason{};
  /// "clear", "likely" or "a guess", from 0.95 and 0.75 on.
  std::string word() const {
    return confidence > 0.95 ? "clear" : confidence > 0.75 ? "likely" : "a guess";
  }
};

/// The usual axes of a file format: "x", "-x", "y" and so on; empty: it has none.
struct AxisConvention {
  std::string up, forward, format;
};

struct AxesHints {
  AxisConvention conventional = {};
  std::optional<std::string> up = {}, forward = {};  ///< what the user says
};

struct AxesGuess {
  Guess<std::string> up, forward;
  /// Longer than 1.6 times its breadth, and not a body on end: it has a bow. Else any horizontal
  /// axis may be called forward.
  bool ship = true;
};

/// Compares the 24 ways to lay the axes. Speaking for up: a level deck over a bottom that is not,
/// an open top, no mirror image below; of columns and buoys the axis about which they turn. For
/// forward: the longer horizontal axis, port and starboard alike, the end with the finer plan.
/// Beside these the habits of formats, and axes that point the positive way.
/// @param mesh  in the file's own axes and unit, any surface; not empty.
/// @throws HydroError BadArgument where the hints put up and forward on one axis.
/// O(faces + 1e6), a tenth of a second.
AxesGuess guessAxes(const SurfaceMesh& mesh, const AxesHints& hints);

/// "m", "cm", "mm" for a length along `forward` in the file's unit: what makes a ship of
/// 3 to 450 m, metres first and from 0.8 m on (models in tanks). An empty value: no unit makes a
/// ship of it.
/// @param game  a model for games, rather in cm than in mm where both make a ship.
Guess<std::string> guessUnit(double length, bool game);

/// Height of calm water along `up`, in the file's unit.
struct WaterlineGuess {
  Guess<double> height;
  double low = 0.0;    ///< of the lowest point
  double deck = 0.0;   ///< up to which the hull's sides reach, superstructures not counted
  double high = 0.0;   ///< of the highest point
  bool inFile = true;  ///< 0 is calm water in the file; else the height is made up
};
/// 0 where the file's 0 lies between 2 % and 98 % of the hull's depth above its lowest point, or
/// the mesh ends there; else 45 % of that depth.
/// @param up  as AxesGuess::up.
WaterlineGuess guessWaterline(const SurfaceMesh& mesh, const std::string& up);

/// Volume [unit³] below the height, of a hull without overhangs: down to its lowest skin, seen from
/// below. What a search for a draught starts from.
double volumeFromBelow(const SurfaceMesh& mesh, const std::string& up, double height);

}  // namespace cutwater
