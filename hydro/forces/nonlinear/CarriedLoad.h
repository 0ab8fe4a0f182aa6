#pragma once
#include <memory>
#include <string>
#include <vector>

#include "hydro/forces/Compartment.h"
#include "hydro/forces/ForceGenerator.h"
#include "hydro/ship/ShipParticulars.h"

namespace cutwater {

/// Something that a ship carries beside its database's mass: cargo, fuel, stores, people.
struct Weight {
  std::string name;             ///< tells it from the others, and finds it again when it changes
  double mass = 0.0;            ///< [kg], ≥ 0
  Vec3 place = Vec3::Zero();    ///< of its centre of gravity in hull axes (Ship::pointMotion) [m]
  Vec3 gyradii = Vec3::Zero();  ///< about its own centre along the ship's axes [m], ≥ 0
};

/// Mass, and its first and second moments about a point: what a rigid body is made of.
struct MassMoments {
  double mass = 0.0;           ///< m [kg]
  Vec3 first = Vec3::Zero();   ///< ∫r dm [kg·m]
  Mat3 second = Mat3::Zero();  ///< inertia ∫(r² I − r rᵀ) dm [kg·m²]

  /// Of a mass with its centre at r and gyradii about it.
  static MassMoments of(double mass, const Vec3& r, const Vec3& gyradii = Vec3::Zero());
  MassMoments& add(const MassMoments& other, double factor = 1.0);
  /// 6×6 about the point: momentum and moment of momentum of a velocity and a turning.
  Mat6 matrix() const;
};

/// What a ship carries, as a part of its load: the weight of cargo and of water in compartments at
/// their places. Their inertia goes with the ship's own (AddedMassConstraint::carry).
///     F = Σ m g,   M = Σ r × m g                                    THEORY.md, chapter 9
/// What changes of the mass from tick to tick is kept here: a weight that is new was put down
/// gently, at the ship's own velocity; one that is gone, or lighter, has taken its momentum along;
/// one that moves keeps the momentum of the whole. Of water see Compartment.h.
class CarriedLoad final : public ForceGenerator {
 public:
  explicit CarriedLoad(const ShipParticulars& ship);
  std::string_view name() const noexcept override { return "loading"; }

  /// All weights from now on. @throws HydroError ValueOutOfRange, naming weight, field and value;
  /// BadArgument: a name twice. The weights before stay then.
  void setWeights(std::vector<Weight> weights);
  const std::vector<Weight>& weights() const noexcept { return weights_; }
  /// @throws HydroError as Compartment.
  Compartment& addCompartment(const CompartmentBox& box);
  const std::vector<std::unique_ptr<Compartment>>& compartments() const noexcept {
    return compartments_;
  }
  /// All of it as it is now, about G in B.
  MassMoments moments() const noexcept;
  double mass() const noexcept { return moments().mass; }

  Wrench evaluate(const TickInput& now) noexcept override;
  /// Of the tick that was evaluated: what is carried, and that of it of which the momentum at the
  /// last solve stays on board. About G in B.
  const MassMoments& carried() const noexcept { return carried_; }
  const MassMoments& kept() const noexcept { return kept_; }

  void reset() noexcept override;
  std::size_t stateSize() const noexcept override;
  void save(std::span<double> state) const noexcept override;
  bool fits(std::span<const double> state) const noexcept override;
  void restore(std::span<const double> state) noexcept override;

 private:
  static constexpr std::size_t kOwnState = 2 + 13 + 13, kWeightState = 8;
  MassMoments of(const Weight& weight) const;
  std::size_t nameIndex(const std::string& name);

  Vec3 cog_;
  double density_;
  std::vector<Weight> weights_;
  std::vector<std::size_t> nameOf_;  // of each weight, in names_
  std::vector<std::string> names_;   // all there ever were: a snapshot holds their places
  std::vector<std::unique_ptr<Compartment>> compartments_;
  std::vector<double> heldBefore_;  // mass of each compartment at the last tick
  std::vector<Vec3> armBefore_;     // and its place
  MassMoments carried_, kept_;
  MassMoments pending_;  // came on board with its momentum, less what took it away
  bool begins_ = true;   // nothing is known of a tick before
};

}  // namespace cutwater
