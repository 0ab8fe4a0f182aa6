#include "demos/report_page/Tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

#include "demos/cutwater/input/WaveGrid.h"
#include "demos/cutwater/output/Messages.h"
#include "demos/report_page/Encoding.h"
#include "hydro/Errors.h"
#include "hydro/base/ParallelFor.h"
#include "hydro/base/Radians.h"
#include "hydro/excitation/WaveExcitation.h"
#include "hydro/memory/RetardationMatrix.h"
#include "hydro/response/FrequencyResponse.h"

namespace cutwater::page {

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

// All round, or to one side of a ship whose other side is the same; without adjoint vectors those
// of the database's table.
std::vector<double> headingsDeg(const Coefficients& c) {
  std::vector<double> headings;
  if (c.adjoint.empty()) {
    for (const double heading : c.headings) headings.push_back(heading / kDegree);
    std::sort(headings.begin(), headings.end());
    return headings;
  }
  for (int heading = 0; heading <= (c.ship.symmetric ? 180 : 345); heading += 15)
    headings.push_back(heading);
  return headings;
}

bool couples(const OverFrequency<Mat6>& table, int j, int k) {
  const auto isHere = [&](const Mat6& m) { return m(j, k) != 0.0; };
  return std::any_of(table.begin(), table.end(), isHere) || isHere(table.atInfinity);
}

// Calls what(name, j, k) for each pair that is not zero, "35" for j = 2, k = 4.
void eachPair(const std::function<bool(int, int)>& isHere,
              const std::function<void(const std::string&, int, int)>& what) {
  for (int j = 0; j < 6; ++j) {
    for (int k = 0; k < 6; ++k)
      if (isHere(j, k)) what(fmt::format("{}{}", j + 1, k + 1), j, k);
  }
}

void pairsJson(Json& json, const char* name, const OverFrequency<Mat6>& table) {
  json.key(name).beginObject();
  eachPair([&](int j, int k) { return couples(table, j, k); },
           [&](const std::string& pair, int j, int k) {
             json.key(pair).beginArray();
             for (const Mat6& m : table) json.value(m(j, k));
             json.end();
           });
  json.end();
}

void limitJson(Json& json, const char* name, const Mat6& limit) {
  json.key(name).beginObject();
  eachPair([&](int j, int k) { return limit(j, k) != 0.0; },
           [&](const std::string& pair, int j, int k) { json.field(pair, limit(j, k)); });
  json.end();
}

// What `at` gives at each heading and wave, `nothing` where the database has no answer; empty where
// it has none at all. The first reason is told, with `what`.
template <class Answer, class At>
std::vector<Answer> overWaves(const Coefficients& c, const std::string& file,
                              const std::string& what, const Answer& nothing, const At& at) {
  const std::vector<double> headings = headingsDeg(c), omegas = waveGrid(c);
  std::vector<Answer> answers(headings.size() * omegas.size(), nothing);
  std::vector<std::string> reasons(answers.size());
  parallelFor(answers.size(), 0, [&](std::size_t i) {
    try {
      answers[i] = at(omegas[i % omegas.size()], headings[i / omegas.size()] * kDegree);
    } catch (const HydroError& error) {
      reasons[i] = error.what();
    }
  });
  const auto isSaid = [](const std::string& reason) { return !reason.empty(); };
  const auto first = std::find_if(reasons.begin(), reasons.end(), isSaid);
  if (first == reasons.end()) return answers;
  const bool all = std::all_of(reasons.begin(), reasons.end(), isSaid);
  command::warn(
      fmt::format("{}: {} {} on the page: {}", file, all ? "no" : "not all of the", what, *first));
  if (all) answers.clear();
  return answers;
}

void axesJson(Json& json, const Coefficients& c) {
  json.key("headingsDeg").list(headingsDeg(c)).key("omega").list(waveGrid(c));
}

FrequencyResponse responseOf(const Coefficients& c, bool free) {
  return free ? FrequencyResponse(c, FrequencyResponse::Free{})
              : FrequencyResponse(c, std::array<bool, 6>{}, c.forwardSpeed);
}

void raoJson(Json& json, const Coefficients& c, const std::string& file, double speed, bool free) {
  const std::string what = fmt::format("motions of the ship {} at {:.4g} m/s",
                                       free ? "free to go" : "on a fixed course", speed);
  std::optional<FrequencyResponse> response;
  try {
    response.emplace(responseOf(c, free));
  } catch (const HydroError& error) {
    command::warn(file + ": no " + what + " on the page: " + error.what());
    return;
  }
  const CVec6 nothing = CVec6::Constant(kNan);
  const auto answers = overWaves(c, file, what, nothing, [&](double omega, double heading) {
    return response->atOrNan(omega, heading, speed);
  });
  if (answers.empty()) return;
  std::vector<double> numbers;
  for (const CVec6& answer : answers) append(numbers, answer);
  json.beginObject().field("speed", speed).field("free", free);
  axesJson(json, c);
  json.key("values");
  blob32(json, numbers);
  json.end();
}

}  // namespace

std::vector<double> waveGrid(const Coefficients& c) {
  const std::vector<double>& own = command::defaultWaveOmega(c);
  if (own.size() < 2) return own;
  const std::size_t parts = (kFewestWaves + own.size() - 2) / (own.size() - 1);
  std::vector<double> grid;
  for (std::size_t i = 0; i + 1 < own.size(); ++i) {
    for (std::size_t part = 0; part < parts; ++part)
      grid.push_back(own[i] + (own[i + 1] - own[i]) * static_cast<double>(part) /
                                  static_cast<double>(parts));
  }
  grid.push_back(own.back());
  return grid;
}

void append(std::vector<double>& numbers, const CVec6& values) {
  for (const Complex& value : values) {
    numbers.push_back(value.real());
    numbers.push_back(value.imag());
  }
}

void coefficientsJson(Json& json, const Coefficients& c) {
  json.beginObject().key("omega").list(c.omega);
  pairsJson(json, "A", c.addedMass);
  pairsJson(json, "B", c.damping);
  limitJson(json, "Ainf", c.addedMass.atInfinity);
  limitJson(json, "A0", c.addedMass.atZero);
  json.field("resolved", c.resolvedOmega).key("masked").beginArray();
  for (std::size_t i = 0; i < c.masked.size(); ++i)
    if (c.masked[i] != 0) json.value(c.omega[i]);
  json.end().end();
}

void excitationJson(Json& json, const Coefficients& c, const std::string& file) {
  const WaveExcitation waves(c);
  const CVec6 nan = CVec6::Constant(kNan);
  const auto forces =
      overWaves(c, file, "wave forces", WaveExcitation::Force{nan, nan},
                [&](double omega, double heading) { return waves.at(omega, heading); });
  if (forces.empty()) {
    json.null();
    return;
  }
  std::vector<double> incident, diffracted;
  for (const WaveExcitation::Force& force : forces) {
    append(incident, force.froudeKrylov);
    append(diffracted, force.diffraction);
  }
  json.beginObject();
  axesJson(json, c);
  json.key("froudeKrylov");
  blob32(json, incident);
  json.key("diffraction");
  blob32(json, diffracted);
  json.end();
}

void retardationJson(Json& json, const Coefficients& c, const std::string& file) {
  constexpr int kSteps = 400;
  std::optional<RetardationMatrix> memory;
  try {
    memory.emplace(c);
  } catch (const HydroError& error) {
    command::warn(file + ": no retardation functions on the page: " + error.what());
  }
  if (!memory || !(memory->duration() > 0.0)) {
    json.null();
    return;
  }
  std::vector<double> tau;
  std::vector<Mat6> kernels;
  for (int i = 0; i <= kSteps; ++i) {
    tau.push_back(memory->duration() * i / kSteps);
    kernels.push_back(memory->at(tau.back()));
  }
  json.beginObject().key("tau").list(tau).key("K").beginObject();
  eachPair([&](int j, int k) { return !memory->isZero(j, k); },
           [&](const std::string& pair, int j, int k) {
             json.key(pair).beginArray();
             for (const Mat6& K : kernels) json.value(K(j, k));
             json.end();
           });
  json.end().end();
}

void raosJson(Json& json, const Coefficients& c, const std::string& file,
              const std::set<double>& speeds) {
  json.beginArray();
  for (const double speed : speeds) {
    for (const bool free : {false, true}) raoJson(json, c, file, speed, free);
  }
  json.end();
}

}  // namespace cutwater::page
