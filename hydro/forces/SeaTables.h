#pragma once
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "hydro/waves/SeaState.h"

namespace cutwater {

class ExcitationTable;
class Hydrodynamics;
class PressureHull;
struct CourseForces;
struct SeaCache;

/// The two parts of a linear wave load.
enum class WaveLoad { FroudeKrylov, Diffraction };
/// What columns and settings call them.
inline constexpr const char* kWaveLoadNames[2] = {"froude_krylov", "diffraction"};

/// Waves of a sea that a database has no forces for: shorter than the last that its panels are made
/// for. Their Froude-Krylov and diffraction forces are 0, in linear mode all that they do. In
/// nonlinear mode their undisturbed pressure acts on the wetted hull as that of all waves.
struct WavesBeyond {
  std::size_t count = 0;   ///< components
  double lastOmega = 0.0;  ///< ω_max of the database [rad/s]
  double share = 0.0;      ///< of m0, 0..1
};

/// What all ships of one Hydrodynamics share in one sea. Seaway makes and keeps it. Its loads are
/// kept by the Hydrodynamics. Any thread may call.
class SeaTables {
 public:
  /// @throws HydroError BadArgument: a null pointer.
  SeaTables(std::shared_ptr<const Hydrodynamics> hydrodynamics,
            std::shared_ptr<const SeaState> sea);
  /// Of a sea that goes over (SeaState::goingOver): all is taken from the tables of its parts,
  /// whose components, one after the other, are its own.
  /// @throws HydroError BadArgument: they are not, or a null pointer.
  SeaTables(std::shared_ptr<const SeaState> sea,
            std::vector<std::shared_ptr<const SeaTables>> parts);
  ~SeaTables();

  const std::shared_ptr<const Hydrodynamics>& hydrodynamics() const noexcept { return hydro_; }
  const SeaState& sea() const noexcept { return *sea_; }

  const WavesBeyond& beyond() const noexcept { return beyond_; }
  /// One line that says so with these numbers; empty if there are none.
  std::string warning() const;

  /// Loads at any course and speed, for a free ship, in Tuck's form. Made once: some tenths
  /// of a second and 10 MB for 200 components.  @throws HydroError as ExcitationTable.
  /// One table for each of the seas that this one is made of, in the order of their components.
  std::vector<std::shared_ptr<const ExcitationTable>> following() const;
  /// Exact loads on a fixed course. The last SeaCache::kCoursesKept are kept, and those in use.
  /// Of waves beyond the database they are 0; a sea of one wave that is beyond it is refused.
  /// @throws HydroError as WaveExcitation::at, naming the component.
  std::shared_ptr<const CourseForces> exact(double heading, double speed) const;
  /// The hull that the pressure of this sea is integrated on, of at most so many triangles. Made
  /// once for each number: milliseconds, or a second for a mesh of 100 000 that is thinned.
  /// @throws HydroError as PressureHull.
  std::shared_ptr<const PressureHull> pressureHull(std::size_t most) const;

 private:
  std::shared_ptr<const Hydrodynamics> hydro_;
  std::shared_ptr<const SeaState> sea_;
  std::vector<std::shared_ptr<const SeaTables>> parts_;  // none: one sea
  std::shared_ptr<SeaCache> cache_;                      // of one sea
  WavesBeyond beyond_;
  mutable std::mutex mutex_;  // of what follows
  mutable std::vector<std::pair<std::size_t, std::shared_ptr<const PressureHull>>> hulls_;
};

}  // namespace cutwater
