#pragma once
#include <memory>
#include <mutex>

#include "hydro/memory/Convolution.h"
#include "hydro/memory/ExponentialSum.h"
#include "hydro/memory/MemoryModel.h"
#include "hydro/memory/RetardationMatrix.h"

namespace cutwater {

/// The radiation that all ships of one database share: retardation functions, the fit, b/U and
/// c/U².
///     const RadiationModel model(coefficients);
///     const auto memory = model.makeMemory(0.02);   // of one ship
/// Made once, in a quarter of a second for 60 frequencies; then immutable but for tables that are
/// made when first asked for. Any thread may call.
class RadiationModel {
 public:
  /// @param coefficients need not outlive this object.
  /// @param form  of the forward-speed terms; absent: the database's own.
  /// @throws HydroError as RetardationMatrix.
  explicit RadiationModel(const Coefficients& coefficients,
                          MemoryModel memory = MemoryModel::Exponential,
                          std::optional<ForwardSpeedForm> form = {});

  /// Memory of one ship that has always been at rest. The model must outlive it.
  /// @param step h [s] > 0.  @throws HydroError ValueOutOfRange.
  std::unique_ptr<RadiationMemory> makeMemory(double step) const;

  ForwardSpeedForm form() const noexcept { return retardation_.form(); }
  MemoryModel memoryModel() const noexcept { return memory_; }
  const RetardationMatrix& retardation() const noexcept { return retardation_; }
  /// False: the database holds no ∂A, ∂B, which the report's form needs at U ≠ 0.
  bool hasSpeedTerms() const noexcept { return retardation_.hasSpeedTerms(); }
  /// ExponentialSum::error(); 0 for the convolution.
  double memoryError() const noexcept { return sum_ ? sum_->error() : 0.0; }
  /// The fit; null for the convolution.
  const ExponentialSum* sum() const noexcept { return sum_.get(); }

 private:
  RetardationMatrix retardation_;
  MemoryModel memory_;
  std::unique_ptr<const ExponentialSum> sum_;
  mutable std::mutex mutex_;
  mutable std::shared_ptr<const ConvolutionWeights> weights_;  // of the last tick length asked for
};

}  // namespace cutwater
