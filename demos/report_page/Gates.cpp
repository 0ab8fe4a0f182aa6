#include "demos/report_page/Gates.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "demos/cutwater/input/WaveGrid.h"
#include "demos/cutwater/output/ShipListing.h"
#include "hydro/base/EnumNames.h"
#include "hydro/base/SymmetricEigen.h"
#include "hydro/database/ForwardSpeed.h"
#include "hydro/database/Interpolation.h"
#include "hydro/database/NegativeDamping.h"
#include "hydro/finish/GridNeeds.h"
#include "hydro/memory/RadiationModel.h"
#include "hydro/memory/SpeedStability.h"

namespace cutwater::page {

namespace {

struct Gate {
  std::string name;
  std::optional<double> value;
  const char* unit;
  std::optional<double> limit;
  std::optional<bool> passes;
  std::string advice = {};  // what to do, where it does not pass
};

void write(Json& json, const Gate& gate) {
  const auto number = [&](const char* name, const std::optional<double>& value) {
    json.key(name);
    if (value) {
      json.value(*value);
    } else {
      json.null();
    }
  };
  json.beginObject().field("name", gate.name);
  number("value", gate.value);
  json.field("unit", gate.unit);
  number("limit", gate.limit);
  json.key("passes");
  if (gate.passes) {
    json.value(*gate.passes);
  } else {
    json.null();
  }
  json.field("advice", gate.passes == true ? "" : gate.advice).end();
}

Gate atMost(const std::string& name, double value, const char* unit, double limit,
            const std::string& advice) {
  return {name, value, unit, limit, value <= limit * (1.0 + 1e-9), advice};
}
Gate atLeast(const std::string& name, double value, const char* unit, double limit,
             const std::string& advice) {
  return {name, value, unit, limit, value >= limit - 1e-9 * std::abs(limit), advice};
}

void symmetry(std::vector<Gate>& gates, const Coefficients& c) {
  constexpr double kMost = 10.0;  // as panelWarnings (finish/GridNeeds.h) has it
  const char* advice = "the panels do not carry the couplings: use a finer mesh";
  gates.push_back(atMost("symmetry of the added mass A",
                         command::solversAsymmetry(c, "added_mass", c.addedMass), "%", kMost,
                         advice));
  gates.push_back(atMost("symmetry of the damping B",
                         command::solversAsymmetry(c, "damping", c.damping), "%", kMost, advice));
}

// Of B over the roots of its greatest diagonal values, the least eigenvalue at any frequency.
void energy(std::vector<Gate>& gates, const Coefficients& c) {
  const std::size_t count = std::min(resolvedCount(c), c.damping.size());
  Vec6 largest = Vec6::Zero();
  for (std::size_t i = 0; i < count; ++i)
    largest = largest.cwiseMax(c.damping[i].diagonal().cwiseAbs());
  const Vec6 size = (largest.array() > 0.0).select(largest.cwiseSqrt(), 1.0);
  double least = 0.0, where = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const double now = symmetricEigenvalues(c.damping[i].cwiseQuotient(size * size.transpose()))[0];
    if (now < least) {
      least = now;
      where = c.omega[i];
    }
  }
  gates.push_back(atLeast(
      "energy: least eigenvalue of the damping B, of its largest", 100.0 * least, "%",
      -100.0 * kNegativeDampingShare,
      fmt::format("near {:.3g} rad/s waves give energy to the ship: use a finer mesh", where)));
}

// ∫|K⁰| dτ, entry by entry.
Mat6 integralOfSize(const RetardationMatrix& memory) {
  constexpr int kSteps = 2000;
  const double step = memory.duration() / kSteps;
  Mat6 sum = Mat6::Zero();
  for (int i = 0; i <= kSteps; ++i)
    sum += (i == 0 || i == kSteps ? 0.5 : 1.0) * step * memory.at(i * step).cwiseAbs();
  return sum;
}

// The worst of the six modes, each with itself.
void memoryIntegral(std::vector<Gate>& gates, const RetardationMatrix& memory) {
  constexpr double kMost = 1.0;  // [%]
  const Mat6 total = memory.integral(memory.duration()), size = integralOfSize(memory);
  double worst = 0.0;
  for (int j = 0; j < 6; ++j)
    if (size(j, j) > 0.0) worst = std::max(worst, 100.0 * std::abs(total(j, j)) / size(j, j));
  gates.push_back(atMost("memory: integral of K0, of the integral of |K0|", worst, "%", kMost,
                         "the memory ends too early: solve with smaller steps of omega"));
}

void memory(std::vector<Gate>& gates, const Coefficients& c) {
  if (c.omega.size() < 2 || c.status == CoefficientStatus::Unfinished) {
    gates.push_back({"memory", {}, "", {}, false, c.unfinishedBecause});
    return;
  }
  const RadiationModel model(c, usableForm(c));
  if (model.retardation().lastOmega() <= 0.0) return;
  const ConsistentLimit limit = consistentLimit(c, model.retardation());
  gates.push_back(atMost("Kramers-Kronig closure: scatter of A(inf) from A and B",
                         100.0 * limit.scatter, "%", 100.0 * kLargestScatter,
                         "A and B do not belong together: solve with smaller steps of omega, "
                         "higher frequencies, or a finer mesh"));
  if (c.hasConsistentLimit())
    gates.push_back(atMost("A(inf) solved directly, from the one that follows",
                           command::infinityDifference(c), "%", 100.0 * kLargestDistance,
                           "use a finer mesh at the waterline, or higher frequencies"));
  memoryIntegral(gates, model.retardation());
  if (model.sum().size() > 0)
    gates.push_back({"fit of the memory by exponentials, error",
                     100.0 * model.sum().error(),
                     "%",
                     {},
                     {},
                     "to be looked at: a few tenths of a per cent are usual"});
}

void grid(std::vector<Gate>& gates, const Coefficients& c) {
  if (c.omega.size() < 2 || !(c.ship.length() > 0.0)) return;
  const GridNeeds needs(c);
  gates.push_back(atMost("largest step of the frequencies", needs.step, "rad/s", needs.neededStep,
                         "solve with smaller steps of omega"));
  gates.push_back(atLeast("last frequency in use", needs.last, "rad/s", needs.neededLast,
                          needs.endsAtPanels ? "use a finer mesh" : "solve to a higher omega"));
  if (c.resolvedOmega > 0.0)
    gates.push_back(atLeast("resolved by the panels", c.resolvedOmega, "rad/s",
                            command::defaultWaveOmega(c).back(),
                            "waves above it are shorter than the panels: use a finer mesh"));
  const auto masked = std::count(c.masked.begin(), c.masked.end(), 1);
  Gate mask{"frequencies masked and interpolated", static_cast<double>(masked), "", {}, {}, {}};
  if (masked == 0) mask.passes = true;
  mask.advice =
      "their condition numbers are above the envelope of [solve] condition_limit_even, "
      "condition_limit_odd; a lid makes them good";
  gates.push_back(mask);
}

void stability(std::vector<Gate>& gates, const Coefficients& c) {
  const SpeedStability& s = c.stability;
  if (s.checkedTo <= 0.0) return;
  const auto gate = [&](const char* name, const GrowthLimit& limit, double to, bool astern) {
    Gate found{name, to, "m/s", to, !limit.speed.has_value(), {}};
    if (limit.speed) {
      found.value = *limit.speed;
      const bool tuck = c.forwardSpeed == ForwardSpeedForm::Tuck;
      found.advice = describe(limit, astern) + ": go slower, or restrain that mode" +
                     (tuck ? "" : ", or solve with forward_speed = \"tuck\"");
    }
    gates.push_back(found);
  };
  gate("stability: motions do not grow ahead up to", s.ahead, s.checkedTo, false);
  gate("stability: motions do not grow astern up to", s.astern, 0.5 * s.checkedTo, true);
  Gate course{"keeps its course by itself up to",
              s.course.value_or(s.checkedTo),
              "m/s",
              s.checkedTo,
              {},
              "a hull without a helm does not: give it keep_course or a rudder"};
  if (!s.course) course.passes = true;
  gates.push_back(course);
}

}  // namespace

void gatesJson(Json& json, const Coefficients& c) {
  std::vector<Gate> gates;
  symmetry(gates, c);
  energy(gates, c);
  memory(gates, c);
  grid(gates, c);
  stability(gates, c);
  json.beginArray();
  for (const Gate& gate : gates) write(json, gate);
  json.end();
}

}  // namespace cutwater::page
