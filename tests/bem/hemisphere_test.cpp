#include <gtest/gtest.h>

#include "tests/bem/Bodies.h"
#include "tests/support/CsvTable.h"
#include "tests/support/Results.h"

// Floating hemisphere of radius 1 against Hulme's multipole solution (uncertainty 1e-4 of ρV), on
// inscribed, unscaled meshes.
namespace cutwater::test {
namespace {

constexpr double kVolume = 2.0 / 3.0 * kPi;

/// A/ρV of heave and surge, then B/ρVω of heave and surge.
using Curves = std::array<double, 4>;

Curves solved(const InfluenceMatrices& matrices, const ModeNormals& normals, double Ka) {
  const CMat6 Z = impulse(matrices, normals, Ka) / kVolume;
  return {Z(Heave, Heave).real(), Z(Surge, Surge).real(), -Z(Heave, Heave).imag(),
          -Z(Surge, Surge).imag()};
}

class Hulme {
 public:
  Hulme() : table_("bem/hemisphere_hulme.csv") {
    for (std::size_t i = 0; i < table_.rows(); ++i)
      for (std::size_t c = 0; c < 4; ++c) peak_[c] = std::max(peak_[c], at(i)[c]);
  }
  std::size_t rows() const { return table_.rows(); }
  double Ka(std::size_t i) const { return table_.number(i, "Ka"); }
  Curves at(std::size_t i) const {
    return {table_.number(i, "heave_A"), table_.number(i, "surge_A"), table_.number(i, "heave_B"),
            table_.number(i, "surge_B")};
  }
  /// Difference as a fraction of each curve's maximum.
  Curves error(std::size_t i, const Curves& got) const {
    Curves e = at(i);
    for (std::size_t c = 0; c < 4; ++c) e[c] = std::abs(got[c] - e[c]) / peak_[c];
    return e;
  }
  double peak(std::size_t c) const { return peak_[c]; }

 private:
  CsvTable table_;
  Curves peak_{};
};

/// Worst fraction over the table's rows with from ≤ Ka ≤ to.
Curves worst(const Hulme& hulme, int around, int down, bool lid, double from, double to,
             PanelShape shape = PanelShape::Flat) {
  const SurfaceMesh wet = wetHemisphere(1.0, around, down);
  const InfluenceMatrices matrices(panels(wet, true, lid, shape), {.threads = 2});
  const ModeNormals normals(matrices.mesh(), Vec3::Zero(), wet);
  Curves most{};
  for (std::size_t i = 0; i < hulme.rows(); ++i) {
    if (hulme.Ka(i) < from || hulme.Ka(i) > to) continue;
    const Curves e = hulme.error(i, solved(matrices, normals, hulme.Ka(i)));
    for (std::size_t c = 0; c < 4; ++c) most[c] = std::max(most[c], e[c]);
  }
  return most;
}

void expectWithin(const Hulme& hulme, int around, int down, double boundA, double boundB) {
  const int panelCount = around * down;
  for (const bool lid : {false, true}) {
    SCOPED_TRACE(lid ? "with lid" : "without lid");
    const Curves e = worst(hulme, around, down, lid, 0.0, 2.0);
    EXPECT_LT(std::max(e[0], e[1]), boundA);
    EXPECT_LT(std::max(e[2], e[3]), boundB);
    const std::string where = "hemisphere, " + std::to_string(panelCount) + " panels a side" +
                              (lid ? ", lid" : "") + ", Ka ≤ 2, % of maximum";
    const char* names[] = {"A33", "A11", "B33", "B11"};
    for (std::size_t c = 0; c < 4; ++c)
      recordResult("solver", std::string(names[c]) + ", " + where, "Hulme 1982", 100.0 * e[c],
                   c < 2 ? "≤ " + std::to_string(100.0 * boundA).substr(0, 4)
                         : "≤ " + std::to_string(100.0 * boundB).substr(0, 4));
  }
}

// 0.5 % and 1 % are asked of 432 panels; a second-order method may have 432/N times that.
TEST(HemisphereClosedForm, AddedMassAndDampingOfHeaveAndSurge) {
  expectWithin(Hulme(), 16, 10, 0.005 * 432 / 160, 0.010 * 432 / 160);
  if (!fullSize()) return;
  expectWithin(Hulme(), 27, 16, 0.005, 0.010);
  expectWithin(Hulme(), 40, 26, 0.0025, 0.005);
}

/// % of each curve's maximum, in the order of Curves: what is asked at 432 panels, which no other
/// code has in all four (the best of each are 0.10, 0.23, 0.50, 0.55), and what the best of other
/// codes reach at 1040, given to two decimals.
constexpr Curves kAsked432{0.10, 0.20, 0.30, 0.15}, kPeers1040{0.05, 0.06, 0.09, 0.17};
constexpr double kTwoDecimals = 0.005;

// Of the error of flat panels two thirds are the volume that an inscribed polyhedron lacks; panels
// moved out to the sphere do not lack it. Most of what is then left is the variation of normal and
// potential over a panel, which the weights of curved panels hold. At 160 panels no curve is worse
// than 0.42 %: for a second-order method 0.15 % at 432 and 0.06 % at 1040.
TEST(HemisphereClosedForm, CurvedPanelsHaveTheVolumeOfTheSphere) {
  const Hulme hulme;
  const Curves flat = worst(hulme, 16, 10, true, 0.0, 2.0);
  const Curves curved = worst(hulme, 16, 10, true, 0.0, 2.0, PanelShape::Auto);
  for (std::size_t c = 0; c < 4; ++c) {
    EXPECT_LT(curved[c], 0.0042);
    EXPECT_LT(curved[c], 0.5 * flat[c]);
  }
  if (!fullSize()) return;
  const char* names[] = {"A33", "A11", "B33", "B11"};
  const Curves at432 = worst(hulme, 27, 16, true, 0.0, 2.0, PanelShape::Auto);
  const Curves at1040 = worst(hulme, 40, 26, true, 0.0, 2.0, PanelShape::Auto);
  for (std::size_t c = 0; c < 4; ++c) {
    EXPECT_LE(100.0 * at432[c], kAsked432[c]) << names[c];
    EXPECT_LE(100.0 * at1040[c], kPeers1040[c] + kTwoDecimals) << names[c];
    const auto record = [&](const char* count, double reached, const char* than, double bound) {
      recordResult("solver",
                   std::string(names[c]) + ", hemisphere, " + count +
                       " panels a side, curved by default, lid, Ka ≤ 2, % of maximum",
                   "Hulme 1982", reached, than + std::to_string(bound).substr(0, 4));
    };
    record("432", 100.0 * at432[c], "≤ ", kAsked432[c]);
    record("1040", 100.0 * at1040[c], "best peer ", kPeers1040[c]);
  }
}

// Short waves with a lid, 0.7 radii long at Ka = 9: 1 % of the maximum is asked. The error is the
// hull panels', not the lid's: a lid of four times as many panels changes it by a tenth, four times
// as many hull panels divide it by three. Without a lid the hull alone is nearer between its
// irregular frequencies.
TEST(HemisphereClosedForm, ShortWavesWithALid) {
  if (!fullSize()) GTEST_SKIP() << "full size only";
  const Curves e = worst(Hulme(), 27, 16, true, 7.0, 9.5, PanelShape::Auto);
  const char* names[] = {"A33", "A11", "B33", "B11"};
  for (std::size_t c = 0; c < 4; ++c) {
    EXPECT_LT(e[c], 0.01) << names[c];
    recordResult(
        "solver",
        std::string(names[c]) + ", hemisphere, 432 panels a side, lid, Ka 7 to 9.5, % of maximum",
        "Hulme 1982", 100.0 * e[c], "≤ 1");
  }
}

// Half the panel size: the error of the worst of the four curves falls fourfold. 1.8 allows for the
// terms of higher order that these coarse meshes still show.
TEST(HemisphereConvergence, OfSecondOrderInThePanelSize) {
  const Hulme hulme;
  const auto error = [&](int around, int down) {
    const Curves e = worst(hulme, around, down, false, 0.0, 2.0);
    return *std::max_element(e.begin(), e.end());
  };
  const double order = std::log2(error(8, 5) / error(16, 10));
  EXPECT_GT(order, 1.8);
  recordResult("solver", "hemisphere, order of convergence in panel size, 40 to 160 panels",
               "Hulme 1982", order, "≥ 1.8");
  if (!fullSize()) return;
  const double fineOrder = std::log2(error(16, 10) / error(32, 20));
  EXPECT_GT(fineOrder, 1.8);
  recordResult("solver", "hemisphere, order of convergence in panel size, 160 to 640 panels",
               "Hulme 1982", fineOrder, "≥ 1.8");
}

/// Parabola through three neighbouring rows: within 0.2 % of the maximum between them (checked on
/// the rows themselves by leaving one out).
Curves between(const Hulme& hulme, double Ka) {
  std::size_t i = 1;
  while (i + 2 < hulme.rows() && hulme.Ka(i + 1) < Ka) ++i;
  Curves sum{};
  for (std::size_t a = i - 1; a <= i + 1; ++a) {
    double share = 1.0;
    for (std::size_t b = i - 1; b <= i + 1; ++b)
      if (a != b) share *= (Ka - hulme.Ka(b)) / (hulme.Ka(a) - hulme.Ka(b));
    for (std::size_t c = 0; c < 4; ++c) sum[c] += share * hulme.at(a)[c];
  }
  return sum;
}

/// Worst B over a fine sweep, where a resonance inside cannot hide between points.
double worstDamping(const Hulme& hulme, const InfluenceMatrices& matrices, double from, double to,
                    double step) {
  const ModeNormals normals(matrices.mesh(), Vec3::Zero());
  double most = 0.0;
  for (double Ka = from; Ka <= to; Ka += step) {
    const Curves got = solved(matrices, normals, Ka), exact = between(hulme, Ka);
    for (std::size_t c = 2; c < 4; ++c)
      most = std::max(most, std::abs(got[c] - exact[c]) / hulme.peak(c));
  }
  return most;
}

// The Dirichlet problem inside resonates in heave at Ka = 2.56 and in surge near 3.9, ... [Hulme's
// A and B know nothing of it]. 4 % is what the acceptance asks; without a lid B33 goes negative
// at 2.58.
TEST(HemisphereVerification, LidLeavesNoIrregularFrequencyUpToKa9) {
  const Hulme hulme;
  const InfluenceMatrices lidded(panels(wetHemisphere(1.0, 14, 8), true, true), {.threads = 2});
  EXPECT_LT(worstDamping(hulme, lidded, 2.5, 2.7, 0.02), 0.04);
  EXPECT_LT(worstDamping(hulme, lidded, 2.7, 9.0, 0.3), 0.04);
  const InfluenceMatrices open(panels(wetHemisphere(1.0, 14, 8), true, false), {.threads = 2});
  EXPECT_GT(worstDamping(hulme, open, 2.5, 2.7, 0.02), 0.20) << "nothing to remove?";
  EXPECT_GT(worstDamping(hulme, open, 3.8, 4.1, 0.02), 0.20) << "nothing to remove?";
  if (!fullSize()) return;
  const InfluenceMatrices fine(panels(wetHemisphere(1.0, 27, 16), true, true), {.threads = 2});
  const InfluenceMatrices fineOpen(panels(wetHemisphere(1.0, 27, 16), true, false), {.threads = 2});
  const double with = worstDamping(hulme, fine, 2.0, 9.0, 0.025);
  const double without = worstDamping(hulme, fineOpen, 2.0, 9.0, 0.025);
  EXPECT_LT(with, 0.04);
  EXPECT_GT(without, 0.20);
  recordResult("solver", "hemisphere 432 with lid, B33 and B11, Ka 2 to 9 by 0.025, % of maximum",
               "Hulme 1982", 100.0 * with, "≤ 4");
  recordResult("solver", "the same without lid", "Hulme 1982", 100.0 * without, "(fails: > 20)");
}

}  // namespace
}  // namespace cutwater::test
