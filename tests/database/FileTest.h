#pragma once
#include <gtest/gtest.h>
#include <hdf5.h>
#include <unistd.h>

#include <filesystem>
#include <string>
#include <vector>

#include "hydro/Errors.h"
#include "hydro/database/CoefficientsFile.h"
#include "hydro/database/Hdf5.h"
#include "tests/database/SampleShip.h"

namespace cutwater::test {

/// A folder of the test's own, removed at its end.
class FileTest : public testing::Test {
 protected:
  FileTest() {
    std::string name = (std::filesystem::temp_directory_path() / "cutwater_test_XXXXXX").string();
    folder_ = ::mkdtemp(name.data());
  }
  ~FileTest() override { std::filesystem::remove_all(folder_); }
  std::string path(const std::string& name = "ship.h5") const { return (folder_ / name).string(); }
  std::size_t files() const {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder_),
                                                  std::filesystem::directory_iterator()));
  }
  /// The fault that reading raises; its message must be one line that names the file.
  Fault faultOf(const std::string& file) const {
    try {
      readCoefficients(file);
    } catch (const HydroError& error) {
      const std::string what = error.what();
      EXPECT_EQ(what.find(file), 0u) << what;
      EXPECT_EQ(what.find('\n'), std::string::npos) << what;
      return error.fault();
    }
    ADD_FAILURE() << file << " was accepted";
    return Fault::BadArgument;
  }
  std::filesystem::path folder_;
};

/// Removes or changes things in a file as another program would.
class Edit {
 public:
  explicit Edit(const std::string& path)
      : file_(H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT)) {}
  Edit(const Edit&) = delete;
  Edit& operator=(const Edit&) = delete;
  ~Edit() { H5Fclose(file_); }
  void remove(const char* name) { EXPECT_GE(H5Ldelete(file_, name, H5P_DEFAULT), 0) << name; }
  void set(const char* name, double value) {  // every number of a dataset
    const hid_t set = H5Dopen2(file_, name, H5P_DEFAULT), space = H5Dget_space(set);
    const std::vector<double> data(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)),
                                   value);
    EXPECT_GE(H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, data.data()), 0);
    H5Sclose(space);
    H5Dclose(set);
  }
  void newNumbers(const char* name, std::vector<hsize_t> shape, double value) {
    const hid_t space = H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr);
    const hid_t set =
        H5Dcreate2(file_, name, H5T_IEEE_F64LE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    H5Dclose(set);
    H5Sclose(space);
    if (value != 0.0) this->set(name, value);
  }
  void version(std::int64_t value) {
    const hid_t group = H5Gopen2(file_, "cutwater", H5P_DEFAULT);
    const hid_t attribute = H5Aopen(group, "format_version", H5P_DEFAULT);
    EXPECT_GE(H5Awrite(attribute, H5T_NATIVE_INT64, &value), 0);
    H5Aclose(attribute);
    H5Gclose(group);
  }
  /// As if the file had been written so.
  void renewChecksum() {
    const std::string sum = hdf5::contentHash(file_);
    const hid_t group = H5Gopen2(file_, "cutwater", H5P_DEFAULT);
    const hid_t attribute = H5Aopen(group, "checksum", H5P_DEFAULT), type = H5Aget_type(attribute);
    EXPECT_EQ(H5Tget_size(type), sum.size() + 1);  // and the zero
    EXPECT_GE(H5Awrite(attribute, type, sum.c_str()), 0);
    H5Tclose(type);
    H5Aclose(attribute);
    H5Gclose(group);
  }

 private:
  hid_t file_;
};

}  // namespace cutwater::test
