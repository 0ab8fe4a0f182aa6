#include "hydro/database/SweepJournal.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "hydro/Errors.h"
#include "hydro/base/AtomicFile.h"
#include "hydro/base/Fnv1a.h"

namespace cutwater {
namespace {

struct Header {
  char magic[16] = {'c', 'u', 't', 'w', 'a', 't', 'e', 'r', ' ', 's', 'w', 'e', 'e', 'p', ' ', '1'};
  std::uint64_t key = 0, size = 0;
};

std::uint64_t checksum(std::uint64_t index, std::span<const double> numbers) {
  Fnv1a hash;
  hash.add(&index, sizeof index);
  hash.add(numbers.data(), numbers.size_bytes());
  return hash.value();
}

/// As many bytes as there are.
std::size_t readSome(int file, void* to, std::size_t bytes) {
  std::size_t done = 0;
  while (done < bytes) {
    const ssize_t got = ::read(file, static_cast<char*>(to) + done, bytes - done);
    if (got <= 0) break;
    done += static_cast<std::size_t>(got);
  }
  return done;
}

bool readAll(int file, void* to, std::size_t bytes) { return readSome(file, to, bytes) == bytes; }

/// Key of the journal at `path`; 0 if there is none, or not yet its whole head.
std::uint64_t keyOf(const std::string& path) {
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
  if (file < 0) return 0;
  Header header;
  const Header wanted;
  const bool whole = readAll(file, &header, sizeof header) &&
                     std::memcmp(header.magic, wanted.magic, sizeof header.magic) == 0;
  ::close(file);
  return whole ? header.key : 0;
}

std::string asidePath(const std::string& path, std::uint64_t key) {
  char digits[18];
  std::snprintf(digits, sizeof digits, ".%016llx", static_cast<unsigned long long>(key));
  return path + digits;
}

}  // namespace

SweepJournal::SweepJournal(const std::string& path, std::uint64_t key, std::size_t size)
    : path_(path), size_(size) {
  makeWayFor(key);
  open();
  try {
    load(key);
  } catch (...) {
    ::close(file_);
    throw;
  }
}

SweepJournal::~SweepJournal() { ::close(file_); }

void SweepJournal::refuse(const char* why) const {
  throw HydroError(Fault::FileNotWritable, path_ + ": cannot be written: " + why);
}

void SweepJournal::put(std::string_view bytes) const {
  if (const int error = writeAll(file_, bytes); error != 0) refuse(std::strerror(error));
}

/// A link is not followed and a pipe not waited for: its name can be foreseen by anybody.
void SweepJournal::open() {
  file_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK, 0666);
  if (file_ < 0) refuse(errno == ELOOP ? "it is a link" : std::strerror(errno));
  struct stat there {};
  const char* why = nullptr;
  if (::fstat(file_, &there) != 0 || !S_ISREG(there.st_mode)) why = "not a file";
  if (why == nullptr && ::flock(file_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
    why = "another program is solving into it";
  if (why == nullptr) return;
  ::close(file_);
  refuse(why);
}

/// Whole journals of other keys step aside; one of this key that did so before comes back.
void SweepJournal::makeWayFor(std::uint64_t key) {
  const std::uint64_t other = keyOf(path_);
  if (other == key) return;
  if (other != 0) {
    open();  // nobody is at work on it
    ::close(file_);
    if (std::rename(path_.c_str(), asidePath(path_, other).c_str()) != 0)
      refuse(std::strerror(errno));
  }
  const std::string before = asidePath(path_, key);
  std::error_code none;
  if (!std::filesystem::exists(path_, none) && keyOf(before) == key)
    std::filesystem::rename(before, path_, none);
}

/// Reads whole records and leaves the file at their end, what follows cut off.
void SweepJournal::load(std::uint64_t key) {
  Header header, wanted;
  wanted.key = key;
  wanted.size = size_;
  const std::size_t got = readSome(file_, &header, sizeof header);
  if (std::memcmp(header.magic, wanted.magic, std::min(got, sizeof header.magic)) != 0)
    throw HydroError(Fault::FileMalformed,
                     path_ + ": not the journal of a sweep; move it out of the way");
  off_t end = sizeof header;
  if (got < sizeof header || header.key != key || header.size != size_) {
    if (::ftruncate(file_, 0) != 0 || ::lseek(file_, 0, SEEK_SET) != 0)
      refuse(std::strerror(errno));
    put({reinterpret_cast<const char*>(&wanted), sizeof wanted});
    return;
  }
  std::uint64_t index = 0, sum = 0;
  std::vector<double> numbers(size_);
  while (readAll(file_, &index, sizeof index) &&
         readAll(file_, numbers.data(), numbers.size() * sizeof(double)) &&
         readAll(file_, &sum, sizeof sum) && sum == checksum(index, numbers)) {
    found_[index] = numbers;
    end = ::lseek(file_, 0, SEEK_CUR);
  }
  if (::ftruncate(file_, end) != 0 || ::lseek(file_, end, SEEK_SET) != end)
    refuse(std::strerror(errno));
}

void SweepJournal::append(std::uint64_t index, std::span<const double> numbers) {
  const std::uint64_t sum = checksum(index, numbers);
  std::string record(sizeof index + numbers.size_bytes() + sizeof sum, '\0');
  std::memcpy(record.data(), &index, sizeof index);
  std::memcpy(record.data() + sizeof index, numbers.data(), numbers.size_bytes());
  std::memcpy(record.data() + sizeof index + numbers.size_bytes(), &sum, sizeof sum);
  put(record);
}

}  // namespace cutwater
