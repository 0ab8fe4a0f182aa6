#include "plugin/Recorder.h"

#include <algorithm>
#include <array>
#include <span>

#include "hydro/Errors.h"
#include "hydro/base/AtomicFile.h"
#include "hydro/base/CsvRow.h"
#include "hydro/forces/Compartment.h"

CUTWATER_PLUGIN_BEGIN

namespace {

constexpr double kDegrees = 180.0 / kPi;

const std::vector<std::string> kMotionColumns{
    "t", "x", "y", "z", "roll_deg", "pitch_deg", "yaw_deg", "u", "v", "w", "p", "q", "r", "wave"};
const std::vector<std::string> kWettedColumns{"wetted_area", "submerged_volume", "buoyancy_x",
                                              "buoyancy_y",  "buoyancy_z",       "immersion"};

}  // namespace

Recorder::Recorder(Seaway& seaway, const Ship& ship, RecorderSettings settings)
    : seaway_(seaway), ship_(ship), settings_(settings), names_(kMotionColumns) {
  if (settings.every < 1) {
    throw HydroError(Fault::ValueOutOfRange,
                     "Recorder: every is less than 1: " + std::to_string(settings.every));
  }
  if (settings.wetted) {
    if (!ship.wetted())
      throw HydroError(Fault::BadArgument,
                       "Recorder: wetted: in mode = \"linear\" the hull is always wet as it is at "
                       "rest; take mode = \"nonlinear\"");
    names_.insert(names_.end(), kWettedColumns.begin(), kWettedColumns.end());
  }
  if (settings.compartments) {
    for (const auto& room : ship.compartments()) {
      rooms_.push_back(room.get());
      names_.push_back(room->box().name + "_water");
    }
  }
  if (settings.forces) matchParts();
  seaway_.addObserver(*this);
}

Recorder::~Recorder() { seaway_.removeObserver(*this); }

// Columns are only ever added, at the end, so that the rows before need but zeros.
void Recorder::addColumns(const std::string& part) {
  const std::size_t before = names_.size(), after = before + 6, count = rows();
  parts_.push_back(part);
  for (int j = 1; j <= 6; ++j) names_.push_back(part + "_F" + std::to_string(j));
  if (count == 0) return;
  std::vector<double> wider(count * after, 0.0);
  for (std::size_t row = 0; row < count; ++row) {
    std::copy_n(numbers_.data() + row * before, before, wider.data() + row * after);
  }
  numbers_ = std::move(wider);
}

void Recorder::matchParts() {
  if (ship_.partsKey() == partsKey_) return;
  partsKey_ = ship_.partsKey();
  places_.clear();
  for (const std::string_view part : ship_.parts()) {
    const auto found = std::find(parts_.begin(), parts_.end(), part);
    places_.push_back(static_cast<std::size_t>(found - parts_.begin()));
    if (found == parts_.end()) addColumns(std::string(part));
  }
}

void Recorder::tickDone(const Seaway&) noexcept {
  if (ticks_++ % static_cast<std::size_t>(settings_.every) != 0) return;
  if (settings_.forces) matchParts();
  const TickRecord& tick = ship_.lastTick();
  const auto put = [this](const auto& values) {
    for (const double value : values) numbers_.push_back(value);
  };
  numbers_.push_back(tick.time);
  put(tick.position);
  put(kDegrees * tick.attitude);
  put(tick.velocity);
  numbers_.push_back(seaway_.sea().elevation(tick.time, tick.position.x(), tick.position.y()));
  if (settings_.wetted) {
    const Wetted wet = ship_.wetted().value_or(Wetted{});
    put(std::array{wet.area, wet.volume, wet.centre.x(), wet.centre.y(), wet.centre.z(),
                   wet.immersion});
  }
  for (const Compartment* room : rooms_) numbers_.push_back(room->volume());
  if (!settings_.forces) return;
  const std::size_t first = numbers_.size();
  numbers_.resize(first + 6 * parts_.size(), 0.0);
  for (std::size_t i = 0; i < places_.size(); ++i) {
    std::copy_n(tick.loads[i].data(), 6, numbers_.data() + first + 6 * places_[i]);
  }
}

std::string Recorder::csv(std::size_t rows) const {
  std::string text;
  for (const std::string& name : names_) text += name + (&name == &names_.back() ? "\n" : ",");
  for (std::size_t row = 0; row < std::min(rows, this->rows()); ++row) {
    addCsvRow(text, std::span(numbers_).subspan(row * names_.size(), names_.size()));
  }
  return text;
}

void Recorder::write(const std::string& path) const { writeWhole(path, csv()); }

CUTWATER_PLUGIN_END
