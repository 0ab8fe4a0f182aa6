#pragma once
#include <memory>
#include <span>
#include <vector>

#include "hydro/forces/floats/FloatHull.h"
#include "hydro/forces/floats/FloatWater.h"
#include "hydro/waves/WaterPressure.h"

namespace cutwater {

/// What the water is to a float.
struct FloatProperties {
  double density = 1025.0;  ///< ρ of the water [kg/m³]
  /// C of the wetted faces: −½ρ(C/2) v_n|v_n| on each, v_n its velocity through the water along its
  /// normal. A cube that moves along an edge has C_D = C, a ball ½C, a cylinder across ⅔C.
  double normalDrag = 1.05;
  double friction = 0.005;  ///< C_F of the wetted faces, along them
  /// v₀ over √(gL), L = V^{1/3}: drag across faces is that of √(v_n² + v₀²) |v_n|. Small swings
  /// lose more at edges than a steady flow of their speed does (C grows as the Keulegan-Carpenter
  /// number falls), so that they end.
  double slowDrag = 0.1;
};

/// One small body in its sea, tick by tick, without an engine: what the water presses on it, its
/// added mass, its drag, and what of these the tick has to take implicitly.
///     body.place(pose);                    // then WaterPressure::at of all bodies' points at once
///     body.press(gravity, water);          // buoyancy, waves' pressure, wet faces
///     ... FloatWater::motion at centre() of each ...
///     const FloatBody::Tick tick = body.tick(motion, mass, flow, h);
/// and then the engine solves (M + tick.inertia)(v⁺ − v⁻) = tick.impulse + its own impulses.
/// THEORY.md, chapter 13. One thread.
class FloatBody {
 public:
  FloatBody(std::shared_ptr<const FloatHull> hull, const FloatProperties& properties);

  struct Pose {
    Vec3 position = Vec3::Zero();      ///< of G in E [m]
    Mat3 attitude = Mat3::Identity();  ///< R_EB
  };
  /// In E, v⁻ of the last solve.
  struct Velocity {
    Vec3 linear = Vec3::Zero(), angular = Vec3::Zero();  ///< [m/s], [rad/s]
  };
  struct Tick {
    Vec6 impulse = Vec6::Zero();  ///< in E: force [N·s] and, about G, moment [N·m·s]
    Mat6 inertia = Mat6::Zero();  ///< in body axes about G; none of a body in the air
  };

  std::size_t points() const noexcept { return hull_->triangles().points().size(); }
  const FloatHull& hull() const noexcept { return *hull_; }
  const FloatProperties& properties() const noexcept { return properties_; }

  /// Columns of points() numbers each.
  struct Columns {
    std::span<double> x, y, z;
  };
  void place(const Pose& pose, const Columns& columns) noexcept;
  struct Water {
    std::span<const double> z, elevation, head, surfaceHead;
  };
  /// @param gravity  g of the world [m/s²].
  void press(double gravity, const Water& water) noexcept;

  double immersion() const noexcept { return share_; }  ///< wet share of the volume, 0 .. 1
  double volume() const noexcept { return state_.volume; }
  double area() const noexcept { return state_.area; }
  Vec3 centre() const noexcept;  ///< of the wet volume in E; G if there is none
  /// Pieces of the waterline in body axes [m].
  const std::vector<std::pair<Vec3, Vec3>>& waterline() const noexcept { return state_.waterline; }
  /// A point of body axes [m] in E.
  Vec3 inEarth(const Vec3& point) const noexcept { return pose_.position + pose_.attitude * point; }
  /// Load of the pressure in E, about G [N, N·m].
  Vec6 pressure() const noexcept;

  /// @param mass  of the body itself [kg].  @param h  the tick [s].
  Tick tick(const Velocity& velocity, double mass, const FloatWater::Motion& water,
            double h) noexcept;
  /// The next tick has no past.
  void forget() noexcept { begun_ = false; }

  /// The water that moves with the body, after a tick: in E, with the arm from G [m].
  struct Moving {
    Mat3 linear = Mat3::Zero(), angular = Mat3::Zero();  ///< A [kg], A_r [kg·m²]
    Vec3 arm = Vec3::Zero();
    Vec3 waterLinear = Vec3::Zero(), waterAngular = Vec3::Zero();  ///< A u, A_r Ω_w
    double share = 0.0;
  };
  /// Exact state between ticks.
  struct Past {
    Moving moving;
    bool begun = false;
  };
  Past past() const noexcept { return {past_, begun_}; }
  void setPast(const Past& past) noexcept {
    past_ = past.moving;
    begun_ = past.begun;
  }

 private:
  struct Forces;
  void addFaces(const Velocity& own, const FloatWater::Motion& water,
                Forces& forces) const noexcept;
  void addRadiation(const Velocity& own, const FloatWater::Motion& water, double mass,
                    Forces& forces) const noexcept;
  Mat6 addedMass() const noexcept;
  Moving moving(const FloatWater::Motion& water) const noexcept;
  Vec6 lostMomentum(const Moving& now, const Velocity& velocity, double standing) const noexcept;

  std::shared_ptr<const FloatHull> hull_;
  FloatProperties properties_;
  WettedTriangles::State state_;
  std::vector<WettedTriangles::WetFace> faces_;
  Pose pose_;
  double gravity_ = 0.0, share_ = 0.0;
  double surface_ = 0.0;  // mean height of the water's surface over the points [m]
  Moving past_;           // a tick ago
  bool begun_ = false;
};

}  // namespace cutwater
