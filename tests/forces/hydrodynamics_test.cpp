#include "hydro/forces/Hydrodynamics.h"

#include <gtest/gtest.h>

#include <string>
#include <thread>
#include <vector>

#include "hydro/Errors.h"
#include "hydro/excitation/ExcitationTable.h"
#include "hydro/excitation/WaveExcitation.h"
#include "hydro/forces/SeaCache.h"
#include "hydro/forces/SeaTables.h"
#include "hydro/memory/RadiationModel.h"
#include "tests/excitation/TableBox.h"
#include "tests/memory/CausalShip.h"

namespace cutwater {
namespace {

TEST(Hydrodynamics, OwnsItsCoefficientsSoThatTemporariesMayBePassed) {
  const Hydrodynamics box(test::boxShip());
  EXPECT_EQ(box.coefficients().omega, test::boxShip().omega);
  EXPECT_EQ(box.ship().mass, test::boxShip().ship.mass);
}

TEST(Hydrodynamics, LengthAndKeelAreThoseOfTheHullOrOfItsVolume) {
  Coefficients box = test::boxShip();
  const Bounds wet = bounds(box.ship.wetSurface);
  EXPECT_EQ(Hydrodynamics(box).length(), wet.high.x() - wet.low.x());
  EXPECT_EQ(Hydrodynamics(box).keel(), wet.low.z());
  box.ship.wetSurface = {};
  box.ship.volume = 1000.0;
  EXPECT_DOUBLE_EQ(Hydrodynamics(box).length(), 50.0);  // five times the cube root
  EXPECT_EQ(Hydrodynamics(box).keel(), 0.0);
}

TEST(Hydrodynamics, ThreadsThatAskTogetherGetOneRadiationModel) {
  const Hydrodynamics ship(test::CausalShip().coefficients(0.2, 20.0));
  std::vector<std::shared_ptr<const RadiationModel>> got(4);
  std::vector<std::thread> threads;
  for (auto& model : got) threads.emplace_back([&] { model = ship.radiation(); });
  for (std::thread& thread : threads) thread.join();
  for (const auto& model : got) EXPECT_EQ(model, got.front());
}

// Of them the hull is cut for what its panels lack; the answers are those of forces made anew.
TEST(Hydrodynamics, ForcesOfSingleWavesAreMadeOnceAndAreTheSame) {
  const auto ship = std::make_shared<const Hydrodynamics>(test::tableBox());
  const auto sea = std::make_shared<const SeaState>(test::tableSea(5));
  const SeaTables tables(ship, sea);
  const auto exact = tables.exact(0.1, 2.0);
  const auto following = tables.following().front();
  EXPECT_EQ(&ship->excitation(), &ship->excitation());
  const WaveExcitation anew(ship->coefficients(), ship->form());
  const ExcitationTable table(ship->coefficients(), *sea, ForwardSpeedForm::Tuck);
  EXPECT_EQ(following->error(), table.error());
  for (std::size_t i = 0; i < sea->components().size(); ++i) {
    const WaveComponent& wave = sea->components()[i];
    const auto force = anew.at(wave.omega, wave.heading + 0.1, 2.0);
    EXPECT_EQ(exact->components[i][0], force.froudeKrylov);
    EXPECT_EQ(exact->components[i][1], force.diffraction);
    EXPECT_EQ(following->froudeKrylov(i, 0.4), table.froudeKrylov(i, 0.4));
    EXPECT_EQ(following->diffraction(i, 0.4, 3.0), table.diffraction(i, 0.4, 3.0));
  }
}

// Their loads are 0, on a fixed course and from the table, those of the others as without them.
TEST(SeaTables, WavesBeyondTheDatabaseHaveNoLoadsAndAreSaid) {
  const auto ship = std::make_shared<const Hydrodynamics>(test::tableBox());
  const double last = ship->coefficients().omega.back();
  const auto within = std::make_shared<const SeaState>(test::tableSea(4, 0.5, 1.5));
  const auto known = within->components();
  std::vector<WaveComponent> waves(known.begin(), known.end());
  waves.insert(waves.begin() + 1, {.omega = last * 1.001, .amplitude = 0.1});
  waves.push_back({.omega = 3.0 * last, .amplitude = 0.2});
  const auto sea = std::make_shared<const SeaState>(waves, within->gravity());
  const SeaTables tables(ship, sea), all(ship, within);
  EXPECT_EQ(all.beyond().count, 0U);
  EXPECT_EQ(all.warning(), "");
  EXPECT_EQ(tables.beyond().count, 2U);
  EXPECT_NEAR(tables.beyond().lastOmega, last, 1e-8 * last);
  // Amplitudes 0.1 but for the last, 0.2.
  EXPECT_NEAR(tables.beyond().share, 5.0 / 9.0, 1e-15);
  const std::string said = tables.warning();
  for (const char* words : {"omega_max = ", "2 of 6 waves", "55.6 % of m0"})
    EXPECT_NE(said.find(words), std::string::npos) << said;
  const auto exact = tables.exact(0.3, 2.0), expected = all.exact(0.3, 2.0);
  const auto table = tables.following().front(), other = all.following().front();
  EXPECT_LT(table->error(), 0.01);
  for (std::size_t i = 0; i < waves.size(); ++i) {
    const bool beyond = i == 1 || i == 5;
    const std::size_t of = i == 0 ? 0 : i - 1;
    const CVec6 zero = CVec6::Zero();
    for (std::size_t load = 0; load < 2; ++load)
      EXPECT_EQ(exact->components[i][load], beyond ? zero : expected->components[of][load]) << i;
    EXPECT_EQ(table->froudeKrylov(i, 0.4), beyond ? zero : other->froudeKrylov(of, 0.4));
    EXPECT_EQ(table->diffraction(i, 0.4, 3.0), beyond ? zero : other->diffraction(of, 0.4, 3.0));
  }
}

// All of a sea may be beyond; a regular wave may not, as nothing would be left of it.
TEST(SeaTables, ARegularWaveBeyondTheDatabaseIsRefused) {
  const auto ship = std::make_shared<const Hydrodynamics>(test::tableBox());
  const double last = ship->coefficients().omega.back();
  const auto tablesOf = [&](std::vector<WaveComponent> waves) {
    return SeaTables(ship,
                     std::make_shared<const SeaState>(std::move(waves), ship->ship().gravity));
  };
  const WaveComponent wave{.omega = 1.01 * last, .amplitude = 0.1};
  const SeaTables one = tablesOf({wave}), two = tablesOf({wave, wave});
  EXPECT_EQ(one.warning(), "");
  EXPECT_THROW(one.exact(0.0, 0.0), HydroError);
  EXPECT_THROW(one.following(), HydroError);
  EXPECT_NE(two.warning().find("2 of 2 waves"), std::string::npos);
  EXPECT_EQ(two.following().front()->froudeKrylov(0, 0.0), CVec6::Zero().eval());
  EXPECT_EQ(two.exact(0.0, 0.0)->components[1][0], CVec6::Zero().eval());
}

TEST(SeaTables, NullPointersAreRefused) {
  const auto ship = std::make_shared<const Hydrodynamics>(test::boxShip());
  const auto sea = std::make_shared<const SeaState>();
  EXPECT_THROW(Hydrodynamics(std::shared_ptr<const Coefficients>{}), HydroError);
  EXPECT_THROW(SeaTables(nullptr, sea), HydroError);
  EXPECT_THROW(SeaTables(ship, nullptr), HydroError);
  EXPECT_NO_THROW(SeaTables(ship, sea));
}

// A ship that comes back to a course finds its loads; of many courses the oldest goes.
TEST(SeaTables, ExactForcesOfTheLastCoursesAreKept) {
  const SeaTables tables(std::make_shared<const Hydrodynamics>(test::tableBox()),
                         std::make_shared<const SeaState>(test::tableSea(3)));
  std::weak_ptr<const CourseForces> first = tables.exact(0.1, 2.0);
  EXPECT_EQ(tables.exact(0.1, 2.0), first.lock());
  EXPECT_NE(tables.exact(0.2, 2.0), first.lock());
  EXPECT_EQ(tables.exact(0.1, 2.0)->components.size(), 3u);
  for (std::size_t i = 0; i < SeaCache::kCoursesKept - 1; ++i)
    tables.exact(0.3 + 0.01 * static_cast<double>(i), 2.0);
  EXPECT_FALSE(first.expired());
  tables.exact(1.0, 2.0);
  EXPECT_TRUE(first.expired());
}

TEST(SeaTables, AWaveOutsideTheDatabaseIsRefusedByItsNumber) {
  const SeaTables tables(std::make_shared<const Hydrodynamics>(test::boxShip()),
                         std::make_shared<const SeaState>(
                             std::vector<WaveComponent>{{9.0, 1.0, 0.0, 0.0}}, test::kBoxGravity));
  try {
    tables.exact(0.0, 0.0);
    FAIL();
  } catch (const HydroError& error) {
    EXPECT_NE(std::string(error.what()).find("wave component 0: WaveExcitation: omega = 9 rad/s"),
              std::string::npos);
  }
}

}  // namespace
}  // namespace cutwater
