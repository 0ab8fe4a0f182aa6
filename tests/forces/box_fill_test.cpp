// Water in a box against sums over thin columns, and against what is known on paper.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <random>

#include "hydro/forces/BoxFill.h"
#include "hydro/forces/Compartment.h"
#include "tests/support/Refusal.h"

namespace cutwater::test {
namespace {

const Vec3 kSize(8.0, 5.0, 3.0);

// Of the water below up·x = height, on n³ cells.
BoxFill summed(const Vec3& size, double height, const Vec3& up, int n) {
  BoxFill fill;
  const double cell = size.prod() / (static_cast<double>(n) * n * n);
  Vec3 moment = Vec3::Zero();
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      for (int k = 0; k < n; ++k) {
        const Vec3 at =
            size.cwiseProduct(Vec3((i + 0.5) / n - 0.5, (j + 0.5) / n - 0.5, (k + 0.5) / n - 0.5));
        if (at.dot(up) > height) continue;
        fill.volume += cell;
        moment += cell * at;
      }
    }
  }
  fill.centre = moment / fill.volume;
  return fill;
}

// 100³ cells know a volume to about a thousandth of the box.
TEST(BoxFillIdentity, AnyAttitudeAgreesWithCells) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> share(0.05, 0.95);
  for (int i = 0; i < 20; ++i) {
    const Vec3 up = Vec3(normal(random), normal(random), normal(random)).normalized();
    const double volume = share(random) * kSize.prod();
    const BoxFill fill = fillBox(kSize, volume, up);
    const BoxFill cells = summed(kSize, fill.height, up, 100);
    EXPECT_NEAR(cells.volume, volume, 2e-3 * kSize.prod());
    EXPECT_LT((cells.centre - fill.centre).norm(), 0.02);
    const BoxFill back = fillBoxTo(kSize, fill.height, up);
    EXPECT_NEAR(back.volume, volume, 1e-12 * kSize.prod());
    // The surface is what the volume grows by.
    const double d = 1e-5;
    const double grows =
        fillBoxTo(kSize, fill.height + d, up).volume - fillBoxTo(kSize, fill.height - d, up).volume;
    EXPECT_NEAR(fill.surface, grows / (2.0 * d), 1e-5 * kSize.prod());
  }
}

// By rounding: closed forms.
TEST(BoxFillClosedForm, UprightHeeledAndInACorner) {
  const BoxFill level = fillBox(kSize, 60.0, Vec3::UnitZ());
  EXPECT_NEAR(level.centre.z(), -0.75, 1e-13);
  EXPECT_NEAR(level.height, 0.0, 1e-13);
  EXPECT_NEAR(level.surface, 40.0, 1e-12);
  // A wedge that moves: i/V tan φ across, with ½ tan² of it up.
  const double heel = 0.2, t = std::tan(heel);
  const BoxFill wedge = fillBox(kSize, 60.0, Vec3(0.0, std::sin(heel), std::cos(heel)));
  const double i = 8.0 * 125.0 / 12.0;
  EXPECT_NEAR(wedge.centre.y(), -i / 60.0 * t, 1e-13);
  EXPECT_NEAR(wedge.centre.z(), -0.75 + 0.5 * i / 60.0 * t * t, 1e-13);
  EXPECT_NEAR(wedge.surface, 40.0 / std::cos(heel), 1e-12);
  // A corner: a tetrahedron of equal legs a, V = a³/6, its centre a/4 from each wall.
  const double a = 1.5;
  const BoxFill corner = fillBox(kSize, a * a * a / 6.0, Vec3(1, 1, 1).normalized());
  EXPECT_LT((corner.centre - (-0.5 * kSize + Vec3::Constant(a / 4.0))).norm(), 1e-9);
  EXPECT_NEAR(corner.surface, std::sqrt(3.0) / 2.0 * a * a, 1e-9);
}

TEST(BoxFill, EmptyFullAndUpsideDown) {
  const Vec3 up = Vec3(0.1, -0.3, -1.0).normalized();
  EXPECT_EQ(fillBox(kSize, -1.0, up).volume, 0.0);
  EXPECT_EQ(fillBox(kSize, 1e9, up).volume, kSize.prod());
  EXPECT_LT(fillBox(kSize, kSize.prod(), up).centre.norm(), 1e-12);
  EXPECT_GT(fillBox(kSize, 10.0, up).centre.z(), 1.0);
}

// What is not a compartment is refused by name, field and value.
TEST(CompartmentRefusals, NameFieldAndValue) {
  const auto made = [](const CompartmentBox& box) { Compartment(box, Vec3::Zero(), 1025.0); };
  const auto out = Fault::ValueOutOfRange;
  expectRefusal(out, {"compartment \"hold\"", "size[1] = 0"}, [&] {
    made({.name = "hold", .size = {1, 0, 1}});
  });
  expectRefusal(out, {"permeability = 1.5"}, [&] {
    made({.name = "hold", .size = {1, 1, 1}, .permeability = 1.5});
  });
  expectRefusal(out, {"volume = 2", "0..1 m3"}, [&] {
    made({.name = "hold", .size = {1, 1, 1}, .volume = 2.0});
  });
  Compartment fuel({.name = "fuel", .size = {1, 1, 1}, .density = 850.0}, Vec3::Zero(), 1025.0);
  expectRefusal(Fault::BadArgument, {"fuel", "does not mix"}, [&] { fuel.openTo({.area = 1.0}); });
  expectRefusal(out, {"rate = nan"}, [&] { fuel.setRate(std::nan("")); });
}

constexpr double kG = 9.81, kDensity = 1025.0;

Compartment tank(double volume = 0.0, double permeability = 1.0) {
  return Compartment({.name = "tank",
                      .centre = {0, 0, -3.5},
                      .size = {4, 3, 3},
                      .permeability = permeability,
                      .volume = volume},
                     Vec3::Zero(), kDensity);
}

// Under a constant head H over an opening that stays above the water inside, Q = C_d A √(2gH).
TEST(OrificeClosedForm, FillsAtAConstantRateUnderAConstantHead) {
  Compartment c = tank();
  c.openTo({.place = {0, 1.5, -2.0}, .area = 0.05});  // at its top
  const double expected = 0.6 * 0.05 * std::sqrt(2.0 * kG * 2.0);
  double time = 0.0;
  for (; c.volume() < 35.0; time += 0.01) c.flow({}, time, 0.01, kG, nullptr);
  EXPECT_NEAR(time, 35.0 / expected, 0.011);
  EXPECT_NEAR(c.inflow(), expected, 1e-12);
}

// From below, against the water that is in it already: S √(2ΔH/g)/(C_d A) until it is level. √ of a
// head that vanishes: the midpoint rule has the time to a part in a thousand, and stays level then.
TEST(OrificeClosedForm, EqualisesInTheTimeOfTorricelli) {
  for (const double mu : {1.0, 0.7}) {
    Compartment c = tank(0.0, mu);
    c.openTo({.place = {0, 0, -5.0}, .area = 0.1});
    // Of the box 0 .. 3 m over the opening the sea stands 5 m: first to its lid.
    double time = 0.0;
    const double root = 0.6 * 0.1 * std::sqrt(2.0 * kG);
    for (; c.volume() < mu * 36.0; time += 0.01) c.flow({}, time, 0.01, kG, nullptr);
    const double expected = mu * 12.0 * 2.0 * (std::sqrt(5.0) - std::sqrt(2.0)) / root;
    EXPECT_NEAR(time, expected, 1e-3 * expected + 0.01);
    // Lifted until the sea stands 1 m over the opening it runs out to that level, and stays.
    const Compartment::Place up{Vec3(0, 0, 4.0), Mat3::Identity()};
    time = 0.0;
    const double out = mu * 12.0 * 2.0 * std::sqrt(2.0) / root;
    for (; c.volume() > mu * 12.0 * (1.0 + 1e-9); time += 0.01) c.flow(up, time, 0.01, kG, nullptr);
    EXPECT_NEAR(time, out, 2e-3 * out + 0.01);
    for (int i = 0; i < 1000; ++i) c.flow(up, time, 0.01, kG, nullptr);
    EXPECT_NEAR(c.volume(), mu * 12.0, 1e-9);
    EXPECT_EQ(c.inflow(), 0.0);
  }
}

// A pump stops where there is nothing left, and where there is no more room.
TEST(Compartment, ARateEndsAtEmptyAndFull) {
  Compartment c = tank(1.0);
  c.setRate(-0.5);
  for (int i = 0; i < 300; ++i) c.flow({}, 0.0, 0.01, kG, nullptr);
  EXPECT_EQ(c.volume(), 0.0);
  c.setRate(20.0);
  for (int i = 0; i < 300; ++i) c.flow({}, 0.0, 0.01, kG, nullptr);
  EXPECT_EQ(c.volume(), c.capacity());
}

// Many ticks of any size into the deepest corner of a heeled box that was empty.
TEST(Compartment, AnEmptyCornerFillsFromBelow) {
  const double heel = 0.3;
  Mat3 attitude;
  attitude = Eigen::AngleAxisd(heel, Vec3::UnitX());
  Compartment c = tank();
  c.openTo({.place = {0, -1.5, -5.0}, .area = 0.1});
  const Compartment::Place place{Vec3(0, 0, 0), attitude};
  for (int i = 0; i < 20000; ++i) c.flow(place, 0.0, 0.02, kG, nullptr);
  c.settle(place);
  EXPECT_EQ(c.volume(), c.capacity());
}

}  // namespace
}  // namespace cutwater::test
