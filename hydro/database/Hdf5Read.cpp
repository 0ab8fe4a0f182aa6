#include <fmt/format.h>

#include <filesystem>
#include <fstream>

#include "hydro/Errors.h"
#include "hydro/database/Hdf5.h"

namespace cutwater::hdf5 {

namespace {

constexpr std::uintmax_t kGreatestCompression = 1100;  // of deflate, HDF5's usual filter
constexpr std::size_t kLongestText = 1u << 24;

std::uintmax_t checkedSize(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) {
    throw HydroError(Fault::FileNotReadable, path + ": no such file");
  }
  if (!std::ifstream(path, std::ios::binary)) {
    throw HydroError(Fault::FileNotReadable, path + ": no permission to read it");
  }
  return std::filesystem::file_size(path, error);
}

}  // namespace

Reader::Reader(const std::string& path)
    : path_(path),
      fileSize_(checkedSize(path)),
      file_(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose) {
  if (!file_.valid()) {
    throw HydroError(Fault::FileMalformed,
                     path + ": not an HDF5 file, or a truncated or damaged one");
  }
}

bool Reader::has(const std::string& name) const {
  for (std::size_t end = name.find('/', 1);; end = name.find('/', end + 1)) {
    if (H5Lexists(file_.get(), name.substr(0, end).c_str(), H5P_DEFAULT) <= 0) return false;
    if (end == std::string::npos) return true;
  }
}

Handle Reader::open(const std::string& name) const {
  if (!has(name)) {
    throw HydroError(Fault::DatabaseIncomplete, fmt::format("{}: {} is missing", path_, name));
  }
  Handle set(H5Dopen2(file_.get(), name.c_str(), H5P_DEFAULT), H5Dclose);
  if (!set.valid()) {
    throw HydroError(Fault::FileMalformed, fmt::format("{}: {} is damaged", path_, name));
  }
  return set;
}

bool Reader::isText(const std::string& name) const {
  const Handle set = open(name);
  const Handle type(H5Dget_type(set.get()), H5Tclose);
  return H5Tget_class(type.get()) == H5T_STRING;
}

Array Reader::numbers(const std::string& name) const {
  const Handle set = open(name);
  const auto refuse = [&](const char* what) {
    throw HydroError(Fault::FileMalformed, fmt::format("{}: {} {}", path_, name, what));
  };
  const Handle type(H5Dget_type(set.get()), H5Tclose);
  const H5T_class_t kind = H5Tget_class(type.get());
  if (kind != H5T_FLOAT && kind != H5T_INTEGER) refuse("does not hold numbers");
  const Handle creation(H5Dget_create_plist(set.get()), H5Pclose);
  if (H5Pget_external_count(creation.get()) != 0) refuse("is kept in another file");
  const Handle space(H5Dget_space(set.get()), H5Sclose);
  hsize_t extent[H5S_MAX_RANK] = {};
  const int rank = H5Sget_simple_extent_dims(space.get(), extent, nullptr);
  const hssize_t count = H5Sget_simple_extent_npoints(space.get());
  if (rank < 0 || count < 0) refuse("is damaged");
  // Before anything is allocated: what is declared must be in the file.
  const bool chunked = H5Pget_layout(creation.get()) == H5D_CHUNKED;
  const std::uintmax_t most = fileSize_ * (chunked ? kGreatestCompression : 1);
  if (static_cast<std::uintmax_t>(count) > most / H5Tget_size(type.get())) {
    refuse("declares more numbers than the file can hold");
  }
  Array array{Shape(extent, extent + rank), std::vector<double>(static_cast<std::size_t>(count))};
  if (count > 0 &&
      H5Dread(set.get(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, array.data.data()) < 0) {
    refuse("cannot be read (damaged?)");
  }
  return array;
}

std::string Reader::text(const std::string& name) const {
  const Handle set = open(name);
  const Handle type(H5Dget_type(set.get()), H5Tclose);
  const Handle space(H5Dget_space(set.get()), H5Sclose);
  const std::size_t size = H5Tget_size(type.get());
  if (H5Tget_class(type.get()) != H5T_STRING || H5Sget_simple_extent_npoints(space.get()) != 1 ||
      size > kLongestText) {
    throw HydroError(Fault::FileMalformed, fmt::format("{}: {} is not one text", path_, name));
  }
  const auto failed = [&] {
    return HydroError(Fault::FileMalformed, fmt::format("{}: {} cannot be read", path_, name));
  };
  if (H5Tis_variable_str(type.get()) > 0) {
    char* found = nullptr;
    if (H5Dread(set.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, &found) < 0) throw failed();
    const std::string value(found ? found : "");
    H5free_memory(found);
    return value;
  }
  std::string value(size, '\0');
  if (H5Dread(set.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, value.data()) < 0) {
    throw failed();
  }
  value.resize(std::min(value.find('\0'), value.size()));
  return value;
}

Handle Reader::openAttribute(const std::string& group, const char* name) const {
  Handle attribute(H5Aopen_by_name(file_.get(), group.c_str(), name, H5P_DEFAULT, H5P_DEFAULT),
                   H5Aclose);
  if (!attribute.valid()) {
    throw HydroError(Fault::FileMalformed,
                     fmt::format("{}: attribute {} of {} is missing", path_, name, group));
  }
  return attribute;
}

std::string Reader::attributeText(const std::string& group, const char* name) const {
  const Handle attribute = openAttribute(group, name);
  const Handle type(H5Aget_type(attribute.get()), H5Tclose);
  const std::size_t size = H5Tget_size(type.get());
  const bool plain = H5Tget_class(type.get()) == H5T_STRING && H5Tis_variable_str(type.get()) == 0;
  std::string value(plain && size <= 4096 ? size : 0, '\0');
  if (value.empty() || H5Aread(attribute.get(), type.get(), value.data()) < 0) {
    throw HydroError(Fault::FileMalformed,
                     fmt::format("{}: attribute {} of {} is not a text", path_, name, group));
  }
  value.resize(std::min(value.find('\0'), value.size()));
  return value;
}

std::int64_t Reader::attributeInteger(const std::string& group, const char* name) const {
  const Handle attribute = openAttribute(group, name);
  const Handle space(H5Aget_space(attribute.get()), H5Sclose);
  std::int64_t value = 0;
  if (H5Sget_simple_extent_npoints(space.get()) != 1 ||
      H5Aread(attribute.get(), H5T_NATIVE_INT64, &value) < 0) {
    throw HydroError(Fault::FileMalformed,
                     fmt::format("{}: attribute {} of {} is not an integer", path_, name, group));
  }
  return value;
}

}  // namespace cutwater::hdf5
