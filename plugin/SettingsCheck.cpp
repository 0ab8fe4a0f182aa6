#include "plugin/SettingsCheck.h"

#include <cmath>
#include <limits>
#include <sstream>

#include "hydro/Errors.h"
#include "hydro/base/Radians.h"

CUTWATER_PLUGIN_BEGIN

namespace {

constexpr double kFarthest = 1e7;       // [m]
constexpr double kFastest = 100.0;      // mean speed [m/s]
constexpr double kFastestOf = 1e3;      // a velocity beside it [m/s, rad/s]
constexpr double kLongestOffset = 1e5;  // [m]

class Check {
 public:
  Check(const char* function, std::string group) : function_(function), group_(std::move(group)) {}
  void within(const std::string& field, double value, double low, double high) const {
    if (value >= low && value <= high) return;
    std::ostringstream line;
    line << function_ << ": " << group_ << field << " = " << value << ": must be in " << low << ".."
         << high;
    throw HydroError(Fault::ValueOutOfRange, line.str());
  }
  void within(const std::string& field, double value, double most) const {
    within(field, value, -most, most);
  }
  void angle(const std::string& field, double value, double largest) const {
    if (std::abs(value) <= largest) return;
    requireRadians(std::string(function_) + ": " + group_ + field, value, largest);
  }

 private:
  const char* function_;
  std::string group_;
};

void checkModel(const ShipModel& model, const char* function) {
  const Check check(function, "model.");
  check.within("mean", static_cast<int>(model.mean), 0, static_cast<int>(Mean::Free));
  check.within("memory", static_cast<int>(model.memory), 0,
               static_cast<int>(MemoryModel::Convolution));
  if (model.engine) requireUsable(*model.engine, function);
  if (model.rudder) requireUsable(*model.rudder, function);
  if (model.mean == Mean::Fixed && (model.engine || model.rudder)) {
    throw HydroError(Fault::BadArgument,
                     std::string(function) + ": model." + (model.engine ? "engine" : "rudder") +
                         ": a ship on a fixed course has none; leave it out, or give model.mean = "
                         "Mean::Free");
  }
  if (model.keepSpeed) checkOrder(*model.keepSpeed, function);
  if (model.keepCourse) checkOrder(*model.keepCourse, function);
}

// The same planet, given to three digits or four: wave numbers are g's.
constexpr double kSameGravity = 1e-3;

}  // namespace

void checkStart(const ShipStart& start, const char* function) {
  const Check check(function, "start.");
  check.within("x", start.x, kFarthest);
  check.within("y", start.y, kFarthest);
  check.angle("heading", start.heading, kTurn);
  check.within("speed", start.speed, kFastest);
  for (int i = 0; i < 6; ++i) {
    const std::string index = "[" + std::to_string(i) + "]";
    if (i < 3) {
      check.within("offset" + index, start.offset[i], kLongestOffset);
    } else {
      check.angle("offset" + index, start.offset[i], kHalfTurn);
    }
    check.within("velocity" + index, start.velocity[i], kFastestOf);
  }
}

void checkOrder(const SpeedKeeper& order, const char* function) {
  const Check check(function, "SpeedKeeper::");
  check.within("speed", order.speed, kFastest);
  check.within("maxThrust", order.maxThrust, 0.0, std::numeric_limits<float>::max());
  check.within("rate", order.rate, 1e-6, 10.0);
}

void checkOrder(const CourseKeeper& order, const char* function) {
  const Check check(function, "CourseKeeper::");
  check.angle("heading", order.heading, kTurn);
  check.within("maxMoment", order.maxMoment, 0.0, std::numeric_limits<float>::max());
  check.within("rate", order.rate, 1e-6, 10.0);
}

void checkSettings(const ShipSettings& settings, const char* function) {
  checkStart(settings.start, function);
  checkModel(settings.model, function);
  if (settings.collision.deck && settings.collision.shape != nullptr) {
    throw HydroError(Fault::BadArgument,
                     std::string(function) +
                         ": collision.deck is for the shape made of the ship's own mesh; with "
                         "collision.shape leave it out");
  }
}

void checkSea(const SeaState& sea, double right, const char* function) {
  if (sea.components().empty() || std::abs(sea.gravity() - right) <= kSameGravity * right) return;
  std::ostringstream line;
  line << function << ": the sea's gravity " << sea.gravity()
       << " m/s2 is not that of the database, " << right << " m/s2: give that to SeaState";
  throw HydroError(Fault::ValueOutOfRange, line.str());
}

CUTWATER_PLUGIN_END
