#include "hydro/forces/linear/WaveForce.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "hydro/Errors.h"
#include "hydro/base/SimdMath.h"
#include "hydro/excitation/ExcitationTable.h"
#include "hydro/forces/SeaCache.h"

namespace cutwater {

namespace {

constexpr std::size_t kRenewedATick = 2, kLookedAtATick = 8;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kSameHeading = 1e-4, kSameSpeed = 1e-3;  // [rad], [m/s]: not worth renewing

bool nearEnough(const WaveForce::Course& a, const WaveForce::Course& b) {
  return std::abs(a.heading - b.heading) <= kSameHeading &&
         std::abs(a.speed - b.speed) <= kSameSpeed;
}

}  // namespace

CUTWATER_VECTOR std::array<double, 6> WaveForce::sumOf(std::span<const Block> blocks,
                                                       std::span<const Phasors4> phasors) noexcept {
  Double4 total[6] = {};
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const Double4 c = load4(phasors[i].re), s = load4(phasors[i].im);
    for (std::size_t j = 0; j < 6; ++j) {
      total[j] += c * load4(blocks[i].re[j].data()) - s * load4(blocks[i].im[j].data());
    }
  }
  std::array<double, 6> sums;
  for (std::size_t j = 0; j < 6; ++j) sums[j] = cutwater::sumOf(total[j]);
  return sums;
}

WaveForce::WaveForce(std::shared_ptr<const SeaTables> tables, WaveLoad load, const Course& start,
                     bool follows)
    : tables_(std::move(tables)),
      load_(load),
      blocks_(tables_->sea().phasorBlocks()),
      madeFor_(follows ? tables_->sea().components().size() : 1, Course{kNan, kNan}) {
  if (follows) {
    table_ = tables_->following();
  } else {
    exact_ = tables_->exact(start.heading, start.speed);
  }
  renewAll(start);
}

void WaveForce::setAmplitude(std::size_t component, const CVec6& force) noexcept {
  Block& block = blocks_[component / 4];
  const std::size_t lane = component % 4;
  const double a = tables_->sea().components()[component].amplitude;
  for (std::size_t j = 0; j < 6; ++j) {
    const Complex f = force[static_cast<int>(j)];
    block.re[j][lane] = a * f.real();
    block.im[j][lane] = a * f.imag();
  }
}

void WaveForce::renew(std::size_t component, const Course& course) noexcept {
  setAmplitude(component, load_ == WaveLoad::FroudeKrylov
                              ? table_->froudeKrylov(component, course.heading)
                              : table_->diffraction(component, course.heading, course.speed));
  madeFor_[component] = course;
}

// A fixed course that Ship has set has its exact loads in the tables already. Only memory may be
// lacking: then the load is not a number, and reported.
void WaveForce::renewAll(const Course& course) noexcept {
  next_ = 0;
  if (table_) {
    for (std::size_t i = 0; i < madeFor_.size(); ++i) {
      if (!(madeFor_[i] == course)) renew(i, course);
    }
    return;
  }
  if (madeFor_.front() == course) return;
  madeFor_.front() = course;
  try {
    exact_ = tables_->exact(course.heading, course.speed);
    for (std::size_t i = 0; i < exact_->components.size(); ++i) {
      setAmplitude(i, exact_->components[i][static_cast<std::size_t>(load_)]);
    }
  } catch (...) {
    for (Block& block : blocks_) block.re.front().fill(kNan);
  }
}

void WaveForce::follow(const Course& course) noexcept {
  std::size_t renewed = 0;
  for (std::size_t n = 0; n < std::min(kLookedAtATick, madeFor_.size()) && renewed < kRenewedATick;
       ++n) {
    if (!nearEnough(madeFor_[next_], course)) {
      renew(next_, course);
      ++renewed;
    }
    next_ = next_ + 1 == madeFor_.size() ? 0 : next_ + 1;
  }
}

Wrench WaveForce::evaluate(const TickInput& now) noexcept {
  const Course course{now.meanHeading, now.speed};
  if (std::isfinite(course.heading) && std::isfinite(course.speed)) {
    if (now.courseBegins) renewAll(course);
    if (table_) follow(course);
  }
  const std::size_t count = std::min(blocks_.size(), now.phasors.size());
  const auto sums = sumOf({blocks_.data(), count}, now.phasors.first(count));
  Wrench wrench;
  for (int j = 0; j < 6; ++j) wrench.load[j] = now.ramp * sums[static_cast<std::size_t>(j)];
  return wrench;
}

std::size_t WaveForce::stateSize() const noexcept { return 1 + 2 * madeFor_.size(); }

void WaveForce::save(std::span<double> state) const noexcept {
  state[0] = static_cast<double>(next_);
  for (std::size_t i = 0; i < madeFor_.size(); ++i) {
    state[1 + 2 * i] = madeFor_[i].heading;
    state[2 + 2 * i] = madeFor_[i].speed;
  }
}

bool WaveForce::fits(std::span<const double> state) const noexcept {
  const auto count = static_cast<double>(std::max<std::size_t>(1, madeFor_.size()));
  return state.size() == stateSize() && state[0] >= 0.0 && state[0] < count &&
         std::all_of(state.begin(), state.end(), [](double x) { return std::isfinite(x); });
}

void WaveForce::restore(std::span<const double> state) noexcept {
  for (std::size_t i = 0; i < madeFor_.size(); ++i) {
    const Course course{state[1 + 2 * i], state[2 + 2 * i]};
    if (madeFor_[i] == course) continue;
    if (table_) {
      renew(i, course);
    } else {
      renewAll(course);
    }
  }
  next_ = static_cast<std::size_t>(state[0]);
}

}  // namespace cutwater
