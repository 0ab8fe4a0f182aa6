#include "hydro/base/AtomicFile.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <random>

#include "hydro/Errors.h"

namespace cutwater {

int writeAll(int file, std::string_view bytes) noexcept {
  while (!bytes.empty()) {
    const ssize_t put = ::write(file, bytes.data(), bytes.size());
    if (put < 0 && errno == EINTR) continue;
    if (put <= 0) return put < 0 ? errno : EIO;
    bytes.remove_prefix(static_cast<std::size_t>(put));
  }
  return 0;
}

namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const std::string& path, const std::string& why) {
  throw HydroError(Fault::FileNotWritable, path + ": cannot be written: " + why);
}
[[noreturn]] void refuse(const std::string& path, int error) { refuse(path, std::strerror(error)); }

/// Where a file really is, and what is there now.
struct Target {
  std::string path;       ///< without links
  bool exists = false;    ///< as a regular file
  bool isStream = false;  ///< a pipe or a character device
  mode_t mode = 0;        ///< of what exists
  std::string folder() const {
    const fs::path parent = fs::path(path).parent_path();
    return parent.empty() ? "." : parent.string();
  }
};

/// @throws HydroError for what may not be written. Looks at the mode as well as at the rights,
/// because root may write what is marked as not to be written.
Target targetOf(const std::string& path) {
  struct stat there {};
  if (path.empty()) refuse("\"\"", "a file without a name");
  if (::stat(path.c_str(), &there) != 0) {
    if (errno != ENOENT) refuse(path, errno);
    struct stat link {};
    if (::lstat(path.c_str(), &link) == 0) refuse(path, "a link to a file that is not there");
    return {.path = path};
  }
  if (S_ISDIR(there.st_mode)) refuse(path, EISDIR);
  if (S_ISFIFO(there.st_mode) || S_ISCHR(there.st_mode)) return {.path = path, .isStream = true};
  if (!S_ISREG(there.st_mode)) refuse(path, "neither a file nor a pipe");
  const mode_t writable = S_IWUSR | S_IWGRP | S_IWOTH;
  if ((there.st_mode & writable) == 0) refuse(path, "the file is read-only");
  if (::faccessat(AT_FDCWD, path.c_str(), W_OK, AT_EACCESS) != 0) refuse(path, errno);
  std::error_code error;
  const fs::path real = fs::canonical(path, error);
  if (error) refuse(path, error.message());
  return {.path = real.string(), .exists = true, .mode = there.st_mode & 0777};
}

/// What cannot be synced (EINVAL) is no file on a disk.
int syncAndClose(int file) {
  int error = ::fsync(file) == 0 || errno == EINVAL ? 0 : errno;
  if (::close(file) != 0 && error == 0) error = errno;
  return error;
}

/// A new file beside `target` that nobody could foresee: an existing one or a link is not opened.
class TemporaryFile {
 public:
  explicit TemporaryFile(const Target& target) {
    std::random_device random;
    for (int attempt = 0; file_ < 0 && attempt < 100; ++attempt) {
      name_ = target.path + "." + std::to_string(random()) + ".tmp";
      file_ = ::open(name_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
      if (file_ < 0 && errno != EEXIST) break;
    }
    error_ = file_ < 0 ? errno : 0;
    if (file_ < 0) name_.clear();
    if (file_ >= 0 && target.exists && ::fchmod(file_, target.mode) != 0) error_ = errno;
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    if (file_ >= 0) ::close(file_);
    if (!name_.empty()) ::unlink(name_.c_str());
  }
  int error() const noexcept { return error_; }
  /// 0, or the error.
  int become(const std::string& path, std::string_view text) {
    int error = writeAll(file_, text);
    const int closing = syncAndClose(file_);
    file_ = -1;
    if (error == 0) error = closing;
    if (error == 0 && ::rename(name_.c_str(), path.c_str()) != 0) error = errno;
    if (error == 0) name_.clear();
    return error;
  }

 private:
  std::string name_;
  int file_ = -1, error_ = 0;
};

void writeStream(const std::string& path, std::string_view text) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
  if (file < 0) refuse(path, errno);
  int error = writeAll(file, text);
  if (::close(file) != 0 && error == 0) error = errno;
  if (error != 0) refuse(path, error);
}

}  // namespace

void writeWhole(const std::string& path, std::string_view text) {
  const Target target = targetOf(path);
  if (target.isStream) return writeStream(path, text);
  TemporaryFile temporary(target);
  int error = temporary.error();
  if (error == 0) error = temporary.become(target.path, text);
  if (error != 0) refuse(path, error);
}

void requireWritable(const std::string& path) {
  const Target target = targetOf(path);
  const std::string place = target.isStream ? path : target.folder();
  const int rights = target.isStream ? W_OK : W_OK | X_OK;
  if (::faccessat(AT_FDCWD, place.c_str(), rights, AT_EACCESS) != 0)
    refuse(path, errno == ENOENT ? "there is no folder " + place : std::strerror(errno));
}

void requireRegular(const std::string& path) {
  requireWritable(path);
  if (targetOf(path).isStream) refuse(path, "a pipe or a device, not a file");
}

}  // namespace cutwater
