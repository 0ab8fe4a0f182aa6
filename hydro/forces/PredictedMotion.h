#pragma once
#include <memory>
#include <span>
#include <vector>

#include "hydro/forces/FreeResponse.h"
#include "hydro/forces/SeaTables.h"
#include "hydro/waves/SeaState.h"

namespace cutwater {

/// What linear theory says of a free ship in a sea, one phasor per component: the waves' load, and
/// the motion with which the ship answers it. The ship's slow motion is its actual one less this
/// (THEORY.md, chapter 8):
///     x_s = x − R_s Re Σ_i w_i a_i ξ̂_i e^{i(ω_i t − k_i·x_s + ε_i)}
/// Amplitudes belong to a slow heading, speed and leeway. Each component's are renewed as these
/// drift, some components a tick, so that none is older than a turn of one degree, or than half a
/// second for each 60 components; in a turn they are made for the heading of half that time ahead.
///
/// A ship that is held, by a berth, the ground or a clamp, does not move so. Of surge, sway and yaw
/// each the mean product of actual and predicted acceleration, over the mean square of the
/// predicted one, says how far the ship follows. As far the prediction counts; whole from 0.85 on.
/// Where the rest of the acceleration is larger than the prediction, it says little and is believed
/// little. One ship's; one thread.
class PredictedMotion {
 public:
  /// Slow heading [rad] and way for which amplitudes are made.
  struct Way {
    double heading = 0.0;
    SteadyWay through{};
    bool operator==(const Way&) const = default;
  };
  /// Sums over the sea at one instant. Motions in axes of the slow heading, or of the ship's own
  /// where that is said.
  struct Sums {
    Vec3 displacement = Vec3::Zero();                  ///< x, y [m], ψ [rad], weighted by w
    Vec3 velocity = Vec3::Zero();                      ///< their rates
    double momentumAhead = 0.0, momentumAcross = 0.0;  ///< p₁′, p₂′ in own axes, weighted [kg·m/s]
    double orbitalAcross = 0.0, orbitalTurn = 0.0;                 ///< v_w [m/s], r_w [rad/s]
    Vec6 froudeKrylov = Vec6::Zero(), diffraction = Vec6::Zero();  ///< [N, N·m]
  };

  /// @throws HydroError as SeaTables::following and Hydrodynamics::freeResponse.
  PredictedMotion(std::shared_ptr<const SeaTables> tables, const ActiveParts& parts);
  ~PredictedMotion();

  /// Other parts act from now on: all amplitudes anew.
  void setParts(const ActiveParts& parts) noexcept;
  /// All amplitudes for this way, of a ship that is free to follow.
  /// @param exactly  false: those that are near enough may stay.
  void renewAll(const Way& way, bool exactly = true) noexcept;
  /// Some of them, at a tick of `step` [s].  @param turnRate  [rad/s].
  void follow(const Way& way, double turnRate, double step) noexcept;

  /// Becomes that of the sea of `other`, which was made for this ship and its parts: amplitudes of
  /// shared waves and how far the ship follows stay what they are, to the bit; `other` is left with
  /// what this one was. Allocates nothing.
  void enterSea(PredictedMotion& other, const SharedWaves& shared) noexcept;
  const ActiveParts& parts() const noexcept { return parts_; }

  /// Looks how far the ship moves as predicted. Once a tick, after sum().
  /// @param velocity  of surge and sway [m/s], of yaw [rad/s], actual, in axes of the slow heading.
  /// @param begins  the ship was set: it did not come to this velocity.
  void compare(const Vec3& velocity, double step, bool begins) noexcept;

  /// x, y, ψ alone of these phasors (SeaState::phasors), at full height of the sea.
  Vec3 displacement(std::span<const Phasors4> phasors) const noexcept;
  /// Makes all sums at these phasors, times the sea's `ramp`.
  void sum(std::span<const Phasors4> phasors, double ramp) noexcept;
  const Sums& now() const noexcept { return now_; }

  const FreeResponse& response() const noexcept { return response_; }

  std::size_t stateSize() const noexcept { return kOwnState + 3 * madeFor_.size(); }
  void save(std::span<double> state) const noexcept;
  bool fits(std::span<const double> state) const noexcept;
  void restore(std::span<const double> state) noexcept;

 private:
  static constexpr std::size_t kOwnState = 2 + 12;
  static constexpr std::size_t kChannels = 25;
  /// Amplitudes of four components.
  struct alignas(32) Block {
    std::array<std::array<double, 4>, kChannels> re{}, im{};
  };
  static void sumOf(std::span<const Block> blocks, std::span<const Phasors4> phasors,
                    std::size_t channels, double* sums) noexcept;
  void findFreedom() noexcept;
  void expectToFollow() noexcept;
  double metAt(std::size_t component, const Way& way) const noexcept;
  void renew(std::size_t component, const Way& way) noexcept;
  void set(std::size_t component, std::size_t channel, Complex value) noexcept;
  void setAnswer(std::size_t component, double omega, const Way& way, const CVec6& force) noexcept;

  std::shared_ptr<const SeaTables> tables_;
  /// Of each component: its forces, and its number there.
  struct Forces {
    const ExcitationTable* table;
    std::size_t component;
  };
  std::vector<std::shared_ptr<const ExcitationTable>> keeps_;
  std::vector<Forces> forces_;
  const FreeResponse& response_;
  ActiveParts parts_;
  std::vector<Block> blocks_;
  std::vector<Way> madeFor_;  // of each component
  std::size_t next_ = 0;      // the component to be looked at next
  Sums now_;
  // How free the ship is to follow, of surge, sway and yaw.
  Vec3 predicted_ = Vec3::Zero();                        // acceleration
  Vec3 actualBefore_ = Vec3::Zero();                     // velocity
  Vec3 product_ = Vec3::Zero(), square_ = Vec3::Zero();  // of accelerations, means
  Vec3 freedom_ = Vec3::Ones();
  Vec3 negligible_;             // square of an acceleration that tells nothing
  Vec3 actual_ = Vec3::Zero();  // square of the actual one, mean
  double patience_;             // [s]
  double seaKey_;               // of the waves
};

}  // namespace cutwater
