#pragma once
#include <memory>
#include <mutex>

#include "hydro/memory/Convolution.h"
#include "hydro/memory/ExponentialSum.h"
#include "hydro/memory/RetardationMatrix.h"

namespace cutwater {

/// The radiation that all ships of one database share: retardation functions, the fit, b/U and
/// c/U².
///     const RadiationModel model(coefficients, form);
///     const auto memory = model.makeMemory(0.02);   // of one ship
/// Immutable but for the fit and tables, which are made when first asked for. Any thread may call.
/// THEORY.md, chapter 7.
class RadiationModel {
 public:
  /// @param coefficients need not outlive this object.
  /// @param form  of the forward-speed terms.
  /// @throws HydroError as RetardationMatrix.
  RadiationModel(const Coefficients& coefficients, ForwardSpeedForm form);

  /// Memory of one ship that has always been at rest: the fit, a sum of damped oscillations. The
  /// model must outlive it.
  /// @param step h [s] > 0.  @throws HydroError ValueOutOfRange.
  std::unique_ptr<RadiationMemory> makeMemory(double step) const;
  /// The same by the convolution itself, slower by a factor of ten or more: for comparison.
  std::unique_ptr<RadiationMemory> makeConvolution(double step) const;

  /// The fit, made at the first call: a quarter of a second for 60 frequencies.
  const ExponentialSum& sum() const;

  /// Added mass of the water's momentum at ω (any sign, 0 too), A(ω) + B(ω)/iω at rest, from the
  /// fit: what p of a ship that oscillates is, over its velocity.
  /// @pre sum() has been asked for.
  CMat6 waterMass(double omega) const noexcept;
  const Mat6& addedMassInf() const noexcept { return addedMassInf_; }  ///< A(∞), symmetric

  ForwardSpeedForm form() const noexcept { return retardation_.form(); }
  const RetardationMatrix& retardation() const noexcept { return retardation_; }
  /// False: the database holds no ∂A, ∂B, which the report's form needs at U ≠ 0.
  bool hasSpeedTerms() const noexcept { return retardation_.hasSpeedTerms(); }

 private:
  RetardationMatrix retardation_;
  Mat6 addedMassInf_;
  mutable std::mutex mutex_;
  mutable std::unique_ptr<const ExponentialSum> sum_;
  mutable std::shared_ptr<const ConvolutionWeights> weights_;  // of the last tick length asked for
};

}  // namespace cutwater
