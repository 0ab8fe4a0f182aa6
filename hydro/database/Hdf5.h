#pragma once
#include <hdf5.h>

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Reading and writing datasets of HDF5 files. Every failure is a HydroError whose message begins
/// with the file's path; HDF5's own messages are silenced. HDF5 is not thread-safe: one thread at a
/// time, even for different files.
namespace cutwater::hdf5 {

/// Owns one HDF5 identifier.
class Handle {
 public:
  using Close = herr_t (*)(hid_t);
  Handle(hid_t id, Close close) noexcept : id_(id), close_(close) {}
  Handle(Handle&& other) noexcept : id_(other.id_), close_(other.close_) { other.id_ = -1; }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  Handle& operator=(Handle&&) = delete;
  ~Handle() { close(); }
  hid_t get() const noexcept { return id_; }
  bool valid() const noexcept { return id_ >= 0; }
  /// @return false if HDF5 could not close it (a full disk shows here).
  bool close() noexcept;

 private:
  hid_t id_;
  Close close_;
};

/// While alive HDF5 prints no errors and loads no filter plugins.
class Quiet {
 public:
  Quiet() noexcept;
  ~Quiet();
  Quiet(const Quiet&) = delete;
  Quiet& operator=(const Quiet&) = delete;

 private:
  H5E_auto2_t print_ = nullptr;
  void* context_ = nullptr;
  unsigned plugins_ = 0;
};

using Shape = std::vector<std::size_t>;

/// Numbers of one dataset, C order.
struct Array {
  Shape shape;
  std::vector<double> data;
};

/// The memory that a file under way lies in; HDF5 calls the functions. H5Fget_file_image would be
/// simpler, but what HDF5 1.10 gives has a superblock whose checksum is wrong.
class FileImage {
 public:
  FileImage() = default;
  FileImage(const FileImage&) = delete;
  FileImage& operator=(const FileImage&) = delete;
  ~FileImage();
  /// Makes files of `access` lie here. @return false if HDF5 refuses.
  bool receive(hid_t access);
  /// Of a file that is closed; empty if there is none.
  std::string_view bytes() const noexcept;

 private:
  static void* resize(void* memory, std::size_t size, H5FD_file_image_op_t op, void* self);
  static herr_t keep(void* memory, H5FD_file_image_op_t op, void* self);
  void* memory_ = nullptr;
  std::size_t size_ = 0;
};

/// A new file, in memory. Groups on the way to a dataset are made as needed.
class Writer {
 public:
  /// @param label  names the file in messages.
  /// @throws HydroError FileNotWritable, also from every member.
  explicit Writer(const std::string& label);
  /// Contiguous little-endian float64.
  void numbers(const std::string& name, const Shape& shape, std::span<const double> data,
               const char* description = nullptr, const char* units = nullptr);
  /// Scalar string of fixed length.
  void text(const std::string& name, const std::string& value);
  void attribute(const std::string& group, const char* name, const std::string& value);
  void attribute(const std::string& group, const char* name, std::int64_t value);
  hid_t file() const noexcept { return file_.get(); }
  /// Closes it. @return its bytes, as they are to stand in a file.
  std::string bytes();

 private:
  void check(bool ok, const std::string& name) const;

  std::string label_;
  Quiet quiet_;
  FileImage image_;
  Handle file_, intermediate_;
};

/// An existing file.
class Reader {
 public:
  /// @throws HydroError FileNotReadable (missing), FileMalformed (not HDF5, truncated).
  explicit Reader(const std::string& path);
  bool has(const std::string& name) const;
  /// @throws HydroError DatabaseIncomplete (missing), FileMalformed (not numbers; declares more
  ///         than the file holds; kept in another file).
  Array numbers(const std::string& name) const;
  std::string text(const std::string& name) const;
  /// True if a dataset holds a string.
  bool isText(const std::string& name) const;
  /// @throws HydroError FileMalformed if missing.
  std::string attributeText(const std::string& group, const char* name) const;
  std::int64_t attributeInteger(const std::string& group, const char* name) const;
  const std::string& path() const noexcept { return path_; }
  hid_t file() const noexcept { return file_.get(); }

 private:
  Handle open(const std::string& name) const;
  Handle openAttribute(const std::string& group, const char* name) const;

  std::string path_;
  Quiet quiet_;
  std::uintmax_t fileSize_ = 0;
  Handle file_;
};

/// Over name, shape and bytes of every dataset, in the order of names; empty if something cannot be
/// read.
std::string contentHash(hid_t file);

}  // namespace cutwater::hdf5
