#include "demos/cutwater/Commands.h"
#include "demos/cutwater/Csv.h"
#include "hydro/database/CoefficientsFile.h"
#include "hydro/forces/WaveExcitation.h"

namespace cutwater::command {

void excitation(const std::string& database, double speed, double headingDeg,
                const std::string& omegaRange, const std::string& out) {
  requireZeroSpeed(speed);
  std::string warning;
  const Coefficients coefficients = readCoefficients(database, &warning);
  warn(warning);
  const WaveExcitation waves(coefficients);
  const double heading = headingRadians(headingDeg);
  Csv csv("omega,omega_e,j,fk_re,fk_im,diff_re,diff_im");
  for (const double omega : omegaList(omegaRange, defaultWaveOmega(coefficients))) {
    const WaveExcitation::Force force = waves.at(omega, heading);
    for (int j = 0; j < 6; ++j) {
      const Complex fk = force.froudeKrylov[j], diffraction = force.diffraction[j];
      csv.row(
          {omega, omega, j + 1.0, fk.real(), fk.imag(), diffraction.real(), diffraction.imag()});
    }
  }
  csv.write(out);
}

}  // namespace cutwater::command
