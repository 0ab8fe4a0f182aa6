#pragma once
#include <array>
#include <memory>
#include <vector>

#include "hydro/forces/ForceGenerator.h"
#include "hydro/forces/SeaTables.h"

namespace cutwater {

/// Linear load of a sea on a ship, one phasor per component:
///     F(t) = r(t) Re Σ_i a_i F̂_i e^{i(ω_i t − k_i(x̄ cos β_i − ȳ sin β_i) + ε_i)}
/// x̄, ȳ: mean place of G in E, so that the load stays linear in the waves; F̂_i in H at the mean
/// heading and speed; r(t) the sea's ramp. On a ship under way x̄, ȳ move with it, which makes the
/// signed encounter frequency of each phase by itself.
///
/// On a fixed course F̂_i are exact. On one that follows the ship they come from a table and are
/// renewed as heading and speed drift, two components a tick: with 200 of them and 60 ticks a
/// second each after 1.7 s, by 1.7° in a turn of 1°/s. Cost: some 2 ns a component on a fixed
/// course, 1 µs more while the course turns.
class WaveForce final : public ForceGenerator {
 public:
  /// Course and speed at the start.
  struct Course {
    double heading = 0.0;  ///< ψ̄ [rad], from E's x axis, about +z
    double speed = 0.0;    ///< U [m/s]
    bool operator==(const Course&) const = default;
  };
  /// @param follows  the mean course follows the ship.
  /// @throws HydroError as SeaTables::exact and SeaTables::following.
  WaveForce(std::shared_ptr<const SeaTables> tables, WaveLoad load, const Course& start,
            bool follows);

  std::string_view name() const noexcept override {
    return kWaveLoadNames[static_cast<int>(load_)];
  }
  Wrench evaluate(const TickInput& now) noexcept override;
  std::size_t stateSize() const noexcept override;
  void save(std::span<double> state) const noexcept override;
  bool fits(std::span<const double> state) const noexcept override;
  void restore(std::span<const double> state) noexcept override;

 private:
  /// a F̂ of four components.
  struct alignas(32) Block {
    std::array<std::array<double, 4>, 6> re{}, im{};
  };
  static std::array<double, 6> sumOf(std::span<const Block> blocks,
                                     std::span<const Phasors4> phasors) noexcept;
  void setAmplitude(std::size_t component, const CVec6& force) noexcept;
  void renew(std::size_t component, const Course& course) noexcept;
  void renewAll(const Course& course) noexcept;
  void follow(const Course& course) noexcept;

  std::shared_ptr<const SeaTables> tables_;
  WaveLoad load_;
  std::shared_ptr<const ExcitationTable> table_;  // null on a fixed course
  std::shared_ptr<const CourseForces> exact_;     // of the fixed course; null on one that follows
  std::vector<Block> blocks_;
  std::vector<Course> madeFor_;  // of each component; of a fixed course one for all
  std::size_t next_ = 0;         // the component to be checked next
};

}  // namespace cutwater
