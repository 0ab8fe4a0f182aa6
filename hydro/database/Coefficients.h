#pragma once
#include <string>
#include <vector>

#include "hydro/Conventions.h"
#include "hydro/base/EnumNames.h"
#include "hydro/geometry/SurfaceMesh.h"

namespace cutwater {

/// Terms the potential theory lacks, as inputs: forces −damping·η̇ − quadratic·|η̇₄|η̇₄ − stiffness·η.
struct Supplementary {
  Vec6 damping = Vec6::Zero();        ///< diagonal, N/(m/s) or N·m/(rad/s)
  Vec6 stiffness = Vec6::Zero();      ///< diagonal, N/m or N·m/rad
  double rollDampingQuadratic = 0.0;  ///< N·m/(rad/s)²
};

/// The ship as it floats at rest. Lengths in hull axes: x forward, y port, z up from calm water.
struct ShipParticulars {
  std::string name;
  SurfaceMesh hull;        ///< closed hull [m], normals out; empty in a plain BEMIO file
  SurfaceMesh wetSurface;  ///< the solver's panels before flattening; port half if symmetric
  bool symmetric = false;
  double mass = 0.0;            ///< [kg]
  Vec3 cog = Vec3::Zero();      ///< centre of gravity G [m]
  Vec3 gyradii = Vec3::Ones();  ///< roll, pitch, yaw, about G [m]
  double volume = 0.0;          ///< displaced [m³]
  Vec3 centreOfBuoyancy = Vec3::Zero();
  Mat6 restoring = Mat6::Zero();  ///< C about G, gravity and density included [N/m, N, N·m]
  double density = kSeaWaterDensity;
  double gravity = kStandardGravity;
  Supplementary supplementary;

  /// Rigid-body mass matrix about G: diag(m, m, m, m r_xx², m r_yy², m r_zz²).
  Mat6 massMatrix() const;
};

/// Where the numbers come from.
struct Provenance {
  std::string code = "Cutwater";
  std::string version;   ///< of the program that wrote it
  std::string meshHash;  ///< of the wet surface, 16 hex digits
  std::string settings;  ///< the solver's settings as TOML
};

/// Which terms a forward speed U adds to coefficients at rest (database/ForwardSpeed.h).
enum class ForwardSpeedForm {
  Report,  ///< ∂A, ∂B as integrated                                             [M03] (24)-(29)
  Tuck     ///< Tuck's theorem without its line integral: Z(U) = S Z⁰ Sᴴ
};
/// What files and commands call them.
inline constexpr EnumNames<2> kForwardSpeedNames{"report", "tuck"};

/// F_D [N/m, N·m/m] on a grid of conditions, form of `Coefficients::forwardSpeed`.
struct DiffractionTable {
  std::vector<double> speeds;     ///< U [m/s]
  std::vector<double> headings;   ///< β [rad]
  std::vector<double> waveOmega;  ///< ω_I [rad/s]
  std::vector<CVec6> values;      ///< [(speed · headings + heading) · waveOmega + frequency]
  bool empty() const { return values.empty(); }
  const CVec6& at(std::size_t speed, std::size_t heading, std::size_t frequency) const {
    return values[(speed * headings.size() + heading) * waveOmega.size() + frequency];
  }
};

/// All that solver and time domain share: hydrodynamic coefficients of one ship in deep water, at
/// rest, with all that any forward speed needs. Forces and moments about G, modes and signs as in
/// Conventions.h. Immutable once made.
struct Coefficients {
  ShipParticulars ship;
  Provenance provenance;

  /// Encounter frequencies [rad/s]: finite, > 0, strictly increasing.
  std::vector<double> omega;
  std::vector<Mat6> addedMass;        ///< A(ω_i)
  std::vector<Mat6> damping;          ///< B(ω_i)
  Mat6 addedMassZero = Mat6::Zero();  ///< A(0)
  Mat6 addedMassInf = Mat6::Zero();   ///< A(∞)

  /// Highest frequency whose waves the panels resolve [rad/s]; the solver's A, B,
  /// ∂A, ∂B and adjoint vectors above it ring; applyMask and withConsistentLimit continue them from
  /// there. 0: not known, every frequency is taken as good.
  double resolvedOmega = 0.0;

  /// Wave frequencies [rad/s] at which tables of excitation and RAOs are written unless others are
  /// asked for; increasing, within the range of `omega`. Empty: `omega` itself.
  std::vector<double> waveOmega;

  /// A(∞) of the ω = ∞ boundary value problem itself, where `addedMassInf` holds the better value
  /// that follows from A(ω) and B(ω) (finish/ConsistentLimit.h); zero if it does not.
  Mat6 addedMassInfDirect = Mat6::Zero();
  /// It does: withConsistentLimit has been here, and A, B, ∂A, ∂B go on above `resolvedOmega`.
  bool hasConsistentLimit() const { return !addedMassInfDirect.isZero(0.0); }

  /// ∂A, ∂B: the x-derivative integrals of theory section 1; empty if not computed.
  std::vector<Mat6> addedMassX, dampingX;
  Mat6 addedMassXZero = Mat6::Zero(), addedMassXInf = Mat6::Zero();

  /// Wave excitation per metre of wave amplitude, crest over the mean position of G at t = 0.
  std::vector<double> headings;                  ///< β [rad]
  std::vector<std::vector<CVec6>> froudeKrylov;  ///< [heading][frequency]
  std::vector<std::vector<CVec6>> diffraction;   ///< [heading][frequency]

  /// Adjoint vectors, 6 × panels: F^ω_j = Σ_i b_j,i v_i and F^U_j = Σ_i b^x_j,i v_i over all panels,
  /// v = −∂φ_I/∂n, its mean over each panel; of a symmetric hull the port panels, to be used with twice
  /// the even (j = 1, 3, 5) or odd part of v. F_D = ω_e F^ω + U F^U.            [M03] (88)-(91)
  ///     b_j = iρ Rᵀ L⁻ᵀ w_j,   b^x_j = −ρ(n_x∘w_j + Rᵀ L⁻ᵀ Tᵀ n_j)
  /// [frequency]; empty if not computed.
  using AdjointVectors = Eigen::Matrix<Complex, 6, Eigen::Dynamic>;
  std::vector<AdjointVectors> adjoint, adjointX;
  AdjointVectors adjointZero, adjointXZero;  ///< at ω_e = 0: rigid free surface
  AdjointVectors adjointInf, adjointXInf;    ///< at ω_e = ∞: φ = 0 on it

  /// How the terms of forward speed are put together unless another form is asked for.
  ForwardSpeedForm forwardSpeed = ForwardSpeedForm::Report;

  /// Diffraction by other means than adjoint vectors; empty unless the solver was asked for it.
  DiffractionTable diffractionTable;

  /// Frequencies of `omega` whose condition number is above the user's envelope: 1, else 0. Their A,
  /// B, ∂A, ∂B, F_D and adjoint vectors are interpolated from the others. Empty: no mask.  [M03] 5.7
  std::vector<int> masked;
  /// The envelopes themselves, pairs (ω, limit), of the even and odd systems.
  std::vector<std::pair<double, double>> conditionLimitEven, conditionLimitOdd;

  /// The solver's panels are those of solverPanels(ship.wetSurface, ship.symmetric, curvedPanels).
  bool curvedPanels = false;

  /// ‖D‖·‖D⁻¹‖ of the even and odd systems (a hull without symmetry fills only `conditionEven`).
  std::vector<double> conditionEven, conditionOdd;
};

}  // namespace cutwater
