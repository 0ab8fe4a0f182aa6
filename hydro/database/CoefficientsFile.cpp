#include "hydro/database/CoefficientsFile.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "hydro/Errors.h"
#include "hydro/base/AtomicFile.h"
#include "hydro/base/Fnv1a.h"
#include "hydro/database/BemioLayout.h"
#include "hydro/database/CutwaterGroup.h"

namespace cutwater {

namespace {

constexpr const char* kGroup = "cutwater";
constexpr const char* kVersion = "format_version";
constexpr const char* kChecksum = "checksum";

// The seal: these letters and 16 hex digits behind the end of the HDF5 file, which HDF5 does not
// look at. It is checked before HDF5 sees the file, because HDF5 1.10 can crash on damaged
// metadata.
constexpr std::string_view kSeal = "cutwater";
constexpr std::streamoff kSealLength = 8 + 16;

/// FNV-1a of the first `length` bytes.
std::string hashOfBytes(std::ifstream& file, std::streamoff length) {
  Fnv1a hash;
  std::vector<char> block(1 << 16);
  file.seekg(0);
  while (length > 0) {
    const auto n = std::min(length, static_cast<std::streamoff>(block.size()));
    if (!file.read(block.data(), n)) return {};
    hash.add(block.data(), static_cast<std::size_t>(n));
    length -= n;
  }
  return hash.digits();
}

std::string sealOf(std::string_view bytes) {
  Fnv1a hash;
  hash.add(bytes.data(), bytes.size());
  return std::string(kSeal) + hash.digits();
}

/// A file without a seal passes: another code's, or one that another program wrote to.
void checkSeal(const std::string& path) {
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  const std::streamoff length = file ? static_cast<std::streamoff>(file.tellg()) - kSealLength : -1;
  std::string found(static_cast<std::size_t>(kSealLength), ' ');
  if (length < 0 || !file.seekg(length) || !file.read(found.data(), kSealLength)) return;
  if (found.compare(0, kSeal.size(), kSeal) != 0) return;
  if (found.substr(kSeal.size()) != hashOfBytes(file, length)) {
    throw HydroError(Fault::FileMalformed, path + ": damaged since it was written (seal broken)");
  }
}

Coefficients readOwn(const hdf5::Reader& reader) {
  const std::int64_t version = reader.attributeInteger(kGroup, kVersion);
  if (version > kFormatVersion) {
    throw HydroError(Fault::VersionNotSupported,
                     fmt::format("{}: format version {}, written by a newer Cutwater; this one "
                                 "reads up to {}",
                                 reader.path(), version, kFormatVersion));
  }
  if (version == 1) {
    throw HydroError(Fault::VersionNotSupported,
                     fmt::format("{}: format version 1, written by an older Cutwater; solve again "
                                 "(this one reads versions {} to {})",
                                 reader.path(), kOldestFormatVersion, kFormatVersion));
  }
  const std::string written = reader.attributeText(kGroup, kChecksum);
  const std::string found = hdf5::contentHash(reader.file());
  if (version < kOldestFormatVersion || found != written) {
    throw HydroError(Fault::FileMalformed,
                     fmt::format("{}: damaged or changed since it was written (checksum {}, {} "
                                 "expected)",
                                 reader.path(), found.empty() ? "unreadable" : found, written));
  }
  return readCutwaterGroup(reader, version);
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
  hdf5::Writer writer(path);
  writeBemio(writer, coefficients, retardation);
  writeCutwaterGroup(writer, coefficients);
  writer.attribute(kGroup, kVersion, kFormatVersion);
  writer.attribute(kGroup, kChecksum, hdf5::contentHash(writer.file()));
  std::string bytes = writer.bytes();
  bytes += sealOf(bytes);
  writeWhole(path, bytes);
}

Coefficients readCoefficients(const std::string& path, std::string* warning) {
  checkSeal(path);
  const hdf5::Reader reader(path);
  std::vector<std::string> missing;
  Coefficients coefficients = reader.has(kGroup) ? readOwn(reader) : readBemio(reader, missing);
  checkCoefficients(coefficients, path);
  if (warning) *warning = missing.empty() ? "" : joinedWarning(path, coefficients, missing);
  return coefficients;
}

}  // namespace cutwater
