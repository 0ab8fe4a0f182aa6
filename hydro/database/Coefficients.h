#pragma once
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "hydro/Conventions.h"
#include "hydro/ship/ShipParticulars.h"

/// One ship's hydrodynamic coefficients:
///     const Coefficients ship = readCoefficients("ship.h5");  // or solve
///     ship.addedMass[i](Heave, Pitch);                        // A_35 at ship.omega[i]
///     ship.addedMass.atInfinity(Heave, Heave);                // A_33(∞)
///     atSpeed(ship, omega, speed, ship.forwardSpeed).damping  // at any ω and U: ForwardSpeed.h
namespace cutwater {

class WetSurface;

/// Where the numbers come from.
struct Provenance {
  std::string code = "Cutwater";
  std::string version;   ///< of the program that wrote it
  std::string meshHash;  ///< of the wet surface, 16 hex digits
  std::string settings;  ///< the solver's settings as TOML

  /// The value of one of the settings, without quotes; empty if it is not there.
  std::string setting(const std::string& key) const;
};

/// Which terms a forward speed U adds to coefficients at rest (database/ForwardSpeed.h).
enum class ForwardSpeedForm {
  Report,  ///< ∂A, ∂B as integrated                                             [M03] (24)-(29)
  Tuck     ///< Tuck's theorem without its line integral: Z(U) = S Z⁰ Sᴴ
};
/// What files and commands call them.
inline constexpr std::array kForwardSpeedNames{"report", "tuck"};

/// The lowest steady speed at which a motion of the ship grows by itself.
struct GrowthLimit {
  std::optional<double> speed = {};  ///< [m/s] ≥ 0; absent: none up to the last one checked
  int mode = 0;                      ///< Mode that grows there
};
/// Steady speeds at which small motions grow by themselves (memory/SpeedStability.h), in the form
/// `CoefficientTables::forwardSpeed`.
struct SpeedStability {
  double checkedTo = 0.0;               ///< last speed looked at [m/s], astern half of it; 0: none
  GrowthLimit ahead = {}, astern = {};  ///< surge, heave, roll or pitch grows
  /// Lowest speed ahead [m/s] at which the ship does not keep its course by itself.
  std::optional<double> course = {};
};

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

/// K(iΔτ), i = 0, 1, …: retardation functions for programs that read them from the file
/// (solve/Solve.h).
struct ImpulseResponse {
  double step = 0.0;         ///< Δτ [s]
  std::vector<Mat6> values;  ///< [unit of B / s]
};

/// A quantity over frequency: its values at the grid's frequencies (`Coefficients::omega`) and its
/// limits. Matrices of fixed size are zero until set; adjoint vectors without columns are not
/// computed.
template <class T>
struct OverFrequency {
  std::vector<T> values;     ///< [frequency]; empty if not computed
  T atZero = nothing();      ///< at ω = 0
  T atInfinity = nothing();  ///< at ω = ∞

  bool empty() const noexcept { return values.empty(); }
  std::size_t size() const noexcept { return values.size(); }
  T& operator[](std::size_t frequency) { return values[frequency]; }
  const T& operator[](std::size_t frequency) const { return values[frequency]; }
  auto begin() noexcept { return values.begin(); }
  auto end() noexcept { return values.end(); }
  auto begin() const noexcept { return values.begin(); }
  auto end() const noexcept { return values.end(); }
  /// change(value) for each value, then for both limits.
  template <class Change>
  void forEach(const Change& change) {
    for (T& value : values) change(value);
    change(atZero);
    change(atInfinity);
  }

 private:
  static T nothing() {
    if constexpr (T::SizeAtCompileTime == Eigen::Dynamic)
      return T();
    else
      return T::Zero();
  }
};

/// Hydrodynamics of one ship in deep water over a grid of frequencies, at rest, with all that any
/// forward speed needs: what `Coefficients` and `SolverOutput` (SolverOutput.h) have in common.
/// Forces and moments about G, modes and signs as in Conventions.h.
struct CoefficientTables {
  ShipParticulars ship;
  Provenance provenance;

  /// Encounter frequencies [rad/s]: finite, > 0, strictly increasing.
  std::vector<double> omega;
  OverFrequency<Mat6> addedMass;  ///< A
  OverFrequency<Mat6> damping;    ///< B; 0 at both limits

  /// Highest frequency whose waves the panels resolve [rad/s]. Above it the solver's A, B, ∂A, ∂B
  /// and adjoint vectors are not to be used; `finish` continues them from there. 0: not known,
  /// every frequency counts as resolved.
  double resolvedOmega = 0.0;

  /// A(∞) of the ω = ∞ boundary value problem itself, where `addedMass.atInfinity` holds the better
  /// value that follows from A(ω) and B(ω) (finish/Finish.h); zero if it does not.
  Mat6 addedMassInfDirect = Mat6::Zero();
  /// `addedMass.atInfinity` is that better value, and A, B, ∂A, ∂B go on above `resolvedOmega`.
  bool hasConsistentLimit() const { return !addedMassInfDirect.isZero(0.0); }

  /// Wave frequencies [rad/s] at which tables of excitation and RAOs are written unless others are
  /// asked for; increasing, within the range of `omega`. Empty: `omega` itself.
  std::vector<double> waveOmega;

  /// ∂A, ∂B: integrals of the potentials' x-derivatives, [M03] (24)-(29); empty if not computed.
  OverFrequency<Mat6> addedMassX, dampingX;

  /// Wave excitation per metre of wave amplitude, crest over the mean position of G at t = 0.
  std::vector<double> headings;                  ///< β [rad]
  std::vector<std::vector<CVec6>> froudeKrylov;  ///< [heading][frequency]
  std::vector<std::vector<CVec6>> diffraction;   ///< [heading][frequency]

  /// Adjoint vectors, 6 × panels: F_D = ω_e F^ω + U F^U with                     [M03] (88)-(91)
  ///     F^ω_j = Σ_i b_j,i v_i,   F^U_j = Σ_i b^x_j,i v_i
  /// over all panels, v = −∂φ_I/∂n, its mean over each panel. Of a symmetric hull they are those of
  /// the port panels, to be used with twice the even (j = 1, 3, 5) or odd part of v.
  ///     b_j = iρ Rᵀ L⁻ᵀ w_j,   b^x_j = −ρ(n_x∘w_j + Rᵀ L⁻ᵀ Tᵀ n_j)
  /// At ω_e = 0 the free surface is rigid, at ω_e = ∞ φ = 0 on it. Empty if not computed.
  using AdjointVectors = Eigen::Matrix<Complex, 6, Eigen::Dynamic>;
  OverFrequency<AdjointVectors> adjoint, adjointX;

  /// How the terms of forward speed are put together unless another form is asked for.
  ForwardSpeedForm forwardSpeed = ForwardSpeedForm::Tuck;

  /// At which speeds small motions grow; filled by `solve`.
  SpeedStability stability;

  /// Diffraction by other means than adjoint vectors; empty unless the solver was asked for it.
  DiffractionTable diffractionTable;

  /// Frequencies of `omega` whose condition number is above the user's envelope: 1, else 0. Their
  /// A, B, ∂A, ∂B, F_D and adjoint vectors are interpolated from the others ([M03] 5.7). Empty: no
  /// mask.
  std::vector<int> masked;
  /// The envelopes themselves, pairs (ω, limit), of the even and odd systems.
  std::vector<std::pair<double, double>> conditionLimitEven, conditionLimitOdd;

  /// How the solver made its panels of the wet surface.
  PanelShape panelShape = PanelShape::Flat;
  /// The wet surface, from which the solver's panels are made. Internal: WetSurface.h is not
  /// installed. It refers to this object, so that a temporary has none.
  WetSurface wet() const& noexcept;
  WetSurface wet() const&& = delete;

  /// ‖D‖·‖D⁻¹‖ of the even and odd systems (a hull without symmetry fills only `conditionEven`).
  std::vector<double> conditionEven, conditionOdd;

 protected:  // neither kind can be copied into the other
  CoefficientTables() = default;
  CoefficientTables(const CoefficientTables&) = default;
  CoefficientTables(CoefficientTables&&) = default;
  CoefficientTables& operator=(const CoefficientTables&) = default;
  CoefficientTables& operator=(CoefficientTables&&) = default;
  ~CoefficientTables() = default;
};

/// What coefficients are good for.
enum class CoefficientStatus {
  Given,      ///< put together by a program or by another code; used as they are
  Finished,   ///< solved, and made consistent by `finish`: good for everything
  Unfinished  ///< solved on too coarse a grid for a memory: for the frequency domain only
};
/// What files and commands call them.
inline constexpr std::array kCoefficientStatusNames{"given", "finished", "unfinished"};

struct SolverOutput;

/// All that solver and time domain share, and what a database file holds. Immutable once made.
struct Coefficients : CoefficientTables {
  Coefficients() = default;

  CoefficientStatus status = CoefficientStatus::Given;
  std::string unfinishedBecause;  ///< in one line, with what would do; empty unless Unfinished

 private:
  explicit Coefficients(CoefficientTables&& tables) : CoefficientTables(std::move(tables)) {}
  friend Coefficients finish(SolverOutput output);  // finish/Finish.h: the one way from the solver
};

/// Refuses unfinished coefficients, for what needs a memory.
/// @param forWhat  begins the message.  @throws HydroError DatabaseIncomplete with the reason.
void requireFinished(const Coefficients& coefficients, const char* forWhat);

}  // namespace cutwater
