#pragma once
#include <vector>

#include "hydro/forces/ForceGenerator.h"
#include "hydro/ship/ShipParticulars.h"

namespace cutwater {

/// What stops a hull in calm water: cross-flow drag of the hull that drifts and turns, and friction
/// along it. Both answer the slow motion through the water alone: ahead u, leeway v, rate of turn r
/// of TickInput.
///     Y = −½ρ C_D ∫T(x) (v + xr)|v + xr| dx,   N = −½ρ C_D ∫T(x) x (v + xr)|v + xr| dx
///     X = −½ρ S (1 + k) C_F u|u|,   C_F = 0.075/(log₁₀ Re − 2)²,   Re = |u|L/ν     [ITTC 1957]
/// x from G, T(x) the depth of the keel, S the wetted area, all of the hull at rest; without a wet
/// surface those of a box of the ship's length, beam and volume. C_D and k are inputs
/// (ShipParticulars::drag). Below Re = 10⁵ C_F is that of 10⁵, so that X goes to 0 as u².
/// A hull whose deck is under water, by A seen from above (nonlinear mode), is slowed in heave too:
///     Z = −½ρ C_D A w|w|
/// The force acts at the height of G: it neither heels nor trims. It takes energy and gives none; a
/// tick can bring a motion to rest and not turn it round. The waves that a ship makes by its speed
/// are not in it. ν is that of sea water of 15 °C.
///
/// This is no manoeuvring model. A part that is one says so by ForceGenerator::replaces(), with
/// "resistance" and "hull_lift".
/// THEORY.md, chapter 11.
class Resistance final : public ForceGenerator {
 public:
  static constexpr double kViscosity = 1.19e-6;  ///< ν [m²/s]
  static constexpr double kLowestReynolds = 1e5;

  /// O(points on the hull's length × faces).
  explicit Resistance(const ShipParticulars& ship);
  std::string_view name() const noexcept override { return "resistance"; }
  Wrench evaluate(const TickInput& now) noexcept override;

  /// Force [N] along the hull at a speed ahead [m/s], negative astern; never along the motion.
  double alongHull(double speed) const noexcept;
  /// ∫T dx [m²]: the area that the ship shows to a flow from abeam.
  double lateralArea() const noexcept { return lateralArea_; }
  double wettedArea() const noexcept { return wettedArea_; }  ///< S [m²]
  /// C_F. @param reynolds Re ≥ 0.
  static double friction(double reynolds) noexcept;

 private:
  double sinking(const TickInput& now) const noexcept;

  /// A piece of the length: from G [m], and its share of ∫T dx [m²].
  struct Strip {
    double x, area;
  };

  std::vector<Strip> strips_;
  double halfDensity_, crossFlow_, form_, length_, mass_;
  Vec3 inertia_;  // about the axes of the hull
  double wettedArea_ = 0.0, lateralArea_ = 0.0;
};

}  // namespace cutwater
