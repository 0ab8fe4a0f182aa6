#pragma once
#include <string>
#include <vector>

#include "plugin/Seaway.h"

CUTWATER_PLUGIN_BEGIN

/// The motions of a ship as CSV.
///     Recorder recorder(seaway, ship, {.forces = true});
///     for (int i = 0; i < 3000; ++i) world.stepSimulation(0.02, 1, 0.02);
///     recorder.write("run.csv");

/// What a Recorder writes down.
struct RecorderSettings {
  bool forces = false;        ///< the parts of the load as well
  int every = 1;              ///< record one tick in so many, the first one included
  bool compartments = false;  ///< the water in those that the ship has now
  bool wetted = false;  ///< what of the hull is wet as well (Ship::wetted); nonlinear mode only
};

/// Motions of a ship, and if wished more, at every internal tick, as CSV:
///   t,x,y,z,roll_deg,pitch_deg,yaw_deg,u,v,w,p,q,r,wave
/// with wetted, what of the hull was in the water (Ship::wetted), its centre of buoyancy [m] in E:
///   wetted_area,submerged_volume,buoyancy_x,buoyancy_y,buoyancy_z,immersion
/// with compartments, the water in each at the end of the tick [m³], by its name:
///   NAME_water
/// with forces PART_F1 … PART_F6 for each part of the load, in the order of Ship::parts().
/// A row is the state at t_n and the loads evaluated from it (TickRecord): x, y, z of G [m] in E; u
/// … r [m/s, rad/s] in B; forces [N] in H, moments [N·m] about G in upright axes with the ship's
/// heading. A part that joins while it records gets columns that hold 0 in the rows before; one
/// that leaves keeps its columns, with 0 from then on. Memory grows by 8 bytes a number; reserve()
/// keeps it from being allocated within ticks.
class Recorder final : private TickObserver {
 public:
  /// Seaway and ship must outlive it.
  /// @throws HydroError ValueOutOfRange: every; BadArgument: wetted, of a ship in linear mode.
  Recorder(Seaway& seaway, const Ship& ship, RecorderSettings settings = {});
  ~Recorder() override;
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  void reserve(std::size_t rows) { numbers_.reserve(rows * columns().size()); }
  std::size_t rows() const noexcept { return numbers_.size() / names_.size(); }
  const std::vector<std::string>& columns() const noexcept { return names_; }
  double at(std::size_t row, std::size_t column) const {
    return numbers_[row * names_.size() + column];
  }

  /// Header and the first `rows` rows.
  std::string csv(std::size_t rows) const;
  std::string csv() const { return csv(rows()); }
  /// Written whole, under another name first, then renamed. @throws HydroError FileNotWritable.
  void write(const std::string& path) const;

 private:
  void tickDone(const Seaway& seaway) noexcept override;
  void matchParts();
  void addColumns(const std::string& part);

  Seaway& seaway_;
  const Ship& ship_;
  RecorderSettings settings_;
  std::size_t ticks_ = 0;
  std::vector<std::string> names_;
  std::vector<const Compartment*> rooms_;
  std::vector<std::string> parts_;   // that have columns
  std::vector<std::size_t> places_;  // of the ship's parts as last seen, in parts_
  std::uint64_t partsKey_ = 0;       // of those
  std::vector<double> numbers_;
};

CUTWATER_PLUGIN_END
