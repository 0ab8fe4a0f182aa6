#include "plugin/Recorder.h"

#include <array>
#include <cstdio>

#include "hydro/Errors.h"
#include "hydro/base/AtomicFile.h"

CUTWATER_PLUGIN_BEGIN

namespace {

constexpr double kDegrees = 180.0 / kPi;

struct Part {
  const char* name;
  Vec6 ForceParts::*value;
};

constexpr std::array<Part, 7> kParts{{{"gravity", &ForceParts::gravity},
                                      {"restoring", &ForceParts::restoring},
                                      {"froude_krylov", &ForceParts::froudeKrylov},
                                      {"diffraction", &ForceParts::diffraction},
                                      {"radiation", &ForceParts::radiation},
                                      {"added_mass", &ForceParts::addedMass},
                                      {"supplementary", &ForceParts::supplementary}}};

std::vector<std::string> columnNames(bool forces) {
  std::vector<std::string> names{"t", "x", "y", "z", "roll_deg", "pitch_deg", "yaw_deg",
                                 "u", "v", "w", "p", "q",        "r",         "wave"};
  if (!forces) return names;
  for (const Part& part : kParts) {
    for (int j = 1; j <= 6; ++j) names.push_back(std::string(part.name) + "_F" + std::to_string(j));
  }
  return names;
}

}  // namespace

Recorder::Recorder(Seaway& seaway, const Ship& ship, RecorderSettings settings)
    : seaway_(seaway), ship_(ship), settings_(settings), names_(columnNames(settings.forces)) {
  if (settings.every < 1) {
    throw HydroError(Fault::ValueOutOfRange,
                     "Recorder: every is less than 1: " + std::to_string(settings.every));
  }
  seaway_.addObserver(*this);
}

Recorder::~Recorder() { seaway_.removeObserver(*this); }

void Recorder::tickDone(const Seaway&) noexcept {
  if (ticks_++ % static_cast<std::size_t>(settings_.every) != 0) return;
  const TickRecord& tick = ship_.lastTick();
  const auto put = [this](const auto& values) {
    for (const double value : values) numbers_.push_back(value);
  };
  numbers_.push_back(tick.time);
  put(tick.position);
  put(kDegrees * tick.attitude);
  put(tick.velocity);
  numbers_.push_back(seaway_.sea().elevation(tick.time, tick.position.x(), tick.position.y()));
  if (!settings_.forces) return;
  for (const Part& part : kParts) put(tick.forces.*part.value);
}

std::string Recorder::csv() const {
  std::string text;
  for (const std::string& name : names_) text += name + (&name == &names_.back() ? "\n" : ",");
  char number[32];
  for (std::size_t i = 0; i < numbers_.size(); ++i) {
    std::snprintf(number, sizeof number, "%.9g", numbers_[i]);
    text += number;
    text += (i + 1) % names_.size() == 0 ? '\n' : ',';
  }
  return text;
}

void Recorder::write(const std::string& path) const { writeWhole(path, csv()); }

CUTWATER_PLUGIN_END
