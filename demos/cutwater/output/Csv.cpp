#include "demos/cutwater/output/Csv.h"

namespace cutwater::command {

double phaseDegrees(Complex z) {
  const double degrees = std::arg(z) * 180.0 / kPi;
  return degrees < -180.0 + 5e-7 ? 180.0 : degrees;  // what nine digits would write as -180
}

void Csv::row(const std::vector<double>& values, const std::string& prefix) {
  text_ += prefix;
  addCsvRow(text_, values);
}

}  // namespace cutwater::command
