#include "demos/cutwater/Commands.h"
#include "demos/cutwater/Csv.h"
#include "hydro/database/CoefficientsFile.h"
#include "hydro/forces/FrequencyResponse.h"

namespace cutwater::command {

void rao(const std::string& database, double speed, double headingDeg,
         const std::string& omegaRange, const std::string& out) {
  requireZeroSpeed(speed);
  std::string warning;
  const Coefficients coefficients = readCoefficients(database, &warning);
  warn(warning);
  const FrequencyResponse response(coefficients);
  const double heading = headingRadians(headingDeg);
  Csv csv("omega,omega_e,j,amplitude,phase_deg");
  for (const double omega : omegaList(omegaRange, defaultWaveOmega(coefficients))) {
    const CVec6 eta = response.at(omega, heading);
    for (int j = 0; j < 6; ++j) {
      csv.row({omega, omega, j + 1.0, std::abs(eta[j]), std::arg(eta[j]) * 180.0 / kPi});
    }
  }
  csv.write(out);
}

}  // namespace cutwater::command
