#include "hydro/solve/Solve.h"

#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <system_error>

#include "demos/cutwater/commands/Commands.h"
#include "demos/cutwater/input/ShipFile.h"
#include "demos/cutwater/output/Csv.h"
#include "demos/cutwater/output/Progress.h"
#include "demos/cutwater/output/ShipListing.h"
#include "hydro/Errors.h"
#include "hydro/base/AtomicFile.h"
#include "hydro/database/CoefficientsFile.h"
#include "hydro/finish/GridNeeds.h"
#include "hydro/memory/SpeedStability.h"

namespace cutwater::command {

namespace {

// What of the mask does not do what its user may expect.
void warnOfMask(const std::string& path, const ShipFile& ship) {
  const SolveSettings& s = ship.solve;
  if (s.lid && !(s.conditionLimitEven.empty() && s.conditionLimitOdd.empty())) {
    warn(path +
         ": [solve] condition limits with lid = true: condition numbers jump by a factor of about "
         "5 where the lid begins, one limit does not fit both sides");
  }
  // With G off the centre plane the modes mix and the hull is solved whole, too.
  const bool halves = ship.particulars.symmetric && ship.particulars.cog.y() == 0.0;
  if (!halves && !s.conditionLimitOdd.empty()) {
    warn(path +
         ": [solve] condition_limit_odd: without symmetry about the centre plane all modes are one "
         "system, which condition_limit_even masks; this one is not used");
  }
}

// What has been solved is kept beside the database until that is written, for a sweep that is
// interrupted: by Ctrl-C after the frequencies at work, by anything else at once.
class Interruption {
 public:
  Interruption() : before_(std::signal(SIGINT, ask)) { asked = 0; }
  ~Interruption() { std::signal(SIGINT, before_); }
  void check(const std::string& journal, int done, int total) const {
    if (asked == 0 || done == total) return;
    throw HydroError(Fault::Interrupted,
                     fmt::format("interrupted; {} of {} frequencies are kept in {}, the same "
                                 "command goes on from there",
                                 done, total, journal));
  }

 private:
  static void ask(int) {
    asked = 1;
    std::signal(SIGINT, SIG_DFL);  // a second Ctrl-C stops the program
  }
  static volatile std::sig_atomic_t asked;
  void (*before_)(int);
};
volatile std::sig_atomic_t Interruption::asked = 0;

// Journals of other ships or settings that lie beside this one.
std::vector<std::string> journalsAside(const std::string& journal) {
  namespace fs = std::filesystem;
  std::vector<std::string> found;
  std::error_code none;
  const std::string begin = fs::path(journal).filename().string() + ".";
  for (const auto& entry : fs::directory_iterator(fs::absolute(journal).parent_path(), none)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with(begin) && name.size() == begin.size() + 16)
      found.push_back(entry.path().string());
  }
  return found;
}

Coefficients solved(const ShipFile& ship, const std::string& journal) {
  Progress progress("solve", Progress::Elsewhere::Lines);
  const Interruption interruption;
  bool first = true;
  return cutwater::solve(
      ship.particulars, ship.solve,
      [&](int done, int total) {
        for (const std::string& aside : first ? journalsAside(journal) : std::vector<std::string>())
          say("solve: frequencies of another ship or of other settings are kept in " + aside);
        if (first && done > 0)
          say(fmt::format("solve: {} of {} frequencies taken from {}", done, total, journal));
        first = false;
        progress.show(done, total);
        interruption.check(journal, done, total);
      },
      journal);
}

}  // namespace

// A sweep can take minutes: better to know first that its result can be kept.
void solve(const std::string& path, const std::string& database, int threads) {
  requireRegular(database);  // its journal lies beside it
  ShipFile ship = readShipFile(path, Balance::Needed);
  ship.solve.threads = threads;
  warnOfMask(path, ship);
  const ShipParticulars& p = ship.particulars;
  say(fmt::format("solve: {} panels{}, {} frequencies, {} headings; {}", p.wetSurface.faces.size(),
                  p.symmetric ? " a side" : "", ship.solve.omega.size(), ship.solve.headings.size(),
                  sizeText(p.symmetric ? bothHalves(p.wetSurface) : p.wetSurface, p.volume)));
  const std::string journal = database + ".sweep";
  Coefficients coefficients;
  naming(path, [&] { coefficients = solved(ship, journal); });
  if (const auto left = std::count(coefficients.masked.begin(), coefficients.masked.end(), 1);
      left > 0) {
    say(fmt::format("solve: {} of {} frequencies masked and interpolated", left,
                    coefficients.omega.size()));
  }
  const std::vector<double>& waveOmega = ship.solve.waveOmega;
  if (coefficients.resolvedOmega > 0.0 && coefficients.resolvedOmega < waveOmega.back()) {
    warn(
        fmt::format("{}: the panels resolve waves up to {:.2f} rad/s only, wave_omega ends at "
                    "{:.2f}; use a finer mesh",
                    path, coefficients.resolvedOmega, waveOmega.back()));
  }
  for (const std::string& line : gridWarnings(coefficients))
    warn(path + ": [solve] omega: " + line);
  for (const std::string& line : panelWarnings(coefficients)) warn(path + ": " + line);
  for (const std::string& line : describe(coefficients.stability)) warn(path + ": " + line);
  ImpulseResponse memory;  // K for the readers of BEMIO
  naming(path, [&] { memory = impulseResponse(coefficients); });
  writeCoefficients(coefficients, database, memory);
  std::error_code none;  // the database is safe, whatever becomes of the journal
  std::filesystem::remove(journal, none);
}

}  // namespace cutwater::command
