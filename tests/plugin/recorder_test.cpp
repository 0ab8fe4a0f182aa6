#include "plugin/Recorder.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "tests/plugin/TestScene.h"

namespace cutwater::test {
namespace {

TEST(Recorder, HasARowForEveryTickWhateverTheCalls) {
  Scene scene({.start = {.x = 3, .offset = one(Heave, 1.0)}});
  Recorder recorder(scene.seaway, *scene.sphere, {.forces = true});
  for (int i = 0; i < 3; ++i) scene.world.world.stepSimulation(4 * kTick, 4, kTick);
  ASSERT_EQ(recorder.rows(), 12u);
  ASSERT_EQ(recorder.columns().size(), 14u + 60u);
  EXPECT_EQ(recorder.columns()[14], "gravity_F1");
  EXPECT_EQ(recorder.columns()[55], "supplementary_F6");
  EXPECT_EQ(recorder.columns()[61], "autopilots_F6");
  EXPECT_EQ(recorder.columns()[67], "hull_lift_F6");
  EXPECT_EQ(recorder.columns()[73], "resistance_F6");
  for (std::size_t row = 0; row < 12; ++row) EXPECT_EQ(recorder.at(row, 0), double(row) / 64);
  EXPECT_EQ(recorder.at(0, 1), 3.0);
  EXPECT_NEAR(recorder.at(0, 3), -1.0, kEpsilon);  // z of G, 2 m below calm water at rest
  EXPECT_NEAR(recorder.at(0, 14 + 2), -261800 * kSphereGravity, 1e7 * kEpsilon);
  EXPECT_NEAR(recorder.at(0, 14 + 6 + 2), 261800 * kSphereGravity - 7.695e5, 1e7 * kEpsilon);
}

TEST(Recorder, RefusesWettedColumnsOfAHullThatIsAlwaysAsAtRest) {
  Scene scene;
  ASSERT_FALSE(scene.sphere->wetted());
  EXPECT_THROW(Recorder(scene.seaway, *scene.sphere, {.wetted = true}), HydroError);
}

TEST(Recorder, WritesWholeFilesOrNone) {
  Scene scene({.start = {.x = 3, .offset = one(Heave, 1.0)}});
  Recorder recorder(scene.seaway, *scene.sphere, {.every = 2});
  for (int i = 0; i < 5; ++i) scene.world.world.stepSimulation(kTick, 1, kTick);
  const auto folder = std::filesystem::temp_directory_path();
  const std::string path =
      folder / (kDouble ? "cutwater_recorder_64.csv" : "cutwater_recorder.csv");
  recorder.write(path);
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  EXPECT_EQ(text.str(), recorder.csv());
  EXPECT_EQ(text.str().substr(0, text.str().find('\n')),
            "t,x,y,z,roll_deg,pitch_deg,yaw_deg,u,v,w,p,q,r,wave");
  EXPECT_EQ(recorder.rows(), 3u);
  std::filesystem::remove(path);
  EXPECT_THROW(recorder.write("/nonexistent-folder/run.csv"), HydroError);
}

}  // namespace
}  // namespace cutwater::test
