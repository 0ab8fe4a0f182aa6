#pragma once
#include <array>
#include <memory>
#include <vector>

#include "hydro/forces/ForceGenerator.h"
#include "hydro/forces/SeaTables.h"

namespace cutwater {

/// Linear load of a sea on a ship on a fixed course, one phasor per component:
///     F(t) = r(t) Re Σ_i a_i F̂_i e^{i(ω_i t − k_i(x̄ cos β_i − ȳ sin β_i) + ε_i)}
/// x̄, ȳ: mean place of G in E, so that the load stays linear in the waves; F̂_i in H, exact for the
/// course's heading and speed; r(t) the sea's ramp. On a ship under way x̄, ȳ move with it, which
/// makes the signed encounter frequency of each phase by itself. Cost: some 2 ns a component.
class WaveForce final : public ForceGenerator {
 public:
  /// Heading and speed of the course.
  struct Course {
    double heading = 0.0;  ///< ψ̄ [rad], from E's x axis, about +z
    double speed = 0.0;    ///< U [m/s]
    bool operator==(const Course&) const = default;
  };
  /// @throws HydroError as SeaTables::exact.
  WaveForce(std::shared_ptr<const SeaTables> tables, WaveLoad load, const Course& course);

  std::string_view name() const noexcept override {
    return kWaveLoadNames[static_cast<int>(load_)];
  }
  Wrench evaluate(const TickInput& now) noexcept override;
  /// Becomes that of the sea of `other`, which was made for the same ship; `other` is left with
  /// what this one was. Allocates nothing if it was made for the same course.
  void enterSea(WaveForce& other) noexcept;
  const Course& course() const noexcept { return madeFor_; }
  std::size_t stateSize() const noexcept override { return 2; }
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
  void make(const Course& course) noexcept;

  std::shared_ptr<const SeaTables> tables_;
  WaveLoad load_;
  std::shared_ptr<const CourseForces> exact_;
  std::vector<Block> blocks_;
  Course madeFor_;
};

}  // namespace cutwater
