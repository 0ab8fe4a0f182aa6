#pragma once
#include "hydro/database/Coefficients.h"
#include "hydro/geometry/panels/PanelMesh.h"
#include "hydro/incident/IncidentWaveForce.h"
#include "hydro/incident/LackingRestoring.h"

namespace cutwater {

/// Complex excitation of a ship by a unit Airy wave, for any heading, frequency and forward speed.
/// Force and moment about G per metre of wave amplitude, F(t) = Re{F e^{iω′t}} with the signed
/// encounter frequency ω′ = ω_I − kU cos β, crest over the mean position of G at t = 0.
///   F_I = −ρg ∫ e^{kz − ik(x cos β − y sin β)} n_j dS, evaluated directly each time   [M03] 5.8
///   F_D = ω′F^ω + U F^U = ρ∫(iω′φ_D − U ∂φ_D/∂x) n_j dS                         [M03] (88)-(91)
///   F^ω_j = Σ_i b_j,i(ω_e) v_i,  F^U_j = Σ_i b^x_j,i(ω_e) v_i,  v = −∂φ_I/∂n exact, b interpolated
/// Of ω_I and β only v depends, of U only ω_e = |ω′|. Tuck's form has F^U_5 = iF^ω_3,
/// F^U_6 = −iF^ω_2, others 0. A ship that overtakes the waves, ω′ < 0, sees their mirror image in
/// time: ψ solved at ω_e from v* gives
///   F_D = conj[ω_e F^ω(v*) + U F^U(v*)]
/// and at ω′ = 0 both give U F^U of the rigid free surface: F_D is continuous there.
///
/// A database without adjoint vectors is read from its DiffractionTable at one of the table's own
/// speeds, or at U = 0 (a plain BEMIO file) from its table of F_I and F_D: cubic in ω_I, linear in
/// β over gaps of up to 30°; of the latter F_I and F_D are only as separate as the file has them.
/// Immutable after construction; any thread may read. `at` costs O(panels); use it at load.
class WaveExcitation {
 public:
  struct Force {
    CVec6 froudeKrylov = CVec6::Zero();
    CVec6 diffraction = CVec6::Zero();
    CVec6 total() const { return froudeKrylov + diffraction; }
  };

  /// @param coefficients must outlive this object.
  /// @param form  of the forward-speed terms.
  WaveExcitation(const CoefficientTables& coefficients, ForwardSpeedForm form);
  /// In the database's own form.
  explicit WaveExcitation(const CoefficientTables& coefficients)
      : WaveExcitation(coefficients, coefficients.forwardSpeed) {}

  /// @param omegaI ω_I [rad/s], 0 < ω_I ≤ the database's last frequency, whose waves the panels are
  ///               made for. Tables are held below their first frequency.
  /// @param heading β [rad], any.  @param speed U [m/s], any.
  /// @throws HydroError ValueOutOfRange: ω_I; ω_e beyond the last frequency if the database holds
  ///         no vectors for ω = ∞; a speed, heading or frequency the tables do not have.
  ///         DatabaseIncomplete: no excitation, or none at a speed; BadArgument: a table of the
  ///         other form.
  Force at(double omegaI, double heading, double speed = 0.0) const;
  /// F_I alone; it does not depend on the speed.   @throws as at().
  CVec6 froudeKrylov(double omegaI, double heading) const;
  /// The highest ω_I [rad/s] that at() answers to: the database's last frequency, or what its
  /// tables of excitation have. Infinite of a database without frequencies, which at() refuses.
  double lastOmega() const noexcept;
  const CoefficientTables& coefficients() const noexcept { return coefficients_; }
  ForwardSpeedForm form() const noexcept { return form_; }
  /// The solver's panels and their surface without gaps; no panels if the database has none.
  const PanelMesh& panels() const noexcept { return panels_; }
  const PanelMesh& faces() const noexcept { return faces_; }
  /// The part of F_I that goes with the hull's restoring instead of its panels'.
  const LackingRestoring& lacking() const noexcept { return lacking_; }

 private:
  CVec6 fromVectors(const AiryWave& wave, double speed) const;
  CVec6 fromDiffractionTable(const AiryWave& wave, double speed) const;
  Force fromTables(double omegaI, double heading) const;

  const CoefficientTables& coefficients_;
  ForwardSpeedForm form_;
  PanelMesh panels_;  // the solver's
  PanelMesh faces_;   // its surface without gaps, for F_I
  LackingRestoring lacking_;
};

}  // namespace cutwater
