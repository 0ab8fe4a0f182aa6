#pragma once
#include <memory>

#include "hydro/forces/ForceGenerator.h"
#include "hydro/forces/Helm.h"
#include "hydro/ship/ShipParticulars.h"

namespace cutwater {

/// Thrust along the slow heading, as ordered (Helm::throttle).
///     τ dx/dt = order − x,   T = x T₀ g(u/u₀) ahead,   T = x s T₀ g(−u/u₀) astern,
///     g(a) = 1 − a held to 0..1,   u the slow speed ahead
/// A propeller's thrust falls about linearly with its speed of advance; against the motion it is
/// taken as at rest. What the ship's particulars leave open follows from the hull:
///     T₀ = 2R(u_h): twice the calm-water resistance at hull speed u_h = 0.4 √(gL), the classic
///          1.34 √(feet) knots
///     u₀ = 2u_h: full thrust ends at u_h, where half of it is left, as of a usual propeller at its
///          design speed
///     s  = 0.5: the rules of class ask for 70 % of the revolutions astern [IACS UR M25], and
///          thrust goes with their square
///     τ  = 2 √(L/g); propeller diameter 0.7 of the draught; place: the stern at the height of G,
///          so that the ship does not trim
/// The waves that a ship makes by its speed are not in R: a real one needs more thrust for u_h.
/// THEORY.md, chapter 12.
class Engine final : public ForceGenerator {
 public:
  /// u_h [m/s].
  static double hullSpeed(const ShipParticulars& ship);

  /// @param resistance R at hullSpeed(ship) [N] ≥ 0; not read if the engine says its thrust.
  /// @throws HydroError ValueOutOfRange.
  Engine(const ShipParticulars& ship, const EngineParticulars& engine, double resistance,
         std::shared_ptr<Helm> helm);
  std::string_view name() const noexcept override { return "engine"; }
  Wrench evaluate(const TickInput& now) noexcept override;
  /// T [N] at a share x of full thrust, −1..1, and a speed ahead [m/s].
  double thrust(double share, double speed) const noexcept;
  double share() const noexcept { return share_; }  ///< x

  /// Stops; the order stays.
  void reset() noexcept override;
  std::size_t stateSize() const noexcept override { return 3; }
  void save(std::span<double> state) const noexcept override;
  void restore(std::span<const double> state) noexcept override;

 private:
  std::shared_ptr<Helm> helm_;
  double timeConstant_, jetOfThrust_;
  Vec3 arm_;  // from G
  double share_ = 0.0;
  bool running_ = false;
};

}  // namespace cutwater
