#pragma once
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "hydro/Conventions.h"

/// A ship's own axes: along its heading and its pitch, but not its roll, R = R_z(ψ) R_y(θ). Added
/// mass turns with them, so that a ship that rolls keeps its lateral symmetry. A moment's part
/// about x turns the roll alone; its generalised forces are those about x, the level y and the
/// vertical.
namespace cutwater {

/// Pitch [rad] up to which R pitches whole with the ship, and that which it never exceeds. Beyond
/// the first the ship is outside the theory, and R pitches less than it, so that x is never steep.
inline constexpr double kWholePitch = kPi / 6.0, kMostPitch = kPi / 4.0;

/// R of a heading and a pitch [rad].
inline Mat3 ownAxes(double heading, double pitch) {
  constexpr double kWhole = kWholePitch, kRest = kMostPitch - kWholePitch;
  const double beyond = std::abs(pitch) - kWhole;
  const double bounded =
      beyond > 0.0 ? std::copysign(kWhole + kRest * std::tanh(beyond / kRest), pitch) : pitch;
  return (Eigen::AngleAxisd(heading, Vec3::UnitZ()) * Eigen::AngleAxisd(bounded, Vec3::UnitY()))
      .toRotationMatrix();
}

/// Parts about x, the level y and the vertical of a moment in E.
inline Vec3 generalisedMoment(const Mat3& own, const Vec3& moment) {
  return {own.col(0).dot(moment), own.col(1).dot(moment), moment.z()};
}

/// The moment in E that has these parts.
inline Vec3 momentOf(const Mat3& own, const Vec3& parts) {
  const double sine = -own(2, 0), cosine = own(2, 2);
  const Vec3 along = (own.col(0) + sine * Vec3::UnitZ()) / (cosine * cosine);
  return parts[0] * along + parts[1] * own.col(1) + parts[2] / cosine * own.col(2);
}

/// How far a ship's motion may go before the water's momentum turns less with it than it should.
struct TurningLimits {
  double fastest = 1e300;   ///< [m/s] of the hull's ends
  double halfLength = 0.0;  ///< from G to them [m]

  /// The share of all cross terms of momentum, Ω × p and V × p, that is taken: 1 within the theory.
  /// Far outside it, where the hull's ends move faster or the ship tilts beyond 30°, less, by the
  /// square of the ratio of speeds and down to none at 45°. A thrown ship stays bounded so: the two
  /// cancel in power in whichever share both are taken, and not in different ones.
  /// @param own  velocities in own axes.  @param upright  cosine of the tilt: with linear
  ///             hydrostatics of the ship's, which hold no heeled hull; with those of the wetted
  ///             hull of the bow's, as own axes do not roll and momentum turns with them alone.
  double share(const Vec6& own, double upright) const {
    const double ends = std::hypot(own.head<3>().norm(), halfLength * own.tail<3>().norm());
    const double ratio = ends > fastest ? fastest / ends : 1.0;
    const double tilt =
        (std::cos(kPi / 6.0) - upright) / (std::cos(kPi / 6.0) - std::cos(kPi / 4.0));
    const double beyond = std::clamp(tilt, 0.0, 1.0);
    return ratio * ratio * (1.0 - beyond * beyond * (3.0 - 2.0 * beyond));
  }
};

/// Momentum of the water, force part p_F and moment part p_M, both in R, as the ship's next axes
/// see it that have turned meanwhile: it stands still in E, but for its part about x, which turns
/// with the ship.                                                      THEORY.md, chapter 8
inline Vec6 carried(const Vec6& momentum, const Mat3& linearThen, const Mat3& angularThen,
                    const Mat3& linearNow, const Mat3& angularNow) {
  const Vec3 moment = angularThen * momentum.tail<3>();
  const double sine = -angularNow(2, 0), cosine = angularNow(2, 2);
  Vec6 now;
  now.head<3>() = linearNow.transpose() * (linearThen * momentum.head<3>());
  now[Roll] = momentum[Roll];
  now[Pitch] = angularNow.col(1).dot(moment);
  now[Yaw] = (moment.z() + sine * momentum[Roll]) / cosine;
  return now;
}

}  // namespace cutwater
