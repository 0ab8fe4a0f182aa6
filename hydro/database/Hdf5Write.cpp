#include <fmt/format.h>

#include <cstdlib>
#include <cstring>
#include <utility>

#include "hydro/Errors.h"
#include "hydro/database/Hdf5.h"

namespace cutwater::hdf5 {

namespace {

/// In memory, growing by megabytes. File format of HDF5 1.8: its metadata carry their own
/// checksums, and every reader of today has it.
Handle accessOf18(FileImage& image) {
  Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  H5Pset_fapl_core(access.get(), std::size_t{1} << 22, 0);
  image.receive(access.get());
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

Writer::Writer(const std::string& label)
    : label_(label),
      file_(H5Fcreate(label.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, accessOf18(image_).get()),
            H5Fclose),
      intermediate_(H5Pcreate(H5P_LINK_CREATE), H5Pclose) {
  if (!file_.valid()) {
    throw HydroError(Fault::FileNotWritable, label + ": cannot be made: not enough memory?");
  }
  H5Pset_create_intermediate_group(intermediate_.get(), 1);
}

void Writer::check(bool ok, const std::string& name) const {
  if (!ok) {
    throw HydroError(Fault::FileNotWritable,
                     fmt::format("{}: cannot be made: {}: not enough memory?", label_, name));
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

std::string Writer::bytes() {
  check(H5Fflush(file_.get(), H5F_SCOPE_GLOBAL) >= 0 && file_.close(), "the end of the file");
  const std::string_view image = image_.bytes();
  check(!image.empty(), "the end of the file");
  return std::string(image);
}

// The memory ends at some whole number of megabytes, the file where its superblock says. That has
// version 2 (accessOf18): the signature, the version at byte 8, the end of the file at byte 28.
std::string_view FileImage::bytes() const noexcept {
  constexpr std::size_t kVersionAt = 8, kEndAt = 28, kHead = 48;
  const auto* at = static_cast<const unsigned char*>(memory_);
  if (at == nullptr || size_ < kHead || at[kVersionAt] != 2) return {};
  std::size_t end = 0;
  for (std::size_t i = 8; i-- > 0;) end = end << 8 | at[kEndAt + i];
  if (end > size_) return {};
  return {static_cast<const char*>(memory_), end};
}

// HDF5 would copy the functions' argument for each of its own copies of `access`; it is the same
// object for all of them.
bool FileImage::receive(hid_t access) {
  H5FD_file_image_callbacks_t callbacks{};
  callbacks.image_malloc = [](std::size_t size, H5FD_file_image_op_t, void*) {
    return std::malloc(size);
  };
  callbacks.image_memcpy = [](void* to, const void* from, std::size_t size, H5FD_file_image_op_t,
                              void*) { return std::memcpy(to, from, size); };
  callbacks.image_realloc = resize;
  callbacks.image_free = keep;
  callbacks.udata_copy = [](void* self) { return self; };
  callbacks.udata_free = [](void*) -> herr_t { return 0; };
  callbacks.udata = this;
  return H5Pset_file_image_callbacks(access, &callbacks) >= 0;
}

FileImage::~FileImage() { std::free(memory_); }

void* FileImage::resize(void* memory, std::size_t size, H5FD_file_image_op_t, void* self) {
  static_cast<FileImage*>(self)->size_ = size;
  return std::realloc(memory, size);
}

/// The memory of a file that is closed is ours from then on.
herr_t FileImage::keep(void* memory, H5FD_file_image_op_t op, void* self) {
  if (op == H5FD_FILE_IMAGE_OP_FILE_CLOSE) {
    std::swap(static_cast<FileImage*>(self)->memory_, memory);
  }
  std::free(memory);
  return 0;
}

}  // namespace cutwater::hdf5
