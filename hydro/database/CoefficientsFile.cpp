#include "hydro/database/CoefficientsFile.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

#include "hydro/Errors.h"
#include "hydro/database/BemioLayout.h"
#include "hydro/database/CutwaterGroup.h"

namespace cutwater {

namespace {

constexpr const char* kGroup = "cutwater";
constexpr const char* kVersion = "format_version";
constexpr const char* kChecksum = "checksum";

/// A name beside the final one; the file is removed unless it was moved there.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& path)
      : final_(path), name_(fmt::format("{}.{}.tmp", path, ::getpid())) {}
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    if (!moved_) std::remove(name_.c_str());
  }
  const std::string& name() const noexcept { return name_; }
  void moveIntoPlace() {
    const int file = ::open(name_.c_str(), O_RDONLY | O_CLOEXEC);
    const bool synced = file >= 0 && ::fsync(file) == 0;
    if (file >= 0) ::close(file);
    if (!synced || std::rename(name_.c_str(), final_.c_str()) != 0) {
      throw HydroError(Fault::FileNotWritable, final_ + ": cannot be put in place");
    }
    moved_ = true;
  }

 private:
  std::string final_, name_;
  bool moved_ = false;
};

Coefficients readOwn(const hdf5::Reader& reader) {
  const std::int64_t version = reader.attributeInteger(kGroup, kVersion);
  if (version > kFormatVersion) {
    throw HydroError(Fault::VersionNotSupported,
                     fmt::format("{}: format version {}, written by a newer Cutwater; this one "
                                 "reads up to {}",
                                 reader.path(), version, kFormatVersion));
  }
  const std::string written = reader.attributeText(kGroup, kChecksum);
  const std::string found = hdf5::contentHash(reader.file());
  if (version < 1 || found != written) {
    throw HydroError(Fault::FileMalformed,
                     fmt::format("{}: damaged or changed since it was written (checksum {}, {} "
                                 "expected)",
                                 reader.path(), found.empty() ? "unreadable" : found, written));
  }
  return readCutwaterGroup(reader);
}

std::string joinedWarning(const std::string& path, const Coefficients& c,
                          const std::vector<std::string>& missing) {
  return fmt::format("{}: plain BEMIO file ({}), for zero speed only; {}", path, c.provenance.code,
                     fmt::join(missing, "; "));
}

}  // namespace

void writeCoefficients(const Coefficients& coefficients, const std::string& path,
                       const ImpulseResponse& retardation) {
  checkCoefficients(coefficients, "writeCoefficients");
  TemporaryFile temporary(path);
  hdf5::Writer writer(temporary.name(), path);
  writeBemio(writer, coefficients, retardation);
  writeCutwaterGroup(writer, coefficients);
  writer.attribute(kGroup, kVersion, kFormatVersion);
  writer.attribute(kGroup, kChecksum, hdf5::contentHash(writer.file()));
  writer.close();
  temporary.moveIntoPlace();
}

Coefficients readCoefficients(const std::string& path, std::string* warning) {
  const hdf5::Reader reader(path);
  std::vector<std::string> missing;
  Coefficients coefficients = reader.has(kGroup) ? readOwn(reader) : readBemio(reader, missing);
  checkCoefficients(coefficients, path);
  if (warning) *warning = missing.empty() ? "" : joinedWarning(path, coefficients, missing);
  return coefficients;
}

}  // namespace cutwater
