#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "hydro/memory/VectorFitting.h"

// Rational functions that are known are found again from their own samples.
namespace cutwater {
namespace {

/// Σ of ½[R/(iω − s) + R*/(iω − s*)]: the transform of Re Σ R e^{sτ}.
struct KnownFunction {
  std::vector<Complex> poles, residues;

  Complex at(double omega) const {
    Complex sum = 0.0;
    for (std::size_t m = 0; m < poles.size(); ++m) {
      const Complex iw(0.0, omega), R = residues[m], s = poles[m];
      sum += 0.5 * (R / (iw - s) + std::conj(R) / (iw - std::conj(s)));
    }
    return sum;
  }
  /// With weights 1 at every ω.
  Response response(const std::vector<double>& omega) const {
    const auto n = static_cast<Eigen::Index>(omega.size());
    Response r{Eigen::VectorXcd(n), Eigen::VectorXd::Ones(n), Eigen::VectorXd::Ones(n)};
    for (Eigen::Index i = 0; i < n; ++i) r.value[i] = at(omega[static_cast<std::size_t>(i)]);
    return r;
  }
};

/// 60 frequencies, 0.05 to 3 rad/s.
std::vector<double> sixtyFrequencies() {
  std::vector<double> omega;
  for (int i = 1; i <= 60; ++i) omega.push_back(0.05 * i);
  return omega;
}

const std::vector<Complex> kTwoPairs{{-0.1, 0.6}, {-0.4, 1.7}};

// Each pole has its columns: a real one 1/(iω − s), of a pair the sum and i times the difference.
// The factors Re R/2 and Im R/2 give the transform of Re{R e^{sτ}}. Round-off of a dozen
// operations.
TEST(VectorFittingIdentity, BasisTimesHalfTheResidueIsTheTransform) {
  const KnownFunction pair{{{-0.3, 1.1}}, {{2.0, -5.0}}}, real{{{-0.7, 0.0}}, {{3.0, 0.0}}};
  const std::vector<double> omega = sixtyFrequencies();
  const Eigen::MatrixXcd basis = rationalBasis(omega, {pair.poles[0], real.poles[0]});
  ASSERT_EQ(basis.rows(), 60);
  ASSERT_EQ(basis.cols(), 3);
  const Eigen::Vector2d half(1.0, -2.5);
  for (Eigen::Index i = 0; i < 60; ++i) {
    const double w = omega[static_cast<std::size_t>(i)];
    const Complex ofPair = basis(i, 0) * half[0] + basis(i, 1) * half[1];
    EXPECT_LT(std::abs(ofPair - pair.at(w)), 1e-14 * std::abs(pair.at(w))) << w;
    EXPECT_LT(std::abs(3.0 * basis(i, 2) - real.at(w)), 1e-14 * std::abs(real.at(w))) << w;
  }
}

// Two responses that share two pairs of poles. With as many poles as the functions have, vector
// fitting ends at them. 1e-9: round-off times the condition of the least squares, 1e5 here at most.
TEST(VectorFittingClosedForm, PolesAndResiduesComeBackFromSamples) {
  const KnownFunction one{kTwoPairs, {{1.0, 0.5}, {-0.2, 2.0}}},
      other{kTwoPairs, {{0.0, -1.0}, {3.0, 0.1}}};
  const std::vector<double> omega = sixtyFrequencies();
  const std::vector<Response> responses{one.response(omega), other.response(omega)};
  const std::vector<Complex> poles = fitPoles(omega, responses, 4, 12);
  ASSERT_EQ(poles.size(), 2u);
  const auto residues = fitResidues(omega, responses, poles);
  ASSERT_EQ(residues.size(), 2u);
  for (std::size_t m = 0; m < 2; ++m) {
    EXPECT_LT(std::abs(poles[m] - kTwoPairs[m]), 1e-9) << m;  // in the order of |s|
    EXPECT_LT(std::abs(residues[0][m] - one.residues[m]), 1e-9) << m;
    EXPECT_LT(std::abs(residues[1][m] - other.residues[m]), 1e-9) << m;
  }
}

// The start is always a pair; its zeros may still become real.
TEST(VectorFittingClosedForm, FindsRealPolesToo) {
  const KnownFunction decay{{{-0.5, 0.0}, {-2.0, 0.0}}, {{1.0, 0.0}, {-3.0, 0.0}}};
  const std::vector<double> omega = sixtyFrequencies();
  const std::vector<Response> responses{decay.response(omega)};
  const std::vector<Complex> poles = fitPoles(omega, responses, 2, 12);
  ASSERT_EQ(poles.size(), 2u);
  const auto residues = fitResidues(omega, responses, poles);
  for (std::size_t m = 0; m < 2; ++m) {
    EXPECT_LT(std::abs(poles[m] - decay.poles[m]), 1e-9) << m;  // as above
    EXPECT_LT(std::abs(residues[0][m] - decay.residues[m]), 1e-9) << m;
  }
}

// A memory must fade. A response that grows in time has poles in the right half plane; they are
// reflected, whatever the fit is then worth.
TEST(VectorFitting, PolesNeverGrowInTime) {
  const KnownFunction growing{{{0.2, 0.9}, {-0.3, 2.0}}, {{1.0, 0.0}, {1.0, 1.0}}};
  const std::vector<double> omega = sixtyFrequencies();
  for (const int iterations : {1, 2, 5, 10})
    for (const Complex& s : fitPoles(omega, {growing.response(omega)}, 4, iterations)) {
      EXPECT_LE(s.real(), -1e-4) << iterations;
      EXPECT_GE(s.imag(), 0.0) << iterations;
    }
}

/// A response no two poles can follow.
Response roughResponse(const std::vector<double>& omega) {
  Response r = KnownFunction{kTwoPairs, {{1.0, 0.5}, {-0.2, 2.0}}}.response(omega);
  for (Eigen::Index i = 0; i < r.value.size(); ++i)
    r.value[i] += 0.2 * Complex(std::cos(7.0 * static_cast<double>(i)), std::sin(i * i));
  return r;
}

Complex transformAtZero(const std::vector<Complex>& residues, const std::vector<Complex>& poles) {
  return KnownFunction{poles, residues}.at(0.0);
}

// What the sum is at ω = 0 is a condition, not one equation among others: exact to round-off, for
// data that disagree with it and among themselves.
TEST(VectorFittingIdentity, ValueAtZeroIsKeptExactly) {
  const std::vector<double> omega = sixtyFrequencies();
  const std::vector<Complex> poles{{-0.2, 0.0}, {-0.3, 0.9}, {-0.5, 2.1}};
  Response r = roughResponse(omega);
  const double loose = transformAtZero(fitResidues(omega, {r}, poles)[0], poles).real();
  r.holdsZero = true;
  for (const double zero : {0.0, 1.0, -3.0}) {
    r.atZero = zero;
    const auto residues = fitResidues(omega, {r}, poles)[0];
    EXPECT_NEAR(transformAtZero(residues, poles).real(), zero, 1e-12);
    EXPECT_GT(std::abs(loose - zero), 1e-2);  // the condition says something
  }
}

/// dH/d(iω) at 0, of a real function of time real.
double slopeAtZero(const std::vector<Complex>& residues, const std::vector<Complex>& poles) {
  double sum = 0.0;
  for (std::size_t m = 0; m < poles.size(); ++m)
    sum -= (residues[m] / (poles[m] * poles[m])).real();
  return sum;
}

// Value and slope at ω = 0 both are conditions.
TEST(VectorFittingIdentity, SlopeAtZeroIsKeptExactlyBesideTheValue) {
  const std::vector<double> omega = sixtyFrequencies();
  const std::vector<Complex> poles{{-0.2, 0.0}, {-0.3, 0.9}, {-0.5, 2.1}};
  Response r = roughResponse(omega);
  r.holdsZero = true;
  r.atZero = 0.5;
  const double loose = slopeAtZero(fitResidues(omega, {r}, poles)[0], poles);
  r.holdsSlope = true;
  for (const double slope : {0.0, 2.0, -40.0}) {
    r.slope = slope;
    const auto residues = fitResidues(omega, {r}, poles)[0];
    EXPECT_NEAR(slopeAtZero(residues, poles), slope, 1e-11);  // 1/s² = 25 magnifies round-off
    EXPECT_NEAR(transformAtZero(residues, poles).real(), 0.5, 1e-12);
    EXPECT_GT(std::abs(loose - slope), 1e-2);  // the condition says something
  }
}

/// Weighted sum of squares of what residues leave of a response.
double misfit(const std::vector<double>& omega, const Response& r,
              const std::vector<Complex>& residues, const std::vector<Complex>& poles) {
  double sum = 0.0;
  for (std::size_t i = 0; i < omega.size(); ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    const Complex left = KnownFunction{poles, residues}.at(omega[i]) - r.value[k];
    sum += std::pow(r.weightRe[k] * left.real(), 2) + std::pow(r.weightIm[k] * left.imag(), 2);
  }
  return sum;
}

// Least squares: any other residues leave more. The misfit is a parabola, so that ±1e-4 must both
// be above.
TEST(VectorFittingIdentity, NoOtherResiduesFitBetter) {
  const std::vector<double> omega = sixtyFrequencies();
  const std::vector<Complex> poles{{-0.2, 0.0}, {-0.3, 0.9}, {-0.5, 2.1}};
  Response r = roughResponse(omega);
  for (Eigen::Index i = 0; i < r.value.size(); ++i) {
    r.weightRe[i] = 1.0 + 0.05 * static_cast<double>(i);
    r.weightIm[i] = i % 3 == 0 ? 0.0 : 2.0;  // some not known at all
  }
  const auto best = fitResidues(omega, {r}, poles)[0];
  const double least = misfit(omega, r, best, poles);
  for (std::size_t m = 0; m < poles.size(); ++m)
    for (const Complex step : {Complex(1e-4, 0.0), Complex(0.0, 1e-4)}) {
      if (poles[m].imag() == 0.0 && step.real() == 0.0) continue;  // a real pole's residue is real
      for (const double sign : {-1.0, 1.0}) {
        std::vector<Complex> other = best;
        other[m] += sign * step;
        EXPECT_GT(misfit(omega, r, other, poles), least) << m;
      }
    }
}

// Among the residues with the given value at ω = 0 too none fits better. Steps that keep it: one
// real pole against another, whose residues R add −R/s.
TEST(VectorFittingIdentity, NoOtherResiduesOfThatValueAtZeroFitBetter) {
  const std::vector<double> omega = sixtyFrequencies();
  const std::vector<Complex> poles{{-0.2, 0.0}, {-0.7, 0.0}, {-1.9, 0.0}};
  Response r = roughResponse(omega);
  r.holdsZero = true;
  r.atZero = 1.5;
  const auto best = fitResidues(omega, {r}, poles)[0];
  const double least = misfit(omega, r, best, poles);
  for (std::size_t m = 0; m < 3; ++m)
    for (const double step : {-1e-4, 1e-4}) {
      const std::size_t other = (m + 1) % 3;
      std::vector<Complex> moved = best;
      moved[m] += step * poles[m];
      moved[other] -= step * poles[other];
      ASSERT_NEAR(transformAtZero(moved, poles).real(), 1.5, 1e-12);
      EXPECT_GT(misfit(omega, r, moved, poles), least) << m;
    }
}

// Among those of the given value and slope none fits better. Of three real poles there is one step
// that keeps both, Σ c_m/s_m = Σ c_m/s_m² = 0.
TEST(VectorFittingIdentity, NoOtherResiduesOfThatValueAndSlopeFitBetter) {
  const std::vector<double> omega = sixtyFrequencies();
  const std::vector<Complex> poles{{-0.2, 0.0}, {-0.7, 0.0}, {-1.1, 0.0}, {-1.9, 0.0}};
  Response r = roughResponse(omega);
  r.holdsZero = r.holdsSlope = true;
  r.atZero = 1.5;
  r.slope = -2.0;
  const auto best = fitResidues(omega, {r}, poles)[0];
  const double least = misfit(omega, r, best, poles);
  for (std::size_t m = 0; m < 4; ++m) {
    const std::size_t n = (m + 1) % 4, l = (m + 2) % 4;
    const auto inverse = [&](std::size_t i) { return 1.0 / poles[i].real(); };
    const Eigen::Vector3d x(inverse(m), inverse(n), inverse(l));
    const Eigen::Vector3d step = x.cross(Eigen::Vector3d(x.cwiseAbs2())).normalized();
    for (const double size : {-1e-3, 1e-3}) {
      std::vector<Complex> moved = best;
      moved[m] += size * step[0];
      moved[n] += size * step[1];
      moved[l] += size * step[2];
      ASSERT_NEAR(transformAtZero(moved, poles).real(), 1.5, 1e-11);
      ASSERT_NEAR(slopeAtZero(moved, poles), -2.0, 1e-11);
      EXPECT_GT(misfit(omega, r, moved, poles), least) << m;
    }
  }
}

// A frequency of no weight is ignored, however wrong its value.
TEST(VectorFittingIdentity, FrequenciesOfNoWeightDoNotCount) {
  const KnownFunction known{kTwoPairs, {{1.0, 0.5}, {-0.2, 2.0}}};
  const std::vector<double> omega = sixtyFrequencies();
  Response r = known.response(omega);
  for (const Eigen::Index i : {0, 17, 59}) {
    r.value[i] = Complex(1e3, -1e3);
    r.weightRe[i] = r.weightIm[i] = 0.0;
  }
  const auto residues = fitResidues(omega, {r}, kTwoPairs)[0];
  for (std::size_t m = 0; m < 2; ++m)
    EXPECT_LT(std::abs(residues[m] - known.residues[m]), 1e-12) << m;  // round-off
}

}  // namespace
}  // namespace cutwater
