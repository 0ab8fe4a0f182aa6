#include "demos/report_page/RunColumns.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>

#include "demos/cutwater/output/Messages.h"
#include "demos/report_page/CsvReader.h"
#include "demos/report_page/Encoding.h"
#include "hydro/Errors.h"

namespace cutwater::page {

namespace {

struct Column {
  std::string_view name, unit;
};
constexpr std::array<Column, 14> kMotions{{{"t", "s"},
                                           {"x", "m"},
                                           {"y", "m"},
                                           {"z", "m"},
                                           {"roll_deg", "deg"},
                                           {"pitch_deg", "deg"},
                                           {"yaw_deg", "deg"},
                                           {"u", "m/s"},
                                           {"v", "m/s"},
                                           {"w", "m/s"},
                                           {"p", "rad/s"},
                                           {"q", "rad/s"},
                                           {"r", "rad/s"},
                                           {"wave", "m"}}};
constexpr std::array<Column, 6> kWetted{{{"wetted_area", "m^2"},
                                         {"submerged_volume", "m^3"},
                                         {"buoyancy_x", "m"},
                                         {"buoyancy_y", "m"},
                                         {"buoyancy_z", "m"},
                                         {"immersion", ""}}};
constexpr std::array<Column, 7> kSweep{{{"omega", "rad/s"},
                                        {"omega_e", "rad/s"},
                                        {"j", ""},
                                        {"time_amplitude", ""},
                                        {"time_phase_deg", "deg"},
                                        {"freq_amplitude", ""},
                                        {"freq_phase_deg", "deg"}}};

constexpr std::string_view kWaterIn = "_water";  // ends the column of a compartment

[[noreturn]] void refuse(const std::string& csv, const std::string& column,
                         const std::string& wanted) {
  throw HydroError(Fault::FileMalformed, fmt::format("{}: line 1: column {}: {}", csv,
                                                     command::shortened(column), wanted));
}

// "froude_krylov" of "froude_krylov_F1" to F6; "" if it is none of them.
std::string partOf(const std::string& column) {
  const std::size_t size = column.size();
  if (size < 4 || column[size - 3] != '_' || column[size - 2] != 'F') return "";
  return column[size - 1] >= '1' && column[size - 1] <= '6' ? column.substr(0, size - 3) : "";
}

std::string unitOf(const std::string& column) {
  for (const Column& known : kMotions)
    if (known.name == column) return std::string(known.unit);
  for (const Column& known : kWetted)
    if (known.name == column) return std::string(known.unit);
  if (column.ends_with(kWaterIn)) return "m^3";
  return column.back() <= '3' ? "N" : "N m";
}

// Motions, then what of the hull is wet, then the water in compartments, then parts of the load,
// six columns each.
std::vector<std::string> partsOf(const std::string& csv, const std::vector<std::string>& columns) {
  std::size_t at = kMotions.size();
  if (at < columns.size() && columns[at] == kWetted[0].name) {
    for (const Column& column : kWetted) {
      if (at >= columns.size() || columns[at] != column.name)
        refuse(csv, at < columns.size() ? columns[at] : "(none)",
               fmt::format("must be {}, as of `simulate --wetted`", column.name));
      ++at;
    }
  }
  while (at < columns.size() && columns[at].ends_with(kWaterIn)) ++at;
  std::vector<std::string> parts;
  for (; at < columns.size(); at += 6) {
    parts.push_back(partOf(columns[at]));
    for (std::size_t j = 0; j < 6; ++j) {
      const std::string wanted = fmt::format("{}_F{}", parts.back(), j + 1);
      const bool here = at + j < columns.size();
      if (!parts.back().empty() && here && columns[at + j] == wanted) continue;
      refuse(csv, here ? columns[at + j] : "(none)",
             parts.back().empty() ? "is none of `simulate`" : "must be " + wanted);
    }
  }
  return parts;
}

// What a first reading finds of a column.
struct Extent {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  bool finite = true;
  void take(double value) {
    finite = finite && std::isfinite(value);
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

std::vector<Extent> extentsOf(const std::string& csv) {
  CsvReader reader(csv);
  std::vector<double> row(reader.columns().size());
  std::vector<Extent> extents(row.size());
  double before = -std::numeric_limits<double>::infinity();
  while (reader.next(row)) {
    if (!(row[0] > before && std::isfinite(row[0])))
      reader.refuse(
          fmt::format("t = {:.9g}: times must rise, the line before has {:.9g}", row[0], before));
    before = row[0];
    for (std::size_t i = 0; i < row.size(); ++i) extents[i].take(row[i]);
  }
  if (before == -std::numeric_limits<double>::infinity()) reader.refuse("no rows after it");
  return extents;
}

// Places within 0.1 mm, however far the ship goes; times to the CSV's nine digits.
double scaleOf(const std::string& column, const Extent& extent) {
  if (column == "t") return seriesScale(extent.high, extent.high, 0.0);
  const bool place = column == "x" || column == "y" || column == "z";
  return seriesScale(extent.low, extent.high, place ? 1e-4 : 0.0);
}

}  // namespace

RunKind kindOf(const std::string& csv) {
  const std::vector<std::string> columns = CsvReader(csv).columns();
  const auto fits = [&](const auto& wanted) {
    return std::equal(
        wanted.begin(), wanted.end(), columns.begin(),
        columns.begin() + static_cast<std::ptrdiff_t>(std::min(columns.size(), wanted.size())),
        [](const Column& a, const std::string& b) { return a.name == b; });
  };
  if (columns.size() == kSweep.size() && fits(kSweep)) return RunKind::Sweep;
  if (!fits(kMotions)) {
    const std::string is = columns.front() == "omega" ? "of `sweep`" : "of `simulate`";
    for (std::size_t i = 0;; ++i) {
      const Column wanted = is == "of `sweep`" ? kSweep[std::min(i, kSweep.size() - 1)]
                                               : kMotions[std::min(i, kMotions.size() - 1)];
      if (i < columns.size() && columns[i] == wanted.name) continue;
      refuse(csv, i < columns.size() ? columns[i] : "(none)",
             fmt::format("must be {}, as {}", wanted.name, is));
    }
  }
  partsOf(csv, columns);
  return RunKind::Simulate;
}

void columnsJson(Json& json, const std::string& csv) {
  const std::vector<Extent> extents = extentsOf(csv);
  CsvReader reader(csv);
  const std::vector<std::string>& names = reader.columns();
  std::vector<SeriesEncoder> series;
  for (std::size_t i = 0; i < names.size(); ++i)
    series.emplace_back(extents[i].finite ? scaleOf(names[i], extents[i]) : 1.0);
  std::vector<std::vector<double>> unfinished(names.size());
  std::vector<double> row(names.size());
  while (reader.next(row)) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (extents[i].finite) {
        series[i].add(row[i]);
      } else {
        unfinished[i].push_back(row[i]);
      }
    }
  }
  json.key("columns").beginArray();
  for (std::size_t i = 0; i < names.size(); ++i) {
    json.beginObject().field("name", names[i]).field("unit", unitOf(names[i])).key("series");
    if (extents[i].finite) {
      series[i].write(json);
    } else {
      json.beginObject().field("n", unfinished[i].size()).key("values");
      blob64(json, unfinished[i]);
      json.end();
    }
    json.end();
  }
  json.end().key("parts").beginArray();
  for (const std::string& part : partsOf(csv, names)) json.value(part);
  json.end();
}

void sweepJson(Json& json, const std::string& csv) {
  constexpr std::array<const char*, 7> kNames{
      "omega", "omegaE", "mode", "timeAmplitude", "timePhaseDeg", "freqAmplitude", "freqPhaseDeg"};
  CsvReader reader(csv);
  std::array<std::vector<double>, 7> columns;
  std::array<double, 7> row{};
  while (reader.next(row)) {
    for (std::size_t i = 0; i < row.size(); ++i) columns[i].push_back(row[i]);
  }
  if (columns[0].empty()) reader.refuse("no rows after it");
  json.beginObject();
  for (std::size_t i = 0; i < columns.size(); ++i) json.key(kNames[i]).list(columns[i]);
  json.end();
}

}  // namespace cutwater::page
