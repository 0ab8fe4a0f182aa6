#include "demos/scenes/SceneRuns.h"

#include <array>
#include <filesystem>
#include <limits>
#include <sstream>

#include "hydro/base/EnumNames.h"
#include "hydro/forces/Compartment.h"

namespace cutwater {

namespace {

namespace fs = std::filesystem;

constexpr double kDegrees = 180.0 / kPi;
constexpr const char* kHeader =
    "t,x,y,z,roll_deg,pitch_deg,yaw_deg,u,v,w,p,q,r,wave\n";  // as Recorder's

// All digits, so that every file of a scene has the same sea.
std::string exact(double number) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(std::numeric_limits<double>::max_digits10);
  text << number;
  return text.str();
}

// Roll, pitch and yaw of R_z R_y R_x [rad].
Vec3 anglesOf(const Mat3& r) {
  return {std::atan2(r(2, 1), r(2, 2)), -std::asin(std::clamp(r(2, 0), -1.0, 1.0)),
          std::atan2(r(1, 0), r(0, 0))};
}

}  // namespace

SceneRuns::SceneRuns(const DemoTable& table, Seaway& seaway, double tick, int every)
    : files_(table.files()), seaway_(seaway), tick_(tick), every_(every) {
  seaway_.addObserver(*this);
}

SceneRuns::~SceneRuns() { seaway_.removeObserver(*this); }

void SceneRuns::ship(const std::string& name, const Ship& ship, const ShipSettings& settings) {
  if (!files_) return;
  const RecorderSettings recorded{.every = every_, .compartments = true};
  ships_.push_back({name, settings, &ship, std::make_unique<Recorder>(seaway_, ship, recorded)});
}

void SceneRuns::box(const std::string& name, const btRigidBody& body, const Vec3& size) {
  if (!files_) return;
  boxes_.push_back({name, &body, size, kHeader});
  addRow(boxes_.back(), seaway_.time());
}

// Ships are recorded as they were when the tick began, at time(); boxes as they are now, a tick
// later.
void SceneRuns::tickDone(const Seaway& seaway) noexcept {
  if (++ticks_ % every_ != 0) return;
  for (Box& box : boxes_) addRow(box, seaway.time() + tick_);
}

void SceneRuns::addRow(Box& box, double time) {
  const btTransform& at = box.body->getWorldTransform();
  const WorldFrame& frame = seaway_.frame();
  const Vec3 place = frame.placeToEarth(at.getOrigin());
  const Mat3 rotation = frame.rotationToEarth(at.getBasis());
  const Vec3 angles = kDegrees * anglesOf(rotation);
  const Vec3 velocity = rotation.transpose() * frame.lengthToEarth(box.body->getLinearVelocity());
  const Vec3 spin = rotation.transpose() * frame.directionToEarth(box.body->getAngularVelocity());
  addCsvRow(box.rows, {time, place.x(), place.y(), place.z(), angles.x(), angles.y(), angles.z(),
                       velocity.x(), velocity.y(), velocity.z(), spin.x(), spin.y(), spin.z(),
                       seaway_.sea().elevation(time, place.x(), place.y())});
}

std::string SceneRuns::sea() const {
  const SeaState& sea = seaway_.sea();
  if (sea.components().empty()) return "[waves]\ntype = \"none\"\n";
  std::string text = "[waves]\ntype = \"components\"\nramp = " + exact(sea.rampTime()) +
                     "\nprofile = \"" + nameOf(kWaveProfileNames, sea.profile()) +
                     "\"\ncomponents = [\n";
  for (const WaveComponent& wave : sea.components()) {
    text += "  { omega = " + exact(wave.omega) + ", amplitude = " + exact(wave.amplitude) +
            ", phase_deg = " + exact(wave.phase * kDegrees) +
            ", direction_deg = " + exact(wave.heading * kDegrees) + " },\n";
  }
  return text + "]\n";
}

std::string SceneRuns::motion(const ShipSettings& settings) const {
  const auto waves = seaway_.sea().components();
  std::string text = "[motion]\nspeed = " + exact(settings.start.speed) + "\n";
  if (!waves.empty()) {  // relative to the bow
    const double beta = (waves.front().heading + settings.start.heading) * kDegrees;
    text += "heading_deg = " + exact(std::remainder(beta, 360.0)) + "\n";
  }
  text +=
      std::string("mean = \"") + (settings.model.mean == Mean::Free ? "free" : "fixed") + "\"\n";
  if (settings.model.mode)
    text += std::string("mode = \"") + nameOf(kHullPressureNames, *settings.model.mode) + "\"\n";
  return text;
}

std::string SceneRuns::rooms(const Ship& ship) {
  const auto list = [](const Vec3& v) {
    return "[" + exact(v.x()) + ", " + exact(v.y()) + ", " + exact(v.z()) + "]";
  };
  std::string text;
  for (const auto& room : ship.compartments()) {
    const CompartmentBox& box = room->box();
    text += "[[compartment]]\nname = \"" + box.name + "\"\ncentre = " + list(box.centre) +
            "\nsize = " + list(box.size) + "\npermeability = " + exact(box.permeability) + "\n";
  }
  return text;
}

void SceneRuns::writeRun(const std::string& name, const std::string& about,
                         const std::string& motion, const std::string& csv) const {
  const std::string stem = files_->stem + "_" + name;
  const std::string time =
      "[bullet]\ndt = " + exact(tick_) + "\nduration = " + exact(seaway_.time()) + "\n";
  writeWhole(stem + ".toml",
             "# One body of a scene, for `cutwater report`: " + fs::path(stem).filename().string() +
                 ".csv is how it moved.\n" + about + time + sea() + motion);
  writeWhole(stem + ".csv", csv);
}

void SceneRuns::write() const {
  if (!files_) return;
  const fs::path folder = fs::absolute(files_->stem).parent_path();
  const std::string database = fs::proximate(fs::absolute(files_->database), folder).string();
  for (const OneShip& one : ships_)
    writeRun(one.name, "database = \"" + database + "\"\n", motion(one.settings) + rooms(*one.ship),
             one.recorder->csv());
  for (const Box& box : boxes_)
    writeRun(box.name,
             "[body]\nsize = [" + exact(box.size.x()) + ", " + exact(box.size.y()) + ", " +
                 exact(box.size.z()) + "]\n",
             "", box.rows);
}

}  // namespace cutwater
