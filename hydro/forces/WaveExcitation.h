#pragma once
#include "hydro/database/Coefficients.h"
#include "hydro/geometry/PanelMesh.h"

namespace cutwater {

/// Complex excitation of a ship by a unit Airy wave, for any heading and frequency, U = 0.
///   F_I = −ρg ∫ e^{kz − ik(x cos β − y sin β)} n_j dS, evaluated directly each time   [M03] 5.8
///   F_D = Σ_i b_j,i(ω) v_i(ω, β), adjoint vectors interpolated in ω, v exact      theory: adjoint
/// Force and moment about G per metre of wave amplitude, crest over the mean position of G at t =
/// 0. Of a database without adjoint vectors (a plain BEMIO file) the stored table is interpolated:
/// cubic in ω, linear in β; F_I and F_D are then only as separate as the file has them. Immutable
/// after construction; any thread may read. `at` costs O(panels); use it at load.
class WaveExcitation {
 public:
  struct Force {
    CVec6 froudeKrylov = CVec6::Zero();
    CVec6 diffraction = CVec6::Zero();
    CVec6 total() const { return froudeKrylov + diffraction; }
  };

  /// @param coefficients must outlive this object.
  explicit WaveExcitation(const Coefficients& coefficients);

  /// @param omega ω_I [rad/s], 0 < ω ≤ the database's last frequency. Below its first one F_D falls
  ///              as ω², its limit for long waves (a table without adjoint vectors is held there).
  /// @param heading β [rad], any.
  /// @throws HydroError ValueOutOfRange, DatabaseIncomplete (no excitation in the file).
  Force at(double omega, double heading) const;

 private:
  Force fromTable(double omega, double heading) const;

  const Coefficients& coefficients_;
  PanelMesh panels_;  // the solver's
  PanelMesh faces_;   // its surface without gaps, for F_I
};

}  // namespace cutwater
