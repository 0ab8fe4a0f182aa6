#pragma once
#include <Eigen/Core>
#include <complex>
#include <numbers>

/// Axes, modes, signs and symbols of everything in Cutwater. SI units throughout; angles in radians
/// inside the library, in degrees only in files whose key ends in `_deg`.
///
/// Modes 1..6 are surge, sway, heave, roll, pitch, yaw; array index = mode − 1.
/// Axes: x forward, y to port, z up, z = 0 at calm water. Frames, named in identifiers by a suffix:
///   E  fixed to the earth, z = 0 at calm water.
///   H  horizontal, moving with the ship's mean course: origin at the calm-water position of the
///      centre of gravity G, x along the mean heading. Forces and motions of linear theory are
///      here.
///   B  fixed to the hull, origin in G. Attitude R_EB = R_z(yaw) R_y(pitch) R_x(roll).
///   hull axes: those of the hull file turned to ours: x forward, y port, z up from calm water.
/// Positive pitch is bow down, positive roll starboard down, positive yaw bow to port.
/// Normals n point out of the hull into the water; n_{4..6} = r × n, r from G.
/// Time dependence Re{· e^{+iωt}}. Waves of heading β travel towards (cos β, −sin β):
///   ζ = a Re e^{i(ωt − k(x cos β − y sin β))}, crest at the origin at t = 0; β = π head seas, 0
///   following, π/2 from port. k = ω²/g (deep water).
///
///   symbol   identifier   unit            meaning
///   ω_I      omegaI       rad/s           wave frequency
///   ω′       omegaE       rad/s           signed encounter frequency ω_I − k U cos β
///   A, B     addedMass, damping           kg, kg m, kg m²  and per second
///   C        restoring    N/m, N, N m     hydrostatic stiffness about G, weight included
///   η, η̇     eta, etaDot  m, rad; m/s     motion about the mean course, frame H
///   K(τ)     retardation                  unit of B per second
///
/// From other codes. Capytaine: e^{−iωt} (conjugate forces and motions), moments about its rotation
/// centre, β the direction towards which waves travel counter-clockwise: β_ours = −β. WAMIT:
/// e^{+iωt}, same β rule as Capytaine. Nemoh: e^{−iωt}, angles as Capytaine. Naval codes with z
/// down: reverse y, z.
namespace cutwater {

using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;
using Vec6 = Eigen::Matrix<double, 6, 1>;
using Mat6 = Eigen::Matrix<double, 6, 6>;
using Complex = std::complex<double>;
using CVec6 = Eigen::Matrix<Complex, 6, 1>;
using CMat6 = Eigen::Matrix<Complex, 6, 6>;

/// Index of each mode in a vector of six.
enum Mode : int { Surge = 0, Sway = 1, Heave = 2, Roll = 3, Pitch = 4, Yaw = 5 };

/// Lower-case names of the six modes, in order; also the prefixes of TOML keys.
inline constexpr const char* kModeNames[6] = {"surge", "sway", "heave", "roll", "pitch", "yaw"};

inline constexpr double kPi = std::numbers::pi;
inline constexpr double kStandardGravity = 9.80665;  ///< [m/s²]
inline constexpr double kSeaWaterDensity = 1025.0;   ///< [kg/m³]

}  // namespace cutwater
