#include <algorithm>
#include <cmath>

#include "hydro/waves/Spectrum.h"
#include "hydro/waves/UnitSpectrum.h"

namespace cutwater {

double Spectrum::peakFrequency() const { return UnitSpectrum(*this).peakFrequency(); }

double Spectrum::operator()(double omega) const {
  const UnitSpectrum unit(*this);
  return unit.variance() * unit(omega);
}

double Spectrum::significantHeight() const {
  const UnitSpectrum unit(*this);
  return 4.0 * std::sqrt(unit.variance() * unit.energy());
}

double Spectrum::moment(int n) const {
  const UnitSpectrum unit(*this);
  return unit.variance() * unit.moment(n);
}

std::pair<double, double> cutOffs(const Spectrum& spectrum, const SeaStateSettings& settings) {
  const UnitSpectrum unit(spectrum);
  return {settings.omegaMin > 0.0 ? settings.omegaMin : unit.usualMin(),
          settings.omegaMax > 0.0 ? settings.omegaMax : unit.usualMax()};
}

double shareOfEnergy(const Spectrum& spectrum, double from, double to) {
  const UnitSpectrum unit(spectrum);
  if (!(to > from)) return 0.0;
  return std::min(1.0, unit.between(std::max(from, 0.0), to) / unit.energy());
}

}  // namespace cutwater
