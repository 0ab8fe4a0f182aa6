#pragma once
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "demos/scenes/DemoShip.h"
#include "plugin/Recorder.h"

namespace cutwater {

/// Writes the bodies of a scene as `cutwater report` takes them, beside the demo's OUT.csv if that
/// was named: OUT_BODY.toml and, in the columns of `cutwater simulate`, OUT_BODY.csv.
///     SceneRuns runs(table, seaway, kTick, 4);  // every fourth tick
///     runs.ship("ship", ship, settings);
///     runs.box("load", load, {2, 2, 2});    // a body of Bullet's, shown as a box
///     ... all ticks ...
///     runs.write();
/// What of the water a body does not move is not told. Seaway and bodies must outlive it.
class SceneRuns : private TickObserver {
 public:
  /// @param tick  Bullet's [s]; one row in `every` ticks.
  SceneRuns(const DemoTable& table, Seaway& seaway, double tick, int every);
  ~SceneRuns() override;
  SceneRuns(const SceneRuns&) = delete;
  SceneRuns& operator=(const SceneRuns&) = delete;

  /// With the compartments that it has now, whose names are of letters, digits and _.
  void ship(const std::string& name, const Ship& ship, const ShipSettings& settings);
  /// @param size  length, beam, height [m] along the body's axes, about its centre of mass.
  void box(const std::string& name, const btRigidBody& body, const Vec3& size);
  /// @throws HydroError FileNotWritable.
  void write() const;

 private:
  struct OneShip {
    std::string name;
    ShipSettings settings;
    const Ship* ship;
    std::unique_ptr<Recorder> recorder;
  };
  struct Box {
    std::string name;
    const btRigidBody* body;
    Vec3 size;
    std::string rows;
  };
  void tickDone(const Seaway& seaway) noexcept override;
  void addRow(Box& box, double time);
  std::string sea() const;
  std::string motion(const ShipSettings& settings) const;
  static std::string rooms(const Ship& ship);
  void writeRun(const std::string& name, const std::string& about, const std::string& motion,
                const std::string& csv) const;

  std::optional<SceneFiles> files_;  // absent: nothing is written
  Seaway& seaway_;
  double tick_;
  int every_, ticks_ = 0;
  std::deque<OneShip> ships_;
  std::deque<Box> boxes_;
};

}  // namespace cutwater
