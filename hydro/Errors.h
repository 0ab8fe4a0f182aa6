#pragma once
#include <cstdint>
#include <stdexcept>
#include <string>

namespace cutwater {

/// What was wrong, for programs; what() says it for people, in one line with the offending value.
enum class Fault {
  FileNotReadable,      ///< missing, or no permission
  FileNotWritable,      ///< target folder missing, disk full, no permission
  FileMalformed,        ///< cannot be parsed, truncated, wrong checksum
  FormatNotSupported,   ///< a file type we do not read (or only with any_format = true)
  VersionNotSupported,  ///< written by a newer Cutwater
  ValueOutOfRange,      ///< a number outside its stated range, or not finite
  MeshEmpty,
  MeshIndexOutOfRange,
  MeshNotFinite,
  HullNotClosed,
  HullInverted,
  HullNotInWater,  ///< wholly above or wholly below calm water
  HullNotSymmetric,
  FrequenciesNotIncreasing,
  DatabaseIncomplete,  ///< a part that is needed here is not in the file
  MatrixSingular,
  SolverNotSupported,  ///< a Bullet solver or world that breaks added mass
  BadArgument,
};

/// The one exception of the library. Constructors and loaders throw it; nothing throws inside a
/// step of the engine.
class HydroError : public std::runtime_error {
 public:
  HydroError(Fault fault, const std::string& what) : std::runtime_error(what), fault_(fault) {}
  Fault fault() const noexcept { return fault_; }

 private:
  Fault fault_;
};

/// What went wrong during a tick, as bits; returned by Seaway and kept until read.
enum StepFault : std::uint32_t {
  kStepOk = 0,
  kLoadNotFinite = 1u << 0,       ///< a load was NaN or infinite and was not applied
  kStateNotFinite = 1u << 1,      ///< the body's position or velocity is NaN or infinite
  kTickLengthChanged = 1u << 2,   ///< memory was restarted for the new tick length
  kBodyNotInWorld = 1u << 3,      ///< the ship's body was removed behind our back
  kSolverNotSupported = 1u << 4,  ///< the world's solver cannot carry added mass (btMLCPSolver)
  kCallbackReplaced =
      1u << 5,  ///< the world's pre-tick callback was overwritten: one tick without loads
};

}  // namespace cutwater
