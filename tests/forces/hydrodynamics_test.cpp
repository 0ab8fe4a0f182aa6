#include "hydro/forces/Hydrodynamics.h"

#include <gtest/gtest.h>

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
                             std::vector<WaveComponent>{{1.0, 1.0, 0.0, 0.0}, {9.0, 1.0, 0.0, 0.0}},
                             test::kBoxGravity));
  try {
    tables.exact(0.0, 0.0);
    FAIL();
  } catch (const HydroError& error) {
    EXPECT_NE(std::string(error.what()).find("wave component 1"), std::string::npos);
  }
}

}  // namespace
}  // namespace cutwater
