#pragma once
#include <vector>

#include "hydro/geometry/SurfaceMesh.h"

namespace cutwater {

/// A hull known by a table of offsets. Its surface passes through all points of the table: monotone
/// cubic splines [Fritsch & Carlson 1980] along each section by its chord length, then lengthwise
/// at equal fractions of the girth above and below calm water, so that nothing overshoots. Forward
/// of the first section the waterlines are rounded off, each as far as it is half as broad there;
/// aft the hull ends in the flat transom of the last section; on top in a deck at the height of the
/// table's highest points.
class LoftedHull {
 public:
  /// @param offsets  points of the port side in hull axes [m] (z = 0 calm water): section by
  ///   section from the bow aft, each from the top down to the keel, y ≥ 0.
  /// @throws HydroError ValueOutOfRange, naming the section: fewer than 3 points, z rising, wholly
  ///   above or below calm water; BadArgument for fewer than 3 sections or x not falling.
  explicit LoftedHull(const std::vector<Vec3>& offsets);

  /// Port half below calm water, normals out, ready for makePanels: `along` strips from transom to
  /// stem, two of them on the rounded stem, `girth` from calm water to the keel.
  SurfaceMesh wet(int along, int girth) const;
  /// Both sides with transom and deck, closed; the wet faces of `wet` first.
  SurfaceMesh closed(int along, int girth) const;

 private:
  struct Section {
    double x;
    std::vector<Vec3> points;   ///< from the top down
    std::vector<double> chord;  ///< to each point
    std::vector<double> slopeY, slopeZ;
    double atWater = 0.0;  ///< chord length where z = 0
    Vec3 at(double chordLength) const;
  };
  /// u: 0 transom, 1 the table's first section, 2 stem; v: −1 deck, 0 calm water, 1 keel.
  Vec3 point(double u, double v) const;
  std::vector<double> stations(int along) const;
  SurfaceMesh transom(int girth, double from, double to) const;
  std::vector<Section> sections_;  ///< from aft forward
};

}  // namespace cutwater
