#pragma once
#include <memory>
#include <mutex>
#include <vector>

#include "hydro/Conventions.h"
#include "hydro/waves/SeaState.h"

namespace cutwater {

class ExcitationTable;
class Hydrodynamics;

/// The two parts of a linear wave load.
enum class WaveLoad { FroudeKrylov, Diffraction };
/// What columns and settings call them.
inline constexpr const char* kWaveLoadNames[2] = {"froude_krylov", "diffraction"};

/// Exact wave loads on a ship of one course and speed: per component of the sea the force [N/m,
/// N·m/m] per metre of amplitude, in H.
struct CourseForces {
  double heading = 0.0, speed = 0.0;             ///< ψ̄ [rad], U [m/s]
  std::vector<std::array<CVec6, 2>> components;  ///< [component][WaveLoad]
};

/// What all ships of one Hydrodynamics share in one sea. Seaway makes and keeps it; it can be
/// exchanged for that of another sea. Immutable but for tables that are made when first asked for;
/// any thread may call.
class SeaTables {
 public:
  /// @throws HydroError BadArgument: a null pointer.
  SeaTables(std::shared_ptr<const Hydrodynamics> hydrodynamics,
            std::shared_ptr<const SeaState> sea);
  ~SeaTables();

  const std::shared_ptr<const Hydrodynamics>& hydrodynamics() const noexcept { return hydro_; }
  const SeaState& sea() const noexcept { return *sea_; }

  /// Loads at any course and speed, for a ship whose mean course follows it. Made once: some tenths
  /// of a second and 10 MB for 200 components.  @throws HydroError as ExcitationTable.
  std::shared_ptr<const ExcitationTable> following() const;
  /// Exact loads on a fixed course; ships of the same course share them while one of them lives.
  /// @throws HydroError as WaveExcitation::at, naming the component.
  std::shared_ptr<const CourseForces> exact(double heading, double speed) const;

 private:
  std::shared_ptr<const Hydrodynamics> hydro_;
  std::shared_ptr<const SeaState> sea_;
  mutable std::mutex mutex_;
  mutable std::shared_ptr<const ExcitationTable> following_;
  mutable std::vector<std::weak_ptr<const CourseForces>> exact_;
};

}  // namespace cutwater
