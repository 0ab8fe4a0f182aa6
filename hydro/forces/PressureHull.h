#pragma once
#include <string>
#include <vector>

#include "hydro/forces/ImmersedMass.h"
#include "hydro/geometry/wetted/WettedTriangles.h"
#include "hydro/ship/ShipParticulars.h"
#include "hydro/waves/SeaState.h"

namespace cutwater {

/// Whether a ship holds a closed hull with its faces outward, as PressureHull needs it.
bool hasClosedHull(const ShipParticulars& ship);

/// The closed hull that the water's pressure is integrated on, made from a ship's own for a sea:
/// thinned to the triangles that it may have, and then refined as far as they go until its edges
/// are short against its strips and the waves. Made once for all ships of a database in a sea;
/// immutable.
/// THEORY.md, chapter 9.
class PressureHull {
 public:
  static constexpr std::size_t kMostStrips =
      16;  ///< along the hull, equally long; fewer of few triangles

  /// @param most  triangles.
  /// @param addedMass  A∞ about G.
  /// @throws HydroError DatabaseIncomplete: the ship has no hull; as WettedTriangles: it is not
  ///         closed; ValueOutOfRange: `most` is below kFewestTriangles.
  PressureHull(const ShipParticulars& ship, const Mat6& addedMass, const SeaState& sea,
               std::size_t most);
  static constexpr std::size_t kFewestTriangles = 100;

  const WettedTriangles& triangles() const noexcept { return triangles_; }
  const ImmersedMass& mass() const noexcept { return mass_; }

  /// Share of each strip that is in the water: what of it faces down and is wet, seen from above,
  /// against the same at rest. The water that a falling section sets in motion goes with the square
  /// of its wet beam [vonKarman29].
  ///     s_i = min(1, (b_i / (0.9 b_i⁰))²)
  /// 0.9 keeps s at 1 in ordinary motion, where linear theory has it so.
  /// @param shares  one for each strip.
  void shares(const WettedTriangles::State& state, std::span<double> shares) const noexcept;
  /// Middle of each strip, from G [m].
  const std::vector<double>& arms() const noexcept { return arms_; }

  /// Wet hull that faces up, seen from above, in calm water at rest [m²].
  double restDeck() const noexcept { return restDeck_; }
  double volume() const noexcept { return volume_; }  ///< below calm water at rest [m³]
  /// −ρg∫z dV of that volume [J].
  double energy() const noexcept { return energy_; }
  /// Largest distance between the thinned hull and the ship's own [m].
  double distance() const noexcept { return distance_; }
  /// What of the waves' pressure is missed because it is taken linear over a triangle, r.m.s. over
  /// a sea, as a part of the waves' own; 0 in calm water.
  double pressureErrorIn(const SeaState& sea) const noexcept;
  /// In the sea that it was made for.
  double pressureError() const noexcept { return pressureError_; }
  /// One line if the ship's weight and the hull's buoyancy at rest differ by more than a
  /// thousandth, with both numbers; else "".
  const std::string& warning() const noexcept { return warning_; }

 private:
  struct Made;
  PressureHull(const ShipParticulars& ship, const Mat6& addedMass, Made made);
  static Made make(const ShipParticulars& ship, const SeaState& sea, std::size_t most);

  WettedTriangles triangles_;
  std::vector<double> arms_, restBeam_;
  ImmersedMass mass_;
  double restDeck_ = 0.0, volume_ = 0.0, energy_ = 0.0, distance_ = 0.0;
  double edge_ = 0.0, pressureError_ = 0.0;
  std::string warning_;
};

}  // namespace cutwater
