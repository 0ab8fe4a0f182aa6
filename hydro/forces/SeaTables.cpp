#include "hydro/forces/SeaTables.h"

#include <string>

#include "hydro/Errors.h"
#include "hydro/excitation/ExcitationTable.h"
#include "hydro/excitation/WaveExcitation.h"
#include "hydro/forces/Hydrodynamics.h"

namespace cutwater {

SeaTables::SeaTables(std::shared_ptr<const Hydrodynamics> hydrodynamics,
                     std::shared_ptr<const SeaState> sea)
    : hydro_(std::move(hydrodynamics)), sea_(std::move(sea)) {
  if (!hydro_ || !sea_) {
    throw HydroError(Fault::BadArgument, "SeaTables: no hydrodynamics or no sea (null pointer)");
  }
}

SeaTables::~SeaTables() = default;

std::shared_ptr<const ExcitationTable> SeaTables::following() const {
  const std::lock_guard lock(mutex_);
  if (!following_) {
    following_ = std::make_shared<ExcitationTable>(hydro_->coefficients(), *sea_, hydro_->form());
  }
  return following_;
}

namespace {

// Seen from a ship whose course is turned by ψ̄ to port, a wave towards (cos β, −sin β) travels at
// the polar angle −β − ψ̄, hence β + ψ̄ relative to the ship.
CourseForces forcesOn(const Hydrodynamics& hydro, const SeaState& sea, double heading,
                      double speed) {
  CourseForces forces{heading, speed, {}};
  if (sea.components().empty()) return forces;
  const WaveExcitation excitation(hydro.coefficients(), hydro.form());
  for (std::size_t i = 0; i < sea.components().size(); ++i) {
    const WaveComponent& wave = sea.components()[i];
    try {
      const auto force = excitation.at(wave.omega, wave.heading + heading, speed);
      forces.components.push_back({force.froudeKrylov, force.diffraction});
    } catch (const HydroError& error) {
      throw HydroError(error.fault(), "wave component " + std::to_string(i) + ": " + error.what());
    }
  }
  return forces;
}

}  // namespace

std::shared_ptr<const CourseForces> SeaTables::exact(double heading, double speed) const {
  const std::lock_guard lock(mutex_);
  std::erase_if(exact_, [](const auto& known) { return known.expired(); });
  for (const auto& known : exact_) {
    const std::shared_ptr<const CourseForces> forces = known.lock();
    if (forces && forces->heading == heading && forces->speed == speed) return forces;
  }
  auto made = std::make_shared<const CourseForces>(forcesOn(*hydro_, *sea_, heading, speed));
  exact_.push_back(made);
  return made;
}

}  // namespace cutwater
