#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <optional>

#include "demos/cutwater/Commands.h"
#include "demos/cutwater/Csv.h"
#include "hydro/database/CoefficientsFile.h"
#include "hydro/memory/RetardationMatrix.h"

namespace cutwater::command {

void retardation(const std::string& database, double step, double duration,
                 const std::string& out) {
  if (!(step > 0.0) || !(duration >= step) || duration / step > 1e6) {
    throw UsageError(fmt::format(
        "--dt {} --duration {}: needs 0 < dt <= duration, at most 1e6 rows", step, duration));
  }
  std::string warning;
  const Coefficients coefficients = readCoefficients(database, &warning);
  warn(warning);
  std::optional<RetardationMatrix> memory;
  naming(database, [&] { memory.emplace(coefficients); });
  // The speed-dependent parts (35)-(40) are not computed.
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  Csv csv("tau,j,k,K0,KU,KUU");
  const int last = static_cast<int>(std::floor(duration / step + 1e-9));
  for (int i = 0; i <= last; ++i) {
    const Mat6 k0 = memory->at(i * step);
    for (int j = 0; j < 6; ++j) {
      for (int k = 0; k < 6; ++k) csv.row({i * step, j + 1.0, k + 1.0, k0(j, k), kNan, kNan});
    }
  }
  csv.write(out);
}

}  // namespace cutwater::command
