#pragma once
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

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

/// What happened during a tick, as bits; Seaway keeps them until they are cleared. Those of
/// kWarningBits say that the ship is where its theory does not hold, or that somebody changed it:
/// the run goes on. The others say that something is broken.
///     if (seaway.faults() & ~kWarningBits) stop();
///     std::puts(faultText(seaway.faults()).c_str());
enum StepFault : std::uint32_t {
  kStepOk = 0,
  // Broken.
  /// A load, or a force that somebody put on the body, was NaN or infinite and was not applied.
  kLoadNotFinite = 1u << 0,
  /// The body's place or velocity was NaN or infinite; it was put back where it last was well.
  kStateNotFinite = 1u << 1,
  kTickLengthChanged = 1u << 2,   ///< the convolution was restarted for the new tick length
  kBodyNotInWorld = 1u << 3,      ///< the ship's body was taken out of the world by somebody else
  kSolverNotSupported = 1u << 4,  ///< the world's solver cannot carry added mass (btMLCPSolver)
  kCallbackReplaced = 1u << 5,    ///< somebody replaced the pre-tick callback: a tick without loads
  /// The ship makes a speed at which its own motions grow (Hydrodynamics::stability), or one faster
  /// than was looked at (Hydrodynamics::fastest): all loads are applied.
  kSpeedOutsideTheory = 1u << 6,
  kTickNotPositive = 1u << 7,  ///< a tick of no length or less: it passed without loads and weight
  /// A tick too long for the ship's own motions: its loads acted for as long as they can be right.
  kTickTooLong = 1u << 8,
  /// A constraint of ours was taken out of the world, or deleted by somebody; it was put back.
  kConstraintRemoved = 1u << 9,
  kMassChanged = 1u << 10,     ///< the body's mass or inertia is not the database's any more
  kGravityChanged = 1u << 11,  ///< the world's gravity is not the database's, or points elsewhere
  /// Tilted more than linear theory can carry (Ship::kLargestTilt): all loads are applied, bounded.
  /// In nonlinear mode pressure is right in any attitude, and the waves that the hull makes are
  /// not.
  kAttitudeOutsideTheory = 1u << 12,
  kOutOfWater = 1u << 13,     ///< the whole hull is above the waves, or below them
  kFarFromCourse = 1u << 14,  ///< far from the mean place where waves are taken (Ship::offCourse)
  kCourseBegan = 1u << 15,    ///< somebody set the body elsewhere: its mean course began there
  /// The tables of a sea that was to come could not be made (Seaway::setSea): the old one stays.
  kSeaNotChanged = 1u << 16,
  /// In linear mode a ship carries more than 5 % of its own mass beside it (Ship::setWeights,
  /// addCompartment): its draught, heel and stability by C are those of small changes.
  kLoadedBeyondLinear = 1u << 17,
  kFoundered = 1u << 18,  ///< wholly under water, and heavier than the water it displaces
};

/// The bits after which a run may go on.
inline constexpr std::uint32_t kWarningBits =
    kTickLengthChanged | kSpeedOutsideTheory | kTickTooLong | kMassChanged | kGravityChanged |
    kAttitudeOutsideTheory | kOutOfWater | kFarFromCourse | kCourseBegan | kSeaNotChanged |
    kLoadedBeyondLinear | kFoundered;

/// What the bits say in plain English, one phrase a bit, joined by "; ". A bit that has no meaning
/// is told by its number; "" for none.
std::string faultText(std::uint32_t bits);
/// "kTickTooLong"; "" for what is not one bit with a meaning.
std::string_view faultName(StepFault bit) noexcept;

}  // namespace cutwater
