#include "hydro/database/Hdf5.h"

#include <fmt/format.h>

#include "hydro/base/Fnv1a.h"

namespace cutwater::hdf5 {

bool Handle::close() noexcept {
  if (id_ < 0) return true;
  const bool ok = close_(id_) >= 0;
  id_ = -1;
  return ok;
}

Quiet::Quiet() noexcept {
  H5Eget_auto2(H5E_DEFAULT, &print_, &context_);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  H5PLget_loading_state(&plugins_);
  H5PLset_loading_state(0);  // a file must not make us load code
}

Quiet::~Quiet() {
  H5PLset_loading_state(plugins_);
  H5Eset_auto2(H5E_DEFAULT, print_, context_);
}

namespace {

herr_t collect(hid_t, const char* name, const H5L_info_t*, void* names) {
  try {
    static_cast<std::vector<std::string>*>(names)->emplace_back(name);
  } catch (...) {
    return -1;
  }
  return 0;
}

/// Adds one object; groups count by their names alone.
bool addObject(hid_t file, const std::string& name, Fnv1a& hash) {
  hash.add(name.c_str(), name.size() + 1);
  const Handle object(H5Oopen(file, name.c_str(), H5P_DEFAULT), H5Oclose);
  if (!object.valid()) return false;
  if (H5Iget_type(object.get()) != H5I_DATASET) return true;
  const Handle type(H5Dget_type(object.get()), H5Tclose);
  const Handle space(H5Dget_space(object.get()), H5Sclose);
  const hssize_t count = H5Sget_simple_extent_npoints(space.get());
  if (count < 0 || H5Tis_variable_str(type.get()) > 0) return false;
  const std::size_t bytes = static_cast<std::size_t>(count) * H5Tget_size(type.get());
  if (bytes != H5Dget_storage_size(object.get())) return false;  // ours are contiguous
  std::vector<unsigned char> data(bytes);
  if (bytes > 0 &&
      H5Dread(object.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, data.data()) < 0) {
    return false;
  }
  hsize_t shape[H5S_MAX_RANK] = {};
  const int rank = H5Sget_simple_extent_dims(space.get(), shape, nullptr);
  for (int i = 0; i < rank; ++i) hash.add(&shape[i], sizeof(hsize_t));
  hash.add(data.data(), bytes);
  return true;
}

}  // namespace

std::string contentHash(hid_t file) {
  std::vector<std::string> names;
  if (H5Lvisit(file, H5_INDEX_NAME, H5_ITER_INC, collect, &names) < 0) return {};
  Fnv1a hash;
  for (const std::string& name : names) {
    if (!addObject(file, name, hash)) return {};
  }
  return hash.digits();
}

}  // namespace cutwater::hdf5
