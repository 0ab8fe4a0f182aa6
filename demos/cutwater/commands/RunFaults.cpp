#include "demos/cutwater/commands/RunFaults.h"

#include <fmt/format.h>

#include <algorithm>

#include "hydro/Errors.h"

namespace cutwater::command {

namespace {

constexpr int kBits = 32;

StepFault bitOf(int number) { return static_cast<StepFault>(1u << number); }

const FaultCount& countOf(const RunFaults& run, int number) {
  return run.counts[static_cast<std::size_t>(number)];
}

// What every bit of a line begins with.
std::string named(StepFault bit, const std::string& more = "") {
  return fmt::format("{} ({}{})", faultText(bit), faultName(bit), more);
}

// Of the runs that raised it: the first time in the first of them, the ticks of all.
std::string warningLine(const std::vector<RunFaults>& runs, int number) {
  const RunFaults* first = nullptr;
  std::size_t raised = 0;
  std::uint64_t ticks = 0;
  double farthest = 0.0;
  for (const RunFaults& run : runs) {
    if ((run.bits & bitOf(number)) == 0) continue;
    if (first == nullptr) first = &run;
    ++raised;
    ticks += countOf(run, number).ticks;
    farthest = std::max(farthest, run.farthest);
  }
  if (first == nullptr) return "";
  std::string line =
      fmt::format("{}: first at t = {:.6g} s{}, in {} tick{}", named(bitOf(number)),
                  countOf(*first, number).first, first->of.empty() ? "" : " of " + first->of, ticks,
                  ticks == 1 ? "" : "s");
  if (runs.size() > 1) line += fmt::format(" of {} of {} runs", raised, runs.size());
  if (bitOf(number) == kFarFromCourse && farthest > 0.0)
    line += fmt::format(", up to {:.4g} m", farthest);
  return line;
}

}  // namespace

RunFaults faultsOf(const Seaway& seaway, Ship& ship) {
  RunFaults run{.bits = seaway.faults(), .part = ship.brokenPart()};
  for (int i = 0; i < kBits; ++i)
    run.counts[static_cast<std::size_t>(i)] = seaway.faultCount(bitOf(i));
  return run;
}

std::vector<std::string> warningLines(const std::vector<RunFaults>& runs) {
  std::vector<std::string> lines;
  for (int i = 0; i < kBits; ++i) {
    if ((kWarningBits & bitOf(i)) == 0) continue;
    const std::string line = warningLine(runs, i);
    if (!line.empty()) lines.push_back(line);
  }
  return lines;
}

std::string brokenLine(const RunFaults& run) {
  std::string line = run.of;
  for (int i = 0; i < kBits; ++i) {
    const StepFault bit = bitOf(i);
    if ((run.bits & ~kWarningBits & bit) == 0) continue;
    const bool ofPart = bit == kLoadNotFinite && !run.part.empty();
    line += fmt::format("{}{} at t = {:.6g} s",
                        line.empty()     ? ""
                        : line == run.of ? ": "
                                         : "; ",
                        named(bit, ofPart ? ", " + run.part : ""), countOf(run, i).first);
  }
  return line;
}

}  // namespace cutwater::command
