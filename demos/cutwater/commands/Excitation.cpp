#include "demos/cutwater/commands/Commands.h"
#include "demos/cutwater/input/WaveGrid.h"
#include "demos/cutwater/output/Csv.h"
#include "hydro/excitation/WaveExcitation.h"

namespace cutwater::command {

void excitation(const std::string& database, const WaveOptions& options, const std::string& out) {
  const Coefficients coefficients = readDatabase(database, options.moving);
  const WaveExcitation waves(coefficients, options.moving.form(coefficients));
  const double heading = headingRadians(options.headingDeg), speed = options.moving.speed;
  Csv csv("omega,omega_e,j,fk_re,fk_im,diff_re,diff_im");
  const auto add = [&](double omega) {
    const WaveExcitation::Force force = waves.at(omega, heading, speed);
    const double met = encounterFrequency(omega, speed, heading, coefficients.ship.gravity);
    for (int j = 0; j < 6; ++j) {
      const Complex fk = force.froudeKrylov[j], diffraction = force.diffraction[j];
      csv.row({omega, met, j + 1.0, fk.real(), fk.imag(), diffraction.real(), diffraction.imag()});
    }
  };
  const auto omegas = omegaList(options.omegaRange, defaultWaveOmega(coefficients));
  warnIfUnresolved(database, coefficients, omegas.back());
  naming(database, [&] {
    for (const double omega : omegas) add(omega);
  });
  csv.write(out);
}

}  // namespace cutwater::command
