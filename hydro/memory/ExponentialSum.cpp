#include "hydro/memory/ExponentialSum.h"

#include <algorithm>
#include <cmath>

#include "hydro/memory/RetardationMatrix.h"
#include "hydro/memory/VectorFitting.h"

namespace cutwater {

namespace {

constexpr double kSpeeds[] = {0.0, 2.5, 5.0, 10.0, 15.0};  // [m/s] at which errors are weighed
constexpr double kNegligible = 1e-9;  // of √(K_jj K_kk): a pair that vanishes by symmetry
constexpr double kBand = 1.5;    // a coefficient's size at ω is its largest from ω/1.5 to 1.5 ω
constexpr double kFloor = 3e-4;  // of its largest at all, and no less
constexpr int kIterations = 6;

/// ω of the fit: evenly over what the data resolve, then in growing steps ten times as far.
std::vector<double> fitFrequencies(double last) {
  std::vector<double> omega;
  constexpr int kEven = 80, kBeyond = 20;
  for (int i = 1; i <= kEven; ++i) omega.push_back(last * i / kEven);
  for (int i = 1; i <= kBeyond; ++i)
    omega.push_back(last * std::pow(10.0, static_cast<double>(i) / kBeyond));
  return omega;
}

/// What the three parts of K are at the frequencies of the fit, and what is known beside it.
struct Spectrum {
  std::vector<double> omega;
  std::vector<RetardationMatrix::Transforms> values;
  Mat6 linearTotal, momentumTotal, speedDamping, speedStiffness, addedMassInf;

  Spectrum(const RetardationMatrix& K, const Mat6& addedMass)
      : omega(fitFrequencies(K.lastOmega())),
        linearTotal(K.linearTotal()),
        momentumTotal(K.momentumIntegral(0.0, HUGE_VAL)),
        speedDamping(K.speedDamping()),
        speedStiffness(K.speedStiffness()),
        addedMassInf(addedMass) {
    for (const double w : omega) values.push_back(K.transforms(w));
  }
  /// B(U) + iωA(U) at frequency i.
  Complex impedance(std::size_t i, double U, int j, int k) const {
    const Complex iw(0.0, omega[i]);
    return iw * addedMassInf(j, k) + U * speedDamping(j, k) + U * U * speedStiffness(j, k) / iw +
           values[i].atRest(j, k) + U * (values[i].linear(j, k) + U * values[i].squared(j, k));
  }
};

/// Largest of |x| in the band about each ω, not below the floor.
std::vector<double> sizes(const std::vector<double>& omega, const std::vector<double>& x) {
  const double all = *std::max_element(x.begin(), x.end());
  std::vector<double> result(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    double largest = std::max(kFloor * all, 1e-300);
    for (std::size_t n = 0; n < x.size(); ++n) {
      if (omega[n] >= omega[i] / kBand && omega[n] <= omega[i] * kBand)
        largest = std::max(largest, x[n]);
    }
    result[i] = largest;
  }
  return result;
}

/// Part of K_jk with weights such that an error of one is one of B or ωA in its band, at the speed
/// where that says most.
Response responseOf(const Spectrum& s, int j, int k, std::size_t part) {
  const auto n = static_cast<Eigen::Index>(s.omega.size());
  Response r{Eigen::VectorXcd(n),
             Eigen::VectorXd::Zero(n),
             Eigen::VectorXd::Zero(n),
             part == 1 ? s.linearTotal(j, k) : 0.0,
             part < 2,
             part == 0 ? s.momentumTotal(j, k) : 0.0,
             part == 0};
  for (Eigen::Index i = 0; i < n; ++i)
    r.value[i] = s.values[static_cast<std::size_t>(i)][part](j, k);
  for (const double U : kSpeeds) {
    if (part > 0 && U == 0.0) continue;
    std::vector<double> re, im;
    for (std::size_t i = 0; i < s.omega.size(); ++i) {
      const Complex z = s.impedance(i, U, j, k);
      re.push_back(std::abs(z.real()));
      im.push_back(std::abs(z.imag()));
    }
    const double share = std::pow(U, static_cast<double>(part));
    const auto sizeRe = sizes(s.omega, re), sizeIm = sizes(s.omega, im);
    for (Eigen::Index i = 0; i < n; ++i) {
      const auto at = static_cast<std::size_t>(i);
      r.weightRe[i] = std::max(r.weightRe[i], share / sizeRe[at]);
      r.weightIm[i] = std::max(r.weightIm[i], share / sizeIm[at]);
    }
  }
  return r;
}

struct Channel {
  int j, k;
  std::size_t part;
};

/// The functions that do not vanish.
std::vector<Channel> channelsOf(const Spectrum& s) {
  Mat6 largest[3] = {Mat6::Zero(), Mat6::Zero(), Mat6::Zero()};
  for (std::size_t i = 0; i < s.omega.size(); ++i) {
    for (std::size_t part = 0; part < 3; ++part)
      largest[part] = largest[part].cwiseMax(s.values[i][part].cwiseAbs());
  }
  std::vector<Channel> channels;
  double share = 1.0;
  for (std::size_t part = 0; part < 3; ++part) {
    for (int n = 0; n < 36; ++n) {
      const int j = n / 6, k = n % 6;
      const double size = std::sqrt(largest[0](j, j) * largest[0](k, k));
      if (share * largest[part](j, k) > kNegligible * size) channels.push_back({j, k, part});
    }
    share *= kSpeeds[4];
  }
  return channels;
}

/// ∫₀^∞ Re{Σ R_m e^{s_m τ}} e^{−iωτ} dτ.
Complex transformOf(const std::vector<Complex>& residues, const std::vector<Complex>& poles,
                    double omega) {
  const Complex iw(0.0, omega);
  Complex sum = 0.0;
  for (std::size_t m = 0; m < poles.size(); ++m) {
    const Complex R = residues[m];
    sum += 0.5 * (R / (iw - poles[m]) + std::conj(R) / (iw - std::conj(poles[m])));
  }
  return sum;
}

double worstError(const std::vector<double>& omega, const std::vector<Response>& responses,
                  const std::vector<Complex>& poles,
                  const std::vector<std::vector<Complex>>& residues) {
  double worst = 0.0;
  for (std::size_t r = 0; r < responses.size(); ++r) {
    for (std::size_t i = 0; i < omega.size(); ++i) {
      const auto at = static_cast<Eigen::Index>(i);
      const Complex error = transformOf(residues[r], poles, omega[i]) - responses[r].value[at];
      worst = std::max({worst, responses[r].weightRe[at] * std::abs(error.real()),
                        responses[r].weightIm[at] * std::abs(error.imag())});
    }
  }
  return worst;
}

}  // namespace

ExponentialSum::ExponentialSum(const RetardationMatrix& retardation, const Mat6& addedMassInf,
                               std::size_t poles) {
  if (retardation.lastOmega() <= 0.0) return;
  const Spectrum spectrum(retardation, addedMassInf);
  const std::vector<Channel> channels = channelsOf(spectrum);
  if (channels.empty()) return;
  std::vector<Response> responses;
  for (const Channel& c : channels) responses.push_back(responseOf(spectrum, c.j, c.k, c.part));
  poles_ = fitPoles(spectrum.omega, responses, 2 * std::min(poles, kMostPoles / 2), kIterations);
  const auto residues = fitResidues(spectrum.omega, responses, poles_);
  error_ = worstError(spectrum.omega, responses, poles_, residues);
  for (std::size_t c = 0; c < channels.size(); ++c) {
    Pair& pair = pairOf(channels[c].j, channels[c].k);
    pair[channels[c].part] = residues[c];
  }
  makeRuns();
}

/// That of (j, k), made where it belongs in the order of rows if there is none.
ExponentialSum::Pair& ExponentialSum::pairOf(int j, int k) {
  const auto at = std::find_if(pairs_.begin(), pairs_.end(),
                               [&](const Pair& p) { return p.j * 6 + p.k >= j * 6 + k; });
  if (at != pairs_.end() && at->j == j && at->k == k) return *at;
  const std::vector<Complex> none(poles_.size(), 0.0);
  return *pairs_.insert(at, {{none, none, none}, j, k});
}

void ExponentialSum::makeRuns() {
  for (std::size_t part = 0; part < 3; ++part) {
    runs_[part].assign(pairs_.size() * 2 * width(), 0.0);
    double* at = runs_[part].data();
    for (const Pair& pair : pairs_) {
      const std::vector<Complex>& residues = pair[part];
      for (std::size_t m = 0; m < poles_.size(); ++m) {
        at[m] = -residues[m].real();
        at[width() + m] = residues[m].imag();
      }
      at += 2 * width();
    }
  }
  momentumRuns_.assign(pairs_.size() * 2 * width(), 0.0);
  double* at = momentumRuns_.data();
  for (const Pair& pair : pairs_) {
    for (std::size_t m = 0; m < poles_.size(); ++m) {
      const Complex residue = pair.atRest[m] / poles_[m];
      at[m] = residue.real();
      at[width() + m] = -residue.imag();
    }
    at += 2 * width();
  }
}

Mat6 ExponentialSum::at(double tau, double speed) const {
  Mat6 K = Mat6::Zero();
  for (const Pair& p : pairs_) {
    for (std::size_t m = 0; m < poles_.size(); ++m) {
      const SpeedParts<Complex> R{p.atRest[m], p.linear[m], p.squared[m]};
      K(p.j, p.k) += (R.at(speed) * std::exp(poles_[m] * tau)).real();
    }
  }
  return K;
}

CMat6 ExponentialSum::transform(double omega, double speed) const {
  CMat6 K = CMat6::Zero();
  for (const Pair& p : pairs_) {
    const SpeedParts<Complex> parts{transformOf(p.atRest, poles_, omega),
                                    transformOf(p.linear, poles_, omega),
                                    transformOf(p.squared, poles_, omega)};
    K(p.j, p.k) = parts.at(speed);
  }
  return K;
}

// As ∫K⁰ = 0, L⁰ is Re Σ (R/s) e^{sτ}, whose transform is Σ Re(R/s) even + Im(R/s) odd.
CMat6 ExponentialSum::momentumTransform(double omega) const noexcept {
  std::array<Complex, kMostPoles> even, odd;
  for (std::size_t m = 0; m < poles_.size(); ++m) {
    const double a = poles_[m].real(), b = poles_[m].imag();
    const Complex from(-a, omega);                                           // iω − a
    const double re = a * a - omega * omega + b * b, im = -2.0 * a * omega;  // (iω − a)² + b²
    const Complex inverse = Complex(re, -im) / (re * re + im * im);
    even[m] = from * inverse;
    odd[m] = -b * inverse;
  }
  CMat6 L = CMat6::Zero();
  const double* residues = momentumRuns_.data();
  for (const Pair& p : pairs_) {
    Complex sum = 0.0;
    for (std::size_t m = 0; m < poles_.size(); ++m)
      sum += residues[m] * even[m] - residues[width() + m] * odd[m];
    L(p.j, p.k) = sum;
    residues += 2 * width();
  }
  return L;
}

}  // namespace cutwater
