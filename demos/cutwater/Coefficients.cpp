#include <limits>

#include "demos/cutwater/Commands.h"
#include "demos/cutwater/Csv.h"
#include "hydro/database/CoefficientsFile.h"

namespace cutwater::command {

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

struct Row {
  double omega;
  const Mat6 *addedMass, *damping, *addedMassX, *dampingX;  // null: not computed
};

void append(Csv& csv, const Row& row) {
  const auto value = [](const Mat6* matrix, int j, int k) {
    return matrix ? (*matrix)(j, k) : kNan;
  };
  for (int j = 0; j < 6; ++j) {
    for (int k = 0; k < 6; ++k) {
      csv.row({row.omega, j + 1.0, k + 1.0, value(row.addedMass, j, k), value(row.damping, j, k),
               value(row.addedMassX, j, k), value(row.dampingX, j, k)});
    }
  }
}

}  // namespace

void coefficients(const std::string& database, double speed, const std::string& out) {
  requireZeroSpeed(speed);
  std::string warning;
  const Coefficients c = readCoefficients(database, &warning);
  warn(warning);
  const bool slopes = !c.addedMassX.empty();
  if (!slopes) warn(database + ": holds no x-derivatives: dA_dx and dB_dx are nan");
  const Mat6 zero = Mat6::Zero();
  Csv csv("omega,j,k,A,B,dA_dx,dB_dx");
  append(csv, {0.0, &c.addedMassZero, &zero, slopes ? &c.addedMassXZero : nullptr,
               slopes ? &zero : nullptr});
  for (std::size_t i = 0; i < c.omega.size(); ++i) {
    append(csv, {c.omega[i], &c.addedMass[i], &c.damping[i], slopes ? &c.addedMassX[i] : nullptr,
                 slopes ? &c.dampingX[i] : nullptr});
  }
  append(csv, {std::numeric_limits<double>::infinity(), &c.addedMassInf, &zero,
               slopes ? &c.addedMassXInf : nullptr, slopes ? &zero : nullptr});
  csv.write(out);
}

}  // namespace cutwater::command
