// Trials of a ship with an engine and a rudder, in calm water: manoeuvres DATABASE.h5 [OUT.csv]
// Look for: full rudder makes a circle of a few ship lengths, and the ship slows in it; full astern
// stops it; in the zigzag the heading runs past 10 degrees before the rudder catches it. Nothing is
// tuned: engine and rudder are those that follow from the hull.
#include <algorithm>

#include "demos/scenes/DemoShip.h"

using namespace cutwater;

namespace {

constexpr double kTick = 0.02, kDegree = kPi / 180.0;
constexpr double kApproach = 0.25;  // Froude number

/// A ship on a straight course at its approach speed, its throttle where that speed needs it.
class Trial {
 public:
  Trial(const Coefficients& coefficients, int run, DemoTable& table)
      : bullet_(coefficients.ship.gravity), seaway_(bullet_.world), run_(run), table_(table) {
    length_ = coefficients.ship.length();
    approach_ = kApproach * std::sqrt(coefficients.ship.gravity * length_);
    ShipSettings settings;
    settings.start.speed = approach_;
    settings.model.engine.emplace();  // all from the hull
    settings.model.rudder.emplace();
    settings.model.keepSpeed = SpeedKeeper{.speed = approach_};
    ship_ = &seaway_.addShip(coefficients, settings);
    const double settled = 60.0 * std::sqrt(length_ / coefficients.ship.gravity);
    while (seaway_.time() < settled) tick();
    ship_->stopKeepingSpeed();  // the throttle stays
    start_ = ship_->position();
    started_ = seaway_.time();
  }
  void tick() {
    bullet_.world.stepSimulation(kTick, 1, kTick);
    turned_ += std::remainder(ship_->attitude().z() - heading_, 2.0 * kPi);
    heading_ = ship_->attitude().z();
    if (count_++ % 10 != 0) return;
    const Vec3 at = ship_->position();
    const Vec6 v = ship_->velocity(), &rudder = ship_->load("rudder");
    table_.row({double(run_), time(), at.x(), at.y(), turned() / kDegree, v[Surge], v[Sway],
                v[Yaw] / kDegree, ship_->load("engine")[Surge], rudder[Sway]});
  }
  Ship& ship() { return *ship_; }
  double time() const { return seaway_.time() - started_; }
  double turned() const { return turned_; }  // [rad], to port
  double speed() const { return ship_->velocity()[Surge]; }
  double approach() const { return approach_; }
  /// Way made since the start, in ship lengths: ahead and to port.
  double ahead() const { return (ship_->position().x() - start_.x()) / length_; }
  double across() const { return (ship_->position().y() - start_.y()) / length_; }
  bool faultless() const { return seaway_.faults() == kStepOk; }

 private:
  BulletWorld bullet_;
  Seaway seaway_;
  Ship* ship_ = nullptr;
  int run_, count_ = 0;
  DemoTable& table_;
  Vec3 start_ = Vec3::Zero();
  double length_ = 0.0, approach_ = 0.0, started_ = 0.0, heading_ = 0.0, turned_ = 0.0;
};

void print(const char* what, double value, const char* usual) {
  std::printf("%-52s %12.3g  %s\n", what, value, usual);
}

bool circle(const Coefficients& coefficients, DemoTable& table) {
  Trial trial(coefficients, 0, table);
  trial.ship().setRudder(35.0 * kDegree);
  const auto turnTo = [&](double degrees) {
    while (trial.turned() < degrees * kDegree && trial.time() < 3600.0) trial.tick();
  };
  turnTo(90.0);
  print("turn: advance [L]", trial.ahead(), "IMO: at most 4.5");
  print("turn: transfer [L]", trial.across(), "");
  turnTo(180.0);
  const double tactical = trial.across();
  print("turn: tactical diameter [L]", tactical, "ships 3 to 6, IMO: at most 5");
  turnTo(540.0);
  const double one = trial.across();
  turnTo(720.0);
  print("turn: steady diameter [L]", std::abs(trial.across() - one), "");
  print("turn: speed left", trial.speed() / trial.approach(), "ships about 0.6");
  bool good = isBelow("turn: tactical diameter [L]", tactical, 12.0);
  good &= isBelow("turn: speed left", trial.speed() / trial.approach(), 0.95);
  return good && trial.faultless();
}

bool crashStop(const Coefficients& coefficients, DemoTable& table) {
  Trial trial(coefficients, 1, table);
  trial.ship().setThrottle(-1.0);
  while (trial.speed() > 0.0 && trial.time() < 3600.0) trial.tick();
  print("crash stop: track reach [L]", trial.ahead(), "IMO: at most 15");
  print("crash stop: time [s]", trial.time(), "");
  return isBelow("crash stop: speed left [m/s]", trial.speed(), 0.0) && trial.faultless();
}

// Rudder 10 degrees to the other side whenever the heading is 10 degrees off.
bool zigzag(const Coefficients& coefficients, DemoTable& table) {
  Trial trial(coefficients, 2, table);
  double side = 1.0, over[3] = {0.0, 0.0, 0.0};
  for (double& most : over) {
    trial.ship().setRudder(side * 10.0 * kDegree);
    while (side * trial.turned() < 10.0 * kDegree && trial.time() < 3600.0) trial.tick();
    trial.ship().setRudder(-side * 10.0 * kDegree);
    while (side * trial.ship().velocity()[Yaw] > 0.0 && trial.time() < 3600.0) {
      trial.tick();
      most = std::max(most, side * trial.turned() / kDegree - 10.0);
    }
    side = -side;
  }
  print("zigzag 10/10: first overshoot [deg]", over[0], "IMO: at most 10 to 20");
  print("zigzag 10/10: second overshoot [deg]", over[1], "IMO: at most 25 to 40");
  return isBelow("zigzag 10/10: second overshoot [deg]", over[1], 40.0) &&
         isBelow("zigzag 10/10: ended at [s]", trial.time(), 3599.0) && trial.faultless();
}

bool run(const Coefficients& coefficients, DemoTable& table) {
  const bool turns = circle(coefficients, table), stops = crashStop(coefficients, table);
  return zigzag(coefficients, table) && turns && stops;
}

}  // namespace

int main(int argc, char** argv) {
  return demoMain(argc, argv, "manoeuvres", "run,t,x,y,turned_deg,u,v,r_deg,thrust,rudder_F2", run);
}
