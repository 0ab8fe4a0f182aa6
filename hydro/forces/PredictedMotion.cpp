#include "hydro/forces/PredictedMotion.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "hydro/base/Fnv1a.h"
#include "hydro/base/SimdMath.h"
#include "hydro/excitation/ExcitationTable.h"
#include "hydro/forces/Hydrodynamics.h"

namespace cutwater {

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kSameHeading = 1e-3, kSameSpeed = 0.02;  // [rad], [m/s]: not worth renewing
constexpr double kOldHeading = kPi / 180.0;               // the oldest that is used
constexpr std::size_t kFewest = 2, kMost = 32;            // renewed a tick
constexpr double kPatience = 12.0;                        // of √(L/g): some waves
constexpr double kNegligible = 1e-4;                      // of g
constexpr double kAlike = 0.7, kFree = 0.85;              // of what is predicted
constexpr double kDoubt = 3.0;                            // of what is not
constexpr double kLargest = 10.0;                         // answer to a wave [m/m], beyond any
constexpr double kSlowest = 1e-3;                         // of ω
constexpr double kFast = 0.9;      // share of what is compared with the actual motion
constexpr double kNoShare = 1e-9;  // of w: met too slowly to be told from a steady motion

// Channels of a block.
enum Channel : std::size_t {
  Displacement = 0,   // x, y, ψ
  Velocity = 3,       // their rates
  MomentumAhead = 6,  // and across
  OrbitalAcross = 8,  // and turn
  FroudeKrylov = 10,
  Diffraction = 16,
  Compared = 22  // accelerations of x, y, ψ by waves that are met fast
};

bool nearEnough(const PredictedMotion::Way& a, const PredictedMotion::Way& b) {
  return std::abs(a.heading - b.heading) <= kSameHeading &&
         std::abs(a.through.ahead - b.through.ahead) <= kSameSpeed &&
         std::abs(a.through.leeway - b.through.leeway) <= kSameSpeed;
}

bool finite(const PredictedMotion::Way& way) {
  return std::isfinite(way.heading) && std::isfinite(way.through.ahead) &&
         std::isfinite(way.through.leeway);
}

}  // namespace

PredictedMotion::PredictedMotion(std::shared_ptr<const SeaTables> tables, const ActiveParts& parts)
    : tables_(std::move(tables)),
      keeps_(tables_->following()),
      response_(tables_->hydrodynamics()->freeResponse()),
      parts_(parts),
      blocks_(tables_->sea().phasorBlocks()),
      madeFor_(tables_->sea().components().size(), Way{kNan, {}}) {
  for (const auto& table : keeps_) {
    for (std::size_t i = 0; i < table->sea().components().size(); ++i)
      forces_.push_back({table.get(), i});
  }
  const double g = tables_->sea().gravity(), L = tables_->hydrodynamics()->length();
  const double linear = kNegligible * g, angular = kNegligible * g / L;
  negligible_ << linear * linear, linear * linear, angular * angular;
  patience_ = kPatience * std::sqrt(L / g);
  Fnv1a key;
  for (const WaveComponent& wave : tables_->sea().components()) {
    for (const double x : {wave.omega, wave.heading, wave.amplitude, wave.phase})
      key.add(&x, sizeof x);
  }
  seaKey_ = static_cast<double>(key.value() >> 12);  // 52 bits
}

PredictedMotion::~PredictedMotion() = default;

void PredictedMotion::setParts(const ActiveParts& parts) noexcept {
  if (parts == parts_) return;
  parts_ = parts;
  for (std::size_t i = 0; i < madeFor_.size(); ++i) {
    if (finite(madeFor_[i])) renew(i, madeFor_[i]);
  }
}

CUTWATER_VECTOR void PredictedMotion::sumOf(std::span<const Block> blocks,
                                            std::span<const Phasors4> phasors, std::size_t channels,
                                            double* sums) noexcept {
  Double4 total[kChannels] = {};
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const Double4 c = load4(phasors[i].re), s = load4(phasors[i].im);
    for (std::size_t j = 0; j < channels; ++j) {
      total[j] += c * load4(blocks[i].re[j].data()) - s * load4(blocks[i].im[j].data());
    }
  }
  for (std::size_t j = 0; j < channels; ++j) sums[j] = cutwater::sumOf(total[j]);
}

Vec3 PredictedMotion::displacement(std::span<const Phasors4> phasors) const noexcept {
  Vec3 sums;
  sumOf(blocks_, phasors, 3, sums.data());
  return freedom_.cwiseProduct(sums);
}

void PredictedMotion::sum(std::span<const Phasors4> phasors, double ramp) noexcept {
  Eigen::Matrix<double, kChannels, 1> sums;
  sumOf(blocks_, phasors, kChannels, sums.data());
  sums *= ramp;
  predicted_ = sums.segment<3>(Compared);
  now_.displacement = freedom_.cwiseProduct(sums.segment<3>(Displacement));
  now_.velocity = freedom_.cwiseProduct(sums.segment<3>(Velocity));
  now_.momentumAhead = freedom_[0] * sums[MomentumAhead];
  now_.momentumAcross = freedom_[1] * sums[MomentumAhead + 1];
  now_.orbitalAcross = sums[OrbitalAcross];
  now_.orbitalTurn = sums[OrbitalAcross + 1];
  now_.froudeKrylov = sums.segment<6>(FroudeKrylov);
  now_.diffraction = sums.segment<6>(Diffraction);
}

void PredictedMotion::compare(const Vec3& velocity, double step, bool begins) noexcept {
  const double share = std::min(1.0, step / patience_);
  for (int i = 0; i < 3 && !begins; ++i) {
    const double actual = (velocity[i] - actualBefore_[i]) / step;
    const double predicted = predicted_[i];
    const double square = predicted * predicted;
    const double product = std::clamp(actual * predicted, -2.0 * square, 2.0 * square);  // blows
    if (!std::isfinite(product)) continue;
    product_[i] += share * (product - product_[i]);
    square_[i] += share * (square - square_[i]);
    actual_[i] += share * (actual * actual - actual_[i]);
  }
  actualBefore_ = velocity;
  findFreedom();
}

// Actual acceleration that has nothing to do with the predicted one hides it where it is larger.
void PredictedMotion::findFreedom() noexcept {
  for (int i = 0; i < 3; ++i) {
    const double explained = square_[i] > 0.0 ? product_[i] * product_[i] / square_[i] : 0.0;
    const double other = std::max(0.0, actual_[i] - explained);
    const double doubt = negligible_[i] + kDoubt * std::max(0.0, other - square_[i]);
    const double alike = (product_[i] + doubt) / (square_[i] + doubt);
    const double nearly = kAlike + (alike - kAlike) * (1.0 - kAlike) / (kFree - kAlike);
    freedom_[i] = std::clamp(alike < kAlike ? alike : nearly, 0.0, 1.0);
  }
}

// As if it had moved as predicted for ever.
void PredictedMotion::expectToFollow() noexcept {
  square_.setZero();
  for (const Block& block : blocks_) {
    for (std::size_t j = 0; j < 12; ++j) {
      const double re = block.re[Compared + j / 4][j % 4], im = block.im[Compared + j / 4][j % 4];
      square_[static_cast<int>(j / 4)] += 0.5 * (re * re + im * im);
    }
  }
  product_ = actual_ = square_;
  findFreedom();
}

double PredictedMotion::metAt(std::size_t component, const Way& way) const noexcept {
  const WaveComponent& wave = tables_->sea().components()[component];
  const double beta = wave.heading + way.heading;
  return wave.omega - tables_->sea().waveNumber(component) * (way.through.ahead * std::cos(beta) -
                                                              way.through.leeway * std::sin(beta));
}

void PredictedMotion::set(std::size_t component, std::size_t channel, Complex value) noexcept {
  const double a = tables_->sea().components()[component].amplitude;
  Block& block = blocks_[component / 4];
  block.re[channel][component % 4] = a * value.real();
  block.im[channel][component % 4] = a * value.imag();
}

void PredictedMotion::setAnswer(std::size_t component, double omega, const Way& way,
                                const CVec6& force) noexcept {
  const double share = parts_.water ? response_.share(omega) : 0.0;
  FreeResponse::Answer answer{CVec6::Zero(), CVec6::Zero()};
  if (share > kNoShare) answer = response_.at(omega, way.through, force, parts_);
  // Near a resonance of a way that no ship can have.
  const double k = tables_->sea().waveNumber(component);
  const double size =
      share * std::max({std::abs(answer.motion[Surge]), std::abs(answer.motion[Sway]),
                        std::abs(answer.motion[Yaw]) / k});
  if (size > kLargest) {
    answer.motion *= kLargest / size;
    answer.momentum *= kLargest / size;
  }
  const Complex rate(0.0, omega);
  for (std::size_t j = 0; j < 3; ++j) {
    const int mode = j == 2 ? Yaw : static_cast<int>(j);
    set(component, Displacement + j, share * answer.motion[mode]);
    const Complex velocity = share * rate * answer.motion[mode];
    set(component, Velocity + j, velocity);
    set(component, Compared + j, share > kFast ? rate * velocity : Complex(0.0));
  }
  for (std::size_t j = 0; j < 2; ++j)
    set(component, MomentumAhead + j, share * answer.momentum[static_cast<int>(j)]);
}

void PredictedMotion::renew(std::size_t component, const Way& way) noexcept {
  const WaveComponent& wave = tables_->sea().components()[component];
  const double k = tables_->sea().waveNumber(component), beta = wave.heading + way.heading;
  const double U = way.through.ahead, V = way.through.leeway;
  const auto& [table, number] = forces_[component];
  const CVec6 incident = table->froudeKrylov(number, way.heading);
  const double met = metAt(component, way);
  CVec6 thrownBack = table->diffraction(number, way.heading, U, V);
  // −V × R p_F of the water that diffraction moves; the term of U is in Tuck's form.
  if (std::abs(met) > kSlowest * wave.omega)
    thrownBack[Yaw] -= V * thrownBack[Surge] / Complex(0.0, met);
  const auto orbital = response_.lift().orbital(wave.omega, k, beta);
  CVec6 force = CVec6::Zero();
  if (parts_.froudeKrylov) force += incident;
  if (parts_.diffraction) force += thrownBack;
  if (parts_.hullLift) response_.lift().push(U, orbital, force);
  setAnswer(component, met, way, force);
  set(component, OrbitalAcross, orbital.side);
  set(component, OrbitalAcross + 1, orbital.turn);
  for (std::size_t j = 0; j < 6; ++j) {
    set(component, FroudeKrylov + j, incident[static_cast<int>(j)]);
    set(component, Diffraction + j, thrownBack[static_cast<int>(j)]);
  }
  madeFor_[component] = way;
}

void PredictedMotion::renewAll(const Way& way, bool exactly) noexcept {
  if (exactly) next_ = 0;
  if (!finite(way)) return;
  for (std::size_t i = 0; i < madeFor_.size(); ++i) {
    if (!(exactly ? madeFor_[i] == way : nearEnough(madeFor_[i], way))) renew(i, way);
  }
  expectToFollow();
}

void PredictedMotion::follow(const Way& way, double turnRate, double step) noexcept {
  if (!finite(way) || !std::isfinite(turnRate) || madeFor_.empty()) return;
  const auto count = static_cast<double>(madeFor_.size());
  const double aTick = count * step * std::abs(turnRate) / kOldHeading;
  const auto most = static_cast<std::size_t>(
      std::clamp(std::ceil(aTick), static_cast<double>(kFewest), static_cast<double>(kMost)));
  // Half of the turn until its next turn to be renewed.
  Way ahead = way;
  const double turn = 0.5 * turnRate * step * count / static_cast<double>(most);
  ahead.heading += std::clamp(turn, -0.5 * kOldHeading, 0.5 * kOldHeading);
  std::size_t renewed = 0;
  for (std::size_t n = 0; n < std::min(4 * most, madeFor_.size()) && renewed < most; ++n) {
    if (!nearEnough(madeFor_[next_], ahead)) {
      renew(next_, ahead);
      ++renewed;
    }
    next_ = next_ + 1 == madeFor_.size() ? 0 : next_ + 1;
  }
}

void PredictedMotion::enterSea(PredictedMotion& other, const SharedWaves& shared) noexcept {
  other.setParts(parts_);
  for (std::size_t i = 0; i < shared.count; ++i) {
    const std::size_t from = shared.first + i, to = shared.to + i;
    if (from >= madeFor_.size() || to >= other.madeFor_.size()) break;
    const Block& was = blocks_[from / 4];
    Block& comes = other.blocks_[to / 4];
    for (std::size_t j = 0; j < kChannels; ++j) {
      comes.re[j][to % 4] = was.re[j][from % 4];
      comes.im[j][to % 4] = was.im[j][from % 4];
    }
    other.madeFor_[to] = madeFor_[from];
  }
  tables_.swap(other.tables_);
  keeps_.swap(other.keeps_);
  forces_.swap(other.forces_);
  blocks_.swap(other.blocks_);
  madeFor_.swap(other.madeFor_);
  std::swap(seaKey_, other.seaKey_);
  const bool stays = next_ >= shared.first && next_ < shared.first + shared.count;
  next_ = stays ? next_ - shared.first + shared.to : 0;
}

void PredictedMotion::save(std::span<double> state) const noexcept {
  state[0] = static_cast<double>(next_);
  state[1] = seaKey_;
  auto at = state.begin() + 2;
  for (const Vec3* own : {&actualBefore_, &product_, &square_, &actual_})
    at = std::copy(own->begin(), own->end(), at);
  for (const Way& way : madeFor_) {
    *at++ = way.heading;
    *at++ = way.through.ahead;
    *at++ = way.through.leeway;
  }
}

bool PredictedMotion::fits(std::span<const double> state) const noexcept {
  const auto count = static_cast<double>(std::max<std::size_t>(1, madeFor_.size()));
  return state.size() == stateSize() && state[0] >= 0.0 && state[0] < count && state[1] == seaKey_;
}

// Before its first tick a ship's amplitudes belong to no way.
void PredictedMotion::restore(std::span<const double> state) noexcept {
  next_ = static_cast<std::size_t>(state[0]);
  auto at = state.begin() + 2;
  for (Vec3* own : {&actualBefore_, &product_, &square_, &actual_}) {
    std::copy_n(at, 3, own->begin());
    at += 3;
  }
  findFreedom();
  for (std::size_t i = 0; i < madeFor_.size(); ++i, at += 3) {
    const Way way{at[0], {at[1], at[2]}};
    if (madeFor_[i] == way) continue;
    if (finite(way)) {
      renew(i, way);
    } else {
      madeFor_[i] = way;
    }
  }
}

}  // namespace cutwater
