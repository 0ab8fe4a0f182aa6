#pragma once
#include <memory>
#include <vector>

#include "hydro/forces/floats/FloatBody.h"
#include "hydro/forces/floats/FloatWater.h"
#include "hydro/waves/WaterPressure.h"
#include "plugin/Float.h"

CUTWATER_PLUGIN_BEGIN

/// What floats ask of a sea.
struct FloatSea {
  /// Allocates all that a tick needs of it.
  explicit FloatSea(std::shared_ptr<const SeaState> sea);
  std::shared_ptr<const SeaState> sea;
  WaterPressure pressure;
  FloatWater water;
  double heights = 0.0;  ///< of all its waves [m]
};

/// All floats of a Seaway. The water is asked once a tick for all of them: at all corners of their
/// surfaces, then at the middles of what is wet.
class FloatFleet {
 public:
  FloatFleet(btDiscreteDynamicsWorld& world, const WorldFrame& frame,
             std::shared_ptr<const SeaState> sea);
  ~FloatFleet();

  /// @throws HydroError as Seaway::addFloat.
  Float& add(btRigidBody& body, const FloatSettings& settings);
  void remove(Float& one);
  Float* of(const btCollisionObject& body) const noexcept;
  const std::vector<std::unique_ptr<Float>>& floats() const noexcept { return floats_; }
  /// @throws HydroError ValueOutOfRange: there are floats, and its gravity is not the world's.
  void checkSea(const SeaState& sea) const;
  /// Another sea from the next tick on; `sea` is left with the one that was. Allocates nothing.
  void enterSea(std::unique_ptr<FloatSea>& sea) noexcept;

  /// Calm water stands at this height of the world [units] and rises at this rate [m/s].
  void setWater(double level, double rate) noexcept {
    frame_.seaLevel = level;
    rate_ = rate;
  }

  /// Floats that sleep wake up: the water has gone elsewhere.
  void wake() noexcept;

  /// StepFault bits of all.
  std::uint32_t beginTick(double time, btScalar step) noexcept;
  std::uint32_t endTick() noexcept;
  /// Its end takes all of ours out of the world, which is there. Otherwise it touches none of it.
  void worldLives() noexcept { worldLives_ = true; }

 private:
  void makeRoom();
  bool moves() const noexcept { return !sea_->sea->components().empty() || rate_ != 0.0; }
  std::uint32_t lookAtAll() noexcept;
  void pressAll(double time) noexcept;
  void sweep() noexcept;

  btDiscreteDynamicsWorld& world_;
  WorldFrame frame_;
  std::unique_ptr<FloatSea> sea_;
  std::vector<std::unique_ptr<Float>> floats_;
  std::vector<Float*> wet_, active_;  // of this tick
  std::vector<double> x_, y_, z_, elevation_, head_, surfaceHead_;
  std::vector<FloatWater::Place> places_;
  std::vector<FloatWater::Motion> motions_;
  double longestEdge_ = 0.0;  // [m]
  double rate_ = 0.0;         // at which calm water rises [m/s]
  bool worldLives_ = false;
  std::vector<btTypedConstraint*> retired_;  // of floats that are gone, in a world's list
};

CUTWATER_PLUGIN_END
