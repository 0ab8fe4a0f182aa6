#pragma once
#include <vector>

#include "hydro/database/HullLiftFactors.h"
#include "hydro/memory/RadiationModel.h"

namespace cutwater {

/// A small motion that grows by itself, e^{st} with Re s > 0.
/// THEORY.md, chapter 7.
struct GrowingMotion {
  Complex s;  ///< [1/s]
  Mode mode;  ///< its cause: the motion would not grow with this mode held
};

/// A ship's own equation at one steady speed, without waves and without anybody at the helm, as the
/// time domain solves it on a fixed course: with the fitted memory. Of e^{st}
///     D(s) = s²(M + A^∞) + s(B_s + b(U) + K̂(U, s)) + C + C_s + c(U)
/// Its growing motions are the zeros of det D with Re s > σ. Their number is the winding of det D
/// about 0 along the line Re s = σ, since D has no poles there; then each is found by Newton's
/// method, those already found divided out.
class OwnEquation {
 public:
  /// Arguments must outlive this object.
  OwnEquation(const CoefficientTables& coefficients, const RadiationModel& model);

  /// Slowest growth that counts, σ [1/s]: 10⁻³√(g/L), e-fold in an hour for a ship of 120 m. What
  /// grows more slowly is the fit's error, and nobody's trouble.
  double least() const noexcept { return least_; }

  /// @param speed U [m/s], any sign.  @param lift  with the lift of the hull (HullLiftFactors.h).
  /// Even and odd modes apart for a symmetric hull; with lift the odd ones alone, on which it acts.
  /// Costs about a millisecond.
  std::vector<GrowingMotion> growing(double speed, bool lift = false) const;

  /// D at a speed, whole.  @param s  Re s > 0.
  CMat6 at(Complex s, double speed, bool lift = false) const;

 private:
  class AtSpeed;
  const CoefficientTables& coefficients_;
  const RadiationModel& model_;
  HullLiftFactors lift_;
  double rate_, least_;  // √(g/L), σ
};

}  // namespace cutwater
