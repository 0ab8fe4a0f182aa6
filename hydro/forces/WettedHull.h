#pragma once
#include <algorithm>
#include <array>
#include <memory>
#include <span>
#include <vector>

#include "hydro/forces/PressureHull.h"
#include "hydro/forces/SeaTables.h"
#include "hydro/waves/WaterPressure.h"

namespace cutwater {

/// The hull of one ship in its sea as a tick finds it: which part of it is wet, what the water
/// presses on it, and how far it is immersed. The pressure is that of the undisturbed waves,
///     p = −ρ(∂Φ_I/∂t + g z) = ρg (H − z),   0 above ζ                       [M03] (109), (110)
/// H the dynamic head of the sea's profile (WaterPressure.h), taken at each vertex of the hull.
/// The level force and the turning moment are those of this pressure but for their mean: they are
/// the rate of the undisturbed water's momentum in the hull, as waves push no hull along at first
/// order (THEORY.md, chapter 9). Of a hull that is held they are those of the pressure.
/// One ship's; one thread. Allocates in its constructor only.
class WettedHull {
 public:
  /// @param scaled  false: the hull counts as wholly immersed always (Immersion::Constant).
  WettedHull(std::shared_ptr<const PressureHull> hull, std::shared_ptr<const SeaTables> tables,
             bool scaled);

  /// G in E [m], R_EB.
  struct Place {
    Vec3 position = Vec3::Zero();
    Mat3 attitude = Mat3::Identity();
  };
  /// The hull at t [s]. Once a tick.
  /// @param slow  where the waves meet the hull: it is as it is there, but moved and turned to the
  ///        slow place and heading of the ship.
  /// @param velocity  of G [m/s] and of turning [rad/s] in E. Only what is not level of the first
  ///        and level of the second counts: the rest is the slow motion.
  /// @param way  velocity of the slow place in E [m/s], x and y.
  void look(double time, const Place& actual, const Place& slow, const Vec6& velocity,
            const std::array<double, 2>& way) noexcept;
  /// The same of a hull that is held there.
  void look(double time, const Place& held) noexcept {
    look(time, held, held, Vec6::Zero(), {0.0, 0.0});
  }
  /// The same but for immersion and added mass: after restore(), what was seen last.
  void see(double time, const Place& actual, const Place& slow, const Vec6& velocity,
           const std::array<double, 2>& way) noexcept;
  /// Becomes that of the sea of `other`, which was made for the same hull; immersion stays. `other`
  /// is left with what this one was. Allocates nothing.
  void enterSea(WettedHull& other) noexcept;
  bool scaled() const noexcept { return scaled_; }
  /// The next look() has no past: nothing comes in or goes out with it.
  void forget() noexcept { begun_ = false; }

  /// In E [N], about G in E [N·m].
  const Vec6& load() const noexcept { return load_; }
  double area() noexcept { return measured().area; }      ///< wetted [m²]
  double volume() noexcept { return measured().volume; }  ///< submerged [m³]
  /// Of that volume, in E [m].
  Vec3 centre() noexcept { return inEarth(measured().centre); }
  /// More of the wet hull that faces up than at rest, seen from above [m²], ≥ 0.
  double deckUnderWater() const noexcept {
    return std::max(0.0, state_.deckArea - hull_->restDeck());
  }
  /// Depth of the highest vertex under the surface [m]; 0 of a hull that is not wholly under it.
  double depthOfTop() const noexcept;
  /// How many vertices are wet: none of a hull that flies, all of one that is under water.
  std::size_t wetVertices() const noexcept { return state_.wetVertices; }
  /// Pieces of the waterline, from G in hull axes [m].
  const std::vector<std::pair<Vec3, Vec3>>& waterline() const noexcept { return state_.waterline; }

  /// s̄, 0 out of the water .. 1.
  double immersion() const noexcept { return mean_; }
  /// Added mass now, in axes along heading and pitch, and what has come and gone since the last
  /// look().
  const ImmersedMass::Change& mass() const noexcept { return change_; }
  /// Some share has changed since the last look().
  bool massChanged() const noexcept { return massChanged_; }
  /// The last look() was the first, or the first after forget().
  bool beginsNow() const noexcept { return begins_; }
  /// A point that is given from G in hull axes [m], in E.
  Vec3 inEarth(const Vec3& point) const noexcept {
    return actual_.position + actual_.attitude * point;
  }

  /// Exact state: the shares.
  std::size_t stateSize() const noexcept { return shares_.size() + 1; }
  void save(std::span<double> state) const noexcept;
  void restore(std::span<const double> state) noexcept;

 private:
  /// Vertices in E: x and y from the slow place, z above calm water; and the water there.
  struct Columns {
    std::vector<double> x, y, z, elevation, head, surfaceHead;
  };
  static void placePoints(const WettedTriangles::Points& points, const Place& at,
                          Columns& columns) noexcept;
  static void pressPoints(double gradient, const Columns& columns,
                          WettedTriangles::State& state) noexcept;
  void takeMeanOff() noexcept;
  const WettedTriangles::State& measured() noexcept;
  void weighWaves(const std::array<double, 2>& way) noexcept;
  void findWater(double time) noexcept;
  void findImmersion(double time) noexcept;

  std::shared_ptr<const PressureHull> hull_;
  std::shared_ptr<const SeaTables> tables_;  // keeps the sea
  WaterPressure water_;
  double density_, gravity_;
  bool scaled_, calm_, measured_ = false;
  double slow_;        // ω₀ of FreeResponse::share
  double near_ = 0.0;  // depth of the deepest vertex of which an edge may be cut [m]
  WettedTriangles::State state_;
  Columns columns_;
  std::vector<std::array<double, 2>> towards_;  // of each wave: where it travels in E
  // Of each wave: factors of the flow along x and y of E, and ω′ [rad/s].
  std::vector<double> weightX_, weightY_, meets_;
  Place actual_, met_;
  Vec6 load_ = Vec6::Zero();
  std::vector<double> shares_, before_, rise_;
  ImmersedMass::Change change_;
  double mean_ = 1.0;
  bool begun_ = false, begins_ = true, massChanged_ = true;
};

}  // namespace cutwater
