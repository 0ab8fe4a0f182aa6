#pragma once
#include <memory>
#include <mutex>

#include "hydro/excitation/ExcitationTable.h"
#include "hydro/memory/RadiationModel.h"
#include "plugin/BulletTypes.h"

CUTWATER_PLUGIN_BEGIN

/// What all ships of one database share in one sea: retardation functions and their fit, wave forces at
/// any course. Made when the first ship needs them. Seaway keeps them; users need not.
class ShipModel {
 public:
  /// Both must outlive it.
  ShipModel(const Coefficients& coefficients, const SeaState& sea)
      : coefficients_(coefficients), sea_(sea) {}

  const Coefficients& coefficients() const noexcept { return coefficients_; }
  const SeaState& sea() const noexcept { return sea_; }
  double length() const noexcept;  ///< of the hull, or of its panels [m]
  double keel() const noexcept;    ///< lowest point, hull axes [m]
  /// @throws HydroError as RadiationModel.
  std::shared_ptr<const RadiationModel> radiation(MemoryModel memory);
  /// @throws HydroError as ExcitationTable.
  std::shared_ptr<const ExcitationTable> excitation();

 private:
  const Coefficients& coefficients_;
  const SeaState& sea_;
  std::mutex mutex_;
  std::shared_ptr<const RadiationModel> radiation_[2];
  std::shared_ptr<const ExcitationTable> excitation_;
};

CUTWATER_PLUGIN_END
