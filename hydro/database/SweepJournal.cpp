#include "hydro/database/SweepJournal.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "hydro/Errors.h"
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

bool writeAll(int file, const void* from, std::size_t bytes) {
  const auto* at = static_cast<const char*>(from);
  while (bytes > 0) {
    const ssize_t put = ::write(file, at, bytes);
    if (put <= 0) return false;
    at += put;
    bytes -= static_cast<std::size_t>(put);
  }
  return true;
}

}  // namespace

SweepJournal::SweepJournal(const std::string& path, std::uint64_t key, std::size_t size)
    : path_(path), size_(size), file_(::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666)) {
  if (file_ < 0) refuse(std::strerror(errno));
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
    if (::ftruncate(file_, 0) != 0 || ::lseek(file_, 0, SEEK_SET) != 0 ||
        !writeAll(file_, &wanted, sizeof wanted))
      refuse(std::strerror(errno));
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
  if (!writeAll(file_, record.data(), record.size())) refuse(std::strerror(errno));
}

}  // namespace cutwater
