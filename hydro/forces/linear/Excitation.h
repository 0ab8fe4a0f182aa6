#pragma once
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "hydro/excitation/ExcitationTable.h"
#include "hydro/forces/ForceGenerator.h"
#include "hydro/waves/SeaState.h"

namespace cutwater {

/// Linear wave excitation in a sea state, one phasor per component:
///   F(t) = r(t) Re Σ_i a_i F̂_i e^{i(ω_i t − k_i(x̄ cos β_i − ȳ sin β_i) + ε_i)}
/// x̄, ȳ: mean position of G in E, so that the force stays linear in the waves; F̂_i in H at the mean
/// heading and speed; r(t) the sea's ramp. On a ship under way x̄, ȳ move with her, which makes the
/// signed encounter frequency of each phase by itself.
///
/// On a fixed course F̂_i are exact. On one that turns they come from a table and are renewed as heading
/// and speed drift, two components a tick: with 200 of them and 60 ticks a second each after 1.7 s, by 1.7° in
/// a turn of 1°/s.
/// Cost: 4 ns a component on a fixed course, some 2 µs more while it turns. Phases are computed anew each
/// tick from the time: nothing accumulates.
class ExcitationForce final : public ForceGenerator {
 public:
  /// A fixed course.
  /// @param meanHeading  ψ̄ [rad]: angle of the mean course from E's x axis, positive to port (about
  /// +z).
  /// @param meanSpeed    U [m/s] along it.
  /// @param form         of the forward-speed terms; absent: the database's own.
  /// @throws HydroError as WaveExcitation::at, naming the component.
  ExcitationForce(const Coefficients& coefficients, const SeaState& sea, double meanHeading,
                  double meanSpeed = 0.0, std::optional<ForwardSpeedForm> form = {});
  /// A course that may turn: ShipMotion::meanHeading and speed are followed.
  ExcitationForce(std::shared_ptr<const ExcitationTable> table, double meanHeading,
                  double meanSpeed = 0.0);

  /// Froude-Krylov and diffraction together.
  Vec6 at(const ShipMotion& motion) noexcept override;
  /// The two parts of the last call.
  const Vec6& froudeKrylov() const noexcept { return froudeKrylov_; }
  const Vec6& diffraction() const noexcept { return diffraction_; }

  /// Renews all amplitudes of a course that may turn at once, after a teleport.
  void renew(double meanHeading, double meanSpeed) noexcept;

  /// Exact state of a course that may turn: what each component was last renewed for. Empty on a fixed one.
  std::size_t stateSize() const noexcept { return table_ ? 1 + 2 * madeFor_.size() : 0; }
  void save(std::span<double> state) const noexcept;
  /// @throws HydroError BadArgument: another number of components, a place among them that is none.
  void restore(std::span<const double> state);

 private:
  struct Course {
    double heading, speed;
  };
  void setAmplitude(std::size_t component, const CVec6& froudeKrylov,
                    const CVec6& diffraction) noexcept;
  void renew(std::size_t component, const Course& course) noexcept;
  void follow(const ShipMotion& motion) noexcept;

  SeaState sea_;
  // Per four components 28 runs of four: ω, ε, k_x, k_y, then a Re F̂_I (6), a Im F̂_I, a Re F̂_D, a Im F̂_D.
  std::vector<double> blocks_;
  std::shared_ptr<const ExcitationTable> table_;
  std::vector<Course> madeFor_;
  std::size_t next_ = 0;
  Vec6 froudeKrylov_ = Vec6::Zero();
  Vec6 diffraction_ = Vec6::Zero();
};

}  // namespace cutwater
