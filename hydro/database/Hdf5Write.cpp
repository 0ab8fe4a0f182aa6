#include <fmt/format.h>

#include <cstring>

#include "hydro/Errors.h"
#include "hydro/database/Hdf5.h"

namespace cutwater::hdf5 {

namespace {

/// File format of HDF5 1.8: its metadata carry their own checksums, and every reader of today has
/// it.
Handle accessOf18() {
  Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  H5Pset_libver_bounds(access.get(), H5F_LIBVER_V18, H5F_LIBVER_V18);
  return access;
}

/// Null-terminated, the C_S1 kind that every reader knows.
Handle textType(std::size_t length) {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type.get(), length + 1);
  return type;
}

bool writeTextAttribute(hid_t object, const char* name, const char* value) {
  const Handle type = textType(std::strlen(value));
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  const Handle attribute(
      H5Acreate2(object, name, type.get(), space.get(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  return attribute.valid() && H5Awrite(attribute.get(), type.get(), value) >= 0;
}

}  // namespace

Writer::Writer(const std::string& path, const std::string& label)
    : label_(label),
      file_(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, accessOf18().get()), H5Fclose),
      intermediate_(H5Pcreate(H5P_LINK_CREATE), H5Pclose) {
  if (!file_.valid()) {
    throw HydroError(Fault::FileNotWritable,
                     label + ": cannot be created (is there such a folder, may we write in it?)");
  }
  H5Pset_create_intermediate_group(intermediate_.get(), 1);
}

void Writer::check(bool ok, const std::string& name) const {
  if (!ok) {
    throw HydroError(Fault::FileNotWritable,
                     fmt::format("{}: writing {} failed (disk full?)", label_, name));
  }
}

void Writer::numbers(const std::string& name, const Shape& shape, std::span<const double> data,
                     const char* description, const char* units) {
  const std::vector<hsize_t> extent(shape.begin(), shape.end());
  const Handle space(H5Screate_simple(static_cast<int>(extent.size()), extent.data(), nullptr),
                     H5Sclose);
  const Handle set(H5Dcreate2(file_.get(), name.c_str(), H5T_IEEE_F64LE, space.get(),
                              intermediate_.get(), H5P_DEFAULT, H5P_DEFAULT),
                   H5Dclose);
  check(set.valid(), name);
  check(data.empty() ||
            H5Dwrite(set.get(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, data.data()) >= 0,
        name);
  if (description) check(writeTextAttribute(set.get(), "description", description), name);
  if (units) check(writeTextAttribute(set.get(), "units", units), name);
}

void Writer::text(const std::string& name, const std::string& value) {
  const Handle type = textType(value.size());
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  const Handle set(H5Dcreate2(file_.get(), name.c_str(), type.get(), space.get(),
                              intermediate_.get(), H5P_DEFAULT, H5P_DEFAULT),
                   H5Dclose);
  check(set.valid() &&
            H5Dwrite(set.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, value.c_str()) >= 0,
        name);
}

void Writer::attribute(const std::string& group, const char* name, const std::string& value) {
  const Handle object(H5Oopen(file_.get(), group.c_str(), H5P_DEFAULT), H5Oclose);
  check(object.valid() && writeTextAttribute(object.get(), name, value.c_str()), group);
}

void Writer::attribute(const std::string& group, const char* name, std::int64_t value) {
  const Handle object(H5Oopen(file_.get(), group.c_str(), H5P_DEFAULT), H5Oclose);
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  const Handle attribute(
      H5Acreate2(object.get(), name, H5T_STD_I64LE, space.get(), H5P_DEFAULT, H5P_DEFAULT),
      H5Aclose);
  check(attribute.valid() && H5Awrite(attribute.get(), H5T_NATIVE_INT64, &value) >= 0, group);
}

void Writer::close() {
  check(H5Fflush(file_.get(), H5F_SCOPE_GLOBAL) >= 0 && file_.close(), "the end of the file");
}

}  // namespace cutwater::hdf5
