#include "hydro/forces/linear/Excitation.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "hydro/Errors.h"
#include "hydro/excitation/WaveExcitation.h"
#include "hydro/waves/PhaseBlocks.h"

namespace cutwater {

namespace {

using namespace phase_blocks;
constexpr std::size_t kBlock = kPhase + 24 * kLanes;
constexpr std::size_t kRenewedATick = 2, kLookedAtATick = 8;
constexpr double kSameHeading = 1e-4, kSameSpeed = 1e-3;  // [rad], [m/s]: not worth renewing

/// Sums of Re and Im over all blocks: Re F_I (6), Re F_D (6) of the force at phase
/// ω t + ε − k_x x − k_y y.
CUTWATER_VECTOR void sumPhasors(const double* block, std::size_t count, double t, double x,
                                double y, double* sums) noexcept {
  Four total[12] = {};
  for (std::size_t i = 0; i < count; ++i, block += kBlock) {
    const auto [s, c] = sineCosine(phaseAt(block, t, x, y));
    const double* re = block + kPhase;
    for (std::size_t j = 0; j < 6; ++j) {
      total[j] += c * loadFour(re + 4 * j) - s * loadFour(re + 4 * (6 + j));
      total[6 + j] += c * loadFour(re + 4 * (12 + j)) - s * loadFour(re + 4 * (18 + j));
    }
  }
  for (std::size_t j = 0; j < 12; ++j) sums[j] = sumOf(total[j]);
}

}  // namespace

void ExcitationForce::setAmplitude(std::size_t i, const CVec6& froudeKrylov,
                                   const CVec6& diffraction) noexcept {
  double* at = placeOf(blocks_, kBlock, i) + kPhase;
  const double a = sea_.components()[i].amplitude;
  for (int j = 0; j < 6; ++j, at += kLanes) {
    at[0] = a * froudeKrylov[j].real();
    at[6 * kLanes] = a * froudeKrylov[j].imag();
    at[12 * kLanes] = a * diffraction[j].real();
    at[18 * kLanes] = a * diffraction[j].imag();
  }
}

ExcitationForce::ExcitationForce(const Coefficients& coefficients, const SeaState& sea,
                                 double meanHeading, double meanSpeed,
                                 std::optional<ForwardSpeedForm> form)
    : sea_(sea) {
  if (sea.components().empty()) return;
  blocks_ = phaseBlocks(sea, kBlock);
  const WaveExcitation excitation(coefficients, form);
  for (std::size_t i = 0; i < sea.components().size(); ++i) {
    const WaveComponent& wave = sea.components()[i];
    // Seen from a ship whose course is turned by ψ̄ to port, a wave towards (cos β, −sin β) travels
    // at the polar angle −β − ψ̄, hence β + ψ̄ relative to her.
    try {
      const auto force = excitation.at(wave.omega, wave.heading + meanHeading, meanSpeed);
      setAmplitude(i, force.froudeKrylov, force.diffraction);
    } catch (const HydroError& error) {
      throw HydroError(error.fault(), "wave component " + std::to_string(i) + ": " + error.what());
    }
  }
}

ExcitationForce::ExcitationForce(std::shared_ptr<const ExcitationTable> table, double meanHeading,
                                 double meanSpeed)
    : sea_(table->sea()), table_(std::move(table)), madeFor_(sea_.components().size()) {
  blocks_ = phaseBlocks(sea_, kBlock);
  renew(meanHeading, meanSpeed);
}

void ExcitationForce::renew(std::size_t i, const Course& course) noexcept {
  const auto amplitude = table_->at(i, course.heading, course.speed);
  setAmplitude(i, amplitude.froudeKrylov, amplitude.diffraction);
  madeFor_[i] = course;
}

void ExcitationForce::renew(double meanHeading, double meanSpeed) noexcept {
  for (std::size_t i = 0; i < madeFor_.size(); ++i) renew(i, {meanHeading, meanSpeed});
  next_ = 0;
}

void ExcitationForce::follow(const ShipMotion& motion) noexcept {
  std::size_t renewed = 0;
  for (std::size_t n = 0; n < std::min(kLookedAtATick, madeFor_.size()) && renewed < kRenewedATick;
       ++n) {
    const Course& course = madeFor_[next_];
    if (!(std::abs(course.heading - motion.meanHeading) <= kSameHeading) ||
        !(std::abs(course.speed - motion.speed) <= kSameSpeed)) {
      renew(next_, {motion.meanHeading, motion.speed});
      ++renewed;
    }
    next_ = next_ + 1 == madeFor_.size() ? 0 : next_ + 1;
  }
}

Vec6 ExcitationForce::at(const ShipMotion& motion) noexcept {
  if (table_ && std::isfinite(motion.meanHeading) && std::isfinite(motion.speed)) follow(motion);
  double sums[12] = {};
  sumPhasors(blocks_.data(), blocks_.size() / kBlock, motion.time, motion.meanX, motion.meanY,
             sums);
  const double grown = sea_.ramp(motion.time);
  for (int j = 0; j < 6; ++j) {
    froudeKrylov_[j] = grown * sums[j];
    diffraction_[j] = grown * sums[6 + j];
  }
  return froudeKrylov_ + diffraction_;
}

void ExcitationForce::save(std::span<double> state) const noexcept {
  if (!table_) return;
  state[0] = static_cast<double>(next_);
  for (std::size_t i = 0; i < madeFor_.size(); ++i) {
    state[1 + 2 * i] = madeFor_[i].heading;
    state[2 + 2 * i] = madeFor_[i].speed;
  }
}

void ExcitationForce::restore(std::span<const double> state) {
  const auto count = static_cast<double>(std::max<std::size_t>(1, madeFor_.size()));
  if (state.size() != stateSize() || (table_ && !(state[0] >= 0.0 && state[0] < count))) {
    throw HydroError(Fault::BadArgument, "ExcitationForce::restore: not a state of this force: " +
                                             std::to_string(state.size()) + " numbers, here are " +
                                             std::to_string(stateSize()));
  }
  if (!table_) return;
  next_ = static_cast<std::size_t>(state[0]);
  for (std::size_t i = 0; i < madeFor_.size(); ++i) {
    const Course course{state[1 + 2 * i], state[2 + 2 * i]};
    if (course.heading != madeFor_[i].heading || course.speed != madeFor_[i].speed)
      renew(i, course);
  }
}

}  // namespace cutwater
