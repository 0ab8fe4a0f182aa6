#include "hydro/Errors.h"

#include <array>
#include <bit>

namespace cutwater {

namespace {

struct FaultRow {
  StepFault bit;
  std::string_view name, text;
};

// In the order of the bits.
constexpr std::array<FaultRow, 19> kFaults{{
    {kLoadNotFinite, "kLoadNotFinite", "a load was not finite and was not applied"},
    {kStateNotFinite, "kStateNotFinite", "the ship's position or velocity was not finite"},
    {kTickLengthChanged, "kTickLengthChanged",
     "the tick length changed, and the memory of radiated waves began anew"},
    {kBodyNotInWorld, "kBodyNotInWorld", "the ship's body was taken out of the world"},
    {kSolverNotSupported, "kSolverNotSupported", "the world's solver cannot carry added mass"},
    {kCallbackReplaced, "kCallbackReplaced",
     "the world's pre-tick callback was replaced, and a tick passed without loads"},
    {kSpeedOutsideTheory, "kSpeedOutsideTheory",
     "the ship made a speed at which its own motions grow, or one faster than was looked at: "
     "outside the theory"},
    {kTickNotPositive, "kTickNotPositive",
     "a tick was not longer than 0 s and passed without loads"},
    {kTickTooLong, "kTickTooLong", "a tick was too long for the ship's own motions"},
    {kConstraintRemoved, "kConstraintRemoved",
     "a constraint of the ship was taken out of the world, and put back"},
    {kMassChanged, "kMassChanged", "the body's mass or inertia is not the database's any more"},
    {kGravityChanged, "kGravityChanged",
     "the world's gravity is not the database's, or does not point down"},
    {kAttitudeOutsideTheory, "kAttitudeOutsideTheory",
     "the ship was tilted further than the theory of its radiation and diffraction goes"},
    {kOutOfWater, "kOutOfWater", "the whole hull was above the waves, or below them"},
    {kFarFromCourse, "kFarFromCourse",
     "the ship was far from the mean place where its waves are taken"},
    {kCourseBegan, "kCourseBegan", "the ship was set elsewhere, and its mean course began there"},
    {kSeaNotChanged, "kSeaNotChanged",
     "the sea that was to come could not be made, the old one stays"},
    {kLoadedBeyondLinear, "kLoadedBeyondLinear",
     "the ship carried more than 5 % of its own mass beside it, too much for linear mode"},
    {kFoundered, "kFoundered",
     "the ship was wholly under water and heavier than what it displaces: it goes down"},
}};

const FaultRow* find(std::uint32_t bit) noexcept {
  for (const FaultRow& row : kFaults) {
    if (row.bit == bit) return &row;
  }
  return nullptr;
}

}  // namespace

std::string faultText(std::uint32_t bits) {
  std::string text;
  for (; bits != 0; bits &= bits - 1) {
    const std::uint32_t bit = bits & (~bits + 1);  // the lowest
    const FaultRow* row = find(bit);
    if (!text.empty()) text += "; ";
    if (row != nullptr) {
      text += row->text;
    } else {
      text += "a fault without a name, bit " + std::to_string(std::countr_zero(bit));
    }
  }
  return text;
}

std::string_view faultName(StepFault bit) noexcept {
  const FaultRow* row = find(bit);
  return row != nullptr ? row->name : std::string_view{};
}

}  // namespace cutwater
