#pragma once
#include <cstdint>
#include <stdexcept>
#include <string>

namespace cutwater {

/// What was wrong, for programs. HydroError::what() says it for people.
enum class Fault {
  // Files
  FileNotReadable,      ///< missing, or no permission
  FileNotWritable,      ///< target folder missing, disk full, no permission
  FileMalformed,        ///< cannot be parsed, truncated, wrong checksum
  FormatNotSupported,   ///< a file type we do not read (or only with any_format = true)
  VersionNotSupported,  ///< written by another version of Cutwater that this one cannot read
  // Hulls
  MeshEmpty,
  MeshIndexOutOfRange,  ///< a face names a vertex that is not there
  MeshNotFinite,        ///< a coordinate is NaN or infinite
  HullNotClosed,        ///< a hole below water
  HullInverted,         ///< no outside: a one-sided surface, or faces that do not agree
  HullNotInWater,       ///< wholly above or wholly below calm water
  HullNotSymmetric,     ///< said to be symmetric, and is not
  HullPartHidden,       ///< a part of the outer surface lies inside another
  ShellsNotJoined,      ///< shells that pass through one another leave a gap where they meet
  SectionsNotFollowed,  ///< panels cannot be laid along sections that split, jump or cross
  WaterlineNotClosed,   ///< the waterline has a loose end, so no lid fits
  // Values and databases
  ValueOutOfRange,  ///< a number outside its stated range, or not finite
  FrequenciesNotIncreasing,
  DatabaseIncomplete,  ///< a part that is needed here is not in the file
  MatrixSingular,
  SolverNotSupported,  ///< a Bullet solver or world that breaks added mass
  BadArgument,
  Interrupted,  ///< by the user; what is done so far is kept
};

/// The one exception of the library. Constructors and loaders throw it; nothing throws inside a
/// step of the engine. what() is one line with the offending value.
class HydroError : public std::runtime_error {
 public:
  HydroError(Fault fault, const std::string& what) : std::runtime_error(what), fault_(fault) {}
  Fault fault() const noexcept { return fault_; }

 private:
  Fault fault_;
};

/// What went wrong during a tick, as bits; Seaway returns them and keeps them until they are read.
enum StepFault : std::uint32_t {
  kStepOk = 0,
  kLoadNotFinite = 1u << 0,       ///< a load was NaN or infinite and was not applied
  kStateNotFinite = 1u << 1,      ///< the body's position or velocity is NaN or infinite
  kTickLengthChanged = 1u << 2,   ///< the convolution was restarted for the new tick length
  kBodyNotInWorld = 1u << 3,      ///< the ship's body was removed from the world by somebody else
  kSolverNotSupported = 1u << 4,  ///< the world's solver cannot carry added mass (btMLCPSolver)
  kCallbackReplaced = 1u << 5,    ///< somebody replaced the pre-tick callback: a tick without loads
  /// The ship makes a speed at which its own motions grow (Hydrodynamics::stability): outside the
  /// theory, and all loads are applied.
  kSpeedOutsideTheory = 1u << 6,
  kTickNotPositive = 1u << 7,  ///< a tick of no length or less: it passed without loads and weight
};

}  // namespace cutwater
