#include <functional>
#include <set>

#include "hydro/database/CutwaterGroup.h"
#include "tests/database/FileTest.h"
#include "tests/support/Refusal.h"

namespace cutwater::test {
namespace {

/// Names of all datasets below a group.
std::set<std::string> datasets(const std::string& path, const char* group) {
  std::set<std::string> names;
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  const hid_t start = H5Gopen2(file, group, H5P_DEFAULT);
  const auto note = [](hid_t, const char* name, const H5O_info_t* info, void* to) -> herr_t {
    if (info->type == H5O_TYPE_DATASET) static_cast<std::set<std::string>*>(to)->insert(name);
    return 0;
  };
  H5Ovisit(start, H5_INDEX_NAME, H5_ITER_INC, note, &names);
  H5Gclose(start);
  H5Fclose(file);
  return names;
}

using CutwaterGroup = FileTest;

// Format version 7, dataset by dataset. Whoever changes this list raises kFormatVersion, keeps a
// file of the version before in this folder and reads it (old_format_test.cpp) or refuses it.
TEST_F(CutwaterGroup, IsThisListOfDatasets) {
  ASSERT_EQ(kFormatVersion, 7);
  writeCoefficients(sampleShip(), path());
  const std::set<std::string> version7{"added_mass",
                                       "added_mass_inf",
                                       "added_mass_inf_direct",
                                       "added_mass_x",
                                       "added_mass_x_inf",
                                       "added_mass_x_zero",
                                       "added_mass_zero",
                                       "adjoint",
                                       "adjoint_inf",
                                       "adjoint_x",
                                       "adjoint_x_inf",
                                       "adjoint_x_zero",
                                       "adjoint_zero",
                                       "condition_even",
                                       "condition_limit_even",
                                       "condition_limit_odd",
                                       "condition_odd",
                                       "curved_panels",
                                       "damping",
                                       "damping_x",
                                       "diffraction",
                                       "diffraction_table/headings",
                                       "diffraction_table/speeds",
                                       "diffraction_table/values",
                                       "diffraction_table/wave_omega",
                                       "forward_speed",
                                       "froude_krylov",
                                       "headings",
                                       "masked",
                                       "omega",
                                       "provenance/code",
                                       "provenance/mesh_hash",
                                       "provenance/settings",
                                       "provenance/version",
                                       "resolved_omega",
                                       "ship/centre_of_buoyancy",
                                       "ship/cog",
                                       "ship/density",
                                       "ship/engine/astern",
                                       "ship/engine/diameter",
                                       "ship/engine/max_thrust",
                                       "ship/engine/no_thrust_speed",
                                       "ship/engine/place",
                                       "ship/engine/present",
                                       "ship/engine/time_constant",
                                       "ship/file/metres_per_unit",
                                       "ship/file/origin",
                                       "ship/file/rotation",
                                       "ship/gravity",
                                       "ship/gyradii",
                                       "ship/hull/faces",
                                       "ship/hull/vertices",
                                       "ship/mass",
                                       "ship/name",
                                       "ship/resistance/cross_flow_drag",
                                       "ship/resistance/form_factor",
                                       "ship/restoring",
                                       "ship/rudder/area",
                                       "ship/rudder/aspect_ratio",
                                       "ship/rudder/flow_straightening",
                                       "ship/rudder/limit",
                                       "ship/rudder/place",
                                       "ship/rudder/present",
                                       "ship/rudder/rate",
                                       "ship/rudder/slipstream",
                                       "ship/rudder/stall",
                                       "ship/supplementary/damping",
                                       "ship/supplementary/roll_damping_quadratic",
                                       "ship/supplementary/stiffness",
                                       "ship/symmetric",
                                       "ship/volume",
                                       "ship/wet_surface/faces",
                                       "ship/wet_surface/vertices",
                                       "stability/ahead",
                                       "stability/astern",
                                       "stability/checked_to",
                                       "stability/course",
                                       "status",
                                       "unfinished_because",
                                       "wave_omega"};
  EXPECT_EQ(datasets(path(), "cutwater"), version7);
}

// "auto" is absent in the file, too, and so is an engine that a ship was not given.
TEST_F(CutwaterGroup, WhatAShipWasNotGivenIsNotThereWhenRead) {
  Coefficients c = sampleShip();
  c.ship.engine.reset();
  c.ship.rudder = RudderParticulars{};
  writeCoefficients(c, path());
  const ShipParticulars back = readCoefficients(path()).ship;
  EXPECT_FALSE(back.engine);
  ASSERT_TRUE(back.rudder);
  EXPECT_FALSE(back.rudder->area);
}

TEST(CheckCoefficients, NamesWhatIsNotFinite) {
  Coefficients c = sampleShip();
  EXPECT_NO_THROW(checkCoefficients(c, "here"));
  c.dampingX[1](2, 3) = HUGE_VAL;
  try {
    checkFinite(c, "here");
    FAIL();
  } catch (const HydroError& error) {
    EXPECT_EQ(error.fault(), Fault::ValueOutOfRange);
    EXPECT_EQ(std::string(error.what()).find("here: damping_x"), 0u) << error.what();
  }
}

// A file's axes are a rotation and a scale.
TEST(CheckCoefficients, RefusesAPlacementThatNoFileHas) {
  struct Case {
    std::function<void(FilePlacement&)> spoil;
    const char* says;
  };
  const Case cases[] = {
      {[](auto& f) { f.rotation.row(1) *= -1.0; },
       "ship/file/rotation is no rotation: its axes are mirrored"},
      {[](auto& f) { f.rotation *= 1.01; }, "not of length 1"},
      {[](auto& f) { f.rotation(0, 1) += 0.1; }, "not at right angles"},
      {[](auto& f) { f.rotation(2, 2) = std::nan(""); }, "ship/file/rotation[2, 2] is nan"},
      {[](auto& f) { f.metresPerUnit = 0.0; }, "ship/file/metres_per_unit = 0"},
      {[](auto& f) { f.metresPerUnit = -1.0; }, "ship/file/metres_per_unit = -1"},
      {[](auto& f) { f.origin.y() = HUGE_VAL; }, "ship/file/origin[1] is inf"}};
  for (const Case& c : cases) {
    Coefficients ship = sampleShip();
    c.spoil(ship.ship.file);
    try {
      checkCoefficients(ship, "here");
      ADD_FAILURE() << c.says;
    } catch (const HydroError& error) {
      EXPECT_EQ(error.fault(), Fault::ValueOutOfRange);
      EXPECT_NE(std::string(error.what()).find(c.says), std::string::npos) << error.what();
    }
  }
}

// What ship.toml refuses, a database refuses: one rule.
TEST(CheckCoefficients, RefusesAnEngineOrARudderThatNoShipHas) {
  struct Case {
    std::function<void(ShipParticulars&)> spoil;
    const char* says;
  };
  const Case cases[] = {
      {[](auto& s) { s.drag.crossFlow = -0.1; }, "here: [resistance] cross_flow_drag = -0.1: must"},
      {[](auto& s) { s.drag.formFactor = 101.0; }, "form_factor = 101: must be in 0..100"},
      {[](auto& s) { s.engine->maxThrust = -1.0; }, "[engine] max_thrust = -1"},
      {[](auto& s) { s.engine->astern = 1.1; }, "[engine] astern = 1.1: must be in 0..1"},
      {[](auto& s) { s.engine->noThrustSpeed = 0.0; }, "no_thrust_speed = 0"},
      {[](auto& s) { s.engine->timeConstant = -2.0; }, "time_constant = -2"},
      {[](auto& s) { s.engine->diameter = 0.0; }, "diameter = 0"},
      {[](auto& s) { s.engine->place = Vec3(0.0, -1e7, 0.0); }, "[engine] place = 1e+07"},
      {[](auto& s) { s.rudder->area = 0.0; }, "[rudder] area = 0"},
      {[](auto& s) { s.rudder->limit = 35.0; }, "limit_deg = 2005"},
      {[](auto& s) { s.rudder->rate = 0.0; }, "rate_deg = 0"},
      {[](auto& s) { s.rudder->stall = 0.0; }, "stall_deg = 0"},
      {[](auto& s) { s.rudder->slipstream = 1.5; }, "slipstream = 1.5"},
      {[](auto& s) { s.rudder->flowStraightening = 0.0; }, "flow_straightening = 0"},
      {[](auto& s) { s.rudder->aspectRatio = std::nan(""); }, "ship/rudder/aspect_ratio is nan"},
      {[](auto& s) { s.engine->diameter = HUGE_VAL; }, "ship/engine/diameter is inf"}};
  for (const Case& c : cases) {
    Coefficients ship = sampleShip();
    c.spoil(ship.ship);
    test::expectRefusal(Fault::ValueOutOfRange, {"here: ", c.says},
                        [&] { checkCoefficients(ship, "here"); });
  }
}

}  // namespace
}  // namespace cutwater::test
