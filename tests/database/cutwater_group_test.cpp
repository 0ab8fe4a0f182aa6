#include <set>

#include "hydro/database/CutwaterGroup.h"
#include "tests/database/FileTest.h"

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

// Format version 5, dataset by dataset. Whoever changes this list raises kFormatVersion, keeps a
// file of the version before in this folder and reads it (old_format_test.cpp) or refuses it.
TEST_F(CutwaterGroup, IsThisListOfDatasets) {
  ASSERT_EQ(kFormatVersion, 5);
  writeCoefficients(sampleShip(), path());
  const std::set<std::string> version5{"added_mass",
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
                                       "ship/gravity",
                                       "ship/gyradii",
                                       "ship/hull/faces",
                                       "ship/hull/vertices",
                                       "ship/mass",
                                       "ship/name",
                                       "ship/restoring",
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
  EXPECT_EQ(datasets(path(), "cutwater"), version5);
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

}  // namespace
}  // namespace cutwater::test
