#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <optional>

#include "demos/cutwater/commands/Commands.h"
#include "demos/cutwater/output/Csv.h"
#include "hydro/database/CoefficientsFile.h"
#include "hydro/memory/RetardationMatrix.h"

namespace cutwater::command {

void retardation(const std::string& database, double step, double duration,
                 const std::string& out) {
  if (!(step > 0.0) || !(duration >= step) || !(duration / step <= 1e6)) {
    throw UsageError(fmt::format(
        "--dt {} --duration {}: needs 0 < dt <= duration, at most 1e6 rows", step, duration));
  }
  requireMemory(fmt::format("--dt {} --duration {}", step, duration),
                duration / step * 36.0 * 2.0 * 60.0);  // lines of 60 characters, in a growing text
  std::string warning;
  const Coefficients coefficients = readCoefficients(database, &warning);
  warn(warning);
  std::optional<RetardationMatrix> memory;
  naming(database, [&] { memory.emplace(coefficients); });
  if (!memory->hasSpeedTerms()) {
    warn(database + ": added_mass_x, damping_x: not in the file; KU and KUU are nan");
  }
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  Csv csv("tau,j,k,K0,KU,KUU");
  const int last = static_cast<int>(std::floor(duration / step + 1e-9));
  for (int i = 0; i <= last; ++i) {
    const SpeedKernels K = memory->kernels(i * step);
    const bool known = memory->hasSpeedTerms();
    for (int j = 0; j < 6; ++j) {
      for (int k = 0; k < 6; ++k) {
        csv.row({i * step, j + 1.0, k + 1.0, K.atRest(j, k), known ? K.linear(j, k) : kNan,
                 known ? K.squared(j, k) : kNan});
      }
    }
  }
  csv.write(out);
}

}  // namespace cutwater::command
