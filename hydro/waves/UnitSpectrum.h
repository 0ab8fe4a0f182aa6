#pragma once
#include <vector>

#include "hydro/waves/Spectrum.h"

namespace cutwater {

/// A spectrum with m0 = 1 (of JonswapNormalisation::Dnv: energy()), made ready to be evaluated
/// often. S(ω) = variance() · unit(ω).
class UnitSpectrum {
 public:
  /// @throws HydroError ValueOutOfRange naming a field of the spectrum and its value.
  explicit UnitSpectrum(const Spectrum& spectrum);

  double operator()(double omega) const;
  /// ∫ S dω between two frequencies [rad/s], by five Gauss points in cells of 2 % of ω.
  double between(double from, double to) const;
  /// m_n of the unit spectrum, all frequencies.
  double moment(int n) const;
  double energy() const { return energy_; }
  /// hs²/16 [m²]; of Table its m0.
  double variance() const { return variance_; }
  double peakFrequency() const { return peak_; }
  /// Half the lowest and four times the highest peak; of Table its ends.
  double usualMin() const { return usualMin_; }
  double usualMax() const { return usualMax_; }

 private:
  /// share · 4 c^λ/Γ(λ) ω^{−4λ−1} e^{−c/ω⁴}: m_n = share · c^{n/4} Γ(λ − n/4)/Γ(λ).
  struct Part {
    Part(double share, double peak, double lambda);
    double operator()(double omega) const;
    double moment(int n) const;
    double share, peak, lambda, c, logScale;
  };
  void makeOchiHubble(const Spectrum& spectrum);
  void makeJonswap(const Spectrum& spectrum);
  void makeTable(const SpectrumTable& table);
  double peakedness(double omega) const;
  /// ∫ ω^n (peakedness − 1) S₁ dω, S₁ = the part alone: nothing is left of it beyond 2 ω_p.
  double momentOfPeak(int n) const;
  double fromTable(double omega) const;
  double tableMoment(int n, double from, double to) const;

  std::vector<Part> parts_;
  SpectrumTable table_;  // m0 = 1
  double gamma_ = 1.0, scale_ = 1.0;
  double energy_ = 1.0, variance_ = 0.0;
  double peak_ = 0.0, usualMin_ = 0.0, usualMax_ = 0.0;
};

/// @throws HydroError ValueOutOfRange naming field and value, unless it is good.
void requireOfSpectrum(bool good, const char* field, double value);

}  // namespace cutwater
