#include "hydro/forces/linear/WaveForce.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "hydro/base/SimdMath.h"
#include "hydro/forces/SeaCache.h"

namespace cutwater {

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

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

WaveForce::WaveForce(std::shared_ptr<const SeaTables> tables, WaveLoad load, const Course& course)
    : tables_(std::move(tables)),
      load_(load),
      exact_(tables_->exact(course.heading, course.speed)),
      blocks_(tables_->sea().phasorBlocks()),
      madeFor_{kNan, kNan} {
  make(course);
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

// A course that Ship has set has its exact loads in the tables already. Only memory may be lacking:
// then the load is not a number, and reported.
void WaveForce::make(const Course& course) noexcept {
  if (madeFor_ == course) return;
  madeFor_ = course;
  try {
    exact_ = tables_->exact(course.heading, course.speed);
    for (std::size_t i = 0; i < exact_->components.size(); ++i) {
      setAmplitude(i, exact_->components[i][static_cast<std::size_t>(load_)]);
    }
  } catch (...) {
    for (Block& block : blocks_) block.re.front().fill(kNan);
  }
}

Wrench WaveForce::evaluate(const TickInput& now) noexcept {
  const Course course{now.meanHeading, now.speed};
  if (now.courseBegins && std::isfinite(course.heading) && std::isfinite(course.speed))
    make(course);
  const std::size_t count = std::min(blocks_.size(), now.phasors.size());
  const auto sums = sumOf({blocks_.data(), count}, now.phasors.first(count));
  Wrench wrench;
  const double share = load_ == WaveLoad::Diffraction ? now.immersion * now.upright : 1.0;
  for (int j = 0; j < 6; ++j) wrench.load[j] = share * now.ramp * sums[static_cast<std::size_t>(j)];
  return wrench;
}

void WaveForce::enterSea(WaveForce& other) noexcept {
  other.make(madeFor_);
  tables_.swap(other.tables_);
  exact_.swap(other.exact_);
  blocks_.swap(other.blocks_);
}

void WaveForce::save(std::span<double> state) const noexcept {
  state[0] = madeFor_.heading;
  state[1] = madeFor_.speed;
}

bool WaveForce::fits(std::span<const double> state) const noexcept {
  return state.size() == stateSize() && std::isfinite(state[0]) && std::isfinite(state[1]);
}

void WaveForce::restore(std::span<const double> state) noexcept { make({state[0], state[1]}); }

}  // namespace cutwater
