#include <gtest/gtest.h>

#include <cmath>

#include "hydro/database/IrregularFrequencies.h"
#include "hydro/geometry/shapes/Shapes.h"
#include "hydro/solve/Solve.h"
#include "tests/support/Results.h"

// Two ways round the resonances of the water inside the hull: a lid that has none, and a mask over
// the condition numbers that leaves them out ([M03] 5.7). Off the resonances both are the hull
// alone.
namespace cutwater::test {
namespace {

struct Hull {
  const char* name;
  SurfaceMesh wet;
  Vec3 cog;
  std::vector<double> omega;  // [rad/s], the panels resolve the last
  ConditionLimit even, odd;  // what a user draws over the condition numbers of the hull without lid
};

/// ω = from, from + step, … to.
std::vector<double> range(double from, double to, double step = 0.05) {
  std::vector<double> omega;
  for (double at = from; at <= to + 1e-9; at += step) omega.push_back(at);
  return omega;
}

Coefficients solved(const Hull& hull, bool lid, bool mask) {
  ShipParticulars ship;
  ship.wetSurface = hull.wet;
  ship.symmetric = true;
  ship.cog = hull.cog;
  SolveSettings settings;
  settings.omega = hull.omega;
  settings.lid = lid;
  if (mask) settings.conditionLimitEven = hull.even, settings.conditionLimitOdd = hull.odd;
  settings.threads = 2;
  return solve(ship, settings);
}

/// Largest difference of A_jj and B_jj/ω, as a fraction of A_jj's maximum, where `where` is true.
template <class Where>
double apart(const Coefficients& a, const Coefficients& b, Where where) {
  Vec6 peak = Vec6::Zero();
  for (const Mat6& A : a.addedMass) peak = peak.cwiseMax(A.diagonal().cwiseAbs());
  double most = 0.0;
  for (std::size_t i = 0; i < a.omega.size(); ++i) {
    if (!where(i)) continue;
    const Vec6 dA = (a.addedMass[i] - b.addedMass[i]).diagonal().cwiseAbs();
    const Vec6 dB = (a.damping[i] - b.damping[i]).diagonal().cwiseAbs() / a.omega[i];
    for (int j = 0; j < 6; ++j)
      if (peak[j] > 1e-6 * peak.maxCoeff()) most = std::max(most, (dA[j] + dB[j]) / peak[j]);
  }
  return most;
}

/// How far a point lies off the cubic through its four neighbours, of the maximum: the curve's own
/// fourth difference where it is smooth, the height of a spike where it is not. Where five
/// frequencies are not at one step they are left out.
double roughness(const Coefficients& c) {
  Vec6 peak = Vec6::Zero();
  for (const Mat6& A : c.addedMass) peak = peak.cwiseMax(A.diagonal().cwiseAbs());
  double most = 0.0;
  for (std::size_t i = 2; i + 2 < c.omega.size(); ++i) {
    if (c.omega[i + 2] - c.omega[i - 2] > 4.01 * (c.omega[1] - c.omega[0])) continue;
    const auto at = [&](std::size_t k) -> Vec6 { return c.addedMass[k].diagonal(); };
    const Vec6 cubic = (4.0 * (at(i - 1) + at(i + 1)) - at(i - 2) - at(i + 2)) / 6.0;
    for (int j = 0; j < 6; ++j)
      if (peak[j] > 1e-6 * peak.maxCoeff())
        most = std::max(most, std::abs(at(i)[j] - cubic[j]) / peak[j]);
  }
  return most;
}

std::vector<Hull> hulls() {
  return {{"frigate",
           wetFrigate(23, 5),
           {-2.4165, 0.0, 1.29},
           range(1.0, 2.0),
           {{1.0, 60.0}, {1.7, 300.0}, {2.2, 420.0}},
           {{1.0, 20.0}, {2.2, 90.0}}},
          {"barge",
           wetBox({40.0, 10.0, 3.0, 0.0}, 14, 4, 3),
           {0.0, 0.0, 0.0},
           range(1.2, 2.9),
           {{1.2, 100.0}, {2.0, 120.0}, {2.3, 250.0}},
           {{1.2, 20.0}, {2.5, 45.0}, {2.7, 120.0}, {2.9, 200.0}}},
          {"hemisphere",
           wetHemisphere(5.0, 14, 8),
           {0.0, 0.0, 0.0},
           range(1.4, 3.1),
           {{1.4, 7.0}, {3.1, 14.0}},
           {{1.4, 4.0}, {2.2, 6.0}, {3.1, 16.0}}}};
}

/// What both tests below record of a hull with lid and without [% of maximum].
void recordLid(const std::string& name, double off, double everywhere, double lid, double open) {
  recordResult("irregular frequencies", name + ", lid and no lid off the mask, % of maximum", "0",
               100.0 * off, "discretisation");
  recordResult("irregular frequencies", name + ", lid and no lid, everywhere, % of maximum", "0",
               100.0 * everywhere, "(resonances)");
  recordResult("irregular frequencies", name + ", roughness with lid, % of maximum",
               std::to_string(100.0 * open) + " without", 100.0 * lid, "smooth");
}

// Off the resonances lid and no lid differ by the discretisation error of both and by the foot of
// the next resonance, 5 % of the maximum in the barge 0.15 rad/s below one; a resonance is worth
// twice to ten times that. The mask leaves the lid's curve within the error of interpolating across
// it.
TEST(IrregularFrequenciesVerification, LidAndMaskAgreeOffTheResonances) {
  for (const Hull& hull : hulls()) {
    SCOPED_TRACE(hull.name);
    const Coefficients lid = solved(hull, true, false), open = solved(hull, false, false);
    const Coefficients masked = solved(hull, false, true);
    const auto count = std::count(masked.masked.begin(), masked.masked.end(), 1);
    const double everywhere = apart(lid, open, [](std::size_t) { return true; });
    const double off = apart(lid, masked, [&](std::size_t i) { return masked.masked[i] == 0; });
    const double across = apart(lid, masked, [](std::size_t) { return true; });
    EXPECT_GT(count, 0);
    EXPECT_LT(off, 0.06);
    EXPECT_LT(across, 0.08);
    EXPECT_GT(everywhere, 2.0 * off) << "no resonance?";
    EXPECT_LT(roughness(lid), 0.02);
    EXPECT_GT(roughness(open), 2.0 * roughness(lid));
    recordLid(hull.name, off, everywhere, roughness(lid), roughness(open));
    recordResult("irregular frequencies",
                 std::string(hull.name) + ", lid and mask, everywhere, % of maximum", "0",
                 100.0 * across, "interpolation");
  }
}

/// Five frequencies 0.02 rad/s apart from each of these: in short waves resonances are that dense.
std::vector<double> clusters(const std::vector<double>& starts) {
  std::vector<double> omega;
  for (const double from : starts)
    for (const double at : range(from, from + 0.08, 0.02)) omega.push_back(at);
  return omega;
}

/// Frigates in short waves. The panels of 361 and 1549 a side resolve 3.1 and 5.3 rad/s.
Hull frigateInShortWaves(bool fine) {
  const Vec3 cog(-2.4165, 0.0, 1.29);
  if (!fine)
    return {"frigate 361 a side, 3 rad/s",
            wetFrigate(60, 6),
            cog,
            clusters({3.0}),
            {{3.0, 1400.0}},
            {{3.0, 850.0}}};
  return {"frigate 1549 a side, 4 to 5.3 rad/s",
          wetFrigate(172, 9),
          cog,
          clusters({4.0, 5.2}),
          {{4.0, 3300.0}, {6.0, 3100.0}},
          {{4.0, 2000.0}, {6.0, 3140.0}}};
}

// In short waves a resonance is narrow and the next one near. Off the mask lid and no lid differ by
// 2 to 3 % of the maximum, the foot of the next; without lid the curves jitter by 0.2 to 0.5 % from
// one frequency to the next, with lid they are smooth to 0.003 %, the fourth difference of a curve
// over 0.02 rad/s. What the mask interpolates is not compared: too few frequencies here.
TEST(IrregularFrequenciesVerification, LidIsSmoothInShortWavesAndMeetsTheMaskedCurves) {
  for (const bool fine : {false, true}) {
    if (fine && !fullSize()) break;  // a quarter of an hour of processor time
    const Hull hull = frigateInShortWaves(fine);
    SCOPED_TRACE(hull.name);
    const Coefficients lid = solved(hull, true, false), open = solved(hull, false, false);
    // Curves ring from K·(panel length) = 4.1 on; up to π they are resolved.
    EXPECT_LT(kPi * std::pow(hull.omega.back() / lid.resolvedOmega, 2), 4.0);
    Coefficients limited = open;
    limited.conditionLimitEven = hull.even;
    limited.conditionLimitOdd = hull.odd;
    const std::vector<int> masked = irregularFrequencies(limited);
    const double everywhere = apart(lid, open, [](std::size_t) { return true; });
    const double off = apart(lid, open, [&](std::size_t i) { return masked[i] == 0; });
    EXPECT_GT(std::count(masked.begin(), masked.end(), 1), 0);
    EXPECT_LT(off, 0.03);
    EXPECT_GT(everywhere, off);
    EXPECT_LT(roughness(lid), 2e-4);
    EXPECT_GT(roughness(open), 20.0 * roughness(lid));
    recordLid(hull.name, off, everywhere, roughness(lid), roughness(open));
  }
}

}  // namespace
}  // namespace cutwater::test
