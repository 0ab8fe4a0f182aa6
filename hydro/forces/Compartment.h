#pragma once
#include <string>
#include <vector>

#include "hydro/Conventions.h"
#include "hydro/forces/BoxFill.h"
#include "hydro/waves/SeaState.h"

namespace cutwater {

/// A room of a ship that water can be in: a box along the ship's axes.
struct CompartmentBox {
  std::string name;            ///< for messages
  Vec3 centre = Vec3::Zero();  ///< middle of the box in hull axes (Ship::pointMotion) [m]
  Vec3 size = Vec3::Zero();    ///< length, breadth, height [m], > 0
  double permeability = 1.0;   ///< μ: share of the box that water can take, > 0 .. 1
  double volume = 0.0;         ///< of the water in it at the start [m³], 0 .. μ L B H
  double density = 0.0;        ///< of what is in it [kg/m³]; 0: the ship's water
  /// The surface stays level while the ship heels. False: it lies as in the upright ship, as in
  /// many small cells.
  bool freeSurface = true;
};

/// A hole between a compartment and the sea, small against the compartment.
struct Opening {
  Vec3 place = Vec3::Zero();  ///< its middle in hull axes [m]
  double area = 0.0;          ///< A [m²], > 0
  double discharge = 0.6;     ///< C_d, > 0 .. 1; 0.6 of a sharp edge
};

/// Water in a compartment of a ship, from Ship::addCompartment.
///     Compartment& hold = ship.addCompartment(
///         {.name = "hold", .centre = {20, 0, -2}, .size = {15, 12, 6}, .permeability = 0.6});
///     hold.openTo({.place = {20, 6, -3}, .area = 0.5});  // a hole in the side
///     hold.setRate(-0.3);                                // and a pump [m³/s]
///
/// Its surface is level (normal to gravity) in any attitude of the ship, so that the loss of
/// stability by free surfaces comes out by itself. That is right where the ship moves slowly
/// against the water's own sloshing; there is no sloshing here. Air goes in and out freely. Through
/// an opening the water flows as through an orifice:
///     Q = C_d A sign(Δh) √(2 g |Δh|),   Δh = max(ζ, z_o) − max(z_i, z_o)
/// ζ the sea over the opening with its waves, z_o the opening, z_i the water inside: in while the
/// sea is higher, out while the water inside is, none past the height at which the two are equal.
/// An opening above the water on both sides lets nothing through; water does not splash in.
///
/// What comes in was at rest in the water (of a fixed course: came along); what goes out takes its
/// momentum with it. The water counts as a mass at its centre; its turning about that is left out.
/// Changes are felt from the next tick on. Lives as long as its ship.
/// THEORY.md, chapter 9.
class Compartment {
 public:
  /// Internal: use Ship::addCompartment.  @throws HydroError ValueOutOfRange, naming the field.
  Compartment(const CompartmentBox& box, const Vec3& cog, double waterDensity);

  const CompartmentBox& box() const noexcept { return box_; }
  double capacity() const noexcept { return capacity_; }        ///< μ L B H [m³]
  double volume() const noexcept { return volume_; }            ///< of the water [m³]
  double fill() const noexcept { return volume_ / capacity_; }  ///< 0 .. 1
  double mass() const noexcept { return density_ * volume_; }   ///< [kg]
  /// What comes in through all openings and by setRate [m³/s], mean of the last tick.
  double inflow() const noexcept { return inflow_; }
  /// Middle of the water in hull axes [m] at the start of the last tick, and height of its surface
  /// in E [m].
  Vec3 centre() const noexcept { return box_.centre + water_.centre; }
  double level() const noexcept { return level_; }

  /// Sets the volume [m³] at once.  @throws HydroError ValueOutOfRange: outside 0 .. capacity.
  void setVolume(double volume);
  /// From now on water comes in at this rate [m³/s], out if negative, until it is full or empty.
  /// @throws HydroError ValueOutOfRange: not finite.
  void setRate(double rate);
  double rate() const noexcept { return rate_; }
  /// Opens it to the sea, beside what is open already.
  /// @throws HydroError ValueOutOfRange: area, discharge or place; BadArgument: what is in it is
  ///         not the ship's water.
  void openTo(const Opening& opening);
  /// Closes all openings.
  void close() noexcept { openings_.clear(); }
  const std::vector<Opening>& openings() const noexcept { return openings_; }

  // For CarriedLoad.
  struct Place {
    Vec3 position = Vec3::Zero();      ///< G in E [m]
    Mat3 attitude = Mat3::Identity();  ///< R_EB
  };
  /// Where the water lies now.
  void settle(const Place& ship) noexcept;
  /// Its middle, from G in B [m], as settled.
  Vec3 arm() const noexcept { return fromG_ + water_.centre; }
  /// What flows in a tick, into volume().  @param sea  null: calm.
  void flow(const Place& ship, double time, double step, double gravity,
            const SeaState* sea) noexcept;
  /// Mass [kg] that has gone out since it was asked last: it takes its momentum along.
  double takeLost() noexcept;

  /// Exact state.
  std::size_t stateSize() const noexcept { return kOwnState + kOpeningState * openings_.size(); }
  void save(double* state) const noexcept;
  /// @return numbers read, 0: these are none of a compartment.
  std::size_t fits(const double* state, std::size_t size) const noexcept;
  void restore(const double* state);

 private:
  static constexpr std::size_t kOwnState = 10, kOpeningState = 5;
  double levelOf(const Place& ship, double volume) const noexcept;
  double through(const Opening& opening, const Place& ship, double sea, double step,
                 double gravity) const noexcept;
  void add(double volume) noexcept;

  CompartmentBox box_;
  Vec3 fromG_;
  double capacity_, density_, volume_;
  bool seaWater_;
  double rate_ = 0.0, inflow_ = 0.0, lost_ = 0.0;
  double felt_ = 0.0;  // volume that the last tick weighed, or what flowed since left of it
  double level_ = 0.0;
  BoxFill water_;
  std::vector<Opening> openings_;
};

}  // namespace cutwater
