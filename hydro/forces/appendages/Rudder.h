#pragma once
#include <memory>

#include "hydro/forces/ForceGenerator.h"
#include "hydro/forces/Helm.h"
#include "hydro/ship/ShipParticulars.h"

namespace cutwater {

/// Lift and drag of a rudder blade of area A in the flow at its place, which the slow motion makes:
///     v = leeway + x r,   u_R = u + √(u² + s · 2T/(ρA_p)) − |u|,   x from G
/// with s (slipstream) times what the propeller adds while it pushes ahead, by momentum theory; it
/// gives the rudder its bite at rest, too. α = δ + the flow's own incidence, that behind the hull
/// times γ (flow straightening), and with κ as below
///     C_L = κ sin α cos α,   C_D = C_D0 + w (C_Lα sin α cos α)²/(πΛ) + (1 − w) C_N sin²α,
///     κ = w C_Lα + (1 − w) C_N,   C_Lα = 6.13 Λ/(Λ + 2.25)                     [FujiiTsuda61]
/// w falls from 1 to 0 over the ten degrees beyond the stall; then the blade is a plate across the
/// flow. All of it holds for a flow from any side, ahead, abeam, astern, and goes smoothly through
/// rest. Lift is at right angles to the blade's own way through the water (and the jet), so without
/// thrust the rudder takes energy whatever its angle.
///
/// Positive angles turn the bow to port under way. What the particulars leave open:
///     A      2.5 % of length times draught, as of destroyers; merchant ships have 1.5 to 2 %,
///            tugs and motor boats more
///     place  the stern, at the height of G: heel by the rudder belongs with the hull's own, which
///            no part has yet
///     rate   65° in 28 s as SOLAS asks of ships [II-1/29]; below 100 m that times √(100 m/L)
/// Λ = 1.5, the stall at 35°, s = 0.4 and γ = 0.5 are middling values of measured ships
/// [YasukawaYoshimura15]. The hull amidships has its own lift (HullLift), of which the
/// rudder's is a part: some of it is counted twice.
/// THEORY.md, chapter 12.
class Rudder final : public ForceGenerator {
 public:
  /// @throws HydroError ValueOutOfRange.
  Rudder(const ShipParticulars& ship, const RudderParticulars& rudder, std::shared_ptr<Helm> helm);
  std::string_view name() const noexcept override { return "rudder"; }
  Wrench evaluate(const TickInput& now) noexcept override;
  double angle() const noexcept { return angle_; }  ///< δ [rad]
  double area() const noexcept { return area_; }    ///< A [m²]
  double rate() const noexcept { return rate_; }    ///< [rad/s]

  /// Amidships; the order stays.
  void reset() noexcept override;
  std::size_t stateSize() const noexcept override { return 4; }
  void save(std::span<double> state) const noexcept override;
  void restore(std::span<const double> state) noexcept override;

 private:
  struct Lift {
    double lift, drag;  // C_L, C_D
  };
  Lift coefficients(double incidence) const noexcept;
  void turn(double seconds) noexcept;

  std::shared_ptr<Helm> helm_;
  RudderParticulars given_;
  double area_, rate_, slope_, pressure_;  // C_Lα, ½ρA
  double lightness_;                       // 1/m + x²/I
  Vec3 arm_;                               // from G
  double angle_ = 0.0;
  bool running_ = false;
};

}  // namespace cutwater
